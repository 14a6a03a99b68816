// A flight with MAVLink signing between agent and vehicle, over real sockets: what the vehicle signed reaches the ground byte
// for byte, what a station commands is signed, and a device without the key is nobody on the vehicle's side.
#include "core/engine/agent/agent_core.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/signing.h"
#include "tests/engine/engine_rig.h"
#include "tests/engine/ground.h"
#include "tests/support/clear_frames.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

#include <QtNetwork/QUdpSocket>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

Key32 theKey()
{
    Key32 key;
    key.mutableView()[3] = 9;
    return key;
}

/// A station, an agent and a vehicle that has the key.
struct SignedFlight
{
    SignedFlight() : ground(rig.stationConfig())
    {
        startAgent();
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
        mavlink::SetupSigning setup{.target_system = 1, .target_component = 1};
        setup.initial_timestamp = 1;
        std::ranges::copy(theKey().view(), setup.secret_key.begin());
        deliver(frameOf(setup, 255));
        while (!vehicle->vehicle.pollFrame().empty()) {} // from before it had the key
    }
    void startAgent()
    {
        rig.signing = std::make_unique<engine::VehicleSigning>(engine::VehicleKey{theKey(), nullptr}, false);
        rig.startAgent(ground.ears->listening());
    }
    /// Over the air, or whatever other way there is to the vehicle.
    void deliver(const QByteArray &frame)
    {
        vehicle->vehicle.handleFrame(steadyNow(), *mavlink::readFrame(viewOf(frame), mavlink::Dialect::builtin()));
    }
    void arm() { ground.station->perform(1, vehicle::VehicleCommand(vehicle::Arm{.force = true})); }
    bool armed() const { return vehicle->vehicle.autopilot().armed(); }
    bool vehicleIsHeard() const
    {
        const auto &vehicles = ground.ears->snapshot->vehicles;
        return vehicles.size() == 1 && !vehicles[0].state.lost && !vehicles[0].ended;
    }
    engine::SigningCounters counters() { return *rig.agent->snapshot().signing; }

    FlightRig rig;
    Ground ground;
    std::unique_ptr<VehicleOnUdp> vehicle;
};

QByteArray forcedArm()
{
    return frameOf(mavlink::CommandLong{.target_system = 1,
                                        .target_component = 1,
                                        .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM,
                                        .param1 = 1,
                                        .param2 = 21196},
                   255);
}

} // namespace

class SignedFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesPassUnchanged();
    void pilotCommandsAndStrangersDoNot();
    void strangersVehicleIsNotShown();
    void eachPartStartsAgain();
    void clearGroundFramesAreNeverSigned();
};

void SignedFlightTest::framesPassUnchanged()
{
    const Introduced keys;
    BareEnd station(keys, channel::Role::Station, everySuite());
    engine::AgentConfig config{
        urlOf("udpin:127.0.0.1:0"), {{urlOf("udpout:127.0.0.1:" + std::to_string(station.port()))}}, everySuite(), false};
    engine::AgentCore agent(
        std::move(config), keys.secrets(channel::Role::Agent), [](const engine::AgentEvent &) {},
        std::make_unique<engine::VehicleSigning>(engine::VehicleKey{theKey(), nullptr}, false));
    agent.start();
    bringUp(station, crypto::SuiteId::ChaCha20Poly1305);
    const SampleTraffic telemetry(256);
    mavlink::FrameSigner signer(theKey(), 4);
    std::vector<Bytes> sent, arrived;
    station.frameReceived = [&arrived](ByteView frame) { arrived.emplace_back(frame.begin(), frame.end()); };
    BareSocket vehicle;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    for (const ByteView frame : telemetry.frames()) {
        const ByteView out = signer.signCopy(frame, buffer);
        sent.emplace_back(out.begin(), out.end());
        vehicle.send(portOf(agent.snapshot().vehicle.localAddress), std::array{out, frame}); // and without a signature
    }
    EVENTUALLY((station.pump(), arrived.size() >= sent.size()));
    QVERIFY(arrived == sent);
    QCOMPARE(agent.snapshot().signing->unsignedRefused, std::uint64_t(256));
}

