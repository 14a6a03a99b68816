// When a vehicle exists, how it is lost and found again, what it is asked for at the beginning, and the small trackers.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/vehicle/flight_modes.h"
#include "core/vehicle/gcs_heartbeat.h"
#include "core/vehicle/geodesy.h"
#include "core/vehicle/vehicle_set.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class VehicleTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyAnAutopilotsHeartbeatMakesAVehicle();
    void framesGoToTheirVehicle();
    void lostAfterThreeAndAHalfSecondsAndBack();
    void radioStatusIsNoSignOfLife();
    void otherComponentsAreNotTheVehicle();
    void autopilotIsFoundWhoeverSpeaksFirst();
    void messageOfZerosNamesNoAutopilot();
    void otherAutopilotsOnlyWithoutComponentOne();
    void requestsToTheWrongComponentEnd();
    void otherComponentsAreListed();
    void highLatencyStandsForAHeartbeat();
    void timeOutFollowsTheRateOfHighLatency();
    void nothingIsAskedOverASatelliteModem();
    void armingOverASatelliteModem();
    void olderHighLatencyKeepsTheKind();
    void modeNamesRoundTrip();
    void unknownModesKeepTheirNumber();
    void ardupilotIsAskedForStreams();
    void whatComesByItselfIsAskedForAllTheSame();
    void silentGroupIsAskedForAgain();
    void px4IsNotAsked();
    void oneRateForAllStreams();
    void unsupportedIntervalsAreGivenUp();
    void homeIsRequestedWhereItCannotBeStreamed();
    void lostVehicleIsAskedAnewWhenItReturns();
    void versionIsAskedForInTurnsUntilItComes();
    void latencyIsMeasuredAndSmoothed();
    void answersTheVehiclesTimeSync();
    void homeIsWhereItWasArmedUntilItSays();
    void flightTimeCountsInTheAirOnly();
    void flightTimeEndsWithARestart();
    void gcsHeartbeatIsDueOnceASecond();
    void outboxIsBounded();
};

void VehicleTest::onlyAnAutopilotsHeartbeatMakesAVehicle()
{
    VehicleSet set{VehicleConfig{}};
    Sender one(1);
    QVERIFY(!set.handleFrame(at(1), {}, one.frame(mavlink::Attitude{})));
    QVERIFY(!set.handleFrame(at(1), {}, one.frame(heartbeat(0, false, mavlink::MAV_TYPE_GCS, mavlink::MAV_AUTOPILOT_INVALID))));
    QVERIFY(
        !set.handleFrame(at(1), {}, one.frame(heartbeat(0, false, mavlink::MAV_TYPE_GIMBAL, mavlink::MAV_AUTOPILOT_INVALID))));
    QVERIFY(
        !set.handleFrame(at(1), {}, one.frame(heartbeat(0, false, mavlink::MAV_TYPE_CAMERA, mavlink::MAV_AUTOPILOT_GENERIC))));
    QVERIFY(!set.handleFrame(at(1), {}, one.frame(heartbeat(0, false, mavlink::MAV_TYPE_ONBOARD_CONTROLLER, 0))));
    QVERIFY(set.empty());
    Sender own(255);
    QVERIFY(!set.handleFrame(at(1), {}, own.frame(heartbeat())));
    QVERIFY(set.handleFrame(at(1), {}, one.frame(heartbeat())));
    QVERIFY(!set.handleFrame(at(1), {}, one.frame(heartbeat())));
    QCOMPARE(set.all().size(), std::size_t(1));
    QCOMPARE(set.find(1)->current().type, std::uint8_t(mavlink::MAV_TYPE_QUADROTOR));
    QVERIFY(!set.find(2));
}

