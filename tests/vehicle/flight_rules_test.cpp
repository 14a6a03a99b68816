// What the table of autopilots and frames offers: acts and modes, of real vehicles by their recordings, and of the kinds that
// no recording shows. How the commands are carried out is in command_test.
#include "recorded_flight.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/px4_mode.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/flight_rules.h"

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

/// "arm", "mode GUIDED", "NAV_TAKEOFF 10", or the reason against it.
QString firstStep(const Result<CommandPlan, Reason> &plan)
{
    if (!plan)
        return QStringLiteral("no: ") + QString::fromStdString(plan.error().text());
    if (const auto *mode = std::get_if<ModeIs>(&plan->effect))
        return QStringLiteral("mode ") + QString::fromStdString(mode->name);
    if (const auto *armed = std::get_if<ArmedIs>(&plan->effect))
        return armed->armed ? QStringLiteral("arm") : QStringLiteral("disarm");
    const auto &order = std::get<CommandOrder>(plan->alternatives.front());
    switch (order.command) {
    case mavlink::MAV_CMD_NAV_TAKEOFF: return QStringLiteral("NAV_TAKEOFF %1").arg(std::lround(order.parameters[6]));
    case mavlink::MAV_CMD_NAV_LAND: return QStringLiteral("NAV_LAND");
    case mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH: return QStringLiteral("NAV_RETURN_TO_LAUNCH");
    case mavlink::MAV_CMD_MISSION_START: return QStringLiteral("MISSION_START");
    default: return QStringLiteral("command %1").arg(order.command);
    }
}

/// All steps of a command, when each takes effect.
QString steps(const VehicleCommand &command, VehicleState state)
{
    QStringList out;
    for (VehicleCommand next = command; out.size() < 5;) {
        const auto plan = planCommand(next, state, {});
        out << firstStep(plan);
        if (!plan || !plan->then)
            break;
        if (const auto *mode = std::get_if<ModeIs>(&plan->effect)) {
            state.mode = mode->name;
            state.customMode = mode->customMode;
        }
        if (const auto *armed = std::get_if<ArmedIs>(&plan->effect))
            state.armed = armed->armed;
        next = *plan->then;
    }
    return out.join(QStringLiteral(", "));
}

VehicleState stateOf(std::uint8_t type, std::uint8_t autopilot, bool armed = false, bool verticalTakeOff = false)
{
    VehicleState state;
    state.type = type;
    state.autopilot = autopilot;
    state.baseMode = mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    state.armed = armed;
    state.verticalTakeOff = verticalTakeOff;
    state.mode = modeName({type, autopilot}, state.baseMode, state.customMode);
    state.position = state.home = {47.4, 8.5, 488};
    state.altitudeRelative = 0;
    return state;
}

QString joined(const std::vector<std::string> &names)
{
    QStringList out;
    for (const std::string &name : names)
        out << QString::fromStdString(name);
    return out.join(QLatin1Char(' '));
}

constexpr std::uint8_t kArduPilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA, kPx4 = mavlink::MAV_AUTOPILOT_PX4,
                       kGeneric = mavlink::MAV_AUTOPILOT_GENERIC;

} // namespace

class FlightRulesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recordedVehiclesOfferTheirActs_data();
    void recordedVehiclesOfferTheirActs();
    void recordedVehiclesOfferTheirModes_data();
    void recordedVehiclesOfferTheirModes();
    void otherKinds_data();
    void otherKinds();
    void everyModeOfARuleExists();
    void whatAPlaneSaysOfItself_data();
    void whatAPlaneSaysOfItself();
    void listedModesThatNobodyMaySetAreNotOffered();
    void armingBeginsSomeFlights();
};

