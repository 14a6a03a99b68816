// The buttons and the menu that command the vehicle: what they offer follows the vehicle, and results are said once.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "window_rig.h"
#include "scripted_snapshots.h"

#include <QtCore/QRegularExpression>
#include <QtGui/QAction>
#include <QtGui/QActionGroup>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

using namespace skyseal;
using namespace skyseal::ui;

class VehicleActionsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void modeBoxFollowsTheVehicle()
    {
        const auto *modes = find<QComboBox>("modeBox");
        show("GUIDED");
        QCOMPARE(modes->currentText(), QStringLiteral("GUIDED"));
        show("RTL");
        QCOMPARE(modes->currentText(), QStringLiteral("RTL"));
    }

    void modeBoxKeepsTheOperatorsChoice()
    {
        auto *modes = find<QComboBox>("modeBox");
        show("GUIDED");
        modes->setFocus();
        while (modes->currentText() != QStringLiteral("LAND"))
            QTest::keyClick(modes, Qt::Key_Down);
        show("RTL"); // by itself
        QCOMPARE(modes->currentText(), QStringLiteral("LAND"));
        auto *button = find<HoldButton>("setModeButton");
        QTest::mousePress(button, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(button, Qt::LeftButton);
        QCOMPARE(std::get<vehicle::SetMode>(m_station->commands[0].second).mode, std::string("LAND"));
        show("LAND"); // the choice is in use
        show("GUIDED");
        QCOMPARE(modes->currentText(), QStringLiteral("GUIDED"));
    }

    void armingIsOfferedOnlyToADisarmedVehicle()
    {
        show("GUIDED", true);
        openVehicleMenu();
        const auto *arm = find<QAction>("actionArm"), *disarm = find<QAction>("actionDisarm");
        QVERIFY(!arm->isEnabled() && disarm->isEnabled());
        QCOMPARE(arm->toolTip(), QStringLiteral("Not now: the vehicle is armed"));
        closeVehicleMenu();
        show("GUIDED", false);
        openVehicleMenu();
        QVERIFY(arm->isEnabled() && !disarm->isEnabled());
        QCOMPARE(disarm->toolTip(), QStringLiteral("Not now: the vehicle is disarmed"));
        closeVehicleMenu();
    }

    void whatMakesNoSenseIsDisabled_data()
    {
        QTest::addColumn<QString>("mode");
        QTest::addColumn<bool>("armed");
        QTest::addColumn<QString>("action");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char *mode, bool armed, const char *action, const char *reason) {
            QTest::addRow("%s, %s, %s", action, mode, armed ? "armed" : "disarmed")
                << QString::fromLatin1(mode) << armed << QString::fromLatin1(action) << QString::fromLatin1(reason);
        };
        const char *const disarmed = "Not now: the vehicle is disarmed";
        for (const char *action : {"actionPause", "actionChangeAltitude"}) {
            row("GUIDED", false, action, disarmed);
            row("GUIDED", true, action, "");
        }
        for (const char *action : {"actionTakeOff", "actionStartMission"}) { // they arm, and enter the mode, by themselves
            row("GUIDED", false, action, "");
            row("LOITER", true, action, "");
        }
        row("GUIDED", false, "actionDisarm", disarmed);           // the emergency stop does not depend on it
        for (const char *action : {"actionLand", "actionReturn"}) // anybody can claim that on a plain link
            row("GUIDED", false, action, "");
    }

    /// As in the action bar; the shortcut says why it does nothing.
    void whatMakesNoSenseIsDisabled()
    {
        QFETCH(QString, mode);
        QFETCH(bool, armed);
        QFETCH(QString, action);
        QFETCH(QString, reason);
        show(mode.toLatin1().constData(), armed);
        openVehicleMenu();
        const auto *entry = find<QAction>(action.toLatin1().constData());
        QCOMPARE(entry->isEnabled(), reason.isEmpty());
        if (!reason.isEmpty())
            QCOMPARE(entry->toolTip(), reason);
        closeVehicleMenu();
        const QKeyCombination keys = entry->shortcut()[0];
        QTest::keyClick(m_window.get(), keys.key(), keys.keyboardModifiers());
        const auto dialogs = m_window->findChildren<QDialog *>();
        QCOMPARE(std::ranges::any_of(dialogs, &QDialog::isVisible), reason.isEmpty()); // each of them asks
        const QString line = find<QLabel>("commandResult")->text();
        QVERIFY2(reason.isEmpty() ? line.isEmpty() : line.endsWith(QStringLiteral(": ") + reason), qPrintable(line));
    }

    void modesAreRadioButtons()
    {
        show("GUIDED");
        openVehicleMenu();
        auto *menu = find<QMenu>("menuMode");
        Q_EMIT menu->aboutToShow();
        QStringList checked;
        QVERIFY(menu->actions().size() > 5);
        for (const QAction *action : menu->actions()) {
            QVERIFY(action->actionGroup() && action->actionGroup()->isExclusive());
            if (action->isChecked())
                checked << action->text();
        }
        QCOMPARE(checked, QStringList{QStringLiteral("GUIDED…")});
        closeVehicleMenu();
    }

    void lettersChooseTheMode()
    {
        show("GUIDED");
        const auto active = [this] {
            const QAction *entry = find<QMenu>("menuMode")->activeAction();
            return entry ? entry->text() : QString();
        };
        openModeMenu();
        QTest::keyClick(find<QMenu>("menuMode"), Qt::Key_L);
        QCOMPARE(active(), QStringLiteral("LOITER…"));
        QTest::keyClick(find<QMenu>("menuMode"), Qt::Key_A);
        QCOMPARE(active(), QStringLiteral("LAND…"));
        QTest::keyClick(find<QMenu>("menuMode"), Qt::Key_Escape);
        closeVehicleMenu();
        openModeMenu();
        QStringList seen;
        for (int i = 0; i < 2; ++i) { // the same letter leads on
            QTest::keyClick(find<QMenu>("menuMode"), Qt::Key_A);
            seen << active();
        }
        seen.sort();
        QCOMPARE(seen, (QStringList{QStringLiteral("ALT_HOLD…"), QStringLiteral("AUTO…")}));
        QTest::keyClick(find<QMenu>("menuMode"), Qt::Key_Escape);
        closeVehicleMenu();
    }

    void refusalsAreSaidOnce_data()
    {
        QTest::addColumn<int>("result");
        QTest::addColumn<QString>("reason");
        QTest::addColumn<QString>("line");
        QTest::newRow("with its command") << 4 << QStringLiteral("failed: Disarm: still flying")
                                          << QStringLiteral("Disarm: failed: still flying");
        QTest::newRow("not sent") << 0 << QStringLiteral("nothing was sent: too many commands")
                                  << QStringLiteral("Disarm: nothing was sent: too many commands");
        QTest::newRow("without texts") << 2 << QStringLiteral("denied") << QStringLiteral("Disarm: denied");
        QTest::newRow("without a reason") << 4 << QString() << QStringLiteral("Disarm: refused");
    }

    void refusalsAreSaidOnce()
    {
        QFETCH(int, result);
        QFETCH(QString, reason);
        show("GUIDED", true);
        auto *button = find<HoldButton>("armButton");
        QTest::mousePress(button, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(button, Qt::LeftButton);
        m_station->notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused,
                                                 static_cast<std::uint8_t>(result), reason.toStdString()});
        QTEST(find<QLabel>("commandResult")->text(), "line");
    }

    void resultsShowTheirTime()
    {
        show("GUIDED", true);
        auto *button = find<HoldButton>("armButton");
        QTest::mousePress(button, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(button, Qt::LeftButton);
        m_station->notify(
            vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 4, "still flying"});
        static const QRegularExpression kTime(QStringLiteral("\\d\\d:\\d\\d:\\d\\d Disarm"));
        const QString tip = find<QLabel>("commandResult")->toolTip();
        QVERIFY2(kTime.match(tip).hasMatch() && tip.contains(QStringLiteral("still flying")), qPrintable(tip));
    }

    void resultsDoNotStayForAnotherVehicle()
    {
        m_station->showTwoSealed(++m_time);
        auto *button = find<HoldButton>("landButton");
        QTest::mouseClick(button, Qt::LeftButton);
        EVENTUALLY(!find<QLabel>("commandResult")->text().isEmpty());
        auto *menu = find<QMenu>("menuChooseVehicle");
        Q_EMIT menu->aboutToShow();
        menu->actions().back()->trigger();
        QCOMPARE(find<QLabel>("commandResult")->text(), QString());
    }

private:
    void show(const char *mode, bool armed = true)
    {
        m_station->showSealed(++m_time, [&](auto &state) {
            enterMode(state, mode);
            state.armed = armed;
        });
    }
    void openVehicleMenu()
    {
        auto *menu = find<QMenu>("menuVehicle");
        QTest::mouseClick(m_window->menuBar(), Qt::LeftButton, {},
                          m_window->menuBar()->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
    }
    void openModeMenu()
    {
        openVehicleMenu();
        auto *menu = find<QMenu>("menuVehicle");
        menu->setActiveAction(find<QMenu>("menuMode")->menuAction());
        QTest::keyClick(menu, Qt::Key_Right);
        EVENTUALLY(find<QMenu>("menuMode")->isVisible());
    }
    void closeVehicleMenu()
    {
        auto *menu = find<QMenu>("menuVehicle");
        QTest::keyClick(menu, Qt::Key_Escape);
        EVENTUALLY(!menu->isVisible());
    }

    double m_time = 0;
};

SKYSEAL_TEST_WIDGETS(VehicleActionsTest)
#include "vehicle_actions_test.moc"