void VehicleTest::framesGoToTheirVehicle()
{
    VehicleSet set{VehicleConfig{}};
    for (const std::uint8_t id : {3, 200, 7})
        QVERIFY(set.handleFrame(at(1), {}, Sender(id).frame(heartbeat())));
    mavlink::Attitude attitude;
    attitude.roll = 0.5f;
    set.handleFrame(at(1), {}, Sender(7).frame(attitude));
    QCOMPARE(set.find(7)->current().roll, 0.5);
    QVERIFY(std::isnan(set.find(3)->current().roll));
    QVERIFY(set.nextDeadline() <= at(1));
    set.handleDeadline(at(1));
    for (auto &[id, vehicle] : set.all()) {
        const auto request = as<mavlink::RequestDataStream>(*vehicle.pollOutgoing());
        QVERIFY(request);
        QCOMPARE(request->target_system, id);
    }
}

void VehicleTest::lostAfterThreeAndAHalfSecondsAndBack()
{
    Harness h = Harness::copter(4, true);
    mavlink::Attitude attitude;
    attitude.roll = 0.25f;
    h.feed(attitude);
    const auto before = h.vehicle.state(at(103.5));
    QVERIFY(!before.lost);
    QCOMPARE(before.heartbeatAge, 3.5);
    const auto after = h.vehicle.state(at(103.501));
    QVERIFY(after.lost && h.vehicle.isLost(at(103.501)));
    QCOMPARE(after.roll, 0.25); // nothing is erased
    QVERIFY(after.armed);
    h.now = at(110);
    h.feed(attitude); // any message will do
    const auto back = h.vehicle.state(at(110));
    QVERIFY(!back.lost);
    QCOMPARE(back.heartbeatAge, 10.);
    QCOMPARE(back.messageAge, 0.);
}

void VehicleTest::radioStatusIsNoSignOfLife()
{
    Harness h = Harness::copter();
    h.now = at(104);
    h.feed(mavlink::RadioStatus{});
    QVERIFY(h.vehicle.isLost(h.now));
}

void VehicleTest::otherComponentsAreNotTheVehicle()
{
    Harness h = Harness::copter(4);
    Sender companion(1, 191);
    h.now = at(104);
    h.vehicle.handleFrame(h.now, {}, companion.frame(heartbeat(0, true, mavlink::MAV_TYPE_ONBOARD_CONTROLLER, 8)));
    QVERIFY(h.vehicle.isLost(h.now));
    QVERIFY(!h.vehicle.current().armed);
    QCOMPARE(h.vehicle.current().mode, std::string("GUIDED"));
}

void VehicleTest::autopilotIsFoundWhoeverSpeaksFirst()
{
    VehicleSet set{VehicleConfig{}};
    Sender companion(1, 191), autopilot(1, 1);
    QVERIFY(set.handleFrame(at(1), {}, companion.frame(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, 0))));
    set.handleFrame(at(1), {}, companion.frame(statusText("Companion: ready")));
    QCOMPARE(int(set.find(1)->componentId()), 191);
    QVERIFY(set.handleFrame(at(2), {}, autopilot.frame(heartbeat(5, true))));
    Vehicle &vehicle = *set.find(1);
    QCOMPARE(int(vehicle.state(at(2)).componentId), 1);
    QCOMPARE(vehicle.current().mode, std::string("LOITER"));
    QVERIFY(vehicle.current().armed);
    QCOMPARE(vehicle.state(at(2)).texts.size(), std::size_t(1));
    set.handleDeadline(at(2));
    int requests = 0;
    while (const OutMessage *message = vehicle.pollOutgoing()) {
        if (const auto request = as<mavlink::RequestDataStream>(*message))
            QCOMPARE(int(request->target_component), 1);
        ++requests;
    }
    QVERIFY(requests > 0);
    // The companion goes on.
    QVERIFY(!set.handleFrame(at(3), {}, companion.frame(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, 0))));
    QCOMPARE(int(vehicle.componentId()), 1);
    QVERIFY(vehicle.current().armed);
    QVERIFY(vehicle.isLost(at(6))); // is no sign of life of the autopilot either
}

void VehicleTest::messageOfZerosNamesNoAutopilot()
{
    VehicleSet set{VehicleConfig{}};
    QVERIFY(!set.handleFrame(at(1), {}, Sender(1, 191).frame(heartbeat(0, false, 0, 0))));
    QVERIFY(set.handleFrame(at(2), {}, Sender(1, 1).frame(heartbeat(0, false, 0, 0)))); // component 1 need not name it
}

