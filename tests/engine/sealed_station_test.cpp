// Station, agent and vehicle over real sockets: the session comes up, carries everything while suites change, returns after a
// restart, and passes only what is allowed.
#include "core/engine/station/snapshot.h"
#include "tests/engine/ground.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include "core/crypto/suite.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "core/log/link_events.h"
#include "tests/support/heartbeat.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Whether the agent received the goodbye of a station.
bool wasClosedByTheStation(const FlightRig &rig)
{
    return std::ranges::any_of(rig.agentEvents, [](const engine::AgentEvent &event) {
        const auto *common = std::get_if<channel::Event>(&event);
        const auto *down = common ? std::get_if<channel::SessionDown>(common) : nullptr;
        return down && down->reason == channel::DownReason::PeerClosed;
    });
}

} // namespace

class SealedStationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sessionComesUp();
    void carriesEverythingWhileSuitesChange();
    void returnsAfterTheAgentWasKilled();
    void clearFramesOfAPinnedVehicleAreRefused();
    void clearFramesAreRefusedAfterARestartAsWell();
    void recordingOfASealedVehicleIsShown();
    void switchesAreNotedBesideTheRecording();
    void systemOfAnotherPeerIsRefusedAndReported();
    void observerCannotCommand();
    void pilotCanCommand();
    void unknownStationGetsNothing();
    void agentThatDoesNotKnowUsIsNamed();
    void lastSnapshotKeepsTheCounts();
    void destructionSaysGoodbye();
};

void SealedStationTest::sessionComesUp()
{
    FlightRig rig;
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up());
    QCOMPARE(ground.ears->all<channel::SessionUp>()[0].peerName, std::string("air-1"));
    EVENTUALLY_EQUAL(int(ground.ears->snapshot->security), int(engine::Security::Sealed));
}

void SealedStationTest::carriesEverythingWhileSuitesChange()
{
    FlightRig rig;
    auto config = rig.stationConfig();
    config.streamRate = 50;
    Ground ground(std::move(config));
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->snapshot->vehicles.empty());

    const channel::SessionId session = ground.ears->all<channel::SessionUp>()[0].session;
    std::size_t switches = 0;
    for (int round = 0; round < 3; ++round) {
        for (const crypto::SuiteInfo &info : crypto::suites()) {
            if (!info.authenticated || (round == 0 && info.id == crypto::SuiteId::ChaCha20Poly1305))
                continue;
            ground.station->switchSuite(session, info.id);
            ++switches;
            EVENTUALLY_EQUAL(ground.ears->all<channel::SwitchDone>().size(), switches);
            const channel::SwitchDone done = ground.ears->all<channel::SwitchDone>().back();
            QCOMPARE(int(done.to), int(info.id));
            QCOMPARE(int(done.failure), int(channel::SwitchFailure::None));
            const std::uint64_t frames = ground.ears->snapshot->mavlink.frames;
            EVENTUALLY(ground.ears->snapshot->mavlink.frames > frames + 20);
        }
    }
    const engine::Snapshot &seen = *ground.ears->snapshot;
    QCOMPARE(seen.mavlink.lost, std::uint64_t(0));
    QCOMPARE(seen.mavlink.duplicate, std::uint64_t(0));
    QCOMPARE(seen.channel.rx.lost, std::uint64_t(0));
    QCOMPARE(seen.channel.rx.forged, std::uint64_t(0));
    QVERIFY(seen.vehicles[0].session.has_value());
    QVERIFY(!seen.samples.empty());
}

void SealedStationTest::returnsAfterTheAgentWasKilled()
{
    FlightRig rig;
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up());
    const std::string vehicleAddress = rig.vehicleAddress();
    VehicleOnUdp vehicle(vehicleAddress);
    EVENTUALLY(!ground.ears->snapshot->vehicles.empty());

    const std::uint64_t before = ground.ears->snapshot->channel.rx.good;
    QVERIFY(before > 0);
    rig.killAgent();
    rig.startAgent(ground.ears->listening());
    QCOMPARE(rig.vehicleAddress(), vehicleAddress);
    EVENTUALLY_EQUAL(ground.ears->all<channel::SessionUp>().size(), std::size_t(2));
    const std::uint64_t frames = ground.ears->snapshot->mavlink.frames;
    EVENTUALLY(ground.ears->snapshot->mavlink.frames > frames);
    // Data received before the restart is kept.
    QVERIFY(ground.ears->snapshot->channel.rx.good > before);
}

