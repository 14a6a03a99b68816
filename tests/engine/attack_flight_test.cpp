// Attacks on a whole flight over real sockets: station, agent and a simulated autopilot, and an attacker on the wire between
// them who sends MAVLink as well as they do. The state of the autopilot and the display of the station must not change.
#include "core/engine/station/snapshot.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/engine/ground.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

#include <QtCore/QTimer>
#include <QtTest/QTest>

#include <functional>
#include <map>
#include <set>
#include <numeric>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// A flight with an attacker between agent and station.
struct AttackedFlight
{
    explicit AttackedFlight(channel::PeerRole role = channel::PeerRole::Pilot,
                            const std::function<engine::StationConfig(engine::StationConfig)> &adjust = {},
                            std::vector<std::uint8_t> stationSystems = {})
        : rig(role, {}, std::move(stationSystems)), ground(adjust ? adjust(rig.stationConfig()) : rig.stationConfig()),
          attacker(ground.port())
    {
        rig.startAgent("127.0.0.1:" + std::to_string(attacker.port()));
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
    }
    bool flying() const { return ground.up() && vehicle->sent > 20; }
    sim::FlightMode mode() const { return vehicle->vehicle.autopilot().modes().current(); }
    bool untouched() const { return mode() == sim::FlightMode::Stabilize && !vehicle->vehicle.autopilot().armed(); }

    FlightRig rig;
    Ground ground;
    UdpAttacker attacker;
    std::unique_ptr<VehicleOnUdp> vehicle;
};

/// Arm by force, another mode, full throttle.
std::vector<QByteArray> hostileCommands(std::uint8_t systemId)
{
    using namespace mavlink;
    return {frameOf(CommandLong{.target_system = 1,
                                .target_component = 1,
                                .command = MAV_CMD_COMPONENT_ARM_DISARM,
                                .param1 = 1,
                                .param2 = 21196},
                    systemId),
            frameOf(SetMode{.target_system = 1, .base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, .custom_mode = 2}, systemId),
            frameOf(
                RcChannelsOverride{
                    .target_system = 1, .target_component = 1, .chan1_raw = 1900, .chan2_raw = 1100, .chan3_raw = 2000},
                systemId)};
}

/// A pilot's flight with this system id of the station; the agent's list binds the station to `bound`, or to none (0).
AttackedFlight withStationId(int systemId, int bound)
{
    return AttackedFlight(
        channel::PeerRole::Pilot,
        [systemId](engine::StationConfig config) {
            config.systemId = static_cast<std::uint8_t>(systemId);
            return config;
        },
        bound ? std::vector<std::uint8_t>{static_cast<std::uint8_t>(bound)} : std::vector<std::uint8_t>{});
}

} // namespace

class AttackFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void injectionReachesNoAutopilot();
    void clearBytesAreNotSearched_data();
    void clearBytesAreNotSearched();
    void observerCommandsNothing();
    void nobodySpeaksAsAnother_data();
    void nobodySpeaksAsAnother();
    void pilotsIdIsNotTaken_data();
    void pilotsIdIsNotTaken();
    void spoofedTelemetryIsNotShown();
    void blockedHandshakesOpenNoClearWay_data();
    void blockedHandshakesOpenNoClearWay();
    void nothingReadableOnTheWire();
    void strangersCauseOneEventASecond_data();
    void strangersCauseOneEventASecond();
};

void AttackFlightTest::injectionReachesNoAutopilot()
{
    AttackedFlight flight;
    EVENTUALLY(flight.flying() && !flight.ground.ears->snapshot->vehicles.empty());
    const std::uint64_t before = flight.rig.agent->snapshot().counters.clearRefused;
    // In clear, under the station's own system id and others, and inside what looks like a record of this session.
    QByteArray record;
    for (const UdpAttacker::Seen &seen : flight.attacker.seen) {
        if (!seen.toGround && (seen.bytes[0] & 0xfc) == 0x50)
            record = seen.bytes;
    }
    QVERIFY(!record.isEmpty());
    std::uint64_t sent = 0, forged = 0;
    for (int round = 0; round < 50; ++round) {
        for (const std::uint8_t systemId : {255, 254, 1, 42}) {
            for (const QByteArray &command : hostileCommands(systemId)) {
                flight.attacker.toAgent(command);
                flight.attacker.toAgent(record.left(6) + command);
                ++sent, ++forged;
            }
        }
        EVENTUALLY(flight.rig.agent->snapshot().counters.clearRefused - before == sent || !flight.untouched());
        if (!flight.untouched())
            break;
    }
    HOLDS(flight.untouched(), "the autopilot's state never changes");
    const engine::AgentSnapshot agent = flight.rig.agent->snapshot();
    QCOMPARE(agent.counters.clearRefused - before, sent);
    QCOMPARE(agent.channel.rx.forged + agent.channel.rx.replayed, forged);
    QCOMPARE(flight.ground.ears->all<channel::SessionUp>().size(), std::size_t(1));
    // And the station's own command still arrives.
    flight.ground.station->perform(1, vehicle::SetMode{"ALT_HOLD"});
    EVENTUALLY(flight.mode() == sim::FlightMode::AltHold);
}