void VehicleTest::otherAutopilotsOnlyWithoutComponentOne()
{
    using namespace mavlink;
    const auto heard = [](VehicleSet &set, std::uint8_t component, std::uint8_t type, std::uint8_t autopilot) {
        set.handleFrame(at(1), {}, Sender(1, component).frame(heartbeat(0, false, type, autopilot)));
        return set.find(1) ? int(set.find(1)->componentId()) : 0;
    };
    VehicleSet set{VehicleConfig{}};
    for (const std::uint8_t part : {MAV_TYPE_GCS, MAV_TYPE_GIMBAL, MAV_TYPE_CAMERA, MAV_TYPE_ONBOARD_CONTROLLER, MAV_TYPE_ADSB,
                                    MAV_TYPE_RADIO, MAV_TYPE_ODID}) {
        QCOMPARE(heard(set, 1, part, MAV_AUTOPILOT_ARDUPILOTMEGA), 0);
        QCOMPARE(heard(set, 100, part, MAV_AUTOPILOT_GENERIC), 0);
    }
    QCOMPARE(heard(set, 20, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_GENERIC), 20);
    QCOMPARE(heard(set, 21, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_GENERIC), 20); // the same claim: the first one
    QCOMPARE(heard(set, 22, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_PX4), 22);
    QCOMPARE(heard(set, 23, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_ARDUPILOTMEGA), 22);
    QCOMPARE(heard(set, 1, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_GENERIC), 1);
    QCOMPARE(heard(set, 22, MAV_TYPE_QUADROTOR, MAV_AUTOPILOT_PX4), 1);
}

void VehicleTest::requestsToTheWrongComponentEnd()
{
    VehicleSet set{VehicleConfig{}};
    set.handleFrame(at(1), {}, Sender(1, 191).frame(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, 0)));
    Vehicle &vehicle = *set.find(1);
    vehicle.perform(at(1), RequestId(1), ReadParameters{});
    vehicle.perform(at(1), RequestId(2), ReadMission{});
    vehicle.perform(at(1), RequestId(3), VehicleCommand(vehicle::Arm{}));
    set.handleFrame(at(2), {}, Sender(1, 1).frame(heartbeat()));
    std::map<RequestId, std::string> reasons;
    while (const auto event = vehicle.pollEvent())
        std::visit(
            [&](const auto &result) {
                if constexpr (requires { result.id; })
                    reasons[result.id] = result.reason.text();
            },
            *event);
    QCOMPARE(reasons.size(), std::size_t(3));
    for (const auto &[id, reason] : reasons)
        QCOMPARE(reason, std::string("another component turned out to be the autopilot; request it again"));
    vehicle.handleDeadline(at(600));
    while (const auto event = vehicle.pollEvent())
        QVERIFY(std::holds_alternative<TextReceived>(*event)); // each ended once
}

void VehicleTest::otherComponentsAreListed()
{
    Harness h = Harness::copter(4);
    const auto heard = [&h](int component, std::uint8_t type) {
        Sender sender(1, static_cast<std::uint8_t>(component));
        h.vehicle.handleFrame(h.now, {}, sender.frame(heartbeat(0, false, type, mavlink::MAV_AUTOPILOT_INVALID)));
    };
    heard(191, mavlink::MAV_TYPE_ONBOARD_CONTROLLER);
    heard(100, mavlink::MAV_TYPE_CAMERA);
    h.now = at(102);
    heard(191, mavlink::MAV_TYPE_ONBOARD_CONTROLLER);
    const auto components = h.vehicle.state(at(103)).components;
    QCOMPARE(components.size(), std::size_t(2));
    QCOMPARE(int(components[0].id), 100);
    QCOMPARE(int(components[0].type), int(mavlink::MAV_TYPE_CAMERA));
    QCOMPARE(components[0].age, 3.);
    QCOMPARE(components[1].age, 1.);
    for (int component = 2; component < 256; ++component)
        heard(component, mavlink::MAV_TYPE_CAMERA);
    QCOMPARE(h.vehicle.current().components.size(), Vehicle::kMostComponents);
}