void SealedStationTest::clearFramesOfAPinnedVehicleAreRefused()
{
    FlightRig rig(channel::PeerRole::Pilot, {1});
    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    VehicleOnUdp impostor(ground.ears->listening(), 1);
    EVENTUALLY(!ground.ears->all<engine::PlaintextRefused>().empty());
    QCOMPARE(int(ground.ears->all<engine::PlaintextRefused>()[0].systemId), 1);
    EVENTUALLY(ground.ears->snapshot->plaintextRefused > 0);
    QVERIFY(ground.ears->snapshot->vehicles.empty());
    QVERIFY(ground.ears->snapshot->channel.rx.plaintextDropped > 0);

    // Another vehicle, whose system id is not bound to a key, is shown as plain.
    VehicleOnUdp other(ground.ears->listening(), 2);
    EVENTUALLY_EQUAL(ground.ears->all<engine::VehicleFound>().size(), std::size_t(1));
    QCOMPARE(int(ground.ears->all<engine::VehicleFound>()[0].systemId), 2);
    QVERIFY(!ground.ears->all<engine::VehicleFound>()[0].sealed);
}

void SealedStationTest::clearFramesAreRefusedAfterARestartAsWell()
{
    FlightRig rig; // the agent's key is bound to no system: its system id is learned
    {
        Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
        rig.startAgent(ground.ears->listening());
        VehicleOnUdp vehicle(rig.vehicleAddress());
        EVENTUALLY(!ground.ears->snapshot->vehicles.empty());
        QVERIFY(ground.ears->all<engine::VehicleFound>()[0].sealed);
        std::shared_ptr<const engine::Snapshot> last;
        connect(ground.station.get(), &engine::Station::stopped, this,
                [&last](const std::shared_ptr<const engine::Snapshot> &snapshot) { last = snapshot; });
        ground.station->stop();
        EVENTUALLY(last);
    }
    rig.killAgent();
    Ground again(rig.stationConfig(engine::SecureMode::Preferred));
    VehicleOnUdp impostor(again.ears->listening(), 1);
    EVENTUALLY(!again.ears->all<engine::PlaintextRefused>().empty());
    QVERIFY(again.ears->snapshot->vehicles.empty());
}

void SealedStationTest::recordingOfASealedVehicleIsShown()
{
    FlightRig rig(channel::PeerRole::Pilot, {1});
    QTemporaryDir folder;
    const QString log = folder.filePath(QStringLiteral("flight.tlog"));
    QFile file(log);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write(recordedHeartbeats(1, 600)) > 0);
    file.close();

    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    ground.station->addLink(urlOf("tlog:" + log.toStdString()));
    EVENTUALLY_EQUAL(ground.ears->snapshot->vehicles.size(), std::size_t(1));
    QVERIFY(!ground.ears->all<engine::VehicleFound>()[0].sealed);

    // While the vehicle is live, a recording is not mixed into its state.
    Ground flying(rig.stationConfig(engine::SecureMode::Preferred));
    rig.startAgent(flying.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY_EQUAL(flying.ears->snapshot->vehicles.size(), std::size_t(1));
    flying.station->addLink(urlOf("tlog:" + log.toStdString()));
    EVENTUALLY_EQUAL(flying.ears->snapshot->plaintextRefused, std::uint64_t(600));
    QVERIFY(flying.ears->all<engine::VehicleFound>()[0].sealed);

    // Nor does a recording replace its last state and the message that its session was lost.
    rig.agent->stop();
    EVENTUALLY(flying.ears->snapshot->vehicles[0].ended);
    const std::uint64_t messages = flying.ears->snapshot->vehicles[0].state.sequence.frames;
    flying.station->addLink(urlOf("tlog:" + log.toStdString()));
    EVENTUALLY_EQUAL(flying.ears->snapshot->plaintextRefused, std::uint64_t(1200));
    QVERIFY(flying.ears->snapshot->vehicles[0].ended);
    QVERIFY(flying.ears->snapshot->vehicles[0].session);
    QCOMPARE(flying.ears->snapshot->vehicles[0].state.sequence.frames, messages);
}

