#include "core/sim/parameters.h"

#include "core/sim/flight_settings.h"

#include <algorithm>
#include <cmath>

namespace skyseal::sim {

Parameters::Parameters()
{
    for (const ParameterInfo &info : parameterTable())
        m_values.push_back(info.standard);
}

std::optional<std::size_t> Parameters::find(std::string_view name) const
{
    const auto &table = parameterTable();
    const auto at = std::lower_bound(table.begin(), table.end(), name,
                                     [](const ParameterInfo &info, std::string_view wanted) { return info.name < wanted; });
    if (at == table.end() || at->name != name)
        return std::nullopt;
    return static_cast<std::size_t>(at - table.begin());
}

float Parameters::value(std::string_view name) const
{
    const auto index = find(name);
    return index ? m_values[*index] : 0;
}

Parameters::SetResult Parameters::set(std::size_t index, float value)
{
    if (index >= m_values.size())
        return SetResult::Unknown;
    const ParameterInfo &parameter = info(index);
    if (!std::isfinite(value))
        return SetResult::NotFinite;
    if (parameter.type != ParameterType::Real32)
        value = std::round(value);
    if (value < parameter.minimum || value > parameter.maximum)
        return SetResult::OutOfRange;
    m_values[index] = value;
    ++m_revision;
    return SetResult::Stored;
}

Parameters::SetResult Parameters::set(std::string_view name, float value)
{
    const auto index = find(name);
    return index ? set(*index, value) : SetResult::Unknown;
}

FlightSettings flightSettings(const Parameters &p, const GeoFrame &world)
{
    const auto hundredth = [&](std::string_view name) { return static_cast<double>(p.value(name)) / 100; };
    const auto plain = [&](std::string_view name) { return static_cast<double>(p.value(name)); };

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
    s.windSpeed = plain("SIM_WIND_SPD");
    s.windFrom = radians(plain("SIM_WIND_DIR"));
    s.faults = faults(p, world);
    return s;
}

} // namespace skyseal::sim
