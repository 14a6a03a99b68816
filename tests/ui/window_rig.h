// The window with a fake station and temporary settings: a second base class for tests of the window. All docks are shown at
// first, which none of the workspaces does; a test of the workspaces can change the arrangement before it is shown again.
#pragma once

#include "fake_station.h"
#include "tests/support/eventually.h"
#include "ui/window/main_window.h"

#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QDockWidget>

#include <memory>

namespace skyseal::ui {

class WindowRig
{
protected:
    void setUp(const ProgramFacts &facts = {})
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_store = std::make_unique<QSettings>(m_folder->filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        m_station = std::make_unique<FakeStation>();
        m_facts = facts;
        open();
    }
    /// Of a desktop with the programs of the demo.
    void setUpWithDemo()
    {
        ProgramFacts facts;
        facts.demoAvailable = true;
        setUp(facts);
    }

    void tearDown()
    {
        m_window.reset();
        m_station.reset();
    }

    /// Again, with the same settings.
    void open()
    {
        m_window.reset();
        m_window = std::make_unique<MainWindow>(*m_station, *m_store, m_facts);
        m_window->resize(1280, 900);
        if (!m_store->contains(QStringLiteral("window/workspace")))
            showAllDocks();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kDeadlineMs));
        m_window->activateWindow();
    }

    void showAllDocks()
    {
        for (auto *dock : m_window->findChildren<QDockWidget *>())
            dock->show();
        auto *front = find<QDockWidget>("dockDiagnostics");
        front->raise();
        m_window->resizeDocks({front}, {216}, Qt::Vertical);
    }

    template<typename W> W *find(const char *name) const
    {
        W *found = m_window->findChild<W *>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<FakeStation> m_station;
    std::unique_ptr<MainWindow> m_window;

private:
    ProgramFacts m_facts;
};

} // namespace skyseal::ui
