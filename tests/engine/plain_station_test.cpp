// A station without keys: it shows plain vehicles, names the port that is in use, and stops its heartbeat when its reader
// hangs.
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/keys/peers_file.h"
#include "core/log/link_events.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/ground.h"
#include "tests/support/eventually.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

class PlainStationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plainVehicleIsShownAsPlain();
    void plainVehicleIsNotedBesideTheRecording();
    void lostVehicleIsForgotten();
    void plainVehicleAwaitsApproval();
    void recordingApprovesNoVehicle();
    void pendingVehicleIsNotReportedAsAnAttack();
    void noVehicleNeedsApprovalWithoutPeers();
    void takenPortIsNamed();
    void heartbeatStopsIfTheReaderHangs();
    void noTargetWithoutAHeartbeat();
    void announcementsAreNotCountedAsMalformed();
    void requestToAnUnknownVehicleFails();
    void missionOfAnotherStationIsMarked();
};

void PlainStationTest::plainVehicleIsShownAsPlain()
{
    // A new user: with a key, and without peers.
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    auto station = engine::Station::create(config);
    QVERIFY(station);
    StationEars ears(**station);
    (*station)->addLink(urlOf("udpin:127.0.0.1:0"));
    EVENTUALLY(!ears.listening().empty());
    VehicleOnUdp vehicle(ears.listening());
    EVENTUALLY(!ears.all<engine::VehicleFound>().empty());
    QVERIFY(!ears.all<engine::VehicleFound>()[0].sealed);
    EVENTUALLY_EQUAL(int(ears.snapshot->security), int(engine::Security::Plain));
    // It also receives us: streams start only on request.
    EVENTUALLY(!ears.snapshot->vehicles.empty() && !std::isnan(ears.snapshot->vehicles[0].state.roll));
}

void PlainStationTest::plainVehicleIsNotedBesideTheRecording()
{
    FlightRig rig;
    QTemporaryDir folder;
    engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    config.recordFolder = folder.path().toStdString();
    config.record = true;
    Ground ground(config);
    VehicleOnUdp vehicle(ground.ears->listening());
    for (int recording = 0; recording < 2; ++recording) { // each of them says so
        EVENTUALLY(ground.ears->snapshot->recording.frames > 50);
        const std::string file = ground.ears->snapshot->recording.file;
        ground.station->setRecording(false);
        EVENTUALLY(!ground.ears->snapshot->recording.active);
        const tlog::LinkEvents noted = tlog::linkEventsOf(file);
        QCOMPARE(noted.unreadable, std::uint64_t(0));
        QCOMPARE(noted.events.size(), std::size_t(1));
        QVERIFY(noted.events[0].kind == tlog::LinkEvent::Kind::Plain);
        QCOMPARE(noted.events[0].suite, std::string("none"));
        QCOMPARE(noted.events[0].peer, std::string("1"));
        ground.station->setRecording(true);
    }
}

void PlainStationTest::lostVehicleIsForgotten()
{
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    Ground ground(config);
    QUdpSocket vehicle;
    const auto heartbeat = [&] { vehicle.writeDatagram(clearHeartbeat(1, 1, false), QHostAddress::LocalHost, ground.port()); };
    const auto vehicles = [&] { return ground.ears->snapshot->vehicles.size(); };
    heartbeat();
    EVENTUALLY_EQUAL(vehicles(), std::size_t(1));
    ground.station->forgetVehicle(1); // it is not lost
    QVERIFY(!QTest::qWaitFor([&] { return vehicles() == 0; }, 500));
    EVENTUALLY(ground.ears->snapshot->vehicles[0].state.lost);
    ground.station->forgetVehicle(2);
    ground.station->forgetVehicle(1);
    EVENTUALLY_EQUAL(vehicles(), std::size_t(0));
    heartbeat();
    EVENTUALLY_EQUAL(vehicles(), std::size_t(1));
    QVERIFY(!ground.ears->snapshot->vehicles[0].state.lost);
    QCOMPARE(ground.ears->all<engine::VehicleFound>().size(), std::size_t(2));
}

