// Whole flights by script: the station's side of this library against the simulated vehicle, frame by frame, over a link
// that delays and drops.
#include "core/mavlink/frame_scanner.h"
#include "core/sim/simulated_vehicle.h"
#include "core/vehicle/flight_script_runner.h"
#include "core/vehicle/gcs_heartbeat.h"
#include "core/vehicle/vehicle_set.h"
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include <QtTest/QTest>

#include <deque>
#include <random>

using namespace skyseal;
using namespace skyseal::vehicle;

class ScriptedFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholeFlight_data();
    void wholeFlight();
    void placesAndAltitudes();
    void olderCopterIsSentToAPlaceOutsideGuided();
    void refusedTakeOffEndsTheScript();
    void missionIsUploadedAndFlown();
    void parametersAreReadAndWritten();
    void twoVehicles();
};

namespace {

/// A station and simulated vehicles on one clock.
class World
{
public:
    World(double loss, unsigned seed, std::uint8_t vehicles = 1) : m_random(seed), m_lost(loss)
    {
        for (std::uint8_t id = 1; id <= vehicles; ++id) {
            sim::SimulatedVehicleConfig config;
            config.systemId = id;
            config.autopilot.seed = seed + id;
            m_sims.emplace_back(config, now);
        }
    }

    /// Runs until `done`, or the limit; looks ten times a second, as a station does.
    bool run(double limit, const std::function<bool()> &done)
    {
        const TimePoint end = now + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(limit));
        while (!done()) {
            if (now >= end)
                return false;
            step();
        }
        return true;
    }

    /// Runs a script to its end.
    std::vector<StepReport> fly(const std::string &script, double limit)
    {
        FlightScriptRunner runner(*parseFlightScript(script));
        std::vector<StepReport> reports;
        run(limit, [&] {
            std::vector<VehicleState> states;
            for (const auto &[id, vehicle] : set.all())
                states.push_back(vehicle.state(now));
            std::vector<const VehicleState *> views;
            for (const VehicleState &state : states)
                views.push_back(&state);
            runner.advance(now, views);
            if (const auto order = runner.pollRequest()) {
                runner.requestSent(RequestId{++m_lastId});
                set.find(order->systemId)->perform(now, RequestId{m_lastId}, order->request);
            }
            for (auto &[id, vehicle] : set.all()) {
                while (const auto event = vehicle.pollEvent()) {
                    if (const auto *command = std::get_if<CommandResult>(&*event))
                        runner.handleResult(*command);
                    else if (const auto *parameter = std::get_if<ParameterResult>(&*event))
                        runner.handleResult(*parameter);
                }
            }
            while (auto report = runner.pollReport())
                reports.push_back(std::move(*report));
            return runner.finished();
        });
        return reports;
    }

    sim::SimulatedVehicle &simulated(std::size_t index) { return m_sims[index]; }

    TimePoint now = at(1000);
    VehicleSet set{VehicleConfig{}};
    bool knowsReposition = true; ///< as ArduCopter does since 4.1

private:
    using Air = std::multimap<TimePoint, std::vector<std::uint8_t>>;

    void step()
    {
        now += std::chrono::milliseconds(20);
        if (const auto beat = m_heartbeat.poll(now))
            send(*beat);
        for (auto &[id, vehicle] : set.all()) {
            if (vehicle.nextDeadline() <= now)
                vehicle.handleDeadline(now);
            while (const auto message = vehicle.pollOutgoing())
                send(*message);
        }
        deliver(m_up, [this](const mavlink::Frame &frame) {
            if (!knowsReposition && frame.messageId() == mavlink::CommandInt::kId
                && unpack<mavlink::CommandInt>(frame).command == mavlink::MAV_CMD_DO_REPOSITION)
                return refuse(frame);
            for (auto &sim : m_sims)
                sim.handleFrame(now, frame);
        });
        for (auto &sim : m_sims) {
            sim.advance(now);
            for (ByteView frame = sim.pollFrame(); !frame.empty(); frame = sim.pollFrame())
                carry(m_down, frame);
        }
        deliver(m_down, [this](const mavlink::Frame &frame) { set.handleFrame(now, {}, frame); });
    }

    void refuse(const mavlink::Frame &frame)
    {
        mavlink::CommandAck ack;
        ack.command = unpack<mavlink::CommandInt>(frame).command;
        ack.result = mavlink::MAV_RESULT_UNSUPPORTED;
        ack.target_system = frame.systemId();
        ack.target_component = frame.componentId();
        set.handleFrame(now, {}, m_refuser.frame(ack));
    }