void AttackFlightTest::clearBytesAreNotSearched_data()
{
    QTest::addColumn<QByteArray>("datagram");
    QTest::newRow("all 0xFE") << QByteArray(1400, '\xfe');
    QTest::newRow("all 0xFD") << QByteArray(1400, '\xfd');
    QTest::newRow("half a frame") << hostileCommands(255).front().chopped(10);
}

void AttackFlightTest::clearBytesAreNotSearched()
{
    QFETCH(QByteArray, datagram);
    AttackedFlight flight;
    EVENTUALLY(flight.flying());
    const auto now = [&] { return flight.rig.agent->snapshot().counters; };
    const auto searched = [](const engine::AgentCounters &at) { return at.unusable + at.toVehicle + at.undelivered; };
    const engine::AgentCounters before = now();
    for (int i = 0; i < 200; ++i)
        flight.attacker.toAgent(datagram);
    EVENTUALLY(now().clearRefused >= before.clearRefused + 200 || searched(now()) >= searched(before) + 200);
    HOLDS(now().clearRefused == before.clearRefused + 200, "clear bytes are counted and not searched");
    QVERIFY(flight.untouched());
}

void AttackFlightTest::observerCommandsNothing()
{
    AttackedFlight flight(channel::PeerRole::Observer);
    EVENTUALLY(flight.flying());
    EVENTUALLY(!flight.ground.ears->snapshot->vehicles.empty());
    const auto refused = [&] { return flight.rig.agent->snapshot().counters.observerRefused; };
    const std::uint64_t before = refused();
    flight.ground.station->perform(1, vehicle::SetMode{"ALT_HOLD"});
    flight.ground.station->perform(1, vehicle::Arm{true});
    // The commands are repeated; heartbeats are refused among them, and harmless questions are not.
    EVENTUALLY(!flight.untouched() || refused() >= before + 10);
    HOLDS(flight.untouched(), "an observer moves nothing");
}

void AttackFlightTest::nobodySpeaksAsAnother_data()
{
    QTest::addColumn<int>("systemId");
    QTest::addColumn<int>("bound"); // by the agent's list; 0: to none
    QTest::newRow("as the vehicle itself") << 1 << 0;
    QTest::newRow("as another system than the list binds it to") << 254 << 255;
}

void AttackFlightTest::nobodySpeaksAsAnother()
{
    // A pilot's station that is known and sealed.
    QFETCH(int, systemId);
    QFETCH(int, bound);
    AttackedFlight flight = withStationId(systemId, bound);
    // The agent knows its vehicle before the station is there.
    flight.attacker.passes = [](const UdpAttacker::Seen &) { return false; };
    EVENTUALLY(flight.rig.agent->snapshot().mavlink.frames > 100);
    flight.attacker.passes = {};
    EVENTUALLY(flight.flying());
    EVENTUALLY(flight.rig.agent->snapshot().counters.spoofRefused > 0 || flight.rig.agent->snapshot().counters.toVehicle > 0);
    flight.ground.station->perform(1, vehicle::Arm{true});
    EVENTUALLY(flight.rig.agent->snapshot().counters.spoofRefused > 3 || flight.rig.agent->snapshot().counters.toVehicle > 0);
    HOLDS(flight.rig.agent->snapshot().counters.toVehicle == 0, "nothing of it reaches the autopilot");
    QVERIFY(flight.untouched());
}

void AttackFlightTest::pilotsIdIsNotTaken_data()
{
    QTest::addColumn<int>("systemId");
    QTest::addColumn<int>("bound"); // by the agent's list; 0: to none
    QTest::addColumn<bool>("early");
    QTest::newRow("the customary id, before the station is there") << 255 << 0 << true;
    QTest::newRow("an id of the list, before the station is there") << 7 << 7 << true;
    QTest::newRow("an id that the pilot uses") << 42 << 0 << false;
}

