#include "core/sim/parameter_rows.h"

namespace skyseal::sim {

namespace {

using enum ParameterType;

// Names, defaults and limits as ArduPlane documents them (ArduPlane/Parameters.cpp, AP_TECS.cpp, AP_Landing.cpp).
constexpr ParameterRow kPlaneRows[] = {
    {"AIRSPEED_CRUISE", Real32, 22, 5, 50},
    {"AIRSPEED_MAX", Int16, 28, 5, 100},
    {"AIRSPEED_MIN", Int16, 12, 5, 100},
    {"ALT_OFFSET", Int16, 0, -32767, 32767},
    {"ARSPD_TYPE", Int8, 0, 0, 16},
    {"ARSPD_USE", Int8, 0, 0, 2},
    {"CRUISE_ALT_FLOOR", Real32, 0, 0, 10000},
    {"FBWB_CLIMB_RATE", Real32, 2, 1, 10},
    {"FS_GCS_ENABL", Int8, 0, 0, 2},
    {"FS_LONG_ACTN", Int8, 0, 0, 3},
    {"FS_LONG_TIMEOUT", Real32, 5, 1, 300},
    {"FS_SHORT_ACTN", Int8, 0, 0, 3},
    {"FS_SHORT_TIMEOUT", Real32, 1.5f, 1, 100},
    {"KFF_RDDRMIX", Real32, 0.5f, 0, 1},
    {"LAND_DISARMDELAY", Int8, 20, 0, 127},
    {"LAND_FLARE_ALT", Real32, 3, 0, 30},
    {"LAND_FLARE_SEC", Real32, 2, 0, 10},
    {"LIM_PITCH_MAX", Int16, 2000, 0, 9000},
    {"LIM_PITCH_MIN", Int16, -2500, -9000, 0},
    {"NAVL1_DAMPING", Real32, 0.75f, 0.6f, 1},
    {"NAVL1_PERIOD", Real32, 17, 1, 60},
    {"PTCH2SRV_TCONST", Real32, 0.5f, 0.4f, 1},
    {"PTCH_LIM_MAX_DEG", Real32, 20, 0, 90},
    {"PTCH_LIM_MIN_DEG", Real32, -25, -90, 0},
    {"RLL2SRV_TCONST", Real32, 0.5f, 0.4f, 1},
    {"ROLL_LIMIT_DEG", Real32, 45, 0, 90},
    {"RTL_ALTITUDE", Real32, 100, -1, 32767},
    {"RTL_AUTOLAND", Int8, 0, 0, 4},
    {"RTL_RADIUS", Int16, 0, -32767, 32767},
    {"STALL_PREVENTION", Int8, 1, 0, 1},
    {"STICK_MIXING", Int8, 1, 0, 3},
    {"TECS_CLMB_MAX", Real32, 5, 0.1f, 20},
    {"TECS_SINK_MAX", Real32, 5, 0, 20},
    {"TECS_SINK_MIN", Real32, 2, 0.1f, 10},
    {"THR_FAILSAFE", Int8, 1, 0, 2},
    {"THR_FS_VALUE", Int16, 950, 925, 2200},
    {"THR_MAX", Int8, 100, 0, 100},
    {"THR_MIN", Int8, 0, -100, 100},
    {"TKOFF_ALT", Real32, 50, 0, 200},
    {"TKOFF_DIST", Real32, 200, 0, 500},
    {"TKOFF_LVL_ALT", Real32, 20, 0, 50},
    {"TKOFF_LVL_PITCH", Real32, 15, 0, 30},
    {"TRIM_THROTTLE", Int8, 45, 0, 100},
    {"WP_LOITER_RAD", Int16, 60, -32767, 32767},
    {"WP_MAX_RADIUS", Int16, 0, 0, 32767},
    {"WP_RADIUS", Int16, 90, 1, 32767},
};

} // namespace

std::span<const ParameterRow> planeRows()
{
    return kPlaneRows;
}

} // namespace skyseal::sim