void SignedFlightTest::pilotCommandsAndStrangersDoNot()
{
    SignedFlight flight;
    EVENTUALLY(flight.vehicleIsHeard());
    flight.deliver(forcedArm());
    QVERIFY(!flight.armed());
    flight.arm();
    EVENTUALLY(flight.armed());
    EVENTUALLY_EQUAL(flight.ground.ears->all<vehicle::CommandResult>().size(), std::size_t(1));
    QCOMPARE(flight.ground.ears->all<vehicle::CommandResult>()[0].outcome, vehicle::CommandOutcome::Accepted);
    EVENTUALLY(flight.counters().verified > 20);
    const engine::SigningCounters counters = flight.counters();
    QVERIFY(counters.signedFrames > 1);
    QCOMPARE(counters.wrong + counters.old + counters.unsignedRefused + counters.unsignable, std::uint64_t(0));
    QCOMPARE(flight.ground.ears->snapshot->mavlink.lost, std::uint64_t(0));
}

/// A device on the network of the vehicle's side, where the agent listens.
void SignedFlightTest::strangersVehicleIsNotShown()
{
    SignedFlight flight;
    EVENTUALLY(flight.vehicleIsHeard());
    QUdpSocket stranger;
    const mavlink::Heartbeat heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA};
    const auto port = portOf(flight.rig.vehicleAddress());
    for (int i = 0; i < 20; ++i) {
        for (const std::uint8_t system : {1, 7}) // as the vehicle, and as another one
            stranger.writeDatagram(frameOf(heartbeat, system, 1), QHostAddress::LocalHost, port);
    }
    EVENTUALLY_EQUAL(flight.counters().unsignedRefused, std::uint64_t(40));
    QVERIFY(!flight.rig.agent->isVehicle(7));
    // Nor did it draw the vehicle's commands to itself.
    flight.arm();
    EVENTUALLY(flight.armed());
    QVERIFY(!stranger.hasPendingDatagrams());
    QCOMPARE(flight.ground.ears->snapshot->vehicles.size(), std::size_t(1));
    EVENTUALLY(std::ranges::any_of(flight.rig.agentEvents, [](const engine::AgentEvent &event) {
        const auto *report = std::get_if<engine::VehicleSignatures>(&event);
        return report && report->kind == engine::VehicleSignatures::Kind::Unsigned;
    }));
}

void SignedFlightTest::eachPartStartsAgain()
{
    SignedFlight flight;
    EVENTUALLY(flight.vehicleIsHeard());
    flight.rig.killAgent();
    flight.startAgent(); // without its time
    // The station still shows the vehicle of before; the agent has no way to it until it has heard it.
    EVENTUALLY(flight.ground.ears->all<channel::SessionUp>().size() == 2 && flight.rig.agent->isVehicle(1));
    flight.arm();
    EVENTUALLY(flight.armed());
    flight.vehicle->vehicle.autopilot().arming().disarmNow();
    flight.ground.station->perform(1, vehicle::VehicleCommand(vehicle::Reboot{}));
    EVENTUALLY_EQUAL(flight.ground.ears->all<vehicle::CommandResult>().size(), std::size_t(2));
    const std::uint64_t verified = flight.counters().verified;
    EVENTUALLY(flight.counters().verified > verified + 20); // although the vehicle had not saved its time yet
    flight.arm();
    EVENTUALLY(flight.armed());
}

/// Even by an agent that carries clear MAVLink: its signature would make anybody's command the vehicle's.
void SignedFlightTest::clearGroundFramesAreNeverSigned()
{
    SignedFlight flight;
    UdpAttacker path(flight.ground.port());
    flight.rig.killAgent();
    flight.rig.allowPlain = true;
    flight.rig.introduceStation(false); // no session: the state in which clear MAVLink is carried
    flight.rig.signing = std::make_unique<engine::VehicleSigning>(engine::VehicleKey{theKey(), nullptr}, false);
    flight.rig.startAgent("127.0.0.1:" + std::to_string(path.port()));
    EVENTUALLY(!path.seen.empty() && flight.counters().verified > 10);
    const std::uint64_t before = flight.rig.agent->snapshot().counters.clearRefused;
    for (int i = 0; i < 20; ++i)
        path.toAgent(forcedArm());
    EVENTUALLY_EQUAL(flight.rig.agent->snapshot().counters.clearRefused - before, std::uint64_t(20));
    QCOMPARE(flight.counters().signedFrames, std::uint64_t(0));
    QVERIFY(!flight.armed());
}

SKYSEAL_TEST(SignedFlightTest)
#include "signed_flight_test.moc"