namespace {

mavlink::HighLatency2 px4HighLatency(std::uint8_t throttle = 0)
{
    mavlink::HighLatency2 out;
    out.type = mavlink::MAV_TYPE_FIXED_WING;
    out.autopilot = mavlink::MAV_AUTOPILOT_PX4;
    out.custom_mode = 0x0404;
    out.latitude = 473977420;
    out.longitude = 85455940;
    out.altitude = 520;
    out.battery = 77;
    out.throttle = throttle;
    return out;
}

} // namespace

void VehicleTest::highLatencyStandsForAHeartbeat()
{
    VehicleSet set{VehicleConfig{}};
    QVERIFY(set.handleFrame(at(1), {}, Sender(7).frame(px4HighLatency())));
    const VehicleState state = set.find(7)->state(at(1));
    QCOMPARE(int(state.type), int(mavlink::MAV_TYPE_FIXED_WING));
    QCOMPARE(state.mode, modeName({1, 12}, 1, 0x04040000));
    QVERIFY(!state.mode.starts_with("MODE("));
    QCOMPARE(state.position.latitude, 47.397742);
    QCOMPARE(state.batteryPercent, 77.);
    QVERIFY(state.highLatency && !state.lost);
    QCOMPARE(state.heartbeatAge, 0.);
    QVERIFY(!set.handleFrame(at(2), {}, Sender(7, 191).frame(px4HighLatency()))); // component 1 is the autopilot
}

void VehicleTest::timeOutFollowsTheRateOfHighLatency()
{
    for (const double every : {5., 67.}) {
        Harness h = Harness::px4();
        for (int second = 0; second < 4; ++second) {
            h.feed(heartbeat(0, false, mavlink::MAV_TYPE_FIXED_WING, mavlink::MAV_AUTOPILOT_PX4));
            h.now += std::chrono::seconds(1);
        }
        const auto pass = [&h](double seconds) {
            h.now += std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
        };
        for (int i = 0; i < 20; ++i) {
            h.feed(px4HighLatency());
            pass(i == 10 ? every * 2 : every); // one is lost
            QVERIFY(!h.vehicle.isLost(h.now));
        }
        QCOMPARE(h.vehicle.state(h.now).staleAfter, 2.5 * every);
        pass(1.6 * every);
        QVERIFY(h.vehicle.isLost(h.now));
        // Back on a usual link, its messages decide again, once those of the modem are overdue.
        h.feed(heartbeat(0, false, mavlink::MAV_TYPE_FIXED_WING, mavlink::MAV_AUTOPILOT_PX4));
        QVERIFY(!h.vehicle.isLost(h.now));
        pass(3.6);
        QVERIFY(h.vehicle.isLost(h.now));
    }
}

void VehicleTest::nothingIsAskedOverASatelliteModem()
{
    const auto requests = [](Harness &h, double seconds) {
        h.runUntil(h.now + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)));
        return h.sent().size();
    };
    Harness satellite;
    for (int i = 0; i < 20; ++i) {
        satellite.feed(px4HighLatency());
        QCOMPARE(requests(satellite, 5), std::size_t(0));
    }
    // A request of the operator goes out.
    satellite.vehicle.perform(satellite.now, RequestId(1), ReadParameter{"SYSID_THISMAV"});
    QCOMPARE(satellite.sentOf<mavlink::ParamRequestRead>().size(), std::size_t(1));
    Harness both = Harness::px4();
    both.feed(px4HighLatency());
    QCOMPARE(requests(both, 5), std::size_t(0));
    both.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    QVERIFY(requests(both, 5) > 0); // the usual link is back
}

