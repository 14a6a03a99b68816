// The window in all its states: nothing there, a vehicle, stale values, a port in use, commands and settings; by clicks and
// keys.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/altitude_box.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/take_off_dialog.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/links/link_dialog.h"
#include "ui/map/map_view.h"
#include "ui/status/strip_item.h"
#include "ui/values/value_cell.h"
#include "window_rig.h"

#include <QtGui/QScreen>
#include <QtTest/QSignalSpy>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// The list that pops out of a combo box, named by the box itself.
bool isInsideCombo(const QWidget *widget)
{
    const QByteArray name = widget->metaObject()->className();
    return name.startsWith("QComboBox") && name != "QComboBox";
}

} // namespace

class WindowStatesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUpWithDemo(); }
    void cleanup() { tearDown(); }

    void emptyStateShowsInstructions()
    {
        QVERIFY(find<QWidget>("emptyState")->isVisible());
        m_station->show(waitingSnapshot());
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("0.0.0.0:14550")));
        QVERIFY(find<QLabel>("emptyText")->text().contains(QStringLiteral("skyseal-air")));
        QVERIFY(find<QLabel>("emptyCommand")->text().contains(QStringLiteral("udpout:127.0.0.1:14550")));
        QVERIFY(find<QLabel>("emptyCommand")->text().startsWith(QStringLiteral("skyseal-cli keys new --out air.key")));
        engine::Snapshot elsewhere = waitingSnapshot();
        elsewhere.time = 1;
        elsewhere.links.front().localAddress = "0.0.0.0:14661";
        m_station->show(elsewhere);
        QVERIFY(find<QLabel>("emptyCommand")->text().contains(QStringLiteral("14661")));
        QVERIFY(find<QPushButton>("demoButton")->isVisible());
        QSignalSpy wanted(m_window.get(), &MainWindow::demoRequested);
        QTest::mouseClick(find<QPushButton>("demoButton"), Qt::LeftButton);
        QCOMPARE(wanted.size(), 1);
        QVERIFY(!find<HoldButton>("armButton")->isEnabled());
        QCOMPARE(find<ValueCell>("value_alt_rel")->value(), QString(QChar(0x2013)));
        m_station->show(plainSnapshot(1));
        QVERIFY(!find<QWidget>("emptyState")->isVisible());
        QVERIFY(find<HoldButton>("armButton")->isEnabled());
    }

    void silentAgentIsNamed()
    {
        engine::Snapshot snapshot = waitingSnapshot();
        snapshot.unanswering.push_back({"air-1", "192.0.2.7:40000", "SHA256:own", 4});
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("air-1 does not answer")));
        QVERIFY(find<QLabel>("emptyText")->text().contains(QStringLiteral("SHA256:own")));
        const auto *lock = find<StripItem>("stripLock");
        QCOMPARE(lock->text(), QStringLiteral("air-1 does not answer"));
        QVERIFY(lock->toolTip().contains(QStringLiteral("SHA256:own")));
        QVERIFY(lock->toolTip().contains(QStringLiteral("192.0.2.7:40000")));
        m_station->show(sealedSnapshot(1));
        QVERIFY(!lock->text().contains(QStringLiteral("answer")));
        QVERIFY(!find<QWidget>("emptyState")->isVisible());
    }

    void stripShowsTheCourseOfTheLink()
    {
        auto *link = find<StripItem>("stripLink");
        const auto showLoss = [&](double time, double lossPercent, std::uint8_t system = 1) {
            engine::Snapshot snapshot = sealedSnapshot(time);
            snapshot.sessions.front().lossPercent = lossPercent;
            snapshot.vehicles.front().state.systemId = system;
            m_station->show(snapshot);
        };
        const QString lowest = QStringLiteral("Lowest in the last minute: ");
        showLoss(100, 0);
        EVENTUALLY_EQUAL(link->accessibleDescription(), lowest + QStringLiteral("100.0 %"));
        QImage flat = link->grab().toImage();
        for (int i = 0; i < 20; ++i)
            showLoss(101 + i * 0.25, 40);
        showLoss(107, 0);
        EVENTUALLY_EQUAL(link->accessibleDescription(), lowest + QStringLiteral("60.0 %"));
        QVERIFY(link->toolTip().contains(lowest + QStringLiteral("60.0 %")));
        QVERIFY(link->text().contains(QStringLiteral("100.0 %"))); // at present
        QVERIFY(link->grab().toImage() != flat);                   // the dip is seen
        showLoss(170, 0);
        EVENTUALLY_EQUAL(link->accessibleDescription(), lowest + QStringLiteral("100.0 %")); // it is longer ago
        showLoss(171, 30);
        EVENTUALLY_EQUAL(link->accessibleDescription(), lowest + QStringLiteral("70.0 %"));
        showLoss(172, 0, 2);
        EVENTUALLY_EQUAL(link->accessibleDescription(), lowest + QStringLiteral("100.0 %")); // another vehicle
    }

    void unknownAgentIsNamed()
    {
        engine::Snapshot snapshot = waitingSnapshot();
        snapshot.unknownAgents.push_back({"192.0.2.7:40000"});
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("unknown agent")));
        QVERIFY(find<QLabel>("emptyText")->text().contains(QStringLiteral("192.0.2.7:40000")));
        QVERIFY(find<QLabel>("emptyCommand")->text().contains(QStringLiteral("--pair")));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(QStringLiteral("192.0.2.7:40000")));
        QVERIFY(find<QPushButton>("emptyKeys")->isVisible() && find<QPushButton>("secureKeys")->isVisible());
        snapshot.unknownAgents.clear();
        snapshot.time += 1;
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("Waiting for a vehicle")));
        QVERIFY(!find<QPushButton>("emptyKeys")->isVisible() && !find<QPushButton>("secureKeys")->isVisible());
        // Beside a vehicle it is no news for the middle of the window.
        engine::Snapshot sealed = sealedSnapshot(2);
        sealed.unknownAgents.push_back({"192.0.2.7:40000"});
        m_station->show(sealed);
        QVERIFY(!find<QWidget>("emptyState")->isVisible());
        QVERIFY(!find<QPushButton>("secureKeys")->isVisible());
    }

    void valuesAreThoseOfTheVehicle()
    {
        engine::Snapshot snapshot = plainSnapshot(1);
        auto &state = snapshot.vehicles.front().state;
        state.altitudeRelative = 12.44;
        state.groundSpeed = 3.06;
        state.climb = -0.04;
        state.heading = 359.7;
        state.distanceHome = 48.2;
        state.flightTime = 3723;
        m_station->show(snapshot);
        QCOMPARE(find<ValueCell>("value_alt_rel")->value(), QStringLiteral("12.4"));
        QCOMPARE(find<ValueCell>("value_ground_speed")->value(), QStringLiteral("3.1"));
        QCOMPARE(find<ValueCell>("value_climb")->value(), QStringLiteral("0.0")); // no minus before a zero
        QCOMPARE(find<ValueCell>("value_heading")->value(), QStringLiteral("000"));
        QCOMPARE(find<ValueCell>("value_distance_home")->value(), QStringLiteral("48"));
        QCOMPARE(find<ValueCell>("value_flight_time")->value(), QStringLiteral("1:02:03"));
        QCOMPARE(find<StripItem>("stripArmed")->text(), QStringLiteral("ARMED"));
        QCOMPARE(find<StripItem>("stripMode")->text(), QStringLiteral("GUIDED"));
        QVERIFY(find<StripItem>("stripGps")->text().contains(QStringLiteral("3D fix")));
    }

    void flightTimeSaysThatItsBeginningWasNotSeen()
    {
        engine::Snapshot snapshot = plainSnapshot(1);
        m_station->show(snapshot);
        const auto *cell = find<ValueCell>("value_flight_time");
        QVERIFY(cell->note().isEmpty());
        const QString title = cell->toolTip();
        snapshot.time += 1;
        snapshot.vehicles.front().state.takeOffSeen = false;
        m_station->show(snapshot);
        QCOMPARE(cell->note(), QStringLiteral("since first heard"));
        QVERIFY2(cell->toolTip().startsWith(title) && cell->toolTip().contains(QStringLiteral("already flying")),
                 qPrintable(cell->toolTip()));
        snapshot.time += 1;
        snapshot.vehicles.front().state.takeOffSeen = true;
        m_station->show(snapshot);
        QVERIFY(cell->note().isEmpty());
        QCOMPARE(cell->toolTip(), title);
    }

    void staleValuesTurnGreyWithTheirAge()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        m_station->show(snapshot);
        QVERIFY(!find<ValueCell>("value_alt_rel")->isStale());
        snapshot.vehicles.front().state.messageAge = 3.4;
        m_station->show(snapshot);
        QVERIFY(!find<ValueCell>("value_alt_rel")->isStale());
        snapshot.vehicles.front().state.messageAge = 7.2;
        m_station->show(snapshot);
        QVERIFY(find<ValueCell>("value_alt_rel")->isStale());
        QCOMPARE(find<ValueCell>("value_alt_rel")->value(), QStringLiteral("12.8")); // nothing is erased
        QVERIFY(find<QLabel>("valueAge")->text().contains(QStringLiteral("00:07")));
        QVERIFY(find<StripItem>("stripLink")->text().contains(QStringLiteral("lost")));
    }

    void heldButtonCommandsAndTheAnswerIsSaid()
    {
        m_station->show(sealedSnapshot(1)); // armed
        auto *arm = find<HoldButton>("armButton");
        QCOMPARE(arm->text(), QStringLiteral("Disarm"));
        QTest::mouseClick(arm, Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
        QVERIFY(find<QLabel>("commandResult")->text().contains(QStringLiteral("hold")));
        QTest::mousePress(arm, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(arm, Qt::LeftButton);
        QVERIFY(std::holds_alternative<vehicle::Disarm>(m_station->commands[0].second));
        QCOMPARE(m_station->commands[0].first, std::uint8_t(1));
        m_station->notify(
            vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 4, "failed: still flying"});
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Disarm: failed: still flying"));
        const auto pressed = [arm] {
            QTest::mousePress(arm, Qt::LeftButton);
            return arm->isHeld();
        };
        EVENTUALLY(pressed()); // the button is quiet for a moment after a command
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(2));
        QTest::mouseRelease(arm, Qt::LeftButton);
        m_station->notify(
            vehicle::CommandResult{vehicle::RequestId{2}, 1, vehicle::CommandOutcome::TimedOut, 0, "no answer to 5 attempts"});
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Disarm: no answer to 5 attempts")); // said once
    }

    void takeOffByKeys()
    {
        m_station->show(sealedSnapshot(1));
        find<QDoubleSpinBox>("takeOffAltitude")->setValue(25);
        auto *button = find<HoldButton>("takeOffButton");
        button->setFocus();
        QTest::keyPress(button, Qt::Key_Return);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::keyRelease(button, Qt::Key_Return);
        QCOMPARE(std::get<vehicle::TakeOff>(m_station->commands[0].second).altitude, 25.0);
        m_station->notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Accepted, 0, {}});
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Take off to 25\u00a0m: accepted"));
    }

    void menuCommandIsConfirmed()
    {
        m_station->show(sealedSnapshot(1));
        auto *land = m_window->findChild<QAction *>(QStringLiteral("actionLand"));
        land->trigger();
        auto *box = m_window->findChild<QMessageBox *>(QStringLiteral("confirmCommand"));
        EVENTUALLY(box && box->isVisible());
        QTest::keyClick(box, Qt::Key_Escape);
        EVENTUALLY(!m_window->findChild<QMessageBox *>());
        QVERIFY(m_station->commands.empty());
        land->trigger();
        box = m_window->findChild<QMessageBox *>(QStringLiteral("confirmCommand"));
        QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QVERIFY(std::holds_alternative<vehicle::Land>(m_station->commands[0].second));
    }

    void menuTakeOffAsksHowHighAndRemembers()
    {
        m_station->show(sealedSnapshot(1));
        auto *action = m_window->findChild<QAction *>(QStringLiteral("actionTakeOff"));
        action->trigger();
        auto *dialog = m_window->findChild<TakeOffDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        auto *altitude = dialog->findChild<QDoubleSpinBox *>(QStringLiteral("takeOffDialogAltitude"));
        QCOMPARE(altitude->value(), 10.0);
        QVERIFY(altitude->suffix().contains(QLatin1Char('m')));
        altitude->selectAll();
        QTest::keyClicks(altitude, QStringLiteral("9999"));
        QVERIFY(altitude->value() <= kHighestTakeOff);
        altitude->selectAll();
        QTest::keyClicks(altitude, QStringLiteral("35"));
        QTest::keyClick(altitude, Qt::Key_Return); // in the number it means: done with typing
        QVERIFY(dialog->isVisible());
        QVERIFY(m_station->commands.empty());
        auto *go = dialog->findChild<HoldButton *>(QStringLiteral("takeOffDialogGo"));
        go->setFocus();
        QTest::keyPress(go, Qt::Key_Space);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::keyRelease(m_window.get(), Qt::Key_Space);
        QCOMPARE(std::get<vehicle::TakeOff>(m_station->commands[0].second).altitude, 35.0);
        QCOMPARE(find<QDoubleSpinBox>("takeOffAltitude")->value(), 35.0); // one number for both
        open();
        QCOMPARE(find<QDoubleSpinBox>("takeOffAltitude")->value(), 35.0);
    }

    void takeOffAltitudeFollowsTheUnits()
    {
        AltitudeBox box;
        box.setMetres(10);
        box.setUnits(UnitSystem::Imperial);
        QCOMPARE(box.value(), 33.0);
        QVERIFY(box.suffix().contains(QStringLiteral("ft")));
        QCOMPARE(box.metres(), 10.0); // showing it does not change it
        box.setValue(100);
        QCOMPARE(box.metres(), 30.48);
        box.setMetres(1e9);
        QCOMPARE(box.metres(), kHighestTakeOff);
        box.setMetres(-3);
        QCOMPARE(box.metres(), kLowestTakeOff);
    }

    void lateCommandsAreShown()
    {
        auto snapshot = sealedSnapshot(40);
        auto &report = snapshot.sessions.front().stats.peerFreshness.emplace();
        report.overtakenMilliseconds = 1000;
        report.limitMilliseconds = 5000;
        const auto shown = [&](std::uint64_t milliseconds) {
            report.ageMicroseconds = milliseconds * 1000;
            ++snapshot.time;
            m_station->show(snapshot);
            return std::pair(find<QLabel>("secureTitle")->text(), find<QLabel>("secureAdvice")->text());
        };
        QCOMPARE(shown(40).first, QStringLiteral("Sealed"));
        const auto late = shown(4150);
        QCOMPARE(late.first, QStringLiteral("Sealed, commands are late"));
        QVERIFY2(late.second.startsWith(QStringLiteral("Commands arrive up to 4.2 s late.")), qPrintable(late.second));
        const auto ignored = shown(6020);
        QCOMPARE(ignored.first, QStringLiteral("Sealed, commands are ignored"));
        QVERIFY2(ignored.second.contains(QStringLiteral("up to 6.1 s late, and the limit is 5.0 s")),
                 qPrintable(ignored.second));
        const auto unknown = [&] {
            report.ageMicroseconds = channel::FreshnessReport::kUnknownAge;
            ++snapshot.time;
            m_station->show(snapshot);
            return std::pair(find<QLabel>("secureTitle")->text(), find<QLabel>("secureAdvice")->text());
        };
        QCOMPARE(unknown().first, QStringLiteral("Sealed, commands are ignored"));
        QVERIFY2(unknown().second.contains(QStringLiteral("their delay is unknown")), qPrintable(unknown().second));
        report.limitMilliseconds = 0;
        QCOMPARE(shown(6020).first, QStringLiteral("Sealed, commands are late"));
        QVERIFY2(unknown().second.startsWith(QStringLiteral("The delay of commands is unknown.")),
                 qPrintable(unknown().second));
    }
    void failingDisksAreShown()
    {
        auto snapshot = sealedSnapshot(40);
        const auto shown = [&] {
            ++snapshot.time;
            m_station->show(snapshot);
            return std::pair(find<QLabel>("secureTitle")->text(), find<QLabel>("secureAdvice")->text());
        };
        snapshot.storageProblem = "/x.counters: cannot be written: No space left on device";
        const auto own = shown();
        QCOMPARE(own.first, QStringLiteral("Sealed, disk error on this computer"));
        QVERIFY2(own.second.contains(QStringLiteral("No space left")), qPrintable(own.second));
        snapshot.sessions.front().stats.peerCannotStore = true; // more important
        const auto agents = shown();
        QCOMPARE(agents.first, QStringLiteral("Sealed, disk error at the agent"));
        QVERIFY2(agents.second.contains(QStringLiteral("The link stays up")), qPrintable(agents.second));
        snapshot.sessions.front().stats.peerCannotStore = false;
        snapshot.storageProblem = {};
        QCOMPARE(shown().first, QStringLiteral("Sealed"));
    }
    void silentSessionIsShown()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        m_station->show(snapshot);
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Sealed"));
        snapshot.time = 9;
        snapshot.sessions.front().info.silent = true;
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("secureTitle")->text().contains(QStringLiteral("no data received")));
        QVERIFY(find<QLabel>("secureAdvice")->isVisible());
    }

    /// Frames outside the session, as those of an impostor in clear, show at the lock as well.
    void impostorsShowAtTheLock()
    {
        m_station->show(sealedSnapshot(1));
        QVERIFY(!find<StripItem>("stripLock")->text().contains(QStringLiteral("under attack")));
        m_station->notify(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}});
        m_station->show(sealedSnapshot(2));
        const QString said = find<StripItem>("stripLock")->text();
        QVERIFY2(said.contains(QStringLiteral("87 refused")), qPrintable(said));
        QVERIFY(find<StripItem>("stripLock")->toolTip().contains(QStringLiteral("Under attack: 87")));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(QStringLiteral("87 spoofed frames")));
        // Plain MAVLink of the vehicle itself, until its session is up again.
        m_station->notify(channel::SessionUp{});
        m_station->notify(engine::PlaintextRefused{1, "10.0.0.9:14550", 3, {}});
        m_station->show(sealedSnapshot(3));
        QVERIFY(!find<StripItem>("stripLock")->toolTip().contains(QStringLiteral("Under attack")));
    }

    void fetchingFromALostVehicleSaysSo()
    {
        engine::Snapshot lost = sealedSnapshot(1);
        lost.vehicles.front().state.messageAge = 12;
        m_station->show(lost);
        m_window->findChild<QAction *>(QStringLiteral("view_dockParameters"))->trigger();
        const auto *result = find<QLabel>("parameterResult");
        QTest::mouseClick(find<QPushButton>("parameterFetch"), Qt::LeftButton);
        QVERIFY2(result->text().contains(QStringLiteral("00:12")), qPrintable(result->text()));
        vehicle::ParameterResult failed{vehicle::RequestId{1}, 1};
        failed.reason = "no answer";
        failed.action = vehicle::ParameterAction::ReadList;
        m_station->notify(failed);
        QVERIFY2(result->text().contains(QStringLiteral("no answer")), qPrintable(result->text()));
    }

    void firstWindowFitsTheScreen()
    {
        QSettings fresh(m_folder->filePath(QStringLiteral("fresh.ini")), QSettings::IniFormat);
        MainWindow window(*m_station, fresh, {});
        const QSize smallest(1024, 700); // the smallest screen that the window is made for
        const QSize least = window.minimumSizeHint();
        QVERIFY2(least.boundedTo(smallest) == least,
                 qPrintable(QStringLiteral("%1×%2").arg(least.width()).arg(least.height())));
        const QSize room = window.screen()->availableSize();
        QCOMPARE(window.size(), window.size().boundedTo(room));
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, test::kDeadlineMs));
        QCOMPARE(window.size(), window.size().boundedTo(room.expandedTo(smallest)));
    }

    void portInUseOffersTheNextOne()
    {
        engine::LinkSnapshot link = waitingSnapshot().links.front();
        link.phase = engine::LinkPhase::Failed;
        link.addressInUse = true;
        link.problem = "UDP port 14550 is in use";
        m_station->notify(engine::LinkChanged{link});
        QVERIFY(find<QWidget>("problemBanner")->isVisible());
        QCOMPARE(find<QLabel>("problemText")->text(), QStringLiteral("UDP port 14550 is in use")); // said once
        QCOMPARE(find<QLabel>("problemText")->textFormat(), Qt::PlainText);
        auto *remedy = find<QPushButton>("problemRemedy");
        QVERIFY(remedy->text().contains(QStringLiteral("14551")));
        QTest::mouseClick(remedy, Qt::LeftButton);
        QCOMPARE(m_station->addedLinks, std::vector<std::string>{"udpin:0.0.0.0:14551"});
        QCOMPARE(m_station->removedLinks.size(), std::size_t(1));
        QVERIFY(!find<QWidget>("problemBanner")->isVisible());
    }

    void f12OpensTheLinkDialog()
    {
        QTest::keyClick(m_window.get(), Qt::Key_F12);
        auto *dialog = m_window->findChild<LinkDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        QCOMPARE(dialog->url(), QStringLiteral("udpin:0.0.0.0:14550"));
        auto *ok = dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        auto *host = dialog->findChild<QLineEdit *>(QStringLiteral("linkHost"));
        host->clear();
        QTest::keyClicks(host, QStringLiteral("bad host"));
        QVERIFY(!ok->isEnabled());
        host->clear();
        QTest::keyClicks(host, QStringLiteral("127.0.0.1"));
        dialog->findChild<QSpinBox *>(QStringLiteral("linkPort"))->setValue(14999);
        QVERIFY(ok->isEnabled());
        QTest::mouseClick(ok, Qt::LeftButton);
        QCOMPARE(m_station->addedLinks, std::vector<std::string>{"udpin:127.0.0.1:14999"});
    }

    void insecureStreamIsMarkedAsSuch()
    {
        QTest::keyClick(m_window.get(), Qt::Key_F12);
        auto *dialog = m_window->findChild<LinkDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        auto *protection = dialog->findChild<QComboBox *>(QStringLiteral("linkProtection"));
        auto *nonce = dialog->findChild<QLineEdit *>(QStringLiteral("linkNonce"));
        auto *result = dialog->findChild<QLabel *>(QStringLiteral("linkResult"));
        auto *ok = dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        QVERIFY(!dialog->mavsec() && !nonce->isVisible());
        QVERIFY(!result->text().contains(QStringLiteral("INSECURE")));
        QTest::keyClick(protection, Qt::Key_Down);
        EVENTUALLY(nonce->isVisible());
        QVERIFY(protection->currentText().contains(QStringLiteral("INSECURE")));
        QVERIFY(result->text().contains(QStringLiteral("INSECURE")));
        QTest::keyClicks(nonce, QStringLiteral("00"));
        QVERIFY(!ok->isEnabled());
        nonce->clear();
        auto *counter = dialog->findChild<QLineEdit *>(QStringLiteral("linkCounter"));
        QVERIFY(ok->isEnabled() && counter->isVisible());
        QTest::keyClicks(counter, QStringLiteral("4294967296"));
        QVERIFY(!ok->isEnabled());
        QVERIFY(result->text().contains(QStringLiteral("counter")));
        QTest::keyClick(counter, Qt::Key_Backspace);
        QTest::keyClick(protection, Qt::Key_Down); // AES-256-CTR
        QVERIFY(!counter->isVisible() && ok->isEnabled());
        QTest::keyClick(protection, Qt::Key_Up);
        QTest::mouseClick(ok, Qt::LeftButton);
        QVERIFY(m_station->addedLinks.empty());
        QCOMPARE(m_station->mavsecLinks.size(), std::size_t(1));
        QCOMPARE(m_station->mavsecLinks[0].first, std::string("udpin:0.0.0.0:14550"));
        QCOMPARE(m_station->mavsecLinks[0].second.kind, crypto::MavsecKind::ChaCha20);
        QCOMPARE(m_station->mavsecLinks[0].second.counter, 429496729u);
    }

    void inspectorCollectsOnlyWhileSeen()
    {
        QVERIFY(!m_station->inspecting);
        auto *dock = find<QDockWidget>("dockInspector");
        QTest::keyClick(m_window.get(), Qt::Key_6, Qt::AltModifier);
        EVENTUALLY(m_station->inspecting);
        QVERIFY(dock->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_5, Qt::AltModifier); // the parameters come to the front
        EVENTUALLY(!m_station->inspecting);
    }

    void docksComeByKeysAndAreKept()
    {
        auto *dock = find<QDockWidget>("dockFlight");
        QVERIFY(dock->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::AltModifier);
        QVERIFY(dock->isVisible()); // the key of a dock in front does not hide it
        QVERIFY(dock->isAncestorOf(QApplication::focusWidget()));
        QTest::mouseClick(dock->findChild<QAbstractButton *>(QStringLiteral("qt_dockwidget_closebutton")), Qt::LeftButton);
        EVENTUALLY(!dock->isVisible());
        QVERIFY(!find<QAction>("view_dockFlight")->isChecked());
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::AltModifier);
        EVENTUALLY(dock->isVisible());
        QVERIFY(find<QAction>("view_dockFlight")->isChecked());
        dock->close();
        m_window->close();
        open();
        QVERIFY(!find<QDockWidget>("dockFlight")->isVisible());
        m_window->findChild<QAction *>(QStringLiteral("actionResetView"))->trigger();
        EVENTUALLY(find<QDockWidget>("dockFlight")->isVisible());
    }

    void settingsAreKeptAndApplied()
    {
        m_station->show(plainSnapshot(1));
        m_window->findChild<QAction *>(QStringLiteral("actionSettings"))->trigger();
        auto *dialog = m_window->findChild<SettingsDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        auto *units = dialog->findChild<QComboBox *>(QStringLiteral("settingUnits"));
        units->setCurrentIndex(units->findData(static_cast<int>(UnitSystem::Imperial)));
        auto *theme = dialog->findChild<QComboBox *>(QStringLiteral("settingTheme"));
        theme->setCurrentIndex(theme->findData(static_cast<int>(Theme::Dark)));
        auto *research = dialog->findChild<QCheckBox *>(QStringLiteral("settingResearch"));
        QVERIFY(research->text().contains(QStringLiteral("insecure")));
        QTest::mouseClick(research, Qt::LeftButton, {}, QPoint(8, research->height() / 2));
        dialog->findChild<QSpinBox *>(QStringLiteral("settingSystemId"))->setValue(250);
        dialog->findChild<QComboBox *>(QStringLiteral("settingWeakest"))->setCurrentIndex(3);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QCOMPARE(find<ValueCell>("value_alt_rel")->unit(), QStringLiteral("ft"));
        QVERIFY(m_station->allowResearch);
        QVERIFY(isDark(QApplication::palette()));
        m_store->sync();
        const Settings kept = loadSettings(*m_store);
        QCOMPARE(static_cast<int>(kept.units), static_cast<int>(UnitSystem::Imperial));
        QCOMPARE(kept.systemId, 250);
        QVERIFY(kept.allowResearch);
        QVERIFY(kept.weakestSuite == crypto::SuiteId::ChaCha20Poly1305);
        QVERIFY(m_station->weakest == crypto::SuiteId::ChaCha20Poly1305);
        applyTheme(Theme::Light);
    }

    void damagedSettingsFallBack()
    {
        m_store->setValue(QStringLiteral("station/systemId"), QStringLiteral("many"));
        m_store->setValue(QStringLiteral("station/componentId"), 4711);
        m_store->setValue(QStringLiteral("view/theme"), -3);
        m_store->setValue(QStringLiteral("security/weakestSuite"), QStringLiteral("des"));
        m_store->setValue(QStringLiteral("window/docks"), QByteArray("garbage"));
        const Settings loaded = loadSettings(*m_store);
        QCOMPARE(loaded.systemId, 255);
        QCOMPARE(loaded.componentId, 190);
        QVERIFY(loaded.weakestSuite == crypto::SuiteId::Rc4);
        QCOMPARE(static_cast<int>(loaded.theme), static_cast<int>(Theme::Desktop));
        open();
        QVERIFY(m_window->isVisible());
    }

    void mapMovesByKeysAndMouse()
    {
        for (double t = 0; t < 20; t += 0.5)
            m_station->show(sealedSnapshot(t));
        auto *map = m_window->findChild<MapView *>();
        QVERIFY(map->content().track().points().size() > 10);
        const double before = map->viewport().metresPerPixel();
        map->setFocus();
        QTest::keyClick(map, Qt::Key_Plus);
        EVENTUALLY(map->viewport().metresPerPixel() < 0.7 * before);
        const QPointF centre = map->viewport().centre();
        QTest::keyClick(map, Qt::Key_Left);
        EVENTUALLY(map->viewport().centre().x() < centre.x());
        QVERIFY(!map->isFollowing());
        QTest::keyClick(map, Qt::Key_Home);
        QVERIFY(map->isFollowing());
    }

    void everyActionAndControlHasAName()
    {
        m_station->show(sealedSnapshot(1));
        for (const QAction *action : m_window->findChildren<QAction *>()) {
            if (action->isSeparator() || action->objectName().isEmpty()
                || action->objectName().startsWith(QLatin1String("_q_")))
                continue;
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
        }
        for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
            const bool control = (qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QComboBox *>(widget)
                                  || qobject_cast<const QAbstractSpinBox *>(widget)
                                  || qobject_cast<const QAbstractItemView *>(widget))
                && !widget->objectName().startsWith(QLatin1String("qt_")) && widget->focusPolicy() != Qt::NoFocus;
            const bool part = qobject_cast<QComboBox *>(widget->parentWidget())
                || qobject_cast<QAbstractItemView *>(widget->parentWidget()) || isInsideCombo(widget)
                || qobject_cast<const QDockWidget *>(widget->parentWidget());
            if (control && !part)
                QVERIFY2(
                    !widget->accessibleName().isEmpty(),
                    qPrintable(QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName()));
        }
        QVERIFY(m_window->menuBar()->actions().size() == 7);
    }
};

SKYSEAL_TEST_WIDGETS(WindowStatesTest)
#include "window_states_test.moc"
