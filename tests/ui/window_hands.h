// What an operator's hands do at the window of a test: hold buttons, choose in menus and on the map, and name a file. Every
// function fails the test if that is not possible.
#pragma once

#include "tests/support/eventually.h"
#include "ui/flight/hold_button.h"
#include "ui/map/map_view.h"

#include <QtCore/QDir>
#include <QtCore/QPointer>
#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtGui/QWindow>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

namespace skyseal::ui {

class WindowHands
{
public:
    /// `window` must outlive it.
    explicit WindowHands(QMainWindow &window) : m_window(window) {}

    template<typename W> W *find(const char *name) const
    {
        W *found = m_window.findChild<W *>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }

    void click(const char *button) const { QTest::mouseClick(find<QWidget>(button), Qt::LeftButton); }

    void hold(const char *name) const
    {
        const QPointer<HoldButton> button = find<HoldButton>(name);
        EVENTUALLY2(button->isEnabled(), qPrintable(button->toolTip()));
        QSignalSpy confirmed(button, &HoldButton::confirmed);
        QTest::mousePress(button, Qt::LeftButton);
        EVENTUALLY_EQUAL(confirmed.size(), 1);
        QWidget *released = button; // a dialog may have closed
        QTest::mouseRelease(released ? released : &m_window, Qt::LeftButton);
    }

    void choose(const char *menuName, const QAction *action) const
    {
        auto *menu = find<QMenu>(menuName);
        QMenuBar *bar = m_window.menuBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
        QVERIFY2(action->isEnabled(), qPrintable(action->toolTip()));
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(const_cast<QAction *>(action)).center());
    }
    void choose(const char *menuName, const char *actionName) const { choose(menuName, find<QAction>(actionName)); }

    /// By a right click as the window system reports it.
    void chooseOnMap(const QPoint &at, const char *name) const
    {
        auto &map = *find<MapView>("map");
        QTest::mouseClick(m_window.windowHandle(), Qt::RightButton, {}, map.mapTo(&m_window, at));
        QMenu *menu = nullptr;
        const auto shown = [&] {
            for (QMenu *candidate : map.findChildren<QMenu *>(QStringLiteral("mapMenu")))
                menu = candidate->isVisible() ? candidate : menu;
            return menu != nullptr;
        };
        EVENTUALLY(shown());
        auto *entry = menu->findChild<QAction *>(QLatin1String(name));
        QVERIFY2(entry && entry->isEnabled(), name);
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    }

    /// A click on a button that asks for a file, and the name of one.
    void clickAndName(const char *button, const QString &path) const
    {
        QTimer look; // beside the click, which may wait for the answer
        bool named = false;
        QObject::connect(&look, &QTimer::timeout, &m_window, [&] {
            const auto *dialog = m_window.findChild<QFileDialog *>();
            if (named || !dialog || !dialog->isVisible())
                return;
            auto *name = dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
            name->clear();
            name->insert(path); // as a paste: typing opens a list of files, which would take the key
            named = true;
            QTest::keyClick(name, Qt::Key_Return);
        });
        look.start(20);
        click(button);
        EVENTUALLY(named && !m_window.findChild<QFileDialog *>());
    }

    /// Saves a picture of `widget` (null: the window) in the folder that SKYSEAL_PICTURES names.
    void picture(const QString &name, QWidget *widget = nullptr) const
    {
        const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES");
        QCoreApplication::processEvents(); // what has just been shown is not laid out yet
        if (!folder.isEmpty())
            QVERIFY((widget ? widget : &m_window)->grab().save(QDir(folder).filePath(name + QStringLiteral(".png"))));
    }

private:
    QMainWindow &m_window;
};

} // namespace skyseal::ui