void AttackFlightTest::pilotsIdIsNotTaken()
{
    // A device beside the autopilot claims to be a vehicle with the system id of the pilot's station.
    QFETCH(int, systemId);
    QFETCH(int, bound);
    QFETCH(bool, early);
    AttackedFlight flight = withStationId(systemId, bound);
    const auto counters = [&] { return flight.rig.agent->snapshot().counters; };
    if (early)
        flight.attacker.passes = [](const UdpAttacker::Seen &) { return false; };
    else
        EVENTUALLY(flight.flying() && counters().toVehicle > 0);
    const std::uint64_t before = flight.rig.agent->snapshot().mavlink.frames;
    QUdpSocket rogue;
    const QByteArray claim = clearHeartbeat(static_cast<std::uint8_t>(systemId), 1, false);
    rogue.writeDatagram(claim, QHostAddress::LocalHost, portOf(flight.rig.vehicleAddress()));
    EVENTUALLY(counters().groundIdRefused > 0 || flight.rig.agent->snapshot().mavlink.frames > before + 50);
    flight.attacker.passes = {};
    EVENTUALLY(flight.flying() && !flight.ground.ears->snapshot->vehicles.empty());
    flight.ground.station->perform(1, vehicle::SetMode{"ALT_HOLD"});
    EVENTUALLY(flight.mode() == sim::FlightMode::AltHold || counters().spoofRefused > 3);
    HOLDS(flight.mode() == sim::FlightMode::AltHold, "the pilot is not locked out");
    QCOMPARE(counters().groundIdRefused, std::uint64_t(1));
    QCOMPARE(flight.ground.ears->snapshot->vehicles.size(), std::size_t(1)); // the claim is not shown as a vehicle
    const auto isAlarm = [](const engine::AgentEvent &event) { return std::holds_alternative<engine::GroundIdClaimed>(event); };
    QCOMPARE(std::count_if(flight.rig.agentEvents.begin(), flight.rig.agentEvents.end(), isAlarm), 1);
}

void AttackFlightTest::spoofedTelemetryIsNotShown()
{
    AttackedFlight flight;
    EVENTUALLY(flight.flying() && !flight.ground.ears->snapshot->vehicles.empty());
    const std::uint64_t before = flight.ground.ears->snapshot->plaintextRefused;
    mavlink::Heartbeat heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                 .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA,
                                 .base_mode = 0x81,
                                 .system_status = mavlink::MAV_STATE_ACTIVE};
    for (const std::uint8_t systemId : {1, 2, 77}) {
        for (int i = 0; i < 20; ++i) {
            flight.attacker.toGround(frameOf(heartbeat, systemId, 1));
            flight.attacker.toGround(frameOf(mavlink::Attitude{.roll = 3}, systemId, 1));
        }
    }
    const auto shown = [&] { return flight.ground.ears->snapshot->vehicles.size() != 1; };
    EVENTUALLY(flight.ground.ears->snapshot->plaintextRefused - before == 120 || shown());
    HOLDS(!shown(), "the list of vehicles is unchanged");
    QVERIFY(!flight.ground.ears->snapshot->vehicles[0].state.armed);
    QVERIFY(!flight.ground.ears->all<engine::PlaintextRefused>().empty()); // published, not only counted
}

void AttackFlightTest::blockedHandshakesOpenNoClearWay_data()
{
    QTest::addColumn<bool>("bound");
    QTest::newRow("the list binds the agent to its system") << true;
    QTest::newRow("an agent that was never heard") << false;
}

void AttackFlightTest::blockedHandshakesOpenNoClearWay()
{
    // Sealed where it can be; from the start the attacker lets no handshake through, and offers a vehicle in clear.
    QFETCH(bool, bound);
    FlightRig rig(channel::PeerRole::Pilot, bound ? std::vector<std::uint8_t>{1} : std::vector<std::uint8_t>{});
    Ground ground(rig.stationConfig(engine::SecureMode::Preferred));
    UdpAttacker attacker(ground.port());
    attacker.passes = [](const UdpAttacker::Seen &) { return false; };
    rig.startAgent("127.0.0.1:" + std::to_string(attacker.port()));
    VehicleOnUdp vehicle(rig.vehicleAddress());
    VehicleOnUdp impostor(ground.ears->listening(), 1);
    const auto shown = [&] { return !ground.ears->snapshot->vehicles.empty(); };
    EVENTUALLY(ground.ears->snapshot->plaintextRefused > 20 || shown());
    HOLDS(!shown(), "no telemetry without an explicit act");
    ground.station->perform(1, vehicle::Arm{true});
    EVENTUALLY(!ground.ears->all<vehicle::CommandResult>().empty());
    QCOMPARE(int(ground.ears->all<vehicle::CommandResult>()[0].outcome), int(vehicle::CommandOutcome::Refused));
    QVERIFY(!impostor.vehicle.autopilot().armed());
    // The agent does not give in either: what its vehicle says stays here.
    EVENTUALLY(rig.agent->snapshot().counters.undelivered > 20);
    for (const UdpAttacker::Seen &seen : attacker.seen)
        QCOMPARE(framesIn(seen.bytes), std::size_t(0));
    // A person may take what is held back, but not what the list says is sealed.
    QCOMPARE(ground.ears->snapshot->pendingApproval.empty(), bound);
    ground.station->allowPlaintext(1);
    if (bound)
        QVERIFY(!QTest::qWaitFor(shown, 2500));
    else
        EVENTUALLY(shown());
}

