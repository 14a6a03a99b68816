// The action bar: each button sends its command, what makes no sense is disabled with its reason, the emergency stop has two
// guards, and nothing moves whatever the vehicle does.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/action_bar.h"
#include "ui/flight/emergency_stop.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/held_keys.h"
#include "ui/text/pre_arm_text.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMessageBox>

using namespace skyseal;
using namespace skyseal::ui;

class ActionBarTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void buttonsSendTheirCommands_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<QString>("line");
        QTest::newRow("take off") << QStringLiteral("takeOffButton") << QStringLiteral("Take off to 10\u00a0m: requested…");
        QTest::newRow("start") << QStringLiteral("startMissionButton") << QStringLiteral("Start mission: requested…");
        QTest::newRow("pause") << QStringLiteral("pauseButton") << QStringLiteral("Pause: requested…");
        QTest::newRow("land") << QStringLiteral("landButton") << QStringLiteral("Land: requested…");
        QTest::newRow("return") << QStringLiteral("returnButton") << QStringLiteral("RTL: requested…");
    }

    void buttonsSendTheirCommands()
    {
        QFETCH(QString, button);
        m_station->show(sealedSnapshot(1));
        hold(button.toLatin1().constData());
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        QTEST(find<QLabel>("commandResult")->text(), "line");
    }

    void whatMakesNoSenseIsDisabled_data()
    {
        QTest::addColumn<QString>("state");
        QTest::addColumn<QString>("button");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char *state, const char *button, const char *reason) {
            QTest::addRow("%s %s", state, button)
                << QString::fromLatin1(state) << QString::fromLatin1(button) << QString::fromLatin1(reason);
        };
        const char *const disarmed = "Not now: the vehicle is disarmed";
        row("disarmed", "pauseButton", disarmed);
        row("disarmed", "startMissionButton", "");                              // it arms first
        for (const char *button : {"landButton", "returnButton", "unlockStop"}) // anybody can claim that on a plain link
            row("disarmed", button, "");
        row("disarmed", "takeOffButton", "");
        row("disarmed", "armButton", "");
        row("disarmed a while ago", "takeOffButton", "Not now: the vehicle is not heard");
        const char *const inAir = "Not now: the vehicle is in the air; only an emergency stop ends its motors";
        row("flying", "armButton", inAir);
        row("armed", "armButton", "");
        row("flying", "unlockStop", "");
        row("flying a while ago", "armButton", "Not now: the vehicle was flying when it was last heard");
        row("disarmed", "setModeButton", "");
        row("in LOITER", "takeOffButton", ""); // it enters GUIDED first
        row("flying", "takeOffButton", "Not now: the vehicle is already flying");
        row("flying", "landButton", "");
        row("flying a while ago", "takeOffButton", "Not now: the vehicle was flying when it was last heard");
        row("without a mission", "startMissionButton", "Not now: the mission last read is empty: read it again");
        row("without a position", "pauseButton", "Not now: its position is not known");
        row("disarmed a while ago", "startMissionButton", "Not now: the vehicle is not heard");
        row("armed a while ago", "startMissionButton", "Not now: the vehicle is not heard");
        row("disarmed a while ago", "landButton", ""); // it may have been armed since
        row("disarmed a while ago", "unlockStop", "");
        row("armed", "landButton", "");
        row("armed", "unlockStop", "");
        row("armed", "emergencyStopButton", "Locked: unlock it first");
    }

    void whatMakesNoSenseIsDisabled()
    {
        QFETCH(QString, state);
        QFETCH(QString, button);
        QFETCH(QString, reason);
        engine::Snapshot snapshot = sealedSnapshot(1);
        vehicle::VehicleState &vehicle = snapshot.vehicles.front().state;
        vehicle.armed = !state.startsWith(QLatin1String("disarmed"));
        vehicle.heartbeatAge = state.endsWith(QLatin1String("ago")) ? 4 : 0.4;
        if (state == QLatin1String("in LOITER"))
            enterMode(vehicle, "LOITER");
        vehicle.inAir = state.startsWith(QLatin1String("flying"));
        if (state == QLatin1String("without a mission"))
            snapshot.vehicles.front().mission = std::make_shared<std::vector<vehicle::MissionItem>>(1);
        if (state == QLatin1String("without a position"))
            vehicle.position = {};
        m_station->show(snapshot);
        const auto *control = find<QAbstractButton>(button.toLatin1().constData());
        QCOMPARE(control->isEnabled(), reason.isEmpty());
        if (!reason.isEmpty()) {
            QCOMPARE(control->toolTip(), reason);
            if (qobject_cast<const HoldButton *>(control)) {
                QCOMPARE(control->accessibleDescription(), reason);
            }
        }
    }

    /// What arms says so, and waits for the checklist as arming does.
    void oneActArmsAndStarts()
    {
        engine::Snapshot disarmed = sealedSnapshot(1);
        disarmed.vehicles.front().state.armed = false;
        m_station->show(disarmed);
        auto *takeOff = find<HoldButton>("takeOffButton");
        const auto *start = find<HoldButton>("startMissionButton");
        QCOMPARE(takeOff->text(), QStringLiteral("Arm and\ntake off"));
        QCOMPARE(takeOff->accessibleName(), QStringLiteral("Arm and take off"));
        QVERIFY2(takeOff->toolTip().startsWith(QStringLiteral("Arms the motors, and takes off")),
                 qPrintable(takeOff->toolTip()));
        QCOMPARE(start->accessibleName(), QStringLiteral("Arm and start mission"));
        hold("takeOffButton");
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        QVERIFY(std::get<vehicle::TakeOff>(m_station->commands[0].second).prepare);

        const auto heldAgain = [takeOff] {
            QTest::mousePress(takeOff, Qt::LeftButton);
            return takeOff->isHeld();
        };
        EVENTUALLY(heldAgain());
        m_station->show(sealedSnapshot(2)); // armed by someone else: the button means less
        QVERIFY(!takeOff->isHeld());
        QTest::mouseRelease(takeOff, Qt::LeftButton);
        QCOMPARE(takeOff->accessibleName(), QStringLiteral("Take off"));
        QCOMPARE(start->accessibleName(), QStringLiteral("Start mission"));
        QCOMPARE(m_station->commands.size(), std::size_t(1));
    }

    void modeThatTakesOffByArmingIsNamed()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        vehicle::VehicleState &state = snapshot.vehicles.front().state;
        state.armed = false;
        state.autopilot = mavlink::MAV_AUTOPILOT_PX4;
        enterMode(state, "TAKEOFF");
        m_station->show(snapshot);
        QVERIFY2(
            find<HoldButton>("armButton")->toolTip().startsWith(QStringLiteral("In its present mode the vehicle takes off")),
            qPrintable(find<HoldButton>("armButton")->toolTip()));
        find<QAction>("actionArm")->trigger();
        QVERIFY(find<QMessageBox>("confirmCommand")->text().contains(QStringLiteral("takes off at once")));
    }

    /// However narrow the bar is.
    void everyActionIsNamedByAVerb()
    {
        VehicleCommands commands(*m_station);
        ActionBar bar(commands);
        bar.show();
        bar.showViewState(viewOf(std::make_shared<const engine::Snapshot>(sealedSnapshot(1)), 0));
        const auto *start = bar.findChild<HoldButton *>(QStringLiteral("startMissionButton"));
        QSet<QString> words;
        for (int width = bar.minimumSizeHint().width(); width < 2000; width += 37) {
            bar.resize(width, bar.height());
            QCoreApplication::processEvents();
            words.insert(start->text());
            QCOMPARE(start->accessibleName(), QStringLiteral("Start mission"));
            QVERIFY2(start->toolTip().contains(QStringLiteral("mission")), qPrintable(start->toolTip()));
        }
        QCOMPARE(words, (QSet<QString>{QStringLiteral("Start\nmission"), QStringLiteral("Start mission")}));
    }

    void namesTheVehicleAmongSeveral()
    {
        m_station->show(sealedSnapshot(1));
        QCOMPARE(find<HoldButton>("landButton")->text(), QStringLiteral("Land"));
        QCOMPARE(find<HoldButton>("emergencyStopButton")->text(), QStringLiteral("Emergency stop"));
        m_station->show(withSecondVehicle(sealedSnapshot(2)));
        for (const HoldButton *button : m_window->findChildren<HoldButton *>()) {
            QVERIFY2(button->text().contains(QLatin1Char('1')), qPrintable(button->text()));
            QVERIFY2(button->accessibleName().endsWith(QStringLiteral(", vehicle 1")), qPrintable(button->accessibleName()));
        }
    }

    void emergencyStopIsLocked()
    {
        m_station->show(sealedSnapshot(1));
        auto *stop = find<HoldButton>("emergencyStopButton");
        QTest::mousePress(stop, Qt::LeftButton);
        QVERIFY(!stop->isHeld());
        QTest::mouseRelease(stop, Qt::LeftButton);
        click(find<QCheckBox>("unlockStop"));
        QVERIFY(stop->isEnabled());
        QElapsedTimer since;
        since.start();
        QTest::mousePress(stop, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QVERIFY(since.elapsed() >= EmergencyStop::kStopHoldMs);
        QTest::mouseRelease(stop, Qt::LeftButton);
        QVERIFY(std::get<vehicle::Disarm>(m_station->commands[0].second).force);
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Emergency stop: requested…"));
        QVERIFY(!stop->isEnabled() && !find<QCheckBox>("unlockStop")->isChecked());
    }

    void emergencyStopLocksItself()
    {
        m_station->show(withSecondVehicle(sealedSnapshot(1)));
        auto *unlock = find<QCheckBox>("unlockStop");
        auto *stop = find<HoldButton>("emergencyStopButton");
        click(unlock);
        find<QTimer>("relock")->start(0); // instead of ten seconds
        EVENTUALLY(!unlock->isChecked());
        QVERIFY(!stop->isEnabled());

        EVENTUALLY(!unlock->findChild<CommandGuard *>()->isQuiet());
        click(unlock);
        QTest::mousePress(stop, Qt::LeftButton);
        engine::Snapshot other = sealedSnapshot(2);
        other.vehicles.front().state.systemId = 2;
        m_station->show(other);
        QVERIFY(!stop->isHeld() && !stop->isEnabled() && !unlock->isChecked());
        QTest::mouseRelease(stop, Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
    }

    void heldKeyUnlocksNothing()
    {
        m_station->show(sealedSnapshot(1));
        auto *land = find<HoldButton>("landButton");
        auto *unlock = find<QCheckBox>("unlockStop");
        land->setFocus();
        QTest::keyPress(land, Qt::Key_Space);
        unlock->setFocus();
        for (int i = 0; i < 3; ++i) { // as X11 repeats a key
            QTest::keyRelease(unlock, Qt::Key_Space);
            QTest::keyPress(unlock, Qt::Key_Space);
        }
        QSignalSpy released(&HeldKeys::ofProgram(), &HeldKeys::released);
        QTest::keyRelease(unlock, Qt::Key_Space);
        EVENTUALLY(!released.isEmpty());
        QVERIFY(!unlock->isChecked());
        QTest::keyClick(unlock, Qt::Key_Space);
        QVERIFY(unlock->isChecked());
    }

    /// Otherwise the operator's next key would press the button that has got the focus.
    void disabledButtonLeavesTheFocusToNone()
    {
        m_station->show(sealedSnapshot(1));
        auto *takeOff = find<HoldButton>("takeOffButton");
        takeOff->setFocus();
        QCOMPARE(m_window->focusWidget(), static_cast<QWidget *>(takeOff));
        engine::Snapshot flies = sealedSnapshot(2);
        flies.vehicles.front().state.inAir = true;
        m_station->show(flies);
        QVERIFY(!takeOff->isEnabled() && find<HoldButton>("startMissionButton")->isEnabled());
        QVERIFY(!qobject_cast<QAbstractButton *>(m_window->focusWidget()));
        QTest::keyPress(m_window->focusWidget(), Qt::Key_Space);
        for (const HoldButton *button : m_window->findChildren<HoldButton *>())
            QVERIFY2(!button->isHeld(), qPrintable(button->objectName()));
        QTest::keyRelease(m_window->focusWidget(), Qt::Key_Space);
    }

    /// Row by row, whatever the width that a workspace leaves to the bar.
    void controlsKeepTheirOrder()
    {
        const char *const order[] = {"armButton",   "preArmButton", "takeOffAltitude", "takeOffButton", "startMissionButton",
                                     "pauseButton", "landButton",   "returnButton",    "setModeButton", "emergencyStopButton"};
        VehicleCommands commands(*m_station);
        ActionBar bar(commands);
        bar.show();
        QSet<int> heights;
        for (int width = bar.minimumSizeHint().width(); width < 2000; width += 37) {
            bar.resize(width, bar.height());
            QCoreApplication::processEvents();
            heights.insert(bar.height());
            QRect before;
            for (const char *name : order) {
                const auto *control = bar.findChild<QWidget *>(QLatin1String(name));
                const QRect place(control->mapTo(&bar, QPoint()), control->size());
                const bool follows = place.left() > before.right() || place.top() > before.bottom();
                QVERIFY2(before.isNull() || follows,
                         qPrintable(QStringLiteral("%1 at %2").arg(QLatin1String(name)).arg(width)));
                before = place;
            }
        }
        QVERIFY(heights.size() >= 3); // every arrangement was seen
    }

    void takeOffDialogFollowsTheVehicle()
    {
        m_station->show(sealedSnapshot(1));
        find<QAction>("actionTakeOff")->trigger();
        auto *go = find<HoldButton>("takeOffDialogGo");
        EVENTUALLY(go->isVisible());
        QVERIFY2(go->isEnabled(), qPrintable(go->toolTip()));
        QTest::mousePress(go, Qt::LeftButton);
        engine::Snapshot disarmed = sealedSnapshot(2);
        disarmed.vehicles.front().state.armed = false; // by itself
        m_station->show(disarmed);
        QVERIFY(go->isEnabled() && !go->isHeld()); // it would arm
        QCOMPARE(go->text(), QStringLiteral("Arm and take off"));
        QVERIFY(
            find<QLabel>("takeOffDialogHint")->text().endsWith(QStringLiteral("The vehicle is armed, and takes off at once.")));
        QTest::mouseRelease(go, Qt::LeftButton);
        engine::Snapshot flying = sealedSnapshot(2);
        flying.vehicles.front().state.inAir = true;
        m_station->show(flying);
        QVERIFY(!go->isEnabled());
        QCOMPARE(find<QLabel>("takeOffDialogHint")->text(), QStringLiteral("Not now: the vehicle is already flying"));
        QCOMPARE(go->toolTip(), find<QLabel>("takeOffDialogHint")->text());
        QVERIFY(m_station->commands.empty());
        m_station->show(sealedSnapshot(3));
        QCOMPARE(go->text(), QStringLiteral("Take off"));
        QVERIFY(go->isEnabled());
        QVERIFY(find<QLabel>("takeOffDialogHint")->text().startsWith(QStringLiteral("Hold the button")));
    }

    void nothingMovesWhateverTheVehicleDoes()
    {
        VehicleCommands commands(*m_station);
        ActionBar bar(commands);
        bar.show();
        for (int width = bar.minimumSizeHint().width(); width < 2000; width += 37) {
            bar.resize(width, bar.height());
            QCoreApplication::processEvents();
            bar.showViewState({});
            bar.say({}, true);
            const auto before = placesIn(bar);
            QVERIFY(before.size() >= 12);
            for (const auto &[name, place] : before) {
                const QByteArray what = QStringLiteral("%1 at %2").arg(name).arg(width).toUtf8();
                QVERIFY2(bar.rect().contains(place), what.constData());
                for (const auto &[other, otherPlace] : before)
                    QVERIFY2(name == other || !place.intersects(otherPlace), what.constData());
            }
            for (const char *target : {"takeOffButton", "startMissionButton", "pauseButton", "landButton", "returnButton"})
                QVERIFY(bar.findChild<HoldButton *>(QLatin1String(target))->height() >= ActionBar::kTargetHeight);

            engine::Snapshot disarmed = sealedSnapshot(1);
            disarmed.vehicles.front().state.armed = false;
            disarmed.vehicles.front().state.preArmReasons.assign(16, "Compass not healthy");
            engine::Snapshot many = withSecondVehicle(sealedSnapshot(2));
            many.vehicles.front().state.systemId = 255;
            enterMode(many.vehicles.front().state, "AUTOROTATE");
            many.vehicles.front().state.modes.push_back("AUTOROTATE");
            for (const engine::Snapshot &snapshot : {disarmed, sealedSnapshot(1), many}) {
                bar.showViewState(viewOf(std::make_shared<const engine::Snapshot>(snapshot), 0));
                bar.say(QStringLiteral("Arm: failed: PreArm: Compass not healthy; PreArm: GPS 1: Bad fix"), false);
                QCoreApplication::processEvents();
                QVERIFY2(placesIn(bar) == before, qPrintable(QString::number(width)));
            }
            for (const HoldButton *button : bar.findChildren<HoldButton *>()) { // with the greatest number
                const QByteArray what = QStringLiteral("%1 at %2").arg(button->objectName()).arg(width).toUtf8();
                QVERIFY2(button->width() + 1 >= button->sizeHint().width(), what.constData());
                QVERIFY2(button->height() + 1 >= button->sizeHint().height(), what.constData());
            }
        }
    }

    /// Beside the instruments of Fly; the map has what a second row would take.
    void oneRowOnAScreenOf1366Pixels()
    {
        m_window->findChild<QAction *>(QStringLiteral("actionResetView"))->trigger();
        const auto rows = [this](int width, int height) {
            m_window->resize(width, height);
            auto *bar = find<ActionBar>("actionBar");
            EVENTUALLY(m_window->size() == QSize(width, height));
            QCoreApplication::processEvents();
            const QRect arm = find<HoldButton>("armButton")->geometry();
            m_apart = find<HoldButton>("emergencyStopButton")->mapTo(bar, QPoint()).y() >= arm.bottom();
            m_barHeight = bar->height();
        };
        rows(1366, 768);
        QVERIFY(!m_apart);
        QVERIFY2(m_barHeight <= 80, qPrintable(QString::number(m_barHeight)));
        m_station->show(withSecondVehicle(sealedSnapshot(1)));
        for (const HoldButton *button : find<ActionBar>("actionBar")->findChildren<HoldButton *>())
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->objectName()));
        rows(1024, 700);
        QVERIFY(m_apart);
    }

    void preArmStateIsThatOfTheVehicle_data()
    {
        QTest::addColumn<int>("ok"); // -1: the vehicle does not say
        QTest::addColumn<int>("reasons");
        QTest::addColumn<double>("age");
        QTest::addColumn<bool>("armed");
        QTest::addColumn<QString>("text");
        QTest::newRow("silent about it") << -1 << 0 << 0.1 << false << QStringLiteral("Pre-arm: unknown");
        QTest::newRow("passed") << 1 << 0 << 0.1 << false << QStringLiteral("Pre-arm: ok");
        QTest::newRow("failed") << 0 << 3 << 0.1 << false << QStringLiteral("Pre-arm: 3 failures");
        QTest::newRow("one") << 0 << 1 << 0.1 << false << QStringLiteral("Pre-arm: 1 failure");
        QTest::newRow("refused at an attempt") << 1 << 1 << 0.1 << false << QStringLiteral("Pre-arm: 1 failure");
        QTest::newRow("failed without a word") << 0 << 0 << 0.1 << false << QStringLiteral("Pre-arm: not ok");
        QTest::newRow("passed a while ago") << 1 << 0 << 4.0 << false << QStringLiteral("Pre-arm: unknown");
        QTest::newRow("armed") << 1 << 0 << 0.1 << true << QStringLiteral("Pre-arm: armed");
    }

    void preArmStateIsThatOfTheVehicle()
    {
        QFETCH(int, ok);
        QFETCH(int, reasons);
        QFETCH(double, age);
        QFETCH(bool, armed);
        engine::Snapshot snapshot = sealedSnapshot(1);
        vehicle::VehicleState &state = snapshot.vehicles.front().state;
        state.armed = armed;
        state.messageAge = age;
        if (ok >= 0)
            state.preArmOk = ok == 1;
        for (int i = 0; i < reasons; ++i)
            state.preArmReasons.push_back("Check " + std::to_string(i));
        m_station->show(snapshot);
        QTEST(find<QPushButton>("preArmButton")->text(), "text");
    }

    void listFollowsTheReasons()
    {
        m_station->show(refusing({"Compass not healthy", "GPS 1: Bad fix"}));
        QTest::mouseClick(find<QPushButton>("preArmButton"), Qt::LeftButton);
        auto *dialog = find<QDialog>("preArmDialog");
        EVENTUALLY(dialog->isVisible());
        QVERIFY(!QApplication::activeModalWidget());
        const auto *list = find<QListWidget>("preArmList");
        QCOMPARE(list->count(), 2);
        QVERIFY(list->item(0)->text().startsWith(QStringLiteral("Compass not healthy\n→ Move the vehicle away from metal")));
        m_station->show(refusing({"GPS 1: Bad fix"}));
        QCOMPARE(list->count(), 1);
        QVERIFY(list->item(0)->text().startsWith(QStringLiteral("GPS 1: Bad fix\n")));
        QTest::mouseClick(find<QPushButton>("preArmButton"), Qt::LeftButton); // the same list again
        QCOMPARE(m_window->findChildren<QDialog *>(QStringLiteral("preArmDialog")).size(), 1);
        QTest::mouseClick(find<QPushButton>("preArmCheck"), Qt::LeftButton);
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        QCOMPARE(std::get<vehicle::RawCommand>(m_station->commands[0].second).command, std::uint16_t(401));
        m_station->show(sealedSnapshot(9)); // armed
        QCOMPARE(list->count(), 0);
        QCOMPARE(find<QLabel>("preArmState")->text(), QStringLiteral("The vehicle is armed."));
        QVERIFY(!find<QPushButton>("preArmCheck")->isEnabled());
    }

    void commonReasonsHaveARemedy_data()
    {
        QTest::addColumn<QString>("words");
        const auto row = [](const char *reason, const char *words) { QTest::newRow(reason) << QString::fromLatin1(words); };
        row("GPS 1: Bad fix", "3D fix");
        row("Need Position Estimate", "Wait for the GPS");
        row("GPS HDOP 2.1 (needs 1.4)", "more satellites");
        row("Compass not calibrated", "Calibrate the compass");
        row("Compasses inconsistent", "away from metal");
        row("AHRS: EKF3 still initialising", "Keep the vehicle still");
        row("Battery 1 below minimum arming voltage", "Charge");
        row("RC not calibrated", "Calibrate the radio");
        row("Throttle too high", "throttle stick");
        row("Throttle below failsafe", "transmitter");
        row("Hardware safety switch", "safety switch");
        row("Logging failed", "SD card");
        row("AUTO mode not armable", "Set a mode");
        row("Board (4.1v) out of range 4.3-5.8v", "power supply");
        row("something new", "autopilot's documentation");
    }

    void commonReasonsHaveARemedy()
    {
        QFETCH(QString, words);
        const QString remedy = preArmRemedy(QString::fromLatin1(QTest::currentDataTag()));
        QVERIFY2(remedy.contains(words), qPrintable(remedy));
    }