void FlightRulesTest::recordedVehiclesOfferTheirActs_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("takeOff");
    QTest::addColumn<QString>("mission");
    QTest::addColumn<QString>("land");
    QTest::addColumn<QString>("home");
    QTest::addColumn<QString>("hold");
    QTest::addColumn<QString>("disarm");
    const auto row = [](const char *what, const char *file, double seconds, std::initializer_list<const char *> acts) {
        QTestData &data = QTest::newRow(what) << QString::fromLatin1(file) << seconds;
        for (const char *act : acts)
            data << QString::fromLatin1(act);
    };
    const char *const copter = "arducopter-4.7-dev.tlog", *const quadplane = "quadplane-4.7-dev.tlog",
                      *const px4 = "px4-quadrotor-1.19.tlog", *const vtol = "px4-vtol-1.19.tlog";
    const char *const inAir = "no: the vehicle is in the air; only an emergency stop ends its motors";
    row("ArduCopter in STABILIZE", copter, 30,
        {"mode GUIDED, arm, NAV_TAKEOFF 10", "mode GUIDED, arm, MISSION_START", "mode LAND", "mode RTL", "mode BRAKE",
         "disarm"});
    row("ArduCopter flying", copter, 48, {"NAV_TAKEOFF 10", "MISSION_START", "mode LAND", "mode RTL", "mode BRAKE", inAir});
    row("ArduCopter landed", copter, 74,
        {"mode GUIDED, arm, NAV_TAKEOFF 10", "mode GUIDED, arm, MISSION_START", "mode LAND", "mode RTL", "mode BRAKE",
         "disarm"});
    row("quadplane on the ground", quadplane, 1.2,
        {"mode GUIDED, arm, NAV_TAKEOFF 10", "arm, MISSION_START", "mode QLAND", "mode RTL", "mode LOITER", "disarm"});
    row("quadplane flying", quadplane, 8, {"NAV_TAKEOFF 10", "MISSION_START", "mode QLAND", "mode RTL", "mode LOITER", inAir});
    row("PX4 at rest", px4, 1.4,
        {"arm, NAV_TAKEOFF 10", "arm, mode MISSION", "NAV_LAND", "NAV_RETURN_TO_LAUNCH", "mode LOITER", "disarm"});
    row("PX4 flying", px4, 10, {"NAV_TAKEOFF 10", "mode MISSION", "NAV_LAND", "NAV_RETURN_TO_LAUNCH", "mode LOITER", inAir});
    row("PX4 landed, armed", px4, 30,
        {"NAV_TAKEOFF 10", "mode MISSION", "NAV_LAND", "NAV_RETURN_TO_LAUNCH", "mode LOITER", "disarm"});
    row("PX4 VTOL at rest", vtol, 1.4,
        {"arm, NAV_TAKEOFF 10", "arm, mode MISSION", "NAV_LAND", "NAV_RETURN_TO_LAUNCH", "mode LOITER", "disarm"});
    row("PX4 VTOL flying", vtol, 8,
        {"NAV_TAKEOFF 10", "mode MISSION", "NAV_LAND", "NAV_RETURN_TO_LAUNCH", "mode LOITER", inAir});
}

void FlightRulesTest::recordedVehiclesOfferTheirActs()
{
    QFETCH(QString, file);
    QFETCH(double, seconds);
    const auto recorded = RecordedFlight(file, seconds).state();
    QVERIFY(recorded);
    VehicleState state = *recorded;
    const double ground = state.home.known() ? state.home.altitude : state.position.altitude;
    const double above = VehicleKind{state.type, state.autopilot}.isPx4() ? ground : 0;
    QTEST(steps(TakeOff{.altitude = 10, .prepare = true}, state)
              .replace(QStringLiteral("NAV_TAKEOFF %1").arg(std::lround(10 + above)), QStringLiteral("NAV_TAKEOFF 10")),
          "takeOff");
    QTEST(steps(StartMission{.prepare = true}, state), "mission");
    QTEST(steps(Land{}, state), "land");
    QTEST(steps(ReturnToLaunch{}, state), "home");
    QTEST(steps(Loiter{}, state), "hold");
    QTEST(steps(Disarm{}, state), "disarm");
    QCOMPARE(steps(Disarm{.force = true}, state), QStringLiteral("disarm"));
    // A script says each step, and is told which one is missing.
    if (!state.armed) {
        QVERIFY(steps(TakeOff{}, state).startsWith(QStringLiteral("no: take-off needs ")));
        QCOMPARE(steps(StartMission{}, state), QStringLiteral("no: a mission needs an armed vehicle to start, it is disarmed"));
    }
    QVERIFY(!armsFirst(TakeOff{}, state) && !armsFirst(Land{}, state));
    QCOMPARE(armsFirst(TakeOff{.prepare = true}, state), !state.armed);
}