/// HIGH_LATENCY2 has no field for it. ArduPilot uses a free one; of PX4, running motors say so.
void VehicleTest::armingOverASatelliteModem()
{
    Harness px4 = Harness::px4();
    px4.feed(px4HighLatency());
    QVERIFY(!px4.vehicle.current().armed);
    px4.feed(px4HighLatency(60));
    QVERIFY(px4.vehicle.current().armed);
    px4.feed(px4HighLatency(0)); // glides
    QVERIFY(px4.vehicle.current().armed);
    Harness copter = Harness::copter(5, true);
    mavlink::HighLatency2 message;
    message.type = mavlink::MAV_TYPE_QUADROTOR;
    message.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    message.custom_mode = 6;
    message.custom0 = 81;
    copter.feed(message);
    QVERIFY(!copter.vehicle.current().armed);
    QCOMPARE(copter.vehicle.current().mode, std::string("RTL"));
    message.custom0 = static_cast<std::int8_t>(209);
    copter.feed(message);
    QVERIFY(copter.vehicle.current().armed);
}

void VehicleTest::olderHighLatencyKeepsTheKind()
{
    Harness h = Harness::copter(5, false);
    mavlink::HighLatency message;
    message.base_mode = 209;
    message.custom_mode = 6;
    message.battery_remaining = 60;
    message.heading = 9000;
    h.feed(message);
    const VehicleState state = h.vehicle.state(h.now);
    QCOMPARE(int(state.type), int(mavlink::MAV_TYPE_QUADROTOR));
    QCOMPARE(state.mode, std::string("RTL"));
    QVERIFY(state.armed && state.highLatency);
    QCOMPARE(state.heading, 90.);
    QCOMPARE(state.batteryPercent, 60.);
}

void VehicleTest::modeNamesRoundTrip()
{
    const VehicleKind kinds[] = {{2, 3}, {1, 3}, {10, 3}, {12, 3}, {5, 3}, {2, 12}, {20, 3}};
    for (const VehicleKind kind : kinds) {
        const auto names = modeNames(kind);
        QVERIFY(names.size() > 5);
        for (const std::string &name : names) {
            const auto number = modeNumber(kind, name);
            QVERIFY(number);
            QCOMPARE(modeName(kind, 1, *number), name);
        }
    }
    QCOMPARE(modeName({1, 3}, 1, 11), std::string("RTL"));
    QCOMPARE(modeName({10, 3}, 1, 4), std::string("HOLD"));
    QCOMPARE(modeNumber({2, 3}, "loiter").value(), 5u);
}

void VehicleTest::unknownModesKeepTheirNumber()
{
    QCOMPARE(modeName({2, 3}, 1, 99), std::string("MODE(99)"));
    QCOMPARE(modeNumber({2, 3}, "MODE(99)").value(), 99u);
    QVERIFY(!modeNumber({2, 3}, "MODE(99"));
    QVERIFY(!modeNumber({2, 3}, "MODE()"));
    QVERIFY(!modeNumber({2, 3}, "MODE(99999999999)"));
    QCOMPARE(modeName({2, 0}, 1, 17), std::string("MODE(17)"));
    QCOMPARE(modeName({2, 0}, 4, 0), std::string("AUTO"));
    QVERIFY(modeNames({2, 0}).empty());
}

void VehicleTest::ardupilotIsAskedForStreams()
{
    Harness h;
    h.feed(heartbeat());
    h.runUntil(h.now);
    const auto messages = h.sent();
    std::map<int, int> rates;
    std::vector<float> intervals;
    for (const OutMessage &message : messages) {
        if (const auto stream = as<mavlink::RequestDataStream>(message)) {
            QCOMPARE(stream->start_stop, std::uint8_t(1));
            rates[stream->req_stream_id] = stream->req_message_rate;
        }
        const auto command = as<mavlink::CommandLong>(message);
        if (command && command->command == mavlink::MAV_CMD_SET_MESSAGE_INTERVAL)
            intervals.push_back(command->param1);
    }
    QCOMPARE(rates, (std::map<int, int>{{1, 2}, {2, 2}, {3, 2}, {6, 3}, {10, 10}, {11, 10}, {12, 3}}));
    QCOMPARE(intervals, (std::vector<float>{242, 245}));
}

