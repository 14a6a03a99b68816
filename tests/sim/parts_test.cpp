// The small parts on their own: attitude mathematics, places, the battery, parameters, the pilot's channels and the stream
// schedule.
#include "core/sim/battery.h"
#include "core/sim/flight_physics.h"
#include "core/sim/flight_settings.h"
#include "core/sim/gcs_watch.h"
#include "core/sim/geo_frame.h"
#include "core/sim/noise.h"
#include "core/sim/parameters.h"
#include "core/sim/pilot_input.h"
#include "core/sim/rotor_control.h"
#include "core/sim/stream_scheduler.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <map>

using namespace skyseal;
using namespace skyseal::sim;
using namespace std::chrono_literals;

class SimPartsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anglesSurviveTheQuaternion();
    void placesSurviveTheFrame();
    void noiseHasItsDeviation();
    void batterySagsAndEmpties();
    void parametersAreNamedAndGuarded();
    void settingsFollowTheParameters();
    void overridesExpire();
    void streamRatesAreExact();
    void singleIntervalsOverrideGroups();
    void silenceOfTheStationIsToldOnce();
    void rotorsFollowArmingAndDemand();
    void physicsLiftsAVehicle();
};

void SimPartsTest::anglesSurviveTheQuaternion()
{
    QVERIFY(rc::check("Euler angles to quaternion and back", [] {
        const auto angle = [](double limit) { return *rc::gen::inRange(-1000, 1000) / 1000.0 * limit; };
        const Euler in{angle(3.1), angle(1.5), angle(3.1)};
        const Euler out = Attitude::fromEuler(in).euler();
        RC_ASSERT(std::abs(wrapPi(in.roll - out.roll)) < 1e-6);
        RC_ASSERT(std::abs(in.pitch - out.pitch) < 1e-6);
        RC_ASSERT(std::abs(wrapPi(in.yaw - out.yaw)) < 1e-6);
        const Attitude turned = Attitude::fromEuler(in);
        const Vector3 v{1, -2, 3};
        RC_ASSERT((turned.toBody(turned.toWorld(v)) - v).length() < 1e-9);
        RC_ASSERT(turned.errorTo(turned).length() < 1e-6);
    }));
}

void SimPartsTest::placesSurviveTheFrame()
{
    QVERIFY(rc::check("local to global and back", [] {
        const GeoFrame frame({*rc::gen::inRange(-80, 80) + 0.5, *rc::gen::inRange(-180, 180) + 0.25, 100});
        const Vector3 in{*rc::gen::inRange(-9000, 9000) * 1.0, *rc::gen::inRange(-9000, 9000) * 1.0,
                         *rc::gen::inRange(-500, 50) * 1.0};
        RC_ASSERT((frame.toLocal(frame.toGeo(in)) - in).length() < 0.01);
    }));
}

void SimPartsTest::noiseHasItsDeviation()
{
    Noise noise(7, 1);
    double sum = 0, squares = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const double value = noise.normal(2);
        QVERIFY(std::abs(value) <= 7.0);
        sum += value;
        squares += value * value;
    }
    QVERIFY(std::abs(sum / kCount) < 0.06);
    QVERIFY(std::abs(std::sqrt(squares / kCount) - 2) < 0.05);
    QVERIFY(Noise(7, 1).next() != Noise(7, 2).next());
    QVERIFY(Noise(7, 1).next() != Noise(8, 1).next());
}

void SimPartsTest::batterySagsAndEmpties()
{
    Battery battery;
    battery.replace(3300, 1);
    for (int i = 0; i < 400; ++i)
        battery.step(0.0025, 0, false);
    const double rest = battery.voltage();
    QVERIFY(rest > 12.4);
    double minutes = 0;
    double last = 100;
    while (battery.percent() > 10) {
        for (int i = 0; i < 600; ++i)
            battery.step(0.1, 0.35, true);
        ++minutes;
        QVERIFY(battery.percent() < last);
        last = battery.percent();
    }
    QVERIFY2(minutes > 9 && minutes < 20, qPrintable(QString::number(minutes))); // such vehicles fly a quarter of an hour
    QVERIFY(battery.voltage() < 11.2 && battery.voltage() > 9.5);
}