void AttackFlightTest::nothingReadableOnTheWire()
{
    // A whole conversation with an eavesdropper, as at a router that copies to every sender of a heartbeat: telemetry,
    // all parameters, a mission.
    AttackedFlight flight(channel::PeerRole::Pilot, [](engine::StationConfig config) {
        config.preferredSuite = crypto::SuiteId::Aes256Ctr;
        return config;
    });
    EVENTUALLY(flight.flying() && !flight.ground.ears->snapshot->vehicles.empty());
    EVENTUALLY(flight.ground.ears->snapshot->channel.suite == crypto::SuiteId::Aes256Ctr);
    flight.attacker.seen.clear();
    flight.attacker.toGround(frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS}, 42));
    flight.ground.station->perform(1, vehicle::ReadParameters{});
    std::vector<vehicle::MissionItem> mission(5);
    for (std::size_t i = 0; i < mission.size(); ++i) {
        mission[i].sequence = static_cast<std::uint16_t>(i);
        mission[i].latitude = -35.363261;
        mission[i].longitude = 149.16523;
        mission[i].altitude = 20;
    }
    flight.ground.station->perform(1, vehicle::WriteMission{mission});
    EVENTUALLY(!flight.ground.ears->all<vehicle::MissionResult>().empty());
    QVERIFY(flight.ground.ears->all<vehicle::MissionResult>()[0].ok);
    EVENTUALLY(flight.attacker.seen.size() > 400);

    const auto coordinate = [](std::int32_t value) { return QByteArray(reinterpret_cast<const char *>(&value), 4); };
    const QByteArrayList known{coordinate(-353632610),
                               coordinate(1491652300),
                               "ARMING_CHECK",
                               "WPNAV_SPEED",
                               "STABILIZE",
                               "ArduCopter",
                               "EKF3 IMU0",
                               QByteArray::fromHex("fd09000000"),
                               QByteArray::fromHex("fd1c0000")};
    std::size_t readable = 0;
    for (const UdpAttacker::Seen &seen : flight.attacker.seen) {
        readable += framesIn(seen.bytes);
        for (const QByteArray &word : known)
            readable += seen.bytes.contains(word);
    }
    HOLDS(readable == 0, "nothing that is known is found on the wire");
    // The same search finds what an unsealed wire would carry.
    std::size_t found = framesIn(frameOf(mavlink::Heartbeat{}, 1));
    mavlink::MissionItemInt item{};
    item.x = -353632610;
    item.y = 1491652300;
    for (const QByteArray &word : known)
        found += frameOf(item, 255).contains(word);
    QCOMPARE(found, std::size_t(3));
}

void AttackFlightTest::strangersCauseOneEventASecond_data()
{
    QTest::addColumn<bool>("pairing");
    QTest::newRow("pairing closed") << false;
    QTest::newRow("pairing open at both ends") << true;
}

