// Faults on command, by the SIM_ parameters of ArduPilot's simulator (SITL.cpp there).
#pragma once

#include "core/sim/geo_frame.h"

#include <cstdint>

namespace skyseal::sim {

class Parameters;

/// SIM_RC_FAIL.
enum class RadioFault { None, NoSignal, LowThrottle };

struct Faults
{
    bool gpsDisabled = false;                        ///< SIM_GPS_DISABLE: no satellites
    Vector3 gpsGlitch;                               ///< SIM_GPS_GLITCH_X, _Y and _Z: error of the receiver in m, NED
    bool compassFailed = false;                      ///< SIM_MAG1_FAIL: no readings
    bool pressureFailed = false;                     ///< SIM_BARO_DISABLE: no readings
    double restVoltage = static_cast<double>(12.6f); ///< SIM_BATT_VOLTAGE: a change sets the charge of the battery, V
    RadioFault radio = RadioFault::None;
    std::uint8_t weakRotors = 0; ///< SIM_ENGINE_FAIL: bits of the rotors
    double rotorShare = 1;       ///< SIM_ENGINE_MUL: share of the commanded thrust that these give
};

Faults faults(const Parameters &parameters, const GeoFrame &world);

} // namespace skyseal::sim