void SimPartsTest::parametersAreNamedAndGuarded()
{
    Parameters parameters;
    QVERIFY(parameters.count() >= 100);
    for (std::size_t i = 0; i < parameters.count(); ++i) {
        const ParameterInfo &info = parameters.info(i);
        QVERIFY2(info.name.size() <= 16 && !info.name.empty(), info.name.c_str());
        QVERIFY2(info.standard >= info.minimum && info.standard <= info.maximum, info.name.c_str());
        QCOMPARE(parameters.find(info.name), std::optional<std::size_t>(i)); // sorted, and no name twice
    }
    for (const char *name : {"SYSID_THISMAV", "WPNAV_SPEED", "RTL_ALT", "ATC_ANG_RLL_P", "PSC_POSXY_P", "BATT_CAPACITY",
                             "FS_GCS_ENABLE", "ARMING_CHECK", "SR0_EXTRA1", "INS_USE", "COMPASS_USE", "GPS_TYPE", "EK3_ENABLE",
                             "RC3_MIN", "SERVO1_FUNCTION", "FLTMODE1"})
        QVERIFY2(parameters.find(name), name);
    using R = Parameters::SetResult;
    const unsigned before = parameters.revision();
    QVERIFY(parameters.set("NO_SUCH", 1) == R::Unknown);
    QVERIFY(parameters.set("WPNAV_SPEED", std::nanf("")) == R::NotFinite);
    QVERIFY(parameters.set("WPNAV_SPEED", 1e9f) == R::OutOfRange);
    QCOMPARE(parameters.revision(), before);
    QVERIFY(parameters.set("RTL_ALT", 2000.4f) == R::Stored);
    QCOMPARE(parameters.value("RTL_ALT"), 2000.f); // an integer
}

void SimPartsTest::settingsFollowTheParameters()
{
    Parameters parameters;
    parameters.set("WPNAV_SPEED", 800);
    parameters.set("RTL_LOIT_TIME", 2500);
    const GeoFrame world(GeoPoint{});
    QCOMPARE(flightSettings(parameters, world).speed, 8.0);
    QCOMPARE(flightSettings(parameters, world).rtlLoiter, 2.5);
}

void SimPartsTest::overridesExpire()
{
    PilotInput pilot;
    const TimePoint start{};
    QCOMPARE(pilot.channels()[2], std::uint16_t(1000));
    pilot.setFlying(true);
    QCOMPARE(pilot.channels()[2], std::uint16_t(1500));
    pilot.override(start, {1600, 65535, 1200, 0, 65535, 65535, 65535, 65535});
    QCOMPARE(pilot.channels()[0], std::uint16_t(1600));
    QCOMPARE(pilot.channels()[1], std::uint16_t(1500));
    QCOMPARE(pilot.sticks().throttle, 0.2);
    pilot.expire(start + 2s, 3s);
    QVERIFY(pilot.overridden());
    pilot.expire(start + 4s, 3s);
    QVERIFY(!pilot.overridden());
    QCOMPARE(pilot.channels()[2], std::uint16_t(1500));
}

void SimPartsTest::streamRatesAreExact()
{
    Parameters parameters;
    const TimePoint start{};
    for (int rate : {1, 3, 7, 50, 100}) {
        StreamScheduler scheduler(start, Firmware::ArduPilot);
        QVERIFY(StreamScheduler::requestGroup(parameters, 0, rate));
        scheduler.applyParameters(start, parameters);
        std::map<std::uint32_t, int> count;
        for (TimePoint now = start; now < start + 60s; now += 1700us) {
            while (const auto message = scheduler.pollDue(now))
                ++count[*message];
        }
        QVERIFY(std::abs(count[0] - 60) <= 1); // HEARTBEAT
        for (std::uint32_t message : {30u, 33u, 74u, 1u, 65u, 193u})
            QVERIFY2(std::abs(count[message] - 60 * rate) <= 1, qPrintable(QString::number(count[message])));
    }
    QVERIFY(!StreamScheduler::requestGroup(parameters, 99, 4));
}

