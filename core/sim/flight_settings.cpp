#include "core/sim/flight_settings.h"

#include "core/sim/parameters.h"

namespace skyseal::sim {

namespace {

/// Values of parameters by name, converted to SI units.
class Reader
{
public:
    explicit Reader(const Parameters &parameters) : m_parameters(parameters) {}

    double plain(std::string_view name) const { return static_cast<double>(m_parameters.value(name)); }
    double hundredth(std::string_view name) const { return plain(name) / 100; }
    int integer(std::string_view name) const { return m_parameters.integer(name); }
    bool flag(std::string_view name) const { return m_parameters.flag(name); }

private:
    const Parameters &m_parameters;
};

using Action = FailsafeSettings::Action;

/// BATT_FS_LOW_ACT and BATT_FS_CRT_ACT: 0 only warns, 1 lands a copter and returns another vehicle.
Action batteryAction(const VehicleType &type, int action)
{
    if (action == 0)
        return std::nullopt;
    if (type.isRover())
        return action == 2 ? FlightMode::Hold : FlightMode::Rtl; // Rover/Rover.h
    return type.hovers() && action == 1 ? FlightMode::Land : FlightMode::Rtl;
}

/// FS_THR_ENABLE of ArduCopter. This vehicle has no SMART_RTL.
Action radioAction(int action)
{
    constexpr int kIgnored = 0, kLand = 3, kSmartReturnOrLand = 5, kBrakeOrLand = 7;
    switch (action) {
    case kIgnored: return std::nullopt;
    case kLand:
    case kSmartReturnOrLand: return FlightMode::Land;
    case kBrakeOrLand: return FlightMode::Brake;
    default: return FlightMode::Rtl;
    }
}

FlightSettings copterSettings(const Reader &p)
{
    const auto hundredth = [&](std::string_view name) { return p.hundredth(name); };
    const auto plain = [&](std::string_view name) { return p.plain(name); };
    FlightSettings s;
    s.speed = hundredth("WPNAV_SPEED");
    s.climb = hundredth("WPNAV_SPEED_UP");
    s.descent = hundredth("WPNAV_SPEED_DN");
    s.acceleration = hundredth("WPNAV_ACCEL");
    s.verticalAcceleration = hundredth("WPNAV_ACCEL_Z");
    s.waypointRadius = hundredth("WPNAV_RADIUS");
    s.landSpeed = hundredth("LAND_SPEED");
    s.landSpeedHigh = hundredth("LAND_SPEED_HIGH");
    s.landLow = hundredth("LAND_ALT_LOW");
    s.rtlAltitude = hundredth("RTL_ALT");
    s.rtlFinalAltitude = hundredth("RTL_ALT_FINAL");
    s.rtlSpeed = hundredth("RTL_SPEED");
    s.rtlClimbMin = hundredth("RTL_CLIMB_MIN");
    s.rtlCone = plain("RTL_CONE_SLOPE");
    s.rtlLoiter = plain("RTL_LOIT_TIME") / 1000;
    s.leanLimit = radians(hundredth("ANGLE_MAX"));
    s.pilotClimb = hundredth("PILOT_SPEED_UP");
    s.pilotDescent = p.flag("PILOT_SPEED_DN") ? hundredth("PILOT_SPEED_DN") : s.pilotClimb;
    s.pilotYawRate = radians(plain("PILOT_Y_RATE"));
    s.loiterSpeed = hundredth("LOIT_SPEED");
    s.brakeDeceleration = hundredth("LOIT_BRK_ACCEL");
    s.anglePRoll = plain("ATC_ANG_RLL_P");
    s.anglePPitch = plain("ATC_ANG_PIT_P");
    s.anglePYaw = plain("ATC_ANG_YAW_P");
    s.inputLag = plain("ATC_INPUT_TC");
    s.yawSlew = radians(hundredth("ATC_SLEW_YAW"));
    s.positionP = plain("PSC_POSXY_P");
    s.velocityP = plain("PSC_VELXY_P");
    s.velocityI = plain("PSC_VELXY_I");
    s.altitudeP = plain("PSC_POSZ_P");
    s.climbP = plain("PSC_VELZ_P");
    s.hoverThrottle = plain("MOT_THST_HOVER");
    s.spoolTime = plain("MOT_SPOOL_TIME");
    s.disarmDelay = plain("DISARM_DELAY");
    s.guidedTimeout = plain("GUID_TIMEOUT");

    constexpr int kContinueInAuto = 1, kContinueInGuided = 4; // FS_OPTIONS
    constexpr int kHoldAltitude = 2, kLandAlways = 3;         // FS_EKF_ACTION
    FailsafeSettings &f = s.failsafes;
    f.radio = radioAction(p.integer("FS_THR_ENABLE"));
    f.radioWatched = f.radio.has_value();
    f.radioThrottle = p.integer("FS_THR_VALUE");
    f.goesOnInAuto = (p.integer("FS_OPTIONS") & kContinueInAuto) != 0;
    f.goesOnInGuided = (p.integer("FS_OPTIONS") & kContinueInGuided) != 0;
    f.estimatorLimit = plain("FS_EKF_THRESH");
    f.estimator = p.integer("FS_EKF_ACTION") == kHoldAltitude ? FlightMode::AltHold : FlightMode::Land;
    f.estimatorAlways = p.integer("FS_EKF_ACTION") == kLandAlways;
    f.stationTimeout = plain("FS_GCS_TIMEOUT");
    if (const int action = p.integer("FS_GCS_ENABLE"); action != 0)
        f.station = action == 5 ? FlightMode::Land : FlightMode::Rtl;
    f.crashCheck = p.flag("FS_CRASH_CHECK");
    return s;
}

FlightSettings planeSettings(const Reader &p)
{
    FlightSettings s;
    s.hovers = false;
    s.speed = p.plain("AIRSPEED_CRUISE");
    s.climb = p.plain("TECS_CLMB_MAX");
    s.descent = p.plain("TECS_SINK_MAX");
    s.landSpeed = 0.7;
    s.waypointRadius = std::max(std::abs(p.plain("WP_RADIUS")), std::abs(p.plain("WP_LOITER_RAD")) + 15);
    s.loiterRadius = std::max(std::abs(p.plain("WP_LOITER_RAD")), 10.0);
    s.rtlAltitude = p.plain("RTL_ALTITUDE");
    s.takeOffHeight = p.plain("TKOFF_ALT");
    s.leanLimit = radians(p.plain("ROLL_LIMIT_DEG"));
    s.hoverThrottle = p.hundredth("TRIM_THROTTLE");
    s.spoolTime = 0;
    s.disarmDelay = 0;
    s.disarmAfterFlight = p.plain("LAND_DISARMDELAY");

    FailsafeSettings &f = s.failsafes;
    f.radioWatched = p.flag("THR_FAILSAFE");
    f.radioThrottle = p.integer("THR_FS_VALUE");
    f.goesOnInAuto = f.goesOnInGuided = p.integer("FS_LONG_ACTN") == 0; // ArduPlane/events.cpp
    if (f.radioWatched)
        f.radio = FlightMode::Rtl;
    f.stationTimeout = p.plain("FS_LONG_TIMEOUT");
    if (p.flag("FS_GCS_ENABL"))
        f.station = FlightMode::Rtl;
    f.crashCheck = false;
    return s;
}

FlightSettings roverSettings(const Reader &p)
{
    FlightSettings s;
    s.hovers = s.flies = false;
    s.speed = p.plain("WP_SPEED") > 0 ? p.plain("WP_SPEED") : p.plain("CRUISE_SPEED");
    s.rtlSpeed = p.plain("RTL_SPEED");
    s.waypointRadius = p.plain("WP_RADIUS");
    s.pilotYawRate = radians(p.plain("ATC_STR_RAT_MAX"));
    s.hoverThrottle = 0.5; // the stick as it is
    s.spoolTime = 0;
    s.disarmDelay = 0;

    // FS_ACTION: 0 nothing, 1 RTL, 2 and what this vehicle does not have: HOLD (Rover/failsafe.cpp).
    const int number = p.integer("FS_ACTION");
    const Action action = number == 0 ? Action() : number == 1 ? FlightMode::Rtl : FlightMode::Hold;
    FailsafeSettings &f = s.failsafes;
    f.radioWatched = p.flag("FS_THR_ENABLE");
    f.radioThrottle = p.integer("FS_THR_VALUE");
    if (f.radioWatched)
        f.radio = action;
    f.goesOnInAuto = (p.integer("FS_OPTIONS") & 1) != 0;
    f.stationTimeout = p.plain("FS_GCS_TIMEOUT");
    if (p.flag("FS_GCS_ENABLE"))
        f.station = action;
    f.crashCheck = false;
    return s;
}

/// NAV_DLL_ACT and NAV_RCL_ACT: 1 hold, 2 return, 3 land; termination and the others are not simulated.
Action px4Action(int action)
{
    switch (action) {
    case 1: return FlightMode::Guided;
    case 2: return FlightMode::Rtl;
    case 3: return FlightMode::Land;
    default: return std::nullopt;
    }
}

FlightSettings px4Settings(const Reader &p)
{
    FlightSettings s;
    s.speed = p.plain("MPC_XY_CRUISE");
    s.climb = p.plain("MPC_Z_V_AUTO_UP");
    s.descent = p.plain("MPC_Z_V_AUTO_DN");
    s.acceleration = p.plain("MPC_ACC_HOR");
    s.waypointRadius = p.plain("NAV_ACC_RAD");
    s.landSpeed = p.plain("MPC_LAND_SPEED");
    s.rtlAltitude = p.plain("RTL_RETURN_ALT");
    s.rtlCone = 0;
    s.rtlLoiter = std::max(p.plain("RTL_LAND_DELAY"), 0.0);
    s.takeOffHeight = p.plain("MIS_TAKEOFF_ALT");
    s.guidedTimeout = p.plain("COM_OF_LOSS_T");
    s.leanLimit = radians(p.plain("MPC_MAN_TILT_MAX"));
    s.pilotYawRate = radians(p.plain("MPC_MAN_Y_MAX"));
    s.loiterSpeed = p.plain("MPC_VEL_MANUAL");
    s.anglePRoll = p.plain("MC_ROLL_P");
    s.anglePPitch = p.plain("MC_PITCH_P");
    s.anglePYaw = p.plain("MC_YAW_P");
    s.positionP = p.plain("MPC_XY_P");
    s.altitudeP = p.plain("MPC_Z_P");
    s.hoverThrottle = p.plain("MPC_THR_HOVER");
    s.spoolTime = p.plain("MPC_TKO_RAMP_T");
    s.disarmDelay = std::max(p.plain("COM_DISARM_PRFLT"), 0.0);
    s.disarmAfterFlight = std::max(p.plain("COM_DISARM_LAND"), 0.0);

    FailsafeSettings &f = s.failsafes;
    f.radio = px4Action(p.integer("NAV_RCL_ACT"));
    f.radioWatched = false; // receivers say so themselves
    f.stationTimeout = p.plain("COM_DL_LOSS_T");
    f.station = px4Action(p.integer("NAV_DLL_ACT"));
    f.crashCheck = false;
    return s;
}

} // namespace

FlightSettings flightSettings(const Parameters &parameters, const GeoFrame &world)
{
    const Reader p(parameters);
    const VehicleType &type = parameters.type();
    FlightSettings s;
    if (type.isPx4())
        s = px4Settings(p);
    else if (type.kind == CraftKind::Copter)
        s = copterSettings(p);
    else
        s = type.isRover() ? roverSettings(p) : planeSettings(p);
    s.failsafes.lowBattery = batteryAction(type, p.integer("BATT_FS_LOW_ACT"));
    s.failsafes.criticalBattery = batteryAction(type, p.integer("BATT_FS_CRT_ACT"));
    s.windSpeed = p.plain("SIM_WIND_SPD");
    s.windFrom = radians(p.plain("SIM_WIND_DIR"));
    s.faults = faults(parameters, world);
    return s;
}

} // namespace skyseal::sim
