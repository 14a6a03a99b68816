#include "core/sim/faults.h"

#include "core/sim/parameters.h"

namespace skyseal::sim {

Faults faults(const Parameters &parameters, const GeoFrame &world)
{
    const auto plain = [&](std::string_view name) { return static_cast<double>(parameters.value(name)); };
    Faults out;
    out.gpsDisabled = parameters.flag("SIM_GPS_DISABLE");
    const GeoPoint &origin = world.origin();
    out.gpsGlitch = world.toLocal({origin.latitude + plain("SIM_GPS_GLITCH_X"), origin.longitude + plain("SIM_GPS_GLITCH_Y"),
                                   origin.altitude + plain("SIM_GPS_GLITCH_Z")});
    out.compassFailed = parameters.flag("SIM_MAG1_FAIL");
    out.pressureFailed = parameters.flag("SIM_BARO_DISABLE");
    out.restVoltage = plain("SIM_BATT_VOLTAGE");
    out.radio = static_cast<RadioFault>(parameters.integer("SIM_RC_FAIL"));
    out.weakRotors = static_cast<std::uint8_t>(parameters.integer("SIM_ENGINE_FAIL"));
    out.rotorShare = plain("SIM_ENGINE_MUL");
    return out;
}

} // namespace skyseal::sim
