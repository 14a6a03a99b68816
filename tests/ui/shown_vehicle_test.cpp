// Commands go only to the selected vehicle, whatever happens to it between the question
// and the answer. Where nothing can be sent, nothing is offered.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/take_off_dialog.h"
#include "core/engine/station/snapshot.h"
#include "core/log/log_index.h"
#include "ui/map/vehicle_markers.h"
#include "ui/text/lock_face.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"

#include <QtCore/QFile>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// In rising order, as the engine has them.
engine::Snapshot vehicles(double time, std::initializer_list<std::uint8_t> ids)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    const engine::VehicleSnapshot one = snapshot.vehicles.front();
    snapshot.vehicles.clear();
    for (const std::uint8_t id : ids) {
        snapshot.vehicles.push_back(one);
        snapshot.vehicles.back().state.systemId = id;
    }
    return snapshot;
}

} // namespace

class ShownVehicleTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void newcomerDoesNotTakeThePlace()
    {
        m_station->show(vehicles(1, {5}));
        QTest::mousePress(find<HoldButton>("landButton"), Qt::LeftButton);
        m_station->show(vehicles(1.1, {1, 5}));
        QCOMPARE(find<StripItem>("stripVehicle")->text(), QStringLiteral("Vehicle 5"));
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1)); // the hold goes on
        QCOMPARE(m_station->commands[0].first, std::uint8_t(5));
        QTest::mouseRelease(find<HoldButton>("landButton"), Qt::LeftButton);

        // Another one is shown when there is no choice; it then has the place.
        m_station->show(vehicles(2, {7}));
        m_station->show(vehicles(3, {2, 5, 7}));
        QCOMPARE(m_window->view().vehicle->state.systemId, std::uint8_t(7));
    }

    void questionIsAboutTheVehicleThatItNames()
    {
        m_station->show(vehicles(1, {5}));
        find<QAction>("actionDisarm")->trigger();
        QVERIFY(!find<QMessageBox>("confirmCommand")->text().contains(QStringLiteral("5"))); // there is no other
        delete find<QMessageBox>("confirmCommand");

        m_station->show(vehicles(2, {1, 5}));
        find<QAction>("actionDisarm")->trigger();
        auto *box = find<QMessageBox>("confirmCommand");
        QVERIFY2(box->text().startsWith(QStringLiteral("Vehicle 5: Disarm the motors?")), qPrintable(box->text()));
        find<QAction>("actionTakeOff")->trigger();
        auto *takeOff = m_window->findChild<TakeOffDialog *>();
        QVERIFY(takeOff && takeOff->windowTitle().contains(QStringLiteral("vehicle 5")));
        m_station->show(vehicles(3, {1})); // of another station
        box->button(QMessageBox::Yes)->click();
        auto *go = takeOff->findChild<HoldButton *>(QStringLiteral("takeOffDialogGo"));
        Q_EMIT go->confirmed();
        QVERIFY(m_station->commands.empty());
        const QString line = find<QLabel>("commandResult")->text();
        QVERIFY2(line.contains(QStringLiteral("vehicle 5 is no longer selected")), qPrintable(line));

        m_station->show(vehicles(4, {1}));
        find<QAction>("actionLand")->trigger();
        const auto boxes = m_window->findChildren<QMessageBox *>(QStringLiteral("confirmCommand"));
        boxes.back()->button(QMessageBox::Yes)->click();
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        QCOMPARE(m_station->commands[0].first, std::uint8_t(1));
    }

    void holdEndsWithTheWordOfTheButton()
    {
        m_station->show(sealedSnapshot(1)); // armed
        auto *arm = find<HoldButton>("armButton");
        QCOMPARE(arm->text(), QStringLiteral("Disarm"));
        QTest::mousePress(arm, Qt::LeftButton);
        QVERIFY(arm->isHeld());
        engine::Snapshot landed = sealedSnapshot(1.1);
        landed.vehicles.front().state.armed = false;
        m_station->show(landed);
        QCOMPARE(arm->text(), QStringLiteral("Arm"));
        QVERIFY(!arm->isHeld() && !arm->isDown());
        QTest::mouseRelease(arm, Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
        const QString line = find<QLabel>("commandResult")->text();
        QVERIFY2(line.contains(QStringLiteral("has been disarmed")), qPrintable(line));
    }

    void holdEndsWithTheVehicleAndItsModes()
    {
        m_station->show(vehicles(1, {5}));
        auto *land = find<HoldButton>("landButton"), *mode = find<HoldButton>("setModeButton");
        QTest::mousePress(land, Qt::LeftButton);
        m_station->show(vehicles(2, {6}));
        QVERIFY(!land->isHeld());
        QTest::mouseRelease(land, Qt::LeftButton);
        QTest::mousePress(mode, Qt::LeftButton);
        engine::Snapshot other = vehicles(3, {6});
        other.vehicles.front().state.modes = {"MANUAL", "AUTO"};
        enterMode(other.vehicles.front().state, "AUTO"); // a change that shows at once
        m_station->show(other);
        QVERIFY(!mode->isHeld());
        QTest::mouseRelease(mode, Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
    }

    void buttonsShowReasonsInWholeSentences()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.modes.clear();
        m_station->show(snapshot);
        QVERIFY(find<HoldButton>("landButton")->isEnabled());
        QVERIFY(!find<HoldButton>("setModeButton")->isEnabled());
        QCOMPARE(find<HoldButton>("setModeButton")->toolTip(), QStringLiteral("The modes of this vehicle are not known"));
        m_station->show(waitingSnapshot());
        QCOMPARE(find<HoldButton>("landButton")->toolTip(), QStringLiteral("Nothing can be sent: no vehicle"));
        QCOMPARE(find<HoldButton>("setModeButton")->toolTip(), QStringLiteral("Nothing can be sent: no vehicle"));
    }

    void nothingIsSentOneWay_data()
    {
        QTest::addColumn<bool>("recorded");
        QTest::addColumn<QString>("reason");
        QTest::addColumn<QString>("title");
        QTest::addColumn<QString>("lock");
        QTest::newRow("recording") << true << QStringLiteral("it is a replay") << QStringLiteral("Replay")
                                   << QStringLiteral("Replay · protection not recorded");
        QTest::newRow("stream that is never sent to")
            << false << QStringLiteral("its link is receive-only") << QStringLiteral("Not sealed, receive only")
            << QStringLiteral("Not sealed, receive only");
    }

    void nothingIsSentOneWay()
    {
        QFETCH(bool, recorded);
        QFETCH(QString, reason);
        QFETCH(QString, title);
        engine::Snapshot snapshot = plainSnapshot(1);
        if (recorded)
            snapshot.links.front().recording = true;
        else
            snapshot.links.front().listenOnly = true;
        m_station->show(snapshot);
        for (const char *name : {"armButton", "landButton", "missionSend", "missionRead", "parameterFetch"}) {
            const auto *button = find<QPushButton>(name);
            QVERIFY2(!button->isEnabled() && button->toolTip().contains(reason), name);
        }
        QCOMPARE(find<QLabel>("secureTitle")->text(), title);
        QTEST(find<StripItem>("stripLock")->text(), "lock");
        for (const QString &words : {find<QLabel>("secureAdvice")->text(), find<StripItem>("stripLock")->toolTip()})
            QVERIFY2(!words.contains(QStringLiteral("Start skyseal-air")), qPrintable(words));
        QVERIFY(!find<QPushButton>("secureHelp")->isVisible());
        m_station->show(plainSnapshot(2));
        QVERIFY(find<QPushButton>("armButton")->isEnabled());
    }

    void replayShowsHowTheLinkWasProtected_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<QString>("lock");
        QTest::addColumn<QString>("sentence");
        QTest::addColumn<QString>("onTheMap");
        QTest::newRow("before the first note") << 1.0 << QStringLiteral("Replay · protection not recorded")
                                               << QStringLiteral("is not noted") << QStringLiteral("Vehicle 1");
        QTest::newRow("sealed") << 10.0 << QStringLiteral("Was sealed · ChaCha20-Poly1305 · air-1")
                                << QStringLiteral("was sealed by ChaCha20-Poly1305, with air-1")
                                << QStringLiteral("Vehicle 1 · sealed");
        QTest::newRow("switched") << 25.0 << QStringLiteral("Was sealed · AES-256-GCM · air-1")
                                  << QStringLiteral("was sealed by AES-256-GCM, with air-1")
                                  << QStringLiteral("Vehicle 1 · sealed");
        QTest::newRow("plain") << 40.0 << QStringLiteral("Replay · was not sealed")
                               << QStringLiteral("was plain MAVLink, not sealed") << QStringLiteral("Vehicle 1 · not sealed");
    }
    /// The frames of a recording are in clear, whatever protected them.
    void replayShowsHowTheLinkWasProtected()
    {
        QFETCH(double, seconds);
        QFETCH(QString, sentence);
        engine::Snapshot snapshot = plainSnapshot(1);
        snapshot.links.front().recording = true;
        snapshot.security = engine::securityOf(snapshot);
        QCOMPARE(snapshot.security, engine::Security::Nothing);
        const auto index = std::make_shared<tlog::LogIndex>();
        const auto note = [&](int at, tlog::LinkEvent::Kind kind, const char *suite, const char *peer) {
            index->suites.push_back({std::chrono::seconds(at), {kind, {}, suite, peer}});
        };
        note(5, tlog::LinkEvent::Kind::Sealed, "chacha20-poly1305", "air-1");
        note(20, tlog::LinkEvent::Kind::Switched, "aes-256-gcm", "air-1");
        note(30, tlog::LinkEvent::Kind::Plain, "none", "1");
        engine::ReplayStatus status;
        status.position = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
        status.index = index;
        snapshot.replay = status;
        const ViewState view = viewOf(std::make_shared<const engine::Snapshot>(snapshot), 1);
        const LockFace face = lockFaceOf(view);
        QTEST(face.variants.front(), "lock");
        QVERIFY2(face.toolTip.contains(sentence), qPrintable(face.toolTip));
        QCOMPARE(face.security, engine::Security::Nothing); // no alarm, whatever it was
        QTEST(markerText(1, linkSuiteOf(view, *view.vehicle), 0), "onTheMap");
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(sentence));
        QCOMPARE(find<QAction>("actionChangeKeys")->isEnabled(), false);
    }

    void missionGoesToTheVehicleThatItWasChosenFor_data()
    {
        QTest::addColumn<int>("shownThen"); // 0 = the same one, as a recording
        QTest::addColumn<QString>("refusal");
        QTest::newRow("still there") << 5 << QString();
        QTest::newRow("another one") << 6 << QStringLiteral("another vehicle");
        QTest::newRow("permit gone") << 0 << QStringLiteral("not sealed");
    }

    void missionGoesToTheVehicleThatItWasChosenFor()
    {
        QFETCH(int, shownThen);
        QFETCH(QString, refusal);
        const QString file = m_folder->filePath(QStringLiteral("m.waypoints"));
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.4\t8.5\t488\t1\n");
        out.close();
        m_station->show(vehicles(1, {5}));
        find<QPushButton>("missionSend")->click();
        auto *dialog = m_window->findChild<QFileDialog *>();
        QVERIFY(dialog);
        engine::Snapshot then = vehicles(2, {static_cast<std::uint8_t>(shownThen == 0 ? 5 : shownThen)});
        if (shownThen == 0) {
            then.sessions.clear();
            then.vehicles.front().session.reset();
            then.pendingApproval.push_back({5, "192.0.2.66:40000", "air-1"});
        }
        m_station->show(then);
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(file);
        QMetaObject::invokeMethod(dialog, "accept");
        if (const auto *armed = m_window->findChild<QMessageBox *>(QStringLiteral("confirmSendMission")))
            QTest::mouseClick(armed->button(QMessageBox::Yes), Qt::LeftButton);
        const QString result = find<QLabel>("missionResult")->text();
        QCOMPARE(m_station->missionWrites.empty(), !refusal.isEmpty());
        if (refusal.isEmpty())
            QCOMPARE(m_station->missionWrites[0].first, std::uint8_t(5));
        else
            QVERIFY2(result.contains(QStringLiteral("Not sent")) && result.contains(refusal), qPrintable(result));
    }
};

SKYSEAL_TEST_WIDGETS(ShownVehicleTest)
#include "shown_vehicle_test.moc"