void VehicleTest::whatComesByItselfIsAskedForAllTheSame()
{
    // In one datagram with the first heartbeat, at the rate that the vehicle was left at.
    Harness h;
    h.feed(heartbeat());
    h.feed(mavlink::EkfStatusReport{});
    h.feed(mavlink::Attitude{});
    h.runUntil(h.now);
    QCOMPARE(h.sentOf<mavlink::RequestDataStream>().size(), std::size_t(7));
}

void VehicleTest::silentGroupIsAskedForAgain()
{
    Harness h;
    h.feed(heartbeat());
    h.runUntil(h.now);
    h.sent();
    // Attitude comes, the rest does not: only the rest is asked for, after 2 s.
    for (int i = 0; i < 19; ++i) {
        h.runUntil(h.now + std::chrono::milliseconds(100));
        h.feed(mavlink::Attitude{});
    }
    QCOMPARE(h.sentOf<mavlink::RequestDataStream>().size(), std::size_t(0));
    h.runUntil(at(102));
    const auto again = h.sentOf<mavlink::RequestDataStream>();
    QCOMPARE(again.size(), std::size_t(6));
    QVERIFY(std::none_of(again.begin(), again.end(), [](const auto &m) { return m.req_stream_id == 10; }));
    // A request without an answer is repeated at growing intervals: at 6, 14, 30, 62, 126 and 190 s.
    std::size_t rc = 0;
    for (int second = 103; second <= 300; ++second) {
        h.runUntil(at(second));
        for (const auto &m : h.sentOf<mavlink::RequestDataStream>())
            rc += m.req_stream_id == 3;
    }
    QCOMPARE(rc, std::size_t(6));
}

void VehicleTest::px4IsNotAsked()
{
    Harness h;
    h.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    h.runUntil(at(150));
    for (const OutMessage &message : h.sent()) {
        QVERIFY(message.id != mavlink::RequestDataStream::kId);
        const auto command = as<mavlink::CommandLong>(message);
        QVERIFY(!command || command->command != mavlink::MAV_CMD_SET_MESSAGE_INTERVAL);
    }
}

void VehicleTest::oneRateForAllStreams()
{
    VehicleConfig config;
    config.streamRate = 50;
    Harness h(config);
    h.feed(heartbeat());
    h.runUntil(h.now);
    const auto asked = h.sentOf<mavlink::RequestDataStream>();
    QCOMPARE(asked.size(), std::size_t(7));
    for (const auto &m : asked)
        QCOMPARE(m.req_message_rate, std::uint16_t(50));
    h.vehicle.setStreams(h.now, StreamProfile::LowBandwidth);
    h.runUntil(h.now);
    for (const auto &m : h.sentOf<mavlink::RequestDataStream>()) {
        QVERIFY(m.req_message_rate <= 2);
        QCOMPARE(m.start_stop != 0, m.req_message_rate > 0);
    }
}

void VehicleTest::unsupportedIntervalsAreGivenUp()
{
    Harness h;
    h.feed(heartbeat());
    h.runUntil(h.now);
    h.sent();
    h.ack(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, mavlink::MAV_RESULT_UNSUPPORTED);
    h.runUntil(at(300));
    for (const auto &m : h.sentOf<mavlink::CommandLong>())
        QVERIFY(m.command != mavlink::MAV_CMD_SET_MESSAGE_INTERVAL);
}

/// ArduCopter 3.6 knows GET_HOME_POSITION, but not SET_MESSAGE_INTERVAL.
void VehicleTest::homeIsRequestedWhereItCannotBeStreamed()
{
    Harness h;
    const auto requests = [&h] {
        int count = 0;
        for (const auto &m : h.sentOf<mavlink::CommandLong>())
            count += m.command == mavlink::MAV_CMD_GET_HOME_POSITION;
        return count;
    };
    h.feed(heartbeat());
    h.runUntil(h.now);
    QCOMPARE(requests(), 0);
    h.ack(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, mavlink::MAV_RESULT_UNSUPPORTED);
    h.ack(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, mavlink::MAV_RESULT_UNSUPPORTED); // of the other messages
    h.runUntil(h.now);
    QCOMPARE(requests(), 1);
    h.runUntil(h.now + std::chrono::seconds(3));
    QCOMPARE(requests(), 1); // it had no home yet
    mavlink::HomePosition home;
    home.latitude = 480000000;
    home.longitude = 110000000;
    h.feed(home);
    QCOMPARE(h.vehicle.current().home.latitude, 48.);
    h.sent();
    h.runUntil(h.now + std::chrono::seconds(9));
    QCOMPARE(requests(), 1); // it may have been moved
    h.ack(mavlink::MAV_CMD_GET_HOME_POSITION, mavlink::MAV_RESULT_UNSUPPORTED);
    h.runUntil(h.now + std::chrono::seconds(100));
    QCOMPARE(requests(), 0);
}