    void send(const OutMessage &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        carry(m_up, m_writer.write(message.id, message.crcExtra, message.minLength, message.view(), buffer));
    }

    void carry(Air &air, ByteView frame)
    {
        if (!m_lost(m_random))
            air.emplace(now + std::chrono::milliseconds(30), std::vector<std::uint8_t>(frame.begin(), frame.end()));
    }

    template<typename Handler> void deliver(Air &air, Handler handle)
    {
        while (!air.empty() && air.begin()->first <= now) {
            const auto bytes = std::move(air.extract(air.begin()).mapped());
            const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
            if (!frame)
                throw std::runtime_error("a frame that is none");
            handle(*frame);
        }
    }

    std::vector<sim::SimulatedVehicle> m_sims;
    std::mt19937 m_random;
    std::bernoulli_distribution m_lost;
    mavlink::FrameWriter m_writer{255, 190};
    GcsHeartbeat m_heartbeat;
    Sender m_refuser;
    Air m_up, m_down;
    std::uint32_t m_lastId = 0;
};

std::string story(const std::vector<StepReport> &reports)
{
    std::string out;
    for (const StepReport &report : reports)
        out += std::to_string(report.systemId) + ": " + report.step + " → " + std::string(stepResultName(report.result)) + " "
            + report.reason + "\n";
    return out;
}

} // namespace

void ScriptedFlightTest::wholeFlight_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    QTest::newRow("no loss") << 0.0 << 1;
    QTest::newRow("5 % loss") << 0.05 << 2;
    QTest::newRow("20 % loss") << 0.2 << 3;
}

void ScriptedFlightTest::wholeFlight()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    World world(loss, static_cast<unsigned>(seed));
    const auto reports = world.fly(
        "wait ekf_ok==1 60; wait gps_fix>=3 60; mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60;"
        "goto -35.3630 149.1655 15; wait distance_home>=25 60; rtl; wait mode==RTL 5; wait armed==0 180",
        600);
    QVERIFY2(!reports.empty() && reports.size() == 11, story(reports).c_str());
    QVERIFY2(reports.back().result == StepResult::Reached, story(reports).c_str());
    const auto state = world.set.find(1)->state(world.now);
    QVERIFY(!state.armed);
    QVERIFY2(state.distanceHome < 3, story(reports).c_str());
    QVERIFY(state.flightTime > 20);
    QVERIFY(state.firmware.starts_with("ArduCopter"));
    QVERIFY(state.latency >= 0.05 && state.latency < 0.2);
    QVERIFY(state.batteryPercent < 100 && state.batteryVoltage > 5);
    QVERIFY(!state.texts.empty());
}

/// North of the field, the nose points back at it, and home moves under the vehicle.
void ScriptedFlightTest::placesAndAltitudes()
{
    World world(0.05, 7);
    const auto reports = world.fly(
        "wait ekf_ok==1 60; wait gps_fix>=3 60; mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60;"
        "roi -35.363261 149.165230; goto -35.3628 149.165230 10; wait distance_home>=45 60; wait ground_speed<0.5 60;"
        "wait heading>=170 20; wait heading<=190 20; altitude 20; wait alt_rel>=19.5 60; wait distance_home>=45 5; roi none;"
        "pause; wait mode==BRAKE 5; sethome -35.3628 149.165230; wait distance_home<5 20; wait alt_rel>=19 5; land",
        600);
    QVERIFY2(reports.size() == 22 && reports.back().result == StepResult::Accepted, story(reports).c_str());
}

void ScriptedFlightTest::olderCopterIsSentToAPlaceOutsideGuided()
{
    World world(0.05, 8);
    const auto reports = world.fly(
        "wait ekf_ok==1 60; wait gps_fix>=3 60; mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60; pause", 200);
    QVERIFY2(reports.size() == 7 && reports.back().result == StepResult::Accepted, story(reports).c_str());
    world.knowsReposition = false;
    Vehicle &vehicle = *world.set.find(1);
    QCOMPARE(vehicle.current().mode, std::string("BRAKE"));
    vehicle.perform(world.now, RequestId{77}, GoTo{-35.3630, 149.1655, 15, true});
    std::optional<CommandResult> result;
    QVERIFY(world.run(30, [&] {
        while (const auto event = vehicle.pollEvent()) {
            if (const auto *command = std::get_if<CommandResult>(&*event); command && command->id == RequestId{77})
                result = *command;
        }
        return result.has_value();
    }));
    QVERIFY2(result->outcome == CommandOutcome::Accepted, result->reason.text().c_str());
    QCOMPARE(vehicle.current().mode, std::string("GUIDED"));
    QVERIFY(world.run(60, [&] {
        const VehicleState state = vehicle.state(world.now);
        return std::abs(state.position.latitude + 35.3630) < 2e-5 && std::abs(state.position.longitude - 149.1655) < 2e-5
            && state.altitudeRelative > 14;
    }));
}