void FlightRulesTest::recordedVehiclesOfferTheirModes_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("modes");
    QTest::newRow("ArduCopter") << "arducopter-4.7-dev.tlog"
                                << "STABILIZE ACRO ALT_HOLD AUTO GUIDED LOITER RTL CIRCLE LAND DRIFT SPORT FLIP AUTOTUNE "
                                   "POSHOLD BRAKE THROW GUIDED_NOGPS SMART_RTL FLOWHOLD FOLLOW ZIGZAG SYSTEMID AUTO_RTL TURTLE";
    QTest::newRow("quadplane") << "quadplane-4.7-dev.tlog"
                               << "MANUAL CIRCLE STABILIZE TRAINING ACRO FBWA FBWB CRUISE AUTOTUNE AUTO RTL LOITER TAKEOFF "
                                  "GUIDED QSTABILIZE QHOVER QLOITER QLAND QRTL QAUTOTUNE QACRO THERMAL LOITERALTQLAND AUTOLAND";
    QTest::newRow("PX4 quadrotor") << "px4-quadrotor-1.19.tlog"
                                   << "MANUAL ALTCTL POSCTL POSITION_SLOW TAKEOFF LOITER MISSION RTL LAND FOLLOWME PRECLAND "
                                      "ACRO OFFBOARD STABILIZED ALTITUDE_CRUISE";
    QTest::newRow("PX4 VTOL") << "px4-vtol-1.19.tlog"
                              << "MANUAL ALTCTL POSCTL POSITION_SLOW TAKEOFF LOITER MISSION RTL LAND FOLLOWME PRECLAND "
                                 "VTOL_TAKEOFF ACRO OFFBOARD STABILIZED ALTITUDE_CRUISE";
}

void FlightRulesTest::recordedVehiclesOfferTheirModes()
{
    QFETCH(QString, file);
    const auto state = RecordedFlight(file, 5).state();
    QVERIFY(state);
    QTEST(joined(state->modes), "modes");
}