void VehicleTest::lostVehicleIsAskedAnewWhenItReturns()
{
    Harness h;
    h.feed(heartbeat());
    h.runUntil(h.now);
    h.feed(mavlink::Attitude{});
    h.runUntil(at(105));
    h.sent();
    h.feed(heartbeat());
    h.runUntil(h.now);
    QCOMPARE(h.sentOf<mavlink::RequestDataStream>().size(), std::size_t(7));
}

void VehicleTest::versionIsAskedForInTurnsUntilItComes()
{
    VehicleConfig config;
    config.streams = StreamProfile::Quiet;
    Harness h(config);
    h.feed(heartbeat());
    h.runUntil(at(102));
    const auto asked = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(asked.size(), std::size_t(2));
    QCOMPARE(asked[0].command, std::uint16_t(mavlink::MAV_CMD_REQUEST_MESSAGE));
    QCOMPARE(asked[0].param1, 148.f);
    QCOMPARE(asked[1].command, std::uint16_t(mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES));
    mavlink::AutopilotVersion version;
    version.flight_sw_version = 3u << 24 | 6u << 16 | 7u << 8 | 255;
    version.capabilities = 4;
    h.feed(version);
    QCOMPARE(h.vehicle.current().firmware, std::string("ArduCopter 3.6.7"));
    QCOMPARE(h.vehicle.current().capabilities, std::uint64_t(4));
    h.runUntil(at(130));
    QVERIFY(h.sentOf<mavlink::CommandLong>().empty());
}

void VehicleTest::latencyIsMeasuredAndSmoothed()
{
    Harness h = Harness::copter();
    QVERIFY(std::isnan(h.vehicle.current().latency));
    const auto request = h.nextSent<mavlink::Timesync>(at(101));
    QVERIFY(request);
    mavlink::Timesync answer;
    answer.tc1 = 12345;
    answer.ts1 = request->second.ts1;
    h.runUntil(request->first + std::chrono::milliseconds(40));
    h.feed(answer);
    QCOMPARE(h.vehicle.current().latency, 0.04);
    h.runUntil(h.now + std::chrono::milliseconds(400));
    h.feed(answer); // twice the same: counts once
    QCOMPARE(h.vehicle.current().latency, 0.04);
    answer.ts1 += 1; // never sent
    h.feed(answer);
    QCOMPARE(h.vehicle.current().latency, 0.04);
    const auto second = h.nextSent<mavlink::Timesync>(at(102));
    QVERIFY(second);
    answer.ts1 = second->second.ts1;
    h.runUntil(second->first + std::chrono::milliseconds(140));
    h.feed(answer);
    QVERIFY(std::abs(h.vehicle.current().latency - 0.06) < 1e-9); // a fifth of the way
}