void PlainStationTest::plainVehicleAwaitsApproval()
{
    // A known agent was never heard: this vehicle could be an impostor.
    FlightRig rig;
    auto station = engine::Station::create(rig.stationConfig(engine::SecureMode::Preferred));
    QVERIFY(station);
    StationEars ears(**station);
    (*station)->addLink(urlOf("udpin:127.0.0.1:0"));
    EVENTUALLY(!ears.listening().empty());
    VehicleOnUdp vehicle(ears.listening());
    EVENTUALLY_EQUAL(ears.snapshot->pendingApproval.size(), std::size_t(1));
    const engine::PendingVehicle held = ears.snapshot->pendingApproval[0];
    QCOMPARE(int(held.systemId), 1);
    QCOMPARE(held.mayBe, std::string("air-1"));
    QCOMPARE(int(ears.snapshot->security), int(engine::Security::Plain));
    // It continues to send and receives nothing: no heartbeat, and no request for streams, without which it sends few frames.
    QVERIFY(!QTest::qWaitFor([&] { return !ears.snapshot->vehicles.empty(); }, 2500));
    const auto txDatagrams = [&] { return ears.snapshot->links.empty() ? 0 : ears.snapshot->links[0].txDatagrams; };
    QCOMPARE(txDatagrams(), std::uint64_t(0));
    QCOMPARE(ears.all<engine::PlaintextRefused>().size(), std::size_t(1)); // published once
    QCOMPARE(ears.all<engine::PlaintextRefused>()[0].mayBe, std::string("air-1"));
    (*station)->allowPlaintext(2);
    QVERIFY(!QTest::qWaitFor([&] { return !ears.snapshot->vehicles.empty(); }, 1500));
    (*station)->allowPlaintext(1);
    EVENTUALLY(!ears.snapshot->vehicles.empty() && !std::isnan(ears.snapshot->vehicles[0].state.roll));
    QVERIFY(ears.snapshot->pendingApproval.empty());
    QVERIFY(!ears.snapshot->vehicles[0].session);
}

void PlainStationTest::recordingApprovesNoVehicle()
{
    // A vehicle that awaits approval stays listed while a recording with its system id is shown.
    FlightRig rig;
    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    QUdpSocket vehicle;
    vehicle.writeDatagram(clearHeartbeat(1, 1, false), QHostAddress::LocalHost, ground.port());
    EVENTUALLY_EQUAL(ground.ears->snapshot->pendingApproval.size(), std::size_t(1));
    QTemporaryDir folder;
    QFile log(folder.filePath(QStringLiteral("flight.tlog")));
    QVERIFY(log.open(QIODevice::WriteOnly));
    QVERIFY(log.write(recordedHeartbeats(1, 10)) > 0);
    log.close();
    ground.station->addLink(urlOf("tlog:" + log.fileName().toStdString()));
    EVENTUALLY_EQUAL(ground.ears->snapshot->vehicles.size(), std::size_t(1));
    QCOMPARE(ground.ears->snapshot->pendingApproval.size(), std::size_t(1));
    for (const engine::LinkSnapshot &link : ground.ears->snapshot->links)
        QCOMPARE(link.recording, link.url.starts_with("tlog:"));
}

void PlainStationTest::pendingVehicleIsNotReportedAsAnAttack()
{
    FlightRig rig;
    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    QUdpSocket vehicle;
    for (int i = 0; i < 20; ++i)
        vehicle.writeDatagram(clearHeartbeat(1, 1, false), QHostAddress::LocalHost, ground.port());
    EVENTUALLY_EQUAL(ground.ears->snapshot->plaintextRefused, std::uint64_t(20));
    const auto newest = [&] {
        const auto &samples = ground.ears->snapshot->samples;
        return samples.empty() ? 0 : samples.back().number;
    };
    const std::uint64_t before = newest();
    EVENTUALLY(newest() > before + 1);
    QCOMPARE(ground.ears->snapshot->samples.back().refused, std::uint64_t(0));
    QCOMPARE(ground.ears->snapshot->channel.rx.plaintextDropped, std::uint64_t(0));
}

void PlainStationTest::noVehicleNeedsApprovalWithoutPeers()
{
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    Ground ground(config);
    QUdpSocket vehicle;
    vehicle.writeDatagram(clearHeartbeat(1, 1, false), QHostAddress::LocalHost, ground.port());
    EVENTUALLY_EQUAL(ground.ears->snapshot->pendingApproval.size(), std::size_t(1));
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    ground.station->setPeers({});
    const auto stillNamed = [&] {
        const auto &pendingApproval = ground.ears->snapshot->pendingApproval;
        return std::ranges::any_of(pendingApproval, [](const engine::PendingVehicle &one) { return !one.mayBe.empty(); });
    };
    EVENTUALLY(!stillNamed());
    QVERIFY(ground.ears->snapshot->pendingApproval.empty()); // nor shown as an impostor of ""
}

