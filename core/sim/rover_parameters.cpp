#include "core/sim/parameter_rows.h"

namespace skyseal::sim {

namespace {

using enum ParameterType;

// Names, defaults and limits as Rover documents them (Rover/Parameters.cpp, AR_AttitudeControl.cpp, AR_WPNav.cpp).
constexpr ParameterRow kRoverRows[] = {
    {"ACRO_TURN_RATE", Real32, 180, 0, 360},
    {"ATC_ACCEL_MAX", Real32, 1, 0, 10},
    {"ATC_BRAKE", Int8, 1, 0, 1},
    {"ATC_DECEL_MAX", Real32, 0, 0, 10},
    {"ATC_SPEED_I", Real32, 0.2f, 0, 2},
    {"ATC_SPEED_P", Real32, 0.2f, 0.01f, 2},
    {"ATC_STOP_SPEED", Real32, 0.1f, 0, 0.5f},
    {"ATC_STR_ACC_MAX", Real32, 120, 0, 1000},
    {"ATC_STR_ANG_P", Real32, 2, 1, 10},
    {"ATC_STR_RAT_FF", Real32, 0.2f, 0, 3},
    {"ATC_STR_RAT_MAX", Real32, 120, 0, 1000},
    {"ATC_STR_RAT_P", Real32, 0.2f, 0, 2},
    {"CRUISE_SPEED", Real32, 2, 0, 100},
    {"CRUISE_THROTTLE", Int8, 50, 0, 100},
    {"FRAME_CLASS", Int8, 1, 0, 4},
    {"FRAME_TYPE", Int8, 0, 0, 3},
    {"FS_ACTION", Int8, 2, 0, 6},
    {"FS_CRASH_CHECK", Int8, 0, 0, 2},
    {"FS_GCS_ENABLE", Int8, 0, 0, 2},
    {"FS_GCS_TIMEOUT", Real32, 5, 2, 120},
    {"FS_OPTIONS", Int32, 0, 0, 1},
    {"FS_THR_ENABLE", Int8, 1, 0, 2},
    {"FS_THR_VALUE", Int16, 910, 910, 1100},
    {"FS_TIMEOUT", Real32, 1.5f, 1, 100},
    {"INITIAL_MODE", Int8, 0, 0, 22},
    {"LOIT_RADIUS", Real32, 2, 0, 20},
    {"LOIT_SPEED_GAIN", Real32, 0.5f, 0, 5},
    {"LOIT_TYPE", Int8, 0, 0, 2},
    {"MIS_DONE_BEHAVE", Int8, 0, 0, 3},
    {"MODE_CH", Int8, 8, 0, 16},
    {"MOT_SLEWRATE", Int16, 100, 0, 1000},
    {"MOT_THR_MAX", Int8, 100, 5, 100},
    {"MOT_THR_MIN", Int8, 0, 0, 20},
    {"NAVL1_DAMPING", Real32, 0.75f, 0.6f, 1},
    {"NAVL1_PERIOD", Real32, 8, 1, 60},
    {"PILOT_STEER_TYPE", Int8, 0, 0, 3},
    {"RTL_SPEED", Real32, 0, 0, 100},
    {"SPEED_MAX", Real32, 0, 0, 30},
    {"TURN_RADIUS", Real32, 0.9f, 0, 10},
    {"WP_PIVOT_ANGLE", Int16, 0, 0, 360},
    {"WP_PIVOT_RATE", Real32, 60, 0, 360},
    {"WP_RADIUS", Real32, 2, 0, 100},
    {"WP_SPEED", Real32, 2, 0, 100},
};

} // namespace

std::span<const ParameterRow> roverRows()
{
    return kRoverRows;
}

} // namespace skyseal::sim
