// Every button of the window is an action of the command palette as well, which can have a shortcut: in all states and
// workspaces, and what is chosen there does what the button does, with the same guards.
#include "confirm_question.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/shortcuts/shortcuts.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"
#include "window_states.h"

#include <QtCore/QHash>
#include <QtCore/QSet>
#include <QtGui/QAction>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtGui/QStandardItemModel>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Buttons whose work an action of a menu does: for those that are held, the one that asks first.
const QHash<QString, QString> &sameInMenus()
{
    const auto id = [](const char *name) { return QString::fromLatin1(name); };
    static const QHash<QString, QString> kSame{
        {id("armButton"), id("actionArm")},
        {id("takeOffButton"), id("actionTakeOff")},
        {id("startMissionButton"), id("actionStartMission")},
        {id("pauseButton"), id("actionPause")},
        {id("landButton"), id("actionLand")},
        {id("returnButton"), id("actionReturn")},
        {id("setModeButton"), id("menuMode")},
        {id("unlockStop"), id("focus_unlockStop")}, // no entry of a list may unlock it
        {id("emergencyStopButton"), id("focus_unlockStop")},
        {id("stripLock"), id("view_dockSecure")},
        {id("stripVehicle"), id("view_dockVehicles")},
        {id("stripLink"), id("view_dockLinks")},
        {id("demoButton"), id("actionDemo")},
        {id("connectButton"), id("actionConnect")},
        {id("vehiclesConnect"), id("actionConnect")},
        {id("linkAdd"), id("actionConnect")},
        {id("allowPlainButton"), id("menuAllowPlain")},
        {id("emptyKeys"), id("actionKeys")},
        {id("secureKeys"), id("actionKeys")},
        {id("secureHelp"), id("actionHelpSealing")},
        {id("logReplay"), id("actionReplay")},
        {id("missionReadAgain"), id("press_missionRead")},
        {id("sweepStart"), id("actionSweep")},
        {id("editValues"), id("actionEditValues")},
        {id("chartSave"), id("chartCsv")}, // its menu
        {id("serveClasses"), id("menuServeClasses")},
        {id("alertDismiss1"), id("actionAlerts")}, // which leads to all of them
        {id("alertDismiss2"), id("actionAlerts")},
        {id("alertDismiss3"), id("actionAlerts")},
        {id("alertDismiss4"), id("actionAlerts")},
        {id("alertRemedy0"), id("actionKeys")}, // the dialog pairs
        {id("qt_dockwidget_closebutton"), id("panelClose")},
        {id("qt_dockwidget_floatbutton"), id("panelFloat")},
    };
    return kSame;
}

/// Made by Qt to show more of its widget, or to empty a line, which keys do as well; or nothing that can be pressed.
bool isNoCommand(const QAbstractButton &button)
{
    return qobject_cast<const QTabBar *>(button.parentWidget()) || qobject_cast<const QLineEdit *>(button.parentWidget())
        || button.objectName() == QLatin1String("qt_toolbar_ext_button")
        || button.objectName() == QLatin1String("qt_menubar_ext_button")
        || (qobject_cast<const StripItem *>(&button) && button.focusPolicy() == Qt::NoFocus); // a text
}

QString actionOf(const QAbstractButton &button)
{
    if (const auto *tool = qobject_cast<const QToolButton *>(&button); tool && tool->defaultAction())
        if (!tool->defaultAction()->objectName().isEmpty())
            return tool->defaultAction()->objectName();
    const QString name = button.objectName();
    if (name.startsWith(QLatin1String("row_")))
        return name.mid(4); // of a cipher suite
    return sameInMenus().value(name, QStringLiteral("press_") + name);
}

} // namespace

class PanelActionsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUpWithDemo(); }
    void cleanup() { tearDown(); }

    void everyButtonIsAnAction_data() { addWindowStates(); }
    void everyButtonIsAnAction()
    {
        QFETCH(QString, state);
        enter(state);
        QStringList missing;
        int buttons = 0;
        for (const char *workspace : {"", "workspace_fly", "workspace_plan", "workspace_vehicle", "workspace_lab"}) {
            if (*workspace)
                find<QAction>(workspace)->trigger();
            const QStringList entries = paletteEntries();
            for (const auto *button : m_window->findChildren<QAbstractButton *>()) {
                if (button->window() != m_window.get() || !button->isVisible() || !button->isEnabled() || isNoCommand(*button))
                    continue;
                ++buttons;
                const auto *action = m_window->findChild<QAction *>(actionOf(*button));
                const auto *menu = m_window->findChild<QMenu *>(actionOf(*button));
                QString text = action ? action->text() : menu ? menu->title() : QString();
                text.remove(QLatin1Char('&'));
                const auto isIt = [&](const QString &entry) {
                    return menu || action->menu() ? entry.contains(QStringLiteral(" › ") + text)
                                                  : entry.endsWith(QStringLiteral(" › ") + text);
                };
                if (text.isEmpty() || std::ranges::none_of(entries, isIt))
                    missing << QStringLiteral("%1 (%2) in %3").arg(button->objectName(), text, QLatin1String(workspace));
            }
        }
        QVERIFY(buttons > 40);
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    }

    void everyActionCanHaveAShortcut()
    {
        enter(QStringLiteral("replay"));
        QSet<QString> listed;
        for (const Shortcuts::Item &item : shortcuts().items())
            listed.insert(item.menu + QStringLiteral(" › ") + QString(item.action->text()).remove(QLatin1Char('&')));
        QStringList missing;
        for (const QString &entry : paletteEntries()) {
            const bool fillsItself = entry.count(QStringLiteral(" › ")) > 1;
            const bool isSubmenu = entry == QString::fromUtf8("Vehicle › Mode")
                || entry == QString::fromUtf8("Security › Allow plain MAVLink")
                || entry.endsWith(QLatin1String("What other stations may write"));
            if (!fillsItself && !isSubmenu && !listed.contains(entry))
                missing << entry;
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    }

    void impossibleActionsSayWhy()
    {
        openPalette();
        const auto *model = qobject_cast<QStandardItemModel *>(list()->model());
        for (const char *entry : {"Mission › Read from the vehicle", "Parameters › Fetch the parameters", "Mission › Save as…",
                                  "Links › Remove the selected link"}) {
            const int row = rowOf(QString::fromUtf8(entry));
            QVERIFY2(row >= 0, entry);
            QVERIFY2(!model->item(row)->isEnabled(), entry);
            QVERIFY2(!model->item(row, 1)->text().isEmpty(), entry);
        }
        QCOMPARE(rowOf(QStringLiteral("Replay and demo › Slower")), -1); // there is no replay
    }

    /// From the workspace that hides its panel, which is shown then.
    void readsTheMission()
    {
        enter(QStringLiteral("sealed"));
        find<QAction>("actionResetView")->trigger(); // as Fly is at first
        QVERIFY(!find<QDockWidget>("dockMission")->isVisible());
        choose("Mission › Read from the vehicle");
        EVENTUALLY(!m_station->requests.empty());
        QVERIFY(find<QDockWidget>("dockMission")->isVisible());
        QVERIFY(!find<QLabel>("missionResult")->text().isEmpty());
        QVERIFY(std::holds_alternative<vehicle::ReadMission>(m_station->requests.front()));
    }

    void fetchesTheParametersByAChangedKey()
    {
        enter(QStringLiteral("sealed"));
        find<QAction>("actionResetView")->trigger();
        shortcuts().choose(itemOf("press_parameterFetch"), QKeySequence(Qt::Key_F8));
        press(Qt::Key_F7, Qt::ControlModifier);
        QVERIFY(m_station->requests.empty());
        press(Qt::Key_F8, Qt::NoModifier);
        QCOMPARE(m_station->requests.size(), std::size_t(1));
        QVERIFY(std::holds_alternative<vehicle::ReadParameters>(m_station->requests.front()));
        QVERIFY(find<QDockWidget>("dockParameters")->isVisible());
    }

    void namesTheVehicleAmongSeveral()
    {
        m_station->showTwoSealed(5);
        const QString said = find<QPushButton>("parameterFetch")->accessibleName();
        QVERIFY(said != QLatin1String("Fetch the parameters"));
        QVERIFY(paletteEntries().contains(QStringLiteral("Parameters › ") + said));
    }

    void controlsTheReplay()
    {
        enter(QStringLiteral("replay"));
        choose("Replay and demo › Pause the replay");
        EVENTUALLY(newest<engine::PauseReplay>());
        choose("Replay and demo › Slower");
        EVENTUALLY(newest<engine::SetReplaySpeed>());
        QCOMPARE(newest<engine::SetReplaySpeed>()->factor, 0.5);
        choose("Replay and demo › Faster");
        EVENTUALLY(newest<engine::SetReplaySpeed>() && newest<engine::SetReplaySpeed>()->factor == 1);
        choose("Replay and demo › Forward 10 s");
        EVENTUALLY(newest<engine::SeekReplay>());
        QCOMPARE(newest<engine::SeekReplay>()->to, Duration(std::chrono::seconds(310)));
        choose("Replay and demo › Back 10 s");
        EVENTUALLY(newest<engine::SeekReplay>()->to == Duration(std::chrono::seconds(300)));
        choose("Replay and demo › Next event");
        EVENTUALLY(newest<engine::SeekReplay>()->to > Duration(std::chrono::seconds(300)));
        press(Qt::Key_F8, Qt::ShiftModifier); // the one before
        QVERIFY(newest<engine::SeekReplay>()->to <= Duration(std::chrono::seconds(300)));
        choose("Replay and demo › Back to live");
        EVENTUALLY_EQUAL(m_station->replaysEnded, 1);
        press(Qt::Key_F3, Qt::ShiftModifier);
        QVERIFY(newest<engine::SeekReplay>()); // nothing is played any more
    }

    void changesTheCharts()
    {
        auto *freeze = find<QCheckBox>("chartFreeze");
        choose("Diagnostics › Freeze the charts");
        EVENTUALLY(freeze->isChecked());
        QVERIFY(find<QAction>("press_chartFreeze")->isChecked());
        press(Qt::Key_F9, Qt::ControlModifier);
        QVERIFY(!freeze->isChecked());
        auto *span = find<QComboBox>("chartSpan");
        const int before = span->currentIndex();
        choose("Diagnostics › Shorter time range");
        EVENTUALLY_EQUAL(span->currentIndex(), before - 1);
        press(Qt::Key_F11, Qt::ControlModifier);
        QCOMPARE(span->currentIndex(), before);
        choose("Diagnostics › Choose the view");
        EVENTUALLY(find<QComboBox>("chartView")->hasFocus());
    }

    void switchesTheRecordingAndTheGateway()
    {
        choose("Logs › Record received and sent frames");
        EVENTUALLY(m_station->recording);
        choose("Links › Serve other stations");
        EVENTUALLY_EQUAL(m_station->served.size(), std::size_t(1));
        QVERIFY(find<QCheckBox>("serveOn")->isChecked());
        choose("Links › Serve other stations");
        EVENTUALLY(m_station->served.empty());
        QVERIFY(!find<QAction>("press_serveOn")->isChecked());
        choose("Links › Change the rights of other stations");
        auto *rights = find<QComboBox>("serveRights");
        EVENTUALLY(rights->hasFocus());
        QTest::keyClick(rights, Qt::Key_Down);
        QVERIFY(paletteEntries().contains(QStringLiteral("Links › What other stations may write › Parameters")));
    }

    void copiesAndFindsMessages()
    {
        m_station->notify(vehicle::TextReceived{1, {1, 4, "Bad gyro", {}}});
        find<QAction>("actionResetView")->trigger();
        QGuiApplication::clipboard()->clear();
        choose("Messages › Copy the messages");
        EVENTUALLY(QGuiApplication::clipboard()->text().contains(QStringLiteral("Bad gyro")));
        choose("Messages › Find a message");
        EVENTUALLY(find<QLineEdit>("messageFilter")->hasFocus());
        choose("Messages › Clear the messages");
        EVENTUALLY_EQUAL(find<QTreeView>("messageView")->model()->rowCount(), 0);
    }

    void dismissesTheFirstAlert()
    {
        enter(QStringLiteral("attacked"));
        const QString first = find<QToolButton>("alertDismiss0")->accessibleName();
        QVERIFY(find<QToolButton>("alertDismiss0")->isVisible());
        choose("Alerts › " + first.toUtf8());
        EVENTUALLY(!paletteEntries().contains(QStringLiteral("Alerts › ") + first));
    }

    /// It asks as the menu of the map does.
    void goesToThePlaceOnceConfirmed()
    {
        enter(QStringLiteral("sealed"));
        choose("Place on the map › Go here…");
        EVENTUALLY(test::shownQuestion(*m_window));
        QVERIFY(m_station->commands.empty());
        QTest::keyClick(test::shownQuestion(*m_window), Qt::Key_Escape);
        EVENTUALLY(!test::shownQuestion(*m_window));
        QVERIFY(m_station->commands.empty());
        press(Qt::Key_G, Qt::ControlModifier);
        EVENTUALLY(test::shownQuestion(*m_window));
        QTest::mouseClick(test::shownQuestion(*m_window)->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QVERIFY(std::holds_alternative<vehicle::GoTo>(m_station->commands.front().second));
    }

    void copiesThePlace()
    {
        QGuiApplication::clipboard()->clear();
        choose("Place on the map › Copy coordinates");
        EVENTUALLY(QGuiApplication::clipboard()->text().contains(QLatin1Char('.')));
        choose("Place on the map › Measure from here");
        EVENTUALLY(find<MapView>("map")->measure().isOn());
    }

    /// The key that chose it is still down, and repeats.
    void theEmergencyStopIsOnlyFocused()
    {
        enter(QStringLiteral("sealed"));
        auto *unlock = find<QCheckBox>("unlockStop");
        choose("Flight actions › Go to the lock of the emergency stop", true);
        EVENTUALLY(unlock->hasFocus());
        for (const bool repeats : {true, true, false})
            QTest::simulateEvent(unlock, true, Qt::Key_Return, Qt::NoModifier, QStringLiteral("\r"), repeats);
        QVERIFY(!unlock->isChecked());
        QVERIFY(m_station->commands.empty());
        QTest::keyRelease(unlock, Qt::Key_Return);
        QTest::keyClick(unlock, Qt::Key_Space);
        QVERIFY(unlock->isChecked());
        QVERIFY(m_station->commands.empty());
    }

    void aPanelIsClosedAndFloatedByKeys()
    {
        auto *dock = find<QDockWidget>("dockMessages");
        find<QAction>("view_dockMessages")->trigger();
        find<QLineEdit>("messageFilter")->setFocus();
        EVENTUALLY(find<QAction>("panelClose")->isEnabled());
        choose("Panels › Float or dock the panel that has the focus");
        EVENTUALLY(dock->isFloating());
        find<QAction>("panelFloat")->trigger();
        QVERIFY(!dock->isFloating());
        find<QAction>("panelClose")->trigger();
        QVERIFY(!dock->isVisible());
        m_window->activateWindow();
        find<QWidget>("map")->setFocus();
        EVENTUALLY(!find<QAction>("panelClose")->isEnabled());
        QCOMPARE(find<QAction>("panelClose")->statusTip(), QStringLiteral("No panel has the focus"));
    }

    void opensTheChecklist()
    {
        press(Qt::Key_L, Qt::ControlModifier);
        EVENTUALLY(m_window->findChild<QDialog *>(QStringLiteral("preArmDialog")));
    }

private:
    void enter(const QString &state) { enterState(state, *m_window, *m_station); }
    Shortcuts &shortcuts() const { return *m_window->findChild<Shortcuts *>(); }
    int itemOf(const char *id) const
    {
        const auto &items = shortcuts().items();
        for (std::size_t i = 0; i < items.size(); ++i)
            if (items[i].action->objectName() == QLatin1String(id))
                return static_cast<int>(i);
        qFatal("no action %s", id);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers)
    {
        m_window->activateWindow();
        EVENTUALLY(QApplication::activeWindow() == m_window.get());
        QTest::keyClick(m_window.get(), key, modifiers);
    }
    template<typename Command> const Command *newest() const
    {
        return m_station->replayCommands.empty() ? nullptr : std::get_if<Command>(&m_station->replayCommands.back());
    }
    QDialog *palette() const { return m_window->findChild<QDialog *>(QStringLiteral("commandPalette")); }
    QTreeView *list() const { return find<QTreeView>("paletteList"); }
    void openPalette()
    {
        press(Qt::Key_K, Qt::ControlModifier);
        EVENTUALLY(palette() && palette()->isVisible());
    }
    int rowOf(const QString &name) const
    {
        for (int row = 0; row < list()->model()->rowCount(); ++row)
            if (list()->model()->index(row, 0).data().toString() == name)
                return row;
        return -1;
    }
    QStringList paletteEntries()
    {
        QStringList names;
        find<QAction>("actionPalette")->trigger();
        for (int row = 0; row < list()->model()->rowCount(); ++row)
            names << list()->model()->index(row, 0).data().toString();
        delete palette();
        return names;
    }
    /// By keys alone. `held`: the key that chooses is not released.
    void choose(const QByteArray &entry, bool held = false)
    {
        const QString name = QString::fromUtf8(entry);
        openPalette();
        auto *typed = find<QLineEdit>("paletteTyped");
        QTest::keyClicks(typed, name.section(QStringLiteral(" › "), -1).remove(QChar(0x2026)));
        const int row = rowOf(name);
        QVERIFY2(row >= 0, qPrintable(name));
        for (int i = 0; i < list()->model()->rowCount() && list()->currentIndex().row() != row; ++i)
            QTest::keyClick(typed, Qt::Key_Down);
        QVERIFY2(list()->currentIndex().row() == row, qPrintable(name));
        if (held)
            QTest::keyPress(typed, Qt::Key_Return);
        else
            QTest::keyClick(typed, Qt::Key_Return);
        EVENTUALLY(!palette());
    }
};

SKYSEAL_TEST_WIDGETS(PanelActionsTest)
#include "panel_actions_test.moc"
