// The PX4 personality: identity, modes in both bytes, parameters whose integers travel as bytes, streams without being asked,
// answers of its commands and missions, arming and disarming by its rules.
#include "tests/sim/some_items.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <bit>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimPx4Test : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void identifiesItself();
    void modesAreInBothBytes();
    void integersTravelAsTheirBytes();
    void listBeginsWithTheHash();
    void streamsAtItsOwnRates();
    void takesOffAboveSeaLevel();
    void climbsOnItsWay();
    void landsAndDisarms();
    void refusesByItsOwnResults();
    void missionIsTransferredInOrder();
    void missionHasNoHome();
    void rebootKeepsTheSystemId();
};

namespace {

SimulatedVehicleConfig px4()
{
    SimulatedVehicleConfig config;
    config.autopilot.type.firmware = Firmware::Px4;
    return config;
}

int setMode(TestStation &station, float mainMode, float subMode = 0)
{
    return station.command(MAV_CMD_DO_SET_MODE, {1, mainMode, subMode});
}

int arm(TestStation &station)
{
    return station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1});
}

/// Takes off to a height above the field, which lies at 584 m.
bool airborne(TestStation &station, float height)
{
    station.run(6);
    const float nan = std::nanf("");
    return station.command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, nan, nan, nan, 584 + height}) == MAV_RESULT_ACCEPTED
        && arm(station) == MAV_RESULT_ACCEPTED
        && station.until([&] { return station.vehicle.autopilot().heightAboveHome() > static_cast<double>(height) - 0.4; }, 60);
}

ParamValue readParameter(TestStation &station, std::string_view name)
{
    ParamRequestRead out;
    out.target_system = 1;
    out.param_index = -1;
    std::copy(name.begin(), name.end(), out.param_id.begin());
    station.forget();
    station.send(out);
    return station.last<ParamValue>();
}

} // namespace

void SimPx4Test::identifiesItself()
{
    TestStation station(px4());
    station.run(3);
    const auto heartbeat = station.last<mavlink::Heartbeat>();
    QCOMPARE(int(heartbeat.autopilot), int(MAV_AUTOPILOT_PX4));
    QCOMPARE(int(heartbeat.type), int(MAV_TYPE_QUADROTOR));
    QVERIFY(!station.said("EKF3"));
    QCOMPARE(station.command(MAV_CMD_REQUEST_MESSAGE, {float(AutopilotVersion::kId)}), int(MAV_RESULT_ACCEPTED));
    const auto version = station.last<AutopilotVersion>();
    constexpr std::uint64_t wanted = MAV_PROTOCOL_CAPABILITY_MISSION_INT | MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE;
    QCOMPARE(version.capabilities & wanted, wanted);
    QVERIFY(!(version.capabilities & MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT));
    QCOMPARE(version.flight_sw_version >> 24, 1u);
}

void SimPx4Test::modesAreInBothBytes()
{
    TestStation station(px4());
    station.run(6);
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 4u << 16 | 3u << 24); // AUTO.LOITER at power-on
    QCOMPARE(setMode(station, 3), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 3u << 16);
    QVERIFY(station.last<mavlink::Heartbeat>().base_mode & MAV_MODE_FLAG_MANUAL_INPUT_ENABLED);
    QCOMPARE(setMode(station, 4, 6), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 4u << 16 | 6u << 24);
    QVERIFY(station.last<mavlink::Heartbeat>().base_mode & MAV_MODE_FLAG_AUTO_ENABLED);
    QCOMPARE(setMode(station, 9, 1), int(MAV_RESULT_TEMPORARILY_REJECTED));

    mavlink::SetMode message;
    message.target_system = 1;
    message.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    message.custom_mode = 2u << 16;
    station.forget();
    station.send(message);
    QCOMPARE(station.count<CommandAck>(), std::size_t(1));
    QCOMPARE(int(station.last<CommandAck>().command), int(MAV_CMD_DO_SET_MODE)); // PX4 turns the message into the command
    QCOMPARE(int(station.last<CommandAck>().result), int(MAV_RESULT_ACCEPTED));
}