void PlainStationTest::takenPortIsNamed()
{
    auto first = engine::Station::create(plainConfig());
    auto second = engine::Station::create(plainConfig());
    StationEars firstEars(**first), secondEars(**second);
    (*first)->addLink(urlOf("udpin:127.0.0.1:0"));
    EVENTUALLY(!firstEars.listening().empty());
    const std::string address = firstEars.listening();
    (*second)->addLink(urlOf("udpin:" + address));
    const auto failed = [&secondEars] {
        for (const engine::LinkChanged &changed : secondEars.all<engine::LinkChanged>()) {
            if (changed.link.phase == engine::LinkPhase::Failed)
                return changed.link;
        }
        return engine::LinkSnapshot{};
    };
    EVENTUALLY(failed().addressInUse);
    const std::string port = ":" + std::to_string(portOf(address));
    QVERIFY2(failed().problem.text().find(port) != std::string::npos, failed().problem.text().c_str());
}

namespace {

/// Heartbeats of a ground station among the datagrams that wait in a socket.
int gcsHeartbeats(QUdpSocket &socket)
{
    int out = 0;
    while (socket.hasPendingDatagrams()) {
        QByteArray datagram(static_cast<qsizetype>(socket.pendingDatagramSize()), 0);
        socket.readDatagram(datagram.data(), datagram.size());
        const ByteView bytes(reinterpret_cast<const std::uint8_t *>(datagram.constData()),
                             static_cast<std::size_t>(datagram.size()));
        const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        out += frame && frame->messageId() == 0 && frame->systemId() == 255;
    }
    return out;
}

/// An engine that listens on a port of its own.
struct ListeningCore
{
    ListeningCore()
    {
        core.addLink(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
        if (!eventually([this] { return link.phase == engine::LinkPhase::Listening; }))
            qFatal("no link");
    }
    quint16 port() const { return portOf(link.localAddress); }

    engine::LinkSnapshot link;
    std::shared_ptr<const engine::Snapshot> newest;
    engine::StationCore core{plainConfig(),
                             nullptr,
                             {[this](const auto &snapshot) { newest = snapshot; },
                              [this](const engine::Event &event) {
                                  if (const auto *changed = std::get_if<engine::LinkChanged>(&event))
                                      link = changed->link;
                              }}};
};

} // namespace

void PlainStationTest::heartbeatStopsIfTheReaderHangs()
{
    QUdpSocket remote;
    QVERIFY(remote.bind(QHostAddress::LocalHost, 0));
    engine::StationCore core(plainConfig(), nullptr, {[](const auto &) {}, [](const auto &) {}});
    core.addLink(LinkId{1}, urlOf("udpout:127.0.0.1:" + std::to_string(remote.localPort())));
    int heard = 0;
    QVERIFY(eventually([&] { return (heard += gcsHeartbeats(remote)) >= 2; }));
    core.setReaderAlive(false);
    gcsHeartbeats(remote);
    QVERIFY(!QTest::qWaitFor([&] { return gcsHeartbeats(remote) > 0; }, 2500));
    core.setReaderAlive(true);
    QVERIFY(eventually([&] { return gcsHeartbeats(remote) > 0; }));
}

void PlainStationTest::noTargetWithoutAHeartbeat()
{
    ListeningCore station;
    QUdpSocket noise;
    QVERIFY(noise.bind(QHostAddress::LocalHost, 0));
    noise.writeDatagram("anybody there?", QHostAddress::LocalHost, station.port());
    QVERIFY(!QTest::qWaitFor([&] { return noise.hasPendingDatagrams(); }, 1500));
}

/// An agent that can seal announces itself to every station.
void PlainStationTest::announcementsAreNotCountedAsMalformed()
{
    ListeningCore station;
    QUdpSocket agent;
    QVERIFY(agent.bind(QHostAddress::LocalHost, 0));
    const QByteArray announcement = QByteArray(1, 0x58) + QByteArray(32, 0x33) + QByteArray(94, 0);
    for (int i = 0; i < 3; ++i)
        agent.writeDatagram(announcement, QHostAddress::LocalHost, station.port());
    agent.writeDatagram(announcement.chopped(1), QHostAddress::LocalHost, station.port()); // none of any version
    const auto &newest = station.newest;
    EVENTUALLY(newest && !newest->links.empty() && newest->links[0].rxDatagrams == 4);
    QCOMPARE(newest->channel.rx.malformed, std::uint64_t(1));
}

/// Every kind of request ends in its own result, with the id that perform() returned.
void PlainStationTest::requestToAnUnknownVehicleFails()
{
    FlightRig rig;
    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    const std::vector<vehicle::Request> requests{vehicle::VehicleCommand(vehicle::Land{}),
                                                 vehicle::ReadParameters{},
                                                 vehicle::ReadParameter{"RTL_ALT"},
                                                 vehicle::WriteParameter{"RTL_ALT", 30},
                                                 vehicle::ListFolder{},
                                                 vehicle::ReadFile{},
                                                 vehicle::WriteFile{},
                                                 vehicle::RemoveFile{},
                                                 vehicle::ListLogs{},
                                                 vehicle::ReadLog{},
                                                 vehicle::EraseLogs{},
                                                 vehicle::CancelTransfer{},
                                                 vehicle::ReadMission{},
                                                 vehicle::WriteMission{},
                                                 vehicle::ClearMission{}};
    QCOMPARE(requests.size(), std::variant_size_v<vehicle::RequestVariant>);
    std::vector<vehicle::RequestId> ids;
    for (const vehicle::Request &request : requests)
        ids.push_back(ground.station->perform(7, request));
    EVENTUALLY_EQUAL(ground.ears->all<vehicle::MissionResult>().size(), std::size_t(3)); // in order, so the last
    const std::string reason = "no vehicle with system ID 7";
    const auto commands = ground.ears->all<vehicle::CommandResult>();
    QCOMPARE(commands.size(), std::size_t(1));
    QVERIFY(commands[0].id == ids[0] && commands[0].outcome == vehicle::CommandOutcome::Refused);
    QCOMPARE(commands[0].reason.text(), reason);
    const auto parameters = ground.ears->all<vehicle::ParameterResult>();
    QCOMPARE(parameters.size(), std::size_t(3));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        QVERIFY(parameters[i].id == ids[1 + i] && !parameters[i].ok && parameters[i].reason.text() == reason);
    QCOMPARE(parameters[1].parameter.name, std::string("RTL_ALT"));
    QCOMPARE(parameters[2].parameter.name, std::string("RTL_ALT"));
    const auto files = ground.ears->all<vehicle::FileResult>();
    QCOMPARE(files.size(), std::size_t(5)); // the cancellation among them
    for (std::size_t i = 0; i < files.size(); ++i)
        QVERIFY(files[i].id == ids[i < 4 ? 4 + i : 11] && !files[i].ok && files[i].reason.text() == reason);
    const auto logs = ground.ears->all<vehicle::LogResult>();
    QCOMPARE(logs.size(), std::size_t(3));
    for (std::size_t i = 0; i < logs.size(); ++i)
        QVERIFY(logs[i].id == ids[8 + i] && !logs[i].ok && logs[i].reason.text() == reason);
    const auto missions = ground.ears->all<vehicle::MissionResult>();
    for (std::size_t i = 0; i < missions.size(); ++i)
        QVERIFY(missions[i].id == ids[12 + i] && !missions[i].ok && missions[i].reason.text() == reason);
    QCOMPARE(int(missions[2].transfer), int(vehicle::MissionTransfer::Clear));
}

/// Another station uploads a mission to the vehicle: the snapshot says so, and nothing is written over it.
void PlainStationTest::missionOfAnotherStationIsMarked()
{
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    Ground ground(config);
    QUdpSocket vehicle;
    mavlink::FrameWriter writer(1, 1);
    const auto send = [&](const auto &message) {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = writer.write(message, buffer);
        vehicle.writeDatagram(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()),
                              QHostAddress::LocalHost, ground.port());
    };
    const auto outdated = [&]() -> std::string {
        const auto &vehicles = ground.ears->snapshot->vehicles;
        return vehicles.empty() ? "no vehicle" : vehicles[0].missionOutdated.text();
    };
    vehicle.writeDatagram(clearHeartbeat(1, 1, false), QHostAddress::LocalHost, ground.port());
    mavlink::MissionCurrent current;
    current.total = 3;
    current.mission_state = mavlink::MISSION_STATE_NOT_STARTED;
    current.mission_id = 10;
    send(current);
    EVENTUALLY_EQUAL(outdated(), std::string());
    current.mission_id = 20;
    send(current);
    EVENTUALLY_EQUAL(outdated(), std::string("changed by another station"));
    ground.station->perform(1, vehicle::WriteMission{{vehicle::MissionItem{}}});
    EVENTUALLY(!ground.ears->all<vehicle::MissionResult>().empty());
    const auto result = ground.ears->all<vehicle::MissionResult>()[0];
    QVERIFY(!result.ok);
    QVERIFY2(result.reason.text().starts_with("nothing was sent: "), result.reason.text().c_str());
}

SKYSEAL_TEST(PlainStationTest)
#include "plain_station_test.moc"
