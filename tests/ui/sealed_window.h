// The whole window as the program makes it, for flights over a real sealed link: simulator and agent are processes on loopback
// with fresh keys, and all files of the user are in a temporary folder.
#pragma once

#include "app/skyseal/application.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/snapshot.h"
#include "tests/support/flight.h"
#include "ui/parameters/parameter_model.h"
#include "ui/status/strip_item.h"
#include "window_hands.h"

#include <QtCore/QSettings>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

#include <memory>

namespace skyseal::ui {

class SealedWindow
{
public:
    SealedWindow()
    {
        for (const char *folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            qputenv(folder, path(folder).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("settings"));
        QCoreApplication::setApplicationName(QStringLiteral("skyseal"));
        QCoreApplication::setOrganizationName(QStringLiteral("skyseal"));
    }

    /// Opens the window with the keys of the flight and these links. Returns false if there is none.
    bool open(std::vector<link::LinkUrl> links)
    {
        app::WindowOptions options;
        options.identityFile = flight.path(QStringLiteral("ground.key")).toStdString();
        options.peersFile = flight.path(QStringLiteral("ground.peers")).toStdString();
        options.links = std::move(links);
        return open(std::move(options));
    }
    bool open(app::WindowOptions options)
    {
        if (!crypto::initCrypto() || !flight.ready())
            return false;
        m_application = std::make_unique<app::Application>(std::move(options), m_random);
        if (!m_application->start())
            return false;
        for (QWidget *top : QApplication::topLevelWidgets())
            if (auto *made = qobject_cast<MainWindow *>(top))
                window = made;
        if (!window || !QTest::qWaitForWindowExposed(window, test::kDeadlineMs))
            return false;
        window->resize(1366, 768);
        hands = std::make_unique<WindowHands>(*window);
        activate();
        return true;
    }
    /// Ends the window as the program ends.
    void close()
    {
        hands.reset();
        window = nullptr;
        if (m_application)
            m_application->stop();
        m_application.reset();
    }
    ~SealedWindow() { close(); }

    void startVehicles(const QStringList &more = {})
    {
        sim = std::make_unique<test::Program>(QStringLiteral("skyseal-sim"), flight.simArguments(more));
    }
    void startAgent() { air = std::make_unique<test::Program>(QStringLiteral("skyseal-air"), flight.airArguments()); }
    /// The station's link, to which the agent sends.
    link::LinkUrl groundLink() const { return *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(flight.groundPort)); }
    /// A link on which nothing comes.
    static link::LinkUrl idleLink() { return *link::LinkUrl::parse("udpin:127.0.0.1:0"); }

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    template<typename W> W *find(const char *name) const { return hands->find<W>(name); }
    QString strip(const char *name) const { return find<StripItem>(name)->text(); }
    const ViewState &view() const { return window->view(); }
    const vehicle::VehicleState &vehicle() const { return view().vehicle->state; }
    bool isSealed() const { return window->view().session && strip("stripLock").contains(QStringLiteral("air-1 ✓")); }
    /// GUIDED needs the vehicle's own estimate of its position, which it has a while after the fix; home comes with it.
    bool isReadyToFly() const
    {
        return isSealed() && view().vehicle && vehicle().home.known() && vehicle().ekfOk.value_or(false)
            && !vehicle().modes.empty();
    }
    /// Where no window manager does it when a dialog closes.
    void activate() const
    {
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window, test::kDeadlineMs));
    }
    /// Shows a workspace by its tab.
    void show(const char *workspace) const
    {
        activate();
        const auto *action = find<QAction>(workspace);
        for (QToolButton *tab : find<QWidget>("workspaceTabs")->findChildren<QToolButton *>())
            if (tab->defaultAction() == action)
                QTest::mouseClick(tab, Qt::LeftButton);
        QVERIFY(action->isChecked());
    }
    /// Changes the mode by the action bar.
    void setMode(const QString &mode) const
    {
        auto *modes = find<QComboBox>("modeBox");
        modes->setFocus();
        QTest::keyClick(modes, Qt::Key_Home);
        for (int i = 0; i < modes->count() && modes->currentText() != mode; ++i)
            QTest::keyClick(modes, Qt::Key_Down);
        QCOMPARE(modes->currentText(), mode);
        hands->hold("setModeButton");
        EVENTUALLY2(strip("stripMode") == mode, qPrintable(find<QLabel>("commandResult")->text()));
    }
    /// Fetches the parameters, in the workspace that has them.
    void fetchParameters() const
    {
        show("workspace_vehicle");
        find<QLineEdit>("parameterFilter")->clear(); // else those that match are counted
        hands->click("parameterFetch");
        const auto *count = find<QLabel>("parameterCount");
        const auto all = [count] {
            const QStringList numbers = count->text().split(QStringLiteral(" of "));
            return numbers.size() == 2 && numbers[0] == numbers[1];
        };
        EVENTUALLY2(all(), qPrintable(count->text()));
    }
    /// Types the value of a parameter over the one there is, and waits until the vehicle has it.
    void setParameter(const QString &name, const QString &value) const
    {
        auto *filter = find<QLineEdit>("parameterFilter");
        filter->setFocus();
        QTest::keyClick(filter, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(filter, name);
        auto *list = find<QTreeView>("parameterView");
        const auto found = list->model()->match(list->model()->index(0, ParameterModel::Name), Qt::DisplayRole, name, 1,
                                                Qt::MatchExactly);
        QVERIFY2(found.size() == 1, qPrintable(name));
        const QModelIndex cell = found.front().siblingAtColumn(ParameterModel::Value);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(cell).center());
        EVENTUALLY(list->hasFocus() && list->currentIndex() == cell);
        QTest::keyClick(list, Qt::Key_F2);
        EVENTUALLY(list->viewport()->findChild<QLineEdit *>());
        auto *editor = list->viewport()->findChild<QLineEdit *>();
        QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor, value);
        QTest::keyClick(editor, Qt::Key_Return);
        EVENTUALLY(!list->viewport()->findChild<QLineEdit *>());
        const QModelIndex state = found.front().siblingAtColumn(ParameterModel::State);
        const auto question = [this] { return window->findChild<QMessageBox *>(QStringLiteral("confirmParameter")); };
        EVENTUALLY(question() || state.data().toString().startsWith(QStringLiteral("writ")));
        if (question()) { // the vehicle is armed
            QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
            EVENTUALLY(!question());
            activate();
        }
        EVENTUALLY2(state.data().toString().startsWith(QStringLiteral("written, read back as ")),
                    qPrintable(name + QStringLiteral(": ") + state.data().toString()));
    }
    /// Waits for something of a flight, which takes longer than an answer.
    template<typename Condition> [[nodiscard]] static bool flies(Condition condition)
    {
        return QTest::qWaitFor(condition, 4 * test::kDeadlineMs);
    }

    test::Flight flight;
    std::unique_ptr<test::Program> sim, air;
    MainWindow *window = nullptr;
    std::unique_ptr<WindowHands> hands;

private:
    QTemporaryDir m_folder;
    crypto::SystemRandom m_random;
    std::unique_ptr<app::Application> m_application;
};

} // namespace skyseal::ui