void FlightRulesTest::otherKinds_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("autopilot");
    QTest::addColumn<QString>("takeOff");
    QTest::addColumn<QString>("land");
    QTest::addColumn<QString>("home");
    QTest::addColumn<QString>("mission");
    const auto row = [](const char *what, int type, int autopilot, const char *takeOff, const char *land, const char *home,
                        const char *mission) {
        QTest::newRow(what) << type << autopilot << takeOff << land << home << mission;
    };
    const char *const notFlying = "no: this kind of vehicle does not fly",
                      *const noLanding = "no: this kind of vehicle has no mode to land in";
    row("ArduPlane", mavlink::MAV_TYPE_FIXED_WING, kArduPilot,
        "no: a plane without vertical take-off takes off in the mode TAKEOFF, or in a mission",
        "no: a plane without vertical take-off lands in a mission, or by hand", "mode RTL", "arm, MISSION_START");
    row("ArduPilot's helicopter", mavlink::MAV_TYPE_HELICOPTER, kArduPilot, "mode GUIDED, arm, NAV_TAKEOFF 10", "mode LAND",
        "mode RTL", "mode GUIDED, arm, MISSION_START");
    row("ArduRover", mavlink::MAV_TYPE_GROUND_ROVER, kArduPilot, notFlying, noLanding, "mode RTL", "arm, MISSION_START");
    row("ArduSub", mavlink::MAV_TYPE_SUBMARINE, kArduPilot, notFlying, "mode SURFACE",
        "no: this kind of vehicle has no mode to return in", "arm, MISSION_START");
    row("antenna tracker", mavlink::MAV_TYPE_ANTENNA_TRACKER, kArduPilot, notFlying, noLanding,
        "no: this kind of vehicle has no mode to return in", "no: this kind of vehicle flies no missions");
    row("PX4 plane", mavlink::MAV_TYPE_FIXED_WING, kPx4, "arm, NAV_TAKEOFF 498", "NAV_LAND", "NAV_RETURN_TO_LAUNCH",
        "arm, mode MISSION");
    row("PX4 rover", mavlink::MAV_TYPE_GROUND_ROVER, kPx4, notFlying, noLanding, "NAV_RETURN_TO_LAUNCH", "arm, mode MISSION");
    row("another autopilot", mavlink::MAV_TYPE_QUADROTOR, kGeneric, "NAV_TAKEOFF 10", "NAV_LAND", "NAV_RETURN_TO_LAUNCH",
        "MISSION_START");
}

void FlightRulesTest::otherKinds()
{
    QFETCH(int, type);
    QFETCH(int, autopilot);
    const VehicleState state = stateOf(std::uint8_t(type), std::uint8_t(autopilot));
    QTEST(steps(TakeOff{.altitude = 10, .prepare = true}, state), "takeOff");
    QTEST(steps(Land{}, state), "land");
    QTEST(steps(ReturnToLaunch{}, state), "home");
    QTEST(steps(StartMission{.prepare = true}, state), "mission");
}

/// And is offered, so that nothing advises a mode that cannot be chosen.
void FlightRulesTest::everyModeOfARuleExists()
{
    int checked = 0;
    for (const std::uint8_t autopilot : {kArduPilot, kPx4, kGeneric}) {
        for (int type = 0; type < 50; ++type) {
            for (const bool vertical : {false, true}) {
                const VehicleState state = stateOf(std::uint8_t(type), autopilot, false, vertical);
                const FlightRules &rules = rulesOf(state);
                const auto offered = modeNames({state.type, state.autopilot}, vertical);
                for (const std::string_view mode : {rules.takesOffIn, rules.armsForMissionIn, rules.land.mode,
                                                    rules.returnHome.mode, rules.hold.mode, rules.mission.mode}) {
                    if (mode.empty())
                        continue;
                    ++checked;
                    QVERIFY2(std::ranges::find(offered, mode) != offered.end(),
                             qPrintable(QStringLiteral("type %1: ").arg(type) + QString::fromStdString(std::string(mode))));
                }
            }
        }
    }
    QVERIFY(checked > 100);
}

void FlightRulesTest::whatAPlaneSaysOfItself_data()
{
    QTest::addColumn<QString>("sign");
    QTest::addColumn<bool>("vertical");
    QTest::newRow("nothing") << "" << false;
    QTest::newRow("EXTENDED_SYS_STATE without a state") << "undefined" << false;
    QTest::newRow("EXTENDED_SYS_STATE") << "state" << true;
    QTest::newRow("its mode") << "mode" << true;
    QTest::newRow("its modes") << "modes" << true;
    QTest::newRow("Q_ENABLE") << "parameter" << true;
    QTest::newRow("Q_ENABLE 0") << "parameter 0" << false;
    QTest::newRow("its type") << "type" << true;
}