void VehicleTest::answersTheVehiclesTimeSync()
{
    Harness h = Harness::copter();
    mavlink::Timesync request;
    request.ts1 = 777;
    h.feed(request);
    const auto answer = h.sentOf<mavlink::Timesync>();
    QCOMPARE(answer.size(), std::size_t(1));
    QCOMPARE(answer[0].ts1, std::int64_t(777));
    QCOMPARE(answer[0].tc1, std::int64_t(100'000'000'000));
}

void VehicleTest::homeIsWhereItWasArmedUntilItSays()
{
    Harness h = Harness::copter(0, false);
    mavlink::GlobalPositionInt position;
    position.lat = 480000000;
    position.lon = 110000000;
    h.feed(position);
    QVERIFY(!h.vehicle.current().home.known());
    h.feed(heartbeat(0, true));
    QCOMPARE(h.vehicle.current().home.latitude, 48.0);
    position.lat = 480010000; // 0.001° north
    h.feed(position);
    QVERIFY(std::abs(h.vehicle.current().distanceHome - 111.19) < 0.05);
    mavlink::HomePosition home;
    home.latitude = 480010000;
    home.longitude = 110000000;
    home.altitude = 500000;
    h.feed(home);
    QCOMPARE(h.vehicle.current().distanceHome, 0.);
    QCOMPARE(h.vehicle.current().home.altitude, 500.);
    h.feed(heartbeat(0, false));
    h.feed(heartbeat(0, true)); // armed again: the vehicle's word stands
    QCOMPARE(h.vehicle.current().home.latitude, 48.001);
}

void VehicleTest::flightTimeCountsInTheAirOnly()
{
    Harness h = Harness::copter(4, true);
    mavlink::GlobalPositionInt position;
    const auto altitude = [&](double s, double metres) {
        h.now = at(s);
        position.relative_alt = static_cast<std::int32_t>(metres * 1000);
        h.feed(position);
    };
    altitude(105, 0.1);
    QCOMPARE(h.vehicle.state(at(106)).flightTime, 0.);
    altitude(110, 1);
    QCOMPARE(h.vehicle.state(at(112)).flightTime, 2.);
    altitude(120, 0);
    QCOMPARE(h.vehicle.state(at(130)).flightTime, 10.);
    altitude(140, 5); // up again without disarming: the same flight
    QCOMPARE(h.vehicle.state(at(141)).flightTime, 11.);
    h.now = at(150);
    h.feed(heartbeat(4, false));
    QCOMPARE(h.vehicle.state(at(160)).flightTime, 20.);
    h.feed(heartbeat(4, true));
    altitude(170, 5);
    QCOMPARE(h.vehicle.state(at(171)).flightTime, 21.); // armed at 5 m: a new flight from there
}

void VehicleTest::flightTimeEndsWithARestart()
{
    Harness h = Harness::copter(4, true);
    mavlink::GlobalPositionInt position;
    const auto fly = [&](double s, std::uint32_t sinceBoot) {
        h.now = at(s);
        position.relative_alt = 5000;
        position.time_boot_ms = sinceBoot;
        h.feed(position);
    };
    fly(110, 60'000);
    fly(120, 70'000);
    fly(121, 69'500); // a late frame
    QCOMPARE(h.vehicle.state(at(125)).flightTime, 15.);
    fly(200, 4'000); // restarted in the air
    QCOMPARE(h.vehicle.state(at(203)).flightTime, 3.);
}

void VehicleTest::gcsHeartbeatIsDueOnceASecond()
{
    GcsHeartbeat beat;
    const auto first = beat.poll(at(5));
    QVERIFY(first && first->urgent);
    const auto message = as<mavlink::Heartbeat>(*first);
    QVERIFY(message);
    QCOMPARE(message->type, std::uint8_t(6));
    QCOMPARE(message->autopilot, std::uint8_t(8));
    QVERIFY(!beat.poll(at(5.999)));
    QCOMPARE(beat.nextDeadline(), at(6));
    QVERIFY(beat.poll(at(30)));
    QVERIFY(!beat.poll(at(30.5)));
}

void VehicleTest::outboxIsBounded()
{
    MessageQueue outbox(3);
    for (std::uint32_t i = 0; i < 5; ++i) {
        OutMessage message;
        message.id = i;
        QCOMPARE(outbox.push(message), i < 3);
    }
    QCOMPARE(outbox.refused(), std::uint64_t(2));
    QCOMPARE(outbox.take()->id, 0u);
    OutMessage more;
    more.id = 9;
    QVERIFY(outbox.push(more));
    for (const std::uint32_t expected : {1u, 2u, 9u})
        QCOMPARE(outbox.take()->id, expected);
    QVERIFY(!outbox.take());
}

SKYSEAL_TEST_APPLESS(VehicleTest)
#include "vehicle_test.moc"