void SealedStationTest::switchesAreNotedBesideTheRecording()
{
    using enum tlog::LinkEvent::Kind;
    FlightRig rig;
    QTemporaryDir folder;
    engine::StationConfig config = rig.stationConfig();
    config.recordFolder = folder.path().toStdString();
    config.record = true;
    Ground ground(config);
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(ground.ears->snapshot->recording.frames > 0);
    const auto switchTo = [&](crypto::SuiteId suite) {
        const std::size_t before = ground.ears->all<channel::SwitchDone>().size();
        ground.station->switchSuite(ground.ears->all<channel::SessionUp>()[0].session, suite);
        return test::eventually([&] { return ground.ears->all<channel::SwitchDone>().size() > before; });
    };
    QVERIFY(switchTo(crypto::SuiteId::Aes256Gcm));
    QVERIFY(switchTo(crypto::SuiteId::Aes256Gcm)); // fresh keys are no switch
    QVERIFY(switchTo(crypto::SuiteId::ChaCha20Poly1305));
    const std::string first = ground.ears->snapshot->recording.file;
    ground.station->setRecording(false);
    EVENTUALLY(!ground.ears->snapshot->recording.active);
    const auto is = [](const tlog::LinkEvent &event, tlog::LinkEvent::Kind kind, const char *suite) {
        return event.kind == kind && event.suite == suite && event.peer == "air-1";
    };
    tlog::LinkEvents noted = tlog::linkEventsOf(first);
    QCOMPARE(noted.unreadable, std::uint64_t(0));
    QCOMPARE(noted.events.size(), std::size_t(3));
    QVERIFY(is(noted.events[0], Sealed, "chacha20-poly1305"));
    QVERIFY(is(noted.events[1], Switched, "aes-256-gcm"));
    QVERIFY(is(noted.events[2], Switched, "chacha20-poly1305"));

    // Another recording begins with the suite that is in use.
    QVERIFY(switchTo(crypto::SuiteId::Aes256Gcm));
    ground.station->setRecording(true);
    EVENTUALLY(ground.ears->snapshot->recording.frames > 0);
    const std::string second = ground.ears->snapshot->recording.file;
    ground.station->setRecording(false);
    EVENTUALLY(!ground.ears->snapshot->recording.active);
    QVERIFY(second != first);
    noted = tlog::linkEventsOf(second);
    QCOMPARE(noted.events.size(), std::size_t(1));
    QVERIFY(is(noted.events[0], Sealed, "aes-256-gcm"));
}

void SealedStationTest::systemOfAnotherPeerIsRefusedAndReported()
{
    // Another agent, which is silent now, was heard as system 1 in an earlier run.
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig();
    auto peers = keys::PeersFile::load(config.keys.peers);
    QVERIFY(peers);
    keys::PeerEntry owner;
    owner.peer.name = "air-0";
    owner.peer.key = peers->peers()[0].key;
    owner.peer.key[5] ^= 1;
    engine::SealedSystems systems;
    systems[owner.peer.key].set(1);
    QVERIFY(peers->add(owner) && peers->save(config.keys.peers));
    QVERIFY(engine::writeSealedSystems(engine::sealedSystemsFile(config.keys), systems));

    Ground ground(config);
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->all<engine::SystemRefused>().empty());
    const engine::SystemRefused told = ground.ears->all<engine::SystemRefused>()[0];
    QCOMPARE(int(told.systemId), 1);
    QCOMPARE(told.peer, std::string("air-1"));
    QCOMPARE(told.owner, std::string("air-0"));
    EVENTUALLY(ground.ears->snapshot->spoofed > 20);
    QVERIFY(ground.ears->snapshot->vehicles.empty());
    // A refusal just before the end of its session is published with the same names.
    rig.agent->stop();
    EVENTUALLY(!ground.ears->all<channel::SessionDown>().empty());
    const auto frames = [&ground] {
        std::uint64_t out = 0;
        for (const engine::SystemRefused &refused : ground.ears->all<engine::SystemRefused>())
            out += refused.frames;
        return out;
    };
    EVENTUALLY(frames() > 1 && frames() == ground.ears->snapshot->spoofed);
    for (const engine::SystemRefused &refused : ground.ears->all<engine::SystemRefused>()) {
        QCOMPARE(refused.peer, told.peer);
        QCOMPARE(refused.owner, told.owner);
    }
}

void SealedStationTest::observerCannotCommand()
{
    FlightRig rig(channel::PeerRole::Observer);
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->snapshot->vehicles.empty());
    ground.station->perform(1, vehicle::SetMode{"GUIDED"});
    EVENTUALLY(!ground.ears->all<vehicle::CommandResult>().empty());
    const vehicle::CommandResult result = ground.ears->all<vehicle::CommandResult>()[0];
    QCOMPARE(int(result.outcome), int(vehicle::CommandOutcome::TimedOut));
    QVERIFY2(result.reason.text().starts_with("no answer to 5 attempts; ")
                 && result.reason.text().find("observer") != std::string::npos,
             result.reason.text().c_str());
    ground.station->perform(1, vehicle::WriteParameter{"FS_GCS_ENABLE", 0});
    EVENTUALLY(!ground.ears->all<vehicle::ParameterResult>().empty());
    const vehicle::ParameterResult written = ground.ears->all<vehicle::ParameterResult>()[0];
    QVERIFY2(!written.ok && written.reason.text().find("observer") != std::string::npos, written.reason.text().c_str());
    const engine::AgentSnapshot agent = rig.agent->snapshot();
    QVERIFY(agent.counters.observerRefused > 0);
    QCOMPARE(int(vehicle.vehicle.autopilot().modes().current()), int(sim::FlightMode::Stabilize));
}