private:
    using Places = std::vector<std::pair<QString, QRect>>;

    static Places placesIn(const ActionBar &bar)
    {
        Places out;
        for (const QWidget *widget : bar.findChildren<QWidget *>())
            if ((qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QComboBox *>(widget)
                 || qobject_cast<const QLabel *>(widget) || widget->objectName() == QLatin1String("takeOffAltitude"))
                && widget->isVisibleTo(&bar))
                out.emplace_back(widget->objectName(), QRect(widget->mapTo(&bar, QPoint()), widget->size()));
        return out;
    }

    static engine::Snapshot withSecondVehicle(engine::Snapshot snapshot)
    {
        snapshot.vehicles.push_back(snapshot.vehicles.front());
        snapshot.vehicles.back().state.systemId = 2;
        return snapshot;
    }

    engine::Snapshot refusing(std::vector<std::string> reasons)
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.front().state.armed = false;
        snapshot.vehicles.front().state.preArmReasons = std::move(reasons);
        return snapshot;
    }

    static void click(QCheckBox *box) { QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2)); }

    void hold(const char *name)
    {
        auto *button = find<HoldButton>(name);
        QVERIFY2(button->isEnabled(), qPrintable(button->toolTip()));
        QTest::mousePress(button, Qt::LeftButton);
        EVENTUALLY(!m_station->commands.empty());
        QTest::mouseRelease(button, Qt::LeftButton);
    }

    double m_time = 0;
    int m_barHeight = 0;
    bool m_apart = false;
};

SKYSEAL_TEST_WIDGETS(ActionBarTest)
#include "action_bar_test.moc"