/// A quadplane of ArduPilot is of the type of planes.
void FlightRulesTest::whatAPlaneSaysOfItself()
{
    QFETCH(QString, sign);
    QFETCH(bool, vertical);
    Harness h;
    const auto beat = [&](std::uint32_t mode) {
        h.feed(heartbeat(mode, false,
                         sign == QLatin1String("type") ? mavlink::MAV_TYPE_VTOL_FIXEDROTOR : mavlink::MAV_TYPE_FIXED_WING));
    };
    beat(sign == QLatin1String("mode") ? mavlink::PLANE_MODE_QLOITER : mavlink::PLANE_MODE_MANUAL);
    if (sign == QLatin1String("state"))
        h.feed(mavlink::ExtendedSysState{.vtol_state = mavlink::MAV_VTOL_STATE_MC, .landed_state = 1});
    if (sign == QLatin1String("undefined"))
        h.feed(mavlink::ExtendedSysState{.vtol_state = mavlink::MAV_VTOL_STATE_UNDEFINED, .landed_state = 1});
    if (sign == QLatin1String("modes")) {
        mavlink::AvailableModes mode;
        mode.number_modes = mode.mode_index = 1;
        mode.custom_mode = mavlink::PLANE_MODE_QLAND;
        h.feed(mode);
    }
    if (sign.startsWith(QLatin1String("parameter"))) {
        mavlink::ParamValue value;
        mavlink::setText(value.param_id, "Q_ENABLE");
        value.param_value = sign == QLatin1String("parameter") ? 1 : 0;
        value.param_type = mavlink::MAV_PARAM_TYPE_INT8;
        h.feed(value);
    }
    beat(mavlink::PLANE_MODE_MANUAL);
    const VehicleState &state = h.vehicle.current();
    QCOMPARE(std::ranges::find(state.modes, "QLAND") != state.modes.end(), vertical);
    QCOMPARE(steps(Land{}, state) == QStringLiteral("mode QLAND"), vertical);
    QCOMPARE(steps(TakeOff{.prepare = true}, state).startsWith(QStringLiteral("mode GUIDED")), vertical);
}

void FlightRulesTest::listedModesThatNobodyMaySetAreNotOffered()
{
    const OwnMode listed[] = {{mavlink::PLANE_MODE_AUTO, "Auto", true},
                              {mavlink::PLANE_MODE_INITIALIZING, "Initialising", true}, // as ArduPlane lists it
                              {mavlink::PLANE_MODE_CRUISE, "Cruise", false},
                              {99, "Glide", true}};
    QCOMPARE(joined(modeNames({mavlink::MAV_TYPE_FIXED_WING, kArduPilot}, false, listed)), QStringLiteral("Auto Glide"));
    const OwnMode orbit[] = {{mavlink::kPx4Orbit, "Orbit", true}, {mavlink::kPx4External1, "Survey", true}};
    QCOMPARE(joined(modeNames({mavlink::MAV_TYPE_QUADROTOR, kPx4}, false, orbit)), QStringLiteral("Survey"));
    QCOMPARE(modeName({mavlink::MAV_TYPE_QUADROTOR, kPx4}, 1, mavlink::kPx4Orbit, orbit), std::string("Orbit"));
}

void FlightRulesTest::armingBeginsSomeFlights()
{
    VehicleState px4 = stateOf(mavlink::MAV_TYPE_QUADROTOR, kPx4);
    QVERIFY(!armingTakesOff(px4));
    px4.customMode = mavlink::kPx4AutoTakeOff;
    QVERIFY(armingTakesOff(px4));
    VehicleState copter = stateOf(mavlink::MAV_TYPE_QUADROTOR, kArduPilot);
    copter.customMode = mavlink::COPTER_MODE_AUTO; // it does not arm there
    QVERIFY(!armingTakesOff(copter));
    VehicleState plane = stateOf(mavlink::MAV_TYPE_FIXED_WING, kArduPilot);
    plane.customMode = mavlink::PLANE_MODE_TAKEOFF;
    QVERIFY(armingTakesOff(plane));
}

SKYSEAL_TEST_APPLESS(FlightRulesTest)
#include "flight_rules_test.moc"