void SealedStationTest::pilotCanCommand()
{
    FlightRig rig;
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->snapshot->vehicles.empty());
    const vehicle::RequestId id = ground.station->perform(1, vehicle::SetMode{"ALT_HOLD"});
    EVENTUALLY(!ground.ears->all<vehicle::CommandResult>().empty());
    QCOMPARE(int(ground.ears->all<vehicle::CommandResult>()[0].outcome), int(vehicle::CommandOutcome::Accepted));
    QVERIFY(ground.ears->all<vehicle::CommandResult>()[0].id == id);
    EVENTUALLY_EQUAL(ground.ears->snapshot->vehicles[0].state.mode, std::string("ALT_HOLD"));
}

void SealedStationTest::unknownStationGetsNothing()
{
    FlightRig rig, stranger;
    Ground ground(stranger.stationConfig()); // knows other keys
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->all<channel::HandshakeRefused>().empty());
    QVERIFY(!ground.up());
    QVERIFY(ground.ears->snapshot->vehicles.empty());
    // It keeps announcing itself, which snapshots show and one event reports.
    const auto unknown = [&ground] { return ground.ears->snapshot->unknownAgents; };
    EVENTUALLY_EQUAL(unknown().size(), std::size_t(1));
    QVERIFY(unknown()[0].remoteAddress.starts_with("127.0.0.1:"));
    const double then = ground.ears->snapshot->time;
    EVENTUALLY(ground.ears->snapshot->time > then + 3.5);
    QCOMPARE(ground.ears->all<channel::HandshakeRefused>().size(), std::size_t(1));
    QCOMPARE(unknown().size(), std::size_t(1));
    QCOMPARE(rig.agent->snapshot().counters.toGround, std::uint64_t(0));
}

void SealedStationTest::agentThatDoesNotKnowUsIsNamed()
{
    FlightRig rig;
    rig.introduceStation(false);
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    const auto told = [&ground] { return ground.ears->all<engine::AgentUnanswering>(); };
    EVENTUALLY(!told().empty());
    QVERIFY(!told()[0].over);
    QCOMPARE(told()[0].agent.peerName, std::string("air-1"));
    QVERIFY(told()[0].agent.remoteAddress.starts_with("127.0.0.1:"));
    EVENTUALLY_EQUAL(ground.ears->snapshot->unanswering.size(), std::size_t(1));
    // The fingerprint equals the one that the agent reported when it refused this station.
    QVERIFY(std::any_of(rig.agentEvents.begin(), rig.agentEvents.end(), [&](const engine::AgentEvent &event) {
        const auto *channelEvent = std::get_if<channel::Event>(&event);
        const auto *refused = channelEvent ? std::get_if<channel::HandshakeRefused>(channelEvent) : nullptr;
        return refused && keys::fingerprint(refused->peer) == told()[0].agent.ownFingerprint;
    }));
    rig.introduceStation(true);
    rig.killAgent();
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up());
    EVENTUALLY(ground.ears->snapshot->unanswering.empty());
    EVENTUALLY_EQUAL(told().size(), std::size_t(2));
    QVERIFY(told()[1].over);
}

void SealedStationTest::lastSnapshotKeepsTheCounts()
{
    FlightRig rig;
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(ground.ears->snapshot->mavlink.frames > 5
               && ground.ears->snapshot->channel.rx.good > 5); // of several frames each
    std::shared_ptr<const engine::Snapshot> last;
    connect(ground.station.get(), &engine::Station::stopped, this,
            [&last](const std::shared_ptr<const engine::Snapshot> &snapshot) { last = snapshot; });
    ground.station->stop();
    EVENTUALLY(last);
    QVERIFY(last->mavlink.frames > 5);
    QVERIFY(last->channel.rx.good > 5);
    QVERIFY(last->channel.up);
    EVENTUALLY(wasClosedByTheStation(rig));
}

void SealedStationTest::destructionSaysGoodbye()
{
    FlightRig rig;
    {
        Ground ground(rig.stationConfig());
        rig.startAgent(ground.ears->listening());
        EVENTUALLY(ground.up());
    }
    EVENTUALLY(wasClosedByTheStation(rig));
}

SKYSEAL_TEST(SealedStationTest)
#include "sealed_station_test.moc"