void SimPx4Test::integersTravelAsTheirBytes()
{
    TestStation station(px4());
    auto value = readParameter(station, "SYS_AUTOSTART");
    QCOMPARE(int(value.param_type), int(MAV_PARAM_TYPE_INT32));
    QCOMPARE(std::bit_cast<std::int32_t>(value.param_value), 4001);
    QVERIFY(value.param_index != 65535);
    value = readParameter(station, "MPC_XY_CRUISE");
    QCOMPARE(int(value.param_type), int(MAV_PARAM_TYPE_REAL32));
    QCOMPARE(value.param_value, 5.f);

    station.setParameter("NAV_DLL_ACT", std::bit_cast<float>(std::int32_t(2)));
    QCOMPARE(station.vehicle.autopilot().parameters().integer("NAV_DLL_ACT"), 2);
    value = readParameter(station, "NAV_DLL_ACT");
    QCOMPARE(std::bit_cast<std::int32_t>(value.param_value), 2);
    station.setParameter("NAV_DLL_ACT", 3.f); // as a float it is a huge number
    QCOMPARE(station.vehicle.autopilot().parameters().integer("NAV_DLL_ACT"), 2);
    station.setParameter("NO_SUCH_ONE", 1);
    station.run(0.2);
    QVERIFY(station.said("[pm] unknown param: NO_SUCH_ONE"));
}

void SimPx4Test::listBeginsWithTheHash()
{
    TestStation station(px4());
    ParamRequestList request;
    request.target_system = 1;
    station.send(request);
    station.run(3);
    auto values = station.all<ParamValue>();
    const std::size_t count = station.vehicle.autopilot().parameters().count();
    QCOMPARE(values.size(), count + 1);
    QCOMPARE(std::string(mavlink::textOf(values[0].param_id)), std::string("_HASH_CHECK"));
    QCOMPARE(int(values[0].param_index), 65535);
    for (std::size_t i = 0; i < count; ++i)
        QCOMPARE(std::size_t(values[i + 1].param_index), i);
    const float before = values[0].param_value;
    station.setParameter("MPC_XY_CRUISE", 6);
    QVERIFY(std::bit_cast<std::uint32_t>(readParameter(station, "_HASH_CHECK").param_value)
            != std::bit_cast<std::uint32_t>(before));

    station.forget();
    station.send(request);
    station.setParameter("_HASH_CHECK", before); // a station that has all values stops the list
    station.run(2);
    QVERIFY(station.count<ParamValue>() < 3);
}

void SimPx4Test::streamsAtItsOwnRates()
{
    TestStation station(px4());
    station.run(10);
    RequestDataStream request; // it knows no groups
    request.target_system = 1;
    request.req_message_rate = 50;
    request.start_stop = 1;
    station.send(request);
    station.forget();
    station.run(20);
    QCOMPARE(station.count<mavlink::Heartbeat>(), std::size_t(20));
    QCOMPARE(station.count<mavlink::Attitude>(), std::size_t(300)); // 15 Hz
    QCOMPARE(station.count<GlobalPositionInt>(), std::size_t(100));
    QCOMPARE(station.count<VfrHud>(), std::size_t(80));
    QCOMPARE(station.count<mavlink::SysStatus>(), std::size_t(20));
    QCOMPARE(station.count<mavlink::ExtendedSysState>(), std::size_t(20));
    QCOMPARE(station.count<mavlink::EstimatorStatus>(), std::size_t(10));
    QCOMPARE(station.count<mavlink::HomePosition>(), std::size_t(10));
    QCOMPARE(station.count<mavlink::EkfStatusReport>(), std::size_t(0)); // of ArduPilot
    QCOMPARE(station.count<mavlink::AttitudeTarget>(), std::size_t(40));
    QCOMPARE(station.command(MAV_CMD_SET_MESSAGE_INTERVAL, {float(mavlink::Attitude::kId), 1e6f}), int(MAV_RESULT_ACCEPTED));
    station.forget();
    station.run(10);
    QCOMPARE(station.count<mavlink::Attitude>(), std::size_t(10));
    QCOMPARE(station.command(MAV_CMD_SET_MESSAGE_INTERVAL, {float(mavlink::Attitude::kId), 0}), int(MAV_RESULT_ACCEPTED));
    station.forget();
    station.run(10);
    QCOMPARE(station.count<mavlink::Attitude>(), std::size_t(150)); // back to its default
}

void SimPx4Test::takesOffAboveSeaLevel()
{
    TestStation station(px4());
    QVERIFY(airborne(station, 12));
    station.run(8);
    QVERIFY(std::abs(station.vehicle.autopilot().heightAboveHome() - 12) < 0.6);
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 4u << 16 | 3u << 24); // it holds after the take-off
    QCOMPARE(int(station.last<mavlink::ExtendedSysState>().landed_state), int(MAV_LANDED_STATE_IN_AIR));
}