void SimPartsTest::singleIntervalsOverrideGroups()
{
    Parameters parameters;
    const TimePoint start{};
    StreamScheduler scheduler(start, Firmware::ArduPilot);
    scheduler.applyParameters(start, parameters);
    QCOMPARE(*scheduler.interval(30), Duration(250ms));
    QVERIFY(scheduler.setInterval(start, 30, 10ms));
    parameters.set("SR0_EXTRA1", 2);
    scheduler.applyParameters(start, parameters);
    QCOMPARE(*scheduler.interval(30), Duration(10ms));
    QVERIFY(scheduler.setInterval(start, 30, Duration::zero()));
    QCOMPARE(*scheduler.interval(30), Duration(500ms));
    QVERIFY(scheduler.setInterval(start, 30, -1us));
    QCOMPARE(*scheduler.interval(30), Duration::zero());
    scheduler.forgetSingles(10);
    scheduler.applyParameters(start, parameters);
    QCOMPARE(*scheduler.interval(30), Duration(500ms));
    QVERIFY(!scheduler.setInterval(start, 9999, 10ms));
    QVERIFY(!scheduler.interval(9999));
}

void SimPartsTest::silenceOfTheStationIsToldOnce()
{
    GcsWatch watch;
    const TimePoint start{};
    using enum GcsWatch::Event;
    QVERIFY(watch.update(start + 100s, 5s) == None); // never heard
    watch.heartbeat(start + 100s);
    QVERIFY(watch.update(start + 105s, 5s) == None);
    QVERIFY(watch.update(start + 106s, 5s) == Lost);
    QVERIFY(watch.update(start + 107s, 5s) == None);
    watch.heartbeat(start + 108s);
    QVERIFY(watch.update(start + 108s, 5s) == Back);
}

void SimPartsTest::rotorsFollowArmingAndDemand()
{
    const Estimate level;
    const FlightSettings settings;
    RotorControl rotors;
    FlightDemand climb;
    climb.idle = false;
    climb.vertical = Climb{2};
    rotors.update(0.0025, false, climb, level, settings);
    QVERIFY(rotors.idle());
    QCOMPARE(rotors.commands(), Rotors{});
    FlightDemand idle;
    idle.idle = true;
    rotors.update(0.0025, true, idle, level, settings);
    QVERIFY(rotors.idle());
    QVERIFY(rotors.commands()[0] > 0 && rotors.commands()[0] < 0.1 && rotors.thrust() == 0);
    for (int i = 0; i < 400; ++i)
        rotors.update(0.0025, true, climb, level, settings);
    QVERIFY(!rotors.idle());
    QVERIFY2(rotors.thrust() > settings.hoverThrottle, qPrintable(QString::number(rotors.thrust())));
}

void SimPartsTest::physicsLiftsAVehicle()
{
    FlightPhysics physics({}, 1, 90, 0);
    physics.battery().replace(5000, 1);
    QVERIFY(physics.truth().onGround);
    QVERIFY(std::abs(physics.truth().attitude.euler().yaw - radians(90)) < 1e-9);
    const FlightSettings settings;
    constexpr double kStep = 0.0025;
    std::uint64_t time = 0;
    FlightDemand climb;
    climb.vertical = Climb{2};
    for (int i = 0; i < 1600; ++i)
        physics.step(kStep, time += 2500, settings, climb, true);
    QVERIFY(!physics.truth().onGround && physics.truth().position.z < -1);
    QVERIFY(physics.battery().consumed() > 0);
}

SKYSEAL_TEST_APPLESS(SimPartsTest)
#include "parts_test.moc"