void AttackFlightTest::strangersCauseOneEventASecond()
{
    // All that a stranger can make an end report, from many addresses, at a station that expects one sealed vehicle and at an
    // agent with a session. An open pairing window reports others once a second besides.
    QFETCH(bool, pairing);
    AttackedFlight flight(channel::PeerRole::Pilot, [](engine::StationConfig config) {
        config.secure = engine::SecureMode::Preferred;
        return config;
    });
    EVENTUALLY(flight.flying() && !flight.ground.ears->snapshot->vehicles.empty());
    QByteArray toGround, toAgent;
    for (const UdpAttacker::Seen &seen : flight.attacker.seen) {
        if ((seen.bytes[0] & 0xfc) == 0x50)
            (seen.toGround ? toGround : toAgent) = seen.bytes;
    }
    // Under a counter that was not received yet, so that each comes as far as its tag.
    const auto forged = [](QByteArray record) { return record.replace(3, 3, QByteArray::fromHex("ffff3f")); };
    QByteArray otherVersion(127, 'v'), announcement(127, '\0'), first(127, 'f');
    otherVersion[0] = 0x69;
    announcement[0] = 0x58;
    first[0] = 0x59;
    const QByteArray heartbeat = frameOf(
        mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, 1);

    StrangersKnowledge knows;
    int pairingAtStation = 0;
    connect(flight.ground.station.get(), &engine::Station::pairing, this, [&] { ++pairingAtStation; });
    const auto pairingAtAgent = [&flight] {
        return std::count_if(flight.rig.agentEvents.begin(), flight.rig.agentEvents.end(), [](const engine::AgentEvent &event) {
            return std::holds_alternative<channel::PairingEvent>(event);
        });
    };
    if (pairing) {
        QVERIFY(flight.rig.agent->openPairing("air").has_value());
        flight.ground.station->openPairing("ground");
        EVENTUALLY(pairingAtStation > 0 && pairingAtAgent() > 0); // each shows the other
        for (const UdpAttacker::Seen &seen : flight.attacker.seen) {
            if (const auto token = seen.toGround ? channel::calledToken(viewOf(seen.bytes)) : std::nullopt)
                knows.token = *token;
        }
    }
    std::vector<Bytes (*)(const StrangersKnowledge &, std::mt19937_64 &)> ofPairing;
    for (const StrangerMessage &message : kStrangerMessages) {
        if (std::string_view(message.name).starts_with("pairing: "))
            ofPairing.push_back(message.make);
    }
    std::mt19937_64 random(4);

    const quint16 port = flight.ground.port();
    flight.ground.ears->events.clear();
    flight.rig.agentEvents.clear();
    pairingAtStation = 0;
    const TimePoint begun = steadyNow();
    std::set<Duration::rep> floodedSeconds; // a busy machine leaves some out
    QTimer flood;
    connect(&flood, &QTimer::timeout, this, [&] {
        floodedSeconds.insert((steadyNow() - begun) / 1s);
        QUdpSocket stranger; // each from another address
        for (const QByteArray &datagram : {otherVersion, announcement, heartbeat})
            stranger.writeDatagram(datagram, QHostAddress::LocalHost, port);
        flight.attacker.toGround(forged(toGround));
        for (const QByteArray &datagram : {otherVersion, first, forged(toAgent)})
            flight.attacker.toAgent(datagram);
        for (const auto make : ofPairing) {
            const Bytes bytes = make(knows, random);
            const QByteArray datagram(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
            stranger.writeDatagram(datagram, QHostAddress::LocalHost, port);
            flight.attacker.toAgent(datagram);
        }
        announcement[1] = static_cast<char>(announcement[1] + 1);
    });
    const auto countKinds = [&flight] {
        std::map<std::string, int> out;
        for (const engine::Event &event : flight.ground.ears->events) {
            if (const auto *refused = std::get_if<channel::HandshakeRefused>(&event))
                ++out[refused->reason == channel::RefusalReason::UnknownPeer ? "unknown agent" : "refused"];
            else if (std::holds_alternative<channel::ForgeryAlarm>(event))
                ++out["forged"];
            else if (std::holds_alternative<engine::PlaintextRefused>(event))
                ++out["clear"];
        }
        return out;
    };
    flood.start(4);
    constexpr std::size_t kKinds = 4;
    EVENTUALLY(steadyNow() >= begun + 6s && (countKinds().size() == kKinds || steadyNow() >= begun + 20s));
    flood.stop();
    const double took = seconds(steadyNow() - begun);
    const std::map<std::string, int> kinds = countKinds();
    const auto lines = std::accumulate(kinds.begin(), kinds.end(), 0,
                                       [](int sum, const auto &kind) { return sum + kind.second; });
    HOLDS(lines <= took + 2, "strangers cause one event a second");
    const auto ofWindow = pairingAtAgent();
    const auto others = static_cast<std::ptrdiff_t>(flight.rig.agentEvents.size()) - ofWindow;
    HOLDS(static_cast<double>(others) <= took + 2, "strangers cause one event a second");
    QVERIFY(ofWindow + pairingAtStation <= (pairing ? took + 2 : 0));
    QCOMPARE(ofWindow > 0, pairing); // so the window was reached
    for (const char *kind : {"unknown agent", "refused", "forged", "clear"})
        QVERIFY2(kinds.contains(kind), kind); // no kind hides another
    QVERIFY(others + 2 >= static_cast<std::ptrdiff_t>(floodedSeconds.size()));
}

SKYSEAL_TEST(AttackFlightTest)
#include "attack_flight_test.moc"