/// DO_REPOSITION without a place changes the altitude alone.
void SimPx4Test::climbsOnItsWay()
{
    TestStation station(px4());
    QVERIFY(airborne(station, 12));
    station.run(8);
    const auto here = station.last<GlobalPositionInt>();
    CommandInt go = TestStation::commandAt(MAV_CMD_DO_REPOSITION, MAV_FRAME_GLOBAL, here.lat + 4500, here.lon, 596); // 50 m
    go.param1 = -1;
    go.param2 = 1;
    go.param4 = std::nanf("");
    QCOMPARE(station.resultOf(go), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    const float nan = std::nanf("");
    QCOMPARE(station.command(MAV_CMD_DO_REPOSITION, {-1, 1, 0, nan, nan, nan, 604}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until(
        [&] {
            const auto p = station.last<GlobalPositionInt>();
            return std::abs(p.lat - go.x) < 15 && std::abs(p.relative_alt - 20'000) < 500;
        },
        40));
    QCOMPARE(station.command(MAV_CMD_DO_SET_ROI_NONE), int(MAV_RESULT_ACCEPTED));
}

void SimPx4Test::landsAndDisarms()
{
    TestStation station(px4());
    QVERIFY(airborne(station, 6));
    QCOMPARE(station.command(MAV_CMD_NAV_LAND), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return station.vehicle.autopilot().landed(); }, 60));
    QVERIFY(station.vehicle.autopilot().armed()); // COM_DISARM_LAND
    const TimePoint down = station.now;
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 10));
    QVERIFY(station.now - down > std::chrono::milliseconds(900) && station.now - down < std::chrono::milliseconds(2500));

    QCOMPARE(setMode(station, 4, 3), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(arm(station), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 12)); // COM_DISARM_PRFLT
}

void SimPx4Test::refusesByItsOwnResults()
{
    TestStation station(px4());
    station.run(1);
    QCOMPARE(arm(station), int(MAV_RESULT_TEMPORARILY_REJECTED)); // no position yet
    station.run(0.2);
    QVERIFY(station.said("Arming denied: "));
    station.run(6);
    QCOMPARE(setMode(station, 4, 6), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(arm(station), int(MAV_RESULT_TEMPORARILY_REJECTED)); // not in AUTO.LAND
    QCOMPARE(station.command(31'999), int(MAV_RESULT_UNSUPPORTED));
    QVERIFY(airborne(station, 5));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_TEMPORARILY_REJECTED));
    station.run(0.2);
    QVERIFY(station.said("Disarming denied: not landed"));
}

void SimPx4Test::missionIsTransferredInOrder()
{
    TestStation station(px4());
    station.run(6);
    const auto items = numbered(
        {itemAt(MAV_CMD_NAV_TAKEOFF, 0, 0, 0), itemAt(MAV_CMD_NAV_WAYPOINT, 0, 30, 0), itemAt(MAV_CMD_NAV_WAYPOINT, 0, 30, 30)},
        0);
    QCOMPARE(Uploader(station, items, 0).run(5), int(MAV_MISSION_ACCEPTED));
    MissionRequestList list;
    list.target_system = 1;
    station.send(list);
    QCOMPARE(int(station.last<MissionCount>().count), 3);
    const auto read = [&](int sequence) {
        MissionRequestInt request;
        request.target_system = 1;
        request.seq = static_cast<std::uint16_t>(sequence);
        station.forget();
        station.send(request);
        return station.count<mavlink::MissionItemInt>() == 1;
    };
    QVERIFY(!read(1)); // not before the first
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ERROR));
    QVERIFY(read(0) && read(0) && read(1) && !read(0) && read(2));

    MissionCount count; // an item out of order is asked for again
    count.target_system = 1;
    count.count = 3;
    station.send(count);
    station.forget();
    station.send(items[1]);
    QCOMPARE(station.count<MissionAck>(), std::size_t(0));
    QCOMPARE(int(station.last<MissionRequestInt>().seq), 0);
}

void SimPx4Test::missionHasNoHome()
{
    TestStation station(px4());
    station.run(6);
    auto items = numbered({itemAt(MAV_CMD_NAV_TAKEOFF, 0, 0, 0), itemAt(MAV_CMD_NAV_WAYPOINT, 0, 40, 0),
                           itemAt(MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0)},
                          0);
    items[0].z = items[1].z = 15;
    items[0].frame = items[1].frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    QCOMPARE(Uploader(station, items, 0).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(arm(station), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_MISSION_START), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return station.count<MissionItemReached>() == 2; }, 90));
    QCOMPARE(int(station.all<MissionItemReached>()[0].seq), 0); // the take-off
    QVERIFY(station.vehicle.autopilot().truth().position.x > 35);
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 240));
    QVERIFY(station.vehicle.autopilot().truth().position.horizontal() < 3);
}

void SimPx4Test::rebootKeepsTheSystemId()
{
    TestStation station(px4());
    station.run(1);
    station.setParameter("MAV_SYS_ID", std::bit_cast<float>(std::int32_t(7)));
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(int(station.vehicle.systemId()), 7);
}

SKYSEAL_TEST_APPLESS(SimPx4Test)
#include "px4_test.moc"