void ScriptedFlightTest::refusedTakeOffEndsTheScript()
{
    World world(0, 1);
    const auto reports = world.fly("arm", 60); // no position yet: the vehicle says why not
    QCOMPARE(reports.size(), std::size_t(1));
    QVERIFY2(reports[0].result == StepResult::Refused, story(reports).c_str());
    QVERIFY2(reports[0].reason.size() > std::string("failed: ").size(), story(reports).c_str());
    qInfo("%s", reports[0].reason.c_str());
}

void ScriptedFlightTest::missionIsUploadedAndFlown()
{
    World world(0.05, 4);
    QVERIFY(world.run(60, [&] { return world.set.find(1) && world.set.find(1)->current().ekfOk.value_or(false); }));
    Vehicle &vehicle = *world.set.find(1);
    std::vector<MissionItem> items(4);
    for (std::uint16_t i = 0; i < items.size(); ++i) {
        items[i].sequence = i;
        items[i].latitude = -35.3632 + i * 2e-4;
        items[i].longitude = 149.1652;
        items[i].altitude = 12;
    }
    items[1].command = mavlink::MAV_CMD_NAV_TAKEOFF;
    vehicle.perform(world.now, RequestId{1}, WriteMission{items});
    std::optional<MissionResult> result;
    const auto transferred = [&] {
        while (const auto event = vehicle.pollEvent()) {
            if (const auto *done = std::get_if<MissionResult>(&*event))
                result = *done;
        }
        return result.has_value();
    };
    QVERIFY(world.run(60, transferred));
    QVERIFY2(result->ok, result->reason.text().c_str());
    vehicle.perform(world.now, RequestId{2}, ReadMission{});
    result.reset();
    QVERIFY(world.run(60, transferred));
    QVERIFY2(result->ok, result->reason.text().c_str());
    QCOMPARE(vehicle.mission()->size(), std::size_t(4));
    QVERIFY(std::abs(vehicle.mission()->at(3).latitude - items[3].latitude) < 1e-6);

    const auto reports = world.fly(
        "mode GUIDED; arm; takeoff 10; wait alt_rel>=9 60; mode AUTO; wait mission_current==3 90; land; wait armed==0 120",
        400);
    QVERIFY2(reports.size() == 8 && reports.back().result == StepResult::Reached, story(reports).c_str());
}

void ScriptedFlightTest::parametersAreReadAndWritten()
{
    World world(0.1, 5);
    QVERIFY(world.run(60, [&] { return world.set.find(1) != nullptr; }));
    Vehicle &vehicle = *world.set.find(1);
    vehicle.perform(world.now, RequestId{1}, ReadParameters{});
    QVERIFY(
        world.run(120, [&] { return vehicle.parameters() && vehicle.parametersExpected() == vehicle.parameters()->size(); }));
    QVERIFY(vehicle.parameters()->size() >= 100);
    const auto reports = world.fly("param WPNAV_SPEED 750; param NO_SUCH_THING 1", 60);
    QCOMPARE(reports.size(), std::size_t(2));
    QCOMPARE(reports[0].result, StepResult::Accepted);
    QCOMPARE(reports[1].result, StepResult::Refused);
}

void ScriptedFlightTest::twoVehicles()
{
    World world(0, 6, 2);
    const auto reports = world.fly(
        "1: wait ekf_ok==1 60; 2: wait ekf_ok==1 60; 1: mode GUIDED; 2: mode GUIDED; 1: arm; 2: arm; 2: takeoff 5;"
        "1: takeoff 10; 2: wait alt_rel>4.5 60; 1: wait alt_rel>9 60; 2: land; 2: wait armed==0 90; 1: wait armed==1 1",
        400);
    QVERIFY2(reports.size() == 13 && reports.back().result == StepResult::Reached, story(reports).c_str());
}

SKYSEAL_TEST_APPLESS(ScriptedFlightTest)
#include "scripted_flight_test.moc"
