#include "core/sim/parameter_table.h"

#include <algorithm>
#include <array>

namespace skyseal::sim {

namespace {

using enum ParameterType;

struct Row
{
    const char *name;
    ParameterType type;
    float standard, minimum, maximum;
};

constexpr Row kRows[] = {
    {"ACRO_BAL_PITCH", Real32, 1, 0, 3},
    {"ACRO_BAL_ROLL", Real32, 1, 0, 3},
    {"ACRO_RP_RATE", Real32, 360, 1, 1080},
    {"ACRO_Y_RATE", Real32, 202.5f, 1, 360},
    {"AHRS_EKF_TYPE", Int8, 3, 0, 11},
    {"AHRS_GPS_GAIN", Real32, 1, 0, 1},
    {"AHRS_ORIENTATION", Int8, 0, 0, 102},
    {"AHRS_TRIM_X", Real32, 0, -0.1745f, 0.1745f},
    {"AHRS_TRIM_Y", Real32, 0, -0.1745f, 0.1745f},
    {"ANGLE_MAX", Int16, 3000, 1000, 8000},
    {"ARMING_CHECK", Int32, 1, 0, 1048575},
    {"ARMING_RUDDER", Int8, 2, 0, 2},
    {"ATC_ACCEL_P_MAX", Real32, 110000, 0, 180000},
    {"ATC_ACCEL_R_MAX", Real32, 110000, 0, 180000},
    {"ATC_ACCEL_Y_MAX", Real32, 27000, 0, 72000},
    {"ATC_ANGLE_BOOST", Int8, 1, 0, 1},
    {"ATC_ANG_PIT_P", Real32, 4.5f, 3, 12},
    {"ATC_ANG_RLL_P", Real32, 4.5f, 3, 12},
    {"ATC_ANG_YAW_P", Real32, 4.5f, 3, 12},
    {"ATC_INPUT_TC", Real32, 0.15f, 0.05f, 1},
    {"ATC_RAT_PIT_D", Real32, 0.0036f, 0, 0.05f},
    {"ATC_RAT_PIT_I", Real32, 0.135f, 0.01f, 2},
    {"ATC_RAT_PIT_P", Real32, 0.135f, 0.01f, 0.5f},
    {"ATC_RAT_RLL_D", Real32, 0.0036f, 0, 0.05f},
    {"ATC_RAT_RLL_I", Real32, 0.135f, 0.01f, 2},
    {"ATC_RAT_RLL_P", Real32, 0.135f, 0.01f, 0.5f},
    {"ATC_RAT_YAW_D", Real32, 0, 0, 0.02f},
    {"ATC_RAT_YAW_I", Real32, 0.018f, 0.01f, 1},
    {"ATC_RAT_YAW_P", Real32, 0.18f, 0.1f, 2.5f},
    {"ATC_SLEW_YAW", Real32, 6000, 500, 18000},
    {"ATC_THR_MIX_MAN", Real32, 0.1f, 0.1f, 0.9f},
    {"AUTO_OPTIONS", Int32, 0, 0, 255},
    {"BARO_ALT_OFFSET", Real32, 0, -1000, 1000},
    {"BARO_GND_TEMP", Real32, 0, -60, 80},
    {"BARO_PRIMARY", Int8, 0, 0, 2},
    {"BATT_AMP_OFFSET", Real32, 0, -10, 10},
    {"BATT_AMP_PERVLT", Real32, 17, 0, 200},
    {"BATT_ARM_VOLT", Real32, 0, 0, 100},
    {"BATT_CAPACITY", Int32, 3300, 50, 200000},
    {"BATT_CRT_MAH", Real32, 0, 0, 200000},
    {"BATT_CRT_VOLT", Real32, 0, 0, 120},
    {"BATT_FS_CRT_ACT", Int8, 0, 0, 7},
    {"BATT_FS_LOW_ACT", Int8, 0, 0, 7},
    {"BATT_LOW_MAH", Real32, 0, 0, 200000},
    {"BATT_LOW_TIMER", Int8, 10, 0, 120},
    {"BATT_LOW_VOLT", Real32, 10.5f, 0, 120},
    {"BATT_MONITOR", Int8, 4, 0, 29},
    {"BATT_VOLT_MULT", Real32, 10.1f, 0, 100},
    {"BRD_BOOT_DELAY", Int16, 0, 0, 10000},
    {"BRD_OPTIONS", Int32, 0, 0, 511},
    {"CIRCLE_RADIUS", Real32, 1000, 0, 200000},
    {"CIRCLE_RATE", Real32, 20, -90, 90},
    {"COMPASS_AUTODEC", Int8, 1, 0, 1},
    {"COMPASS_DEC", Real32, 0, -3.142f, 3.142f},
    {"COMPASS_ENABLE", Int8, 1, 0, 1},
    {"COMPASS_LEARN", Int8, 0, 0, 3},
    {"COMPASS_OFS_X", Real32, 5, -400, 400},
    {"COMPASS_OFS_Y", Real32, 13, -400, 400},
    {"COMPASS_OFS_Z", Real32, -18, -400, 400},
    {"COMPASS_USE", Int8, 1, 0, 1},
    {"COMPASS_USE2", Int8, 1, 0, 1},
    {"DISARM_DELAY", Int8, 10, 0, 127},
    {"EK2_ENABLE", Int8, 0, 0, 1},
    {"EK3_ENABLE", Int8, 1, 0, 1},
    {"EK3_IMU_MASK", Int8, 3, 0, 127},
    {"EK3_MAG_CAL", Int8, 3, 0, 6},
    {"EK3_POSNE_M_NSE", Real32, 0.5f, 0.1f, 10},
    {"EK3_SRC1_POSXY", Int8, 3, 0, 6},
    {"EK3_SRC1_POSZ", Int8, 1, 0, 6},
    {"EK3_SRC1_VELXY", Int8, 3, 0, 7},
    {"EK3_SRC1_VELZ", Int8, 3, 0, 7},
    {"EK3_SRC1_YAW", Int8, 1, 0, 8},
    {"EK3_VELNE_M_NSE", Real32, 0.3f, 0.05f, 5},
    {"FENCE_ACTION", Int8, 1, 0, 8},
    {"FENCE_ALT_MAX", Real32, 100, 10, 1000},
    {"FENCE_ALT_MIN", Real32, -10, -100, 100},
    {"FENCE_ENABLE", Int8, 0, 0, 1},
    {"FENCE_MARGIN", Real32, 2, 1, 10},
    {"FENCE_RADIUS", Real32, 300, 30, 10000},
    {"FENCE_TOTAL", Int8, 0, 0, 127},
    {"FENCE_TYPE", Int8, 7, 0, 15},
    {"FLTMODE_CH", Int8, 5, 0, 14},
    {"FRAME_CLASS", Int8, 1, 0, 17},
    {"FRAME_TYPE", Int8, 1, 0, 18},
    {"FS_CRASH_CHECK", Int8, 1, 0, 1},
    {"FS_EKF_ACTION", Int8, 1, 1, 3},
    {"FS_EKF_THRESH", Real32, 0.8f, 0.6f, 1},
    {"FS_GCS_ENABLE", Int8, 1, 0, 7},
    {"FS_GCS_TIMEOUT", Real32, 5, 2, 120},
    {"FS_OPTIONS", Int32, 16, 0, 63},
    {"FS_THR_ENABLE", Int8, 1, 0, 7},
    {"FS_THR_VALUE", Int16, 975, 910, 1100},
    {"GND_EFFECT_COMP", Int8, 1, 0, 1},
    {"GPS_AUTO_SWITCH", Int8, 1, 0, 4},
    {"GPS_HDOP_GOOD", Int16, 140, 100, 900},
    {"GPS_TYPE", Int8, 1, 0, 26},
    {"GPS_TYPE2", Int8, 0, 0, 26},
    {"GUID_OPTIONS", Int32, 0, 0, 255},
    {"GUID_TIMEOUT", Real32, 3, 0.1f, 5},
    {"INS_ACC2OFFS_X", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACC2OFFS_Y", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACC2OFFS_Z", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACCEL_FILTER", Int16, 20, 0, 256},
    {"INS_ACCOFFS_X", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACCOFFS_Y", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACCOFFS_Z", Real32, 0.001f, -3.5f, 3.5f},
    {"INS_ACCSCAL_X", Real32, 1.001f, 0.8f, 1.2f},
    {"INS_ACCSCAL_Y", Real32, 1.001f, 0.8f, 1.2f},
    {"INS_ACCSCAL_Z", Real32, 1.001f, 0.8f, 1.2f},
    {"INS_GYROFFS_X", Real32, 0, -1, 1},
    {"INS_GYROFFS_Y", Real32, 0, -1, 1},
    {"INS_GYROFFS_Z", Real32, 0, -1, 1},
    {"INS_GYRO_FILTER", Int16, 20, 0, 256},
    {"INS_USE", Int8, 1, 0, 1},
    {"INS_USE2", Int8, 1, 0, 1},
    {"LAND_ALT_LOW", Int16, 1000, 100, 10000},
    {"LAND_REPOSITION", Int8, 1, 0, 1},
    {"LAND_SPEED", Int16, 50, 30, 200},
    {"LAND_SPEED_HIGH", Int16, 0, 0, 500},
    {"LOG_BACKEND_TYPE", Int8, 1, 0, 7},
    {"LOG_BITMASK", Int32, 176126, 0, 2097151},
    {"LOG_DISARMED", Int8, 0, 0, 3},
    {"LOIT_ACC_MAX", Real32, 500, 100, 981},
    {"LOIT_ANG_MAX", Real32, 0, 0, 45},
    {"LOIT_BRK_ACCEL", Real32, 250, 25, 250},
    {"LOIT_BRK_DELAY", Real32, 1, 0, 2},
    {"LOIT_SPEED", Real32, 1250, 20, 3500},
    {"MIS_OPTIONS", Int32, 0, 0, 7},
    {"MIS_RESTART", Int8, 0, 0, 1},
    {"MIS_TOTAL", Int16, 0, 0, 32766},
    {"MOT_BAT_VOLT_MAX", Real32, 12.8f, 0, 100},
    {"MOT_BAT_VOLT_MIN", Real32, 9.6f, 0, 100},
    {"MOT_HOVER_LEARN", Int8, 2, 0, 2},
    {"MOT_PWM_MAX", Int16, 2000, 0, 2000},
    {"MOT_PWM_MIN", Int16, 1000, 0, 2000},
    {"MOT_SPIN_ARM", Real32, 0.1f, 0, 1},
    {"MOT_SPIN_MAX", Real32, 0.95f, 0.9f, 1},
    {"MOT_SPIN_MIN", Real32, 0.15f, 0, 0.3f},
    {"MOT_SPOOL_TIME", Real32, 0.5f, 0, 2},
    {"MOT_THST_EXPO", Real32, 0.65f, -1, 1},
    {"MOT_THST_HOVER", Real32, 0.35f, 0.2f, 0.8f},
    {"PILOT_ACCEL_Z", Int16, 250, 50, 500},
    {"PILOT_SPEED_DN", Int16, 0, 0, 500},
    {"PILOT_SPEED_UP", Int16, 250, 50, 500},
    {"PILOT_THR_BHV", Int16, 0, 0, 7},
    {"PILOT_TKOFF_ALT", Real32, 0, 0, 1000},
    {"PILOT_Y_EXPO", Real32, 0, -0.5f, 1},
    {"PILOT_Y_RATE", Real32, 202.5f, 1, 360},
    {"PSC_ACCZ_I", Real32, 1, 0, 3},
    {"PSC_ACCZ_P", Real32, 0.5f, 0.2f, 1.5f},
    {"PSC_JERK_XY", Real32, 5, 1, 20},
    {"PSC_JERK_Z", Real32, 5, 5, 50},
    {"PSC_POSXY_P", Real32, 1, 0.5f, 2},
    {"PSC_POSZ_P", Real32, 1, 0.5f, 3},
    {"PSC_VELXY_D", Real32, 0.5f, 0, 1},
    {"PSC_VELXY_I", Real32, 1, 0.02f, 1},
    {"PSC_VELXY_P", Real32, 2, 0.1f, 6},
    {"PSC_VELZ_P", Real32, 5, 1, 8},
    {"RALLY_INCL_HOME", Int8, 1, 0, 1},
    {"RALLY_LIMIT_KM", Real32, 0.3f, 0, 1000},
    {"RALLY_TOTAL", Int8, 0, 0, 50},
    {"RCMAP_PITCH", Int8, 2, 1, 16},
    {"RCMAP_ROLL", Int8, 1, 1, 16},
    {"RCMAP_THROTTLE", Int8, 3, 1, 16},
    {"RCMAP_YAW", Int8, 4, 1, 16},
    {"RC_OPTIONS", Int32, 32, 0, 8191},
    {"RC_OVERRIDE_TIME", Real32, 3, -1, 120},
    {"RC_SPEED", Int16, 490, 50, 490},
    {"RTL_ALT", Int32, 1500, 30, 300000},
    {"RTL_ALT_FINAL", Int16, 0, 0, 1000},
    {"RTL_ALT_TYPE", Int8, 0, 0, 1},
    {"RTL_CLIMB_MIN", Int16, 0, 0, 3000},
    {"RTL_CONE_SLOPE", Real32, 3, 0, 10},
    {"RTL_LOIT_TIME", Int32, 5000, 0, 60000},
    {"RTL_OPTIONS", Int32, 0, 0, 4},
    {"RTL_SPEED", Int16, 0, 0, 2000},
    {"SCHED_LOOP_RATE", Int16, 400, 50, 400},
    {"SERIAL0_BAUD", Int32, 115, 1, 2000000},
    {"SERIAL0_PROTOCOL", Int8, 2, 1, 2},
    {"SERIAL1_BAUD", Int32, 57, 1, 2000000},
    {"SERIAL1_PROTOCOL", Int8, 2, -1, 45},
    {"SIM_BARO_DISABLE", Int8, 0, 0, 1},
    {"SIM_BATT_VOLTAGE", Real32, 12.6f, 0, 12.6f},
    {"SIM_ENGINE_FAIL", Int32, 0, 0, 15},
    {"SIM_ENGINE_MUL", Real32, 1, 0, 1},
    {"SIM_GPS_GLITCH_X", Real32, 0, -0.1f, 0.1f},
    {"SIM_GPS_GLITCH_Y", Real32, 0, -0.1f, 0.1f},
    {"SIM_GPS_GLITCH_Z", Real32, 0, -1000, 1000},
    {"SIM_MAG1_FAIL", Int8, 0, 0, 1},
    {"SIM_RC_FAIL", Int8, 0, 0, 2},
    {"SIM_BATT_CAP_AH", Real32, 3.3f, 0.05f, 200},
    {"SIM_GPS_DISABLE", Int8, 0, 0, 1},
    {"SIM_SPEEDUP", Real32, 1, 0.1f, 100},
    {"SIM_WIND_DIR", Real32, 180, 0, 360},
    {"SIM_WIND_SPD", Real32, 1.5f, 0, 20},
    {"SR0_ADSB", Int16, 0, 0, 200},
    {"SR0_EXTRA1", Int16, 4, 0, 200},
    {"SR0_EXTRA2", Int16, 4, 0, 200},
    {"SR0_EXTRA3", Int16, 4, 0, 200},
    {"SR0_EXT_STAT", Int16, 4, 0, 200},
    {"SR0_PARAMS", Int16, 0, 0, 200},
    {"SR0_POSITION", Int16, 4, 0, 200},
    {"SR0_RAW_CTRL", Int16, 4, 0, 200},
    {"SR0_RAW_SENS", Int16, 4, 0, 200},
    {"SR0_RC_CHAN", Int16, 4, 0, 200},
    {"SYSID_ENFORCE", Int8, 0, 0, 1},
    {"SYSID_MYGCS", Int16, 255, 1, 255},
    {"SYSID_THISMAV", Int16, 1, 1, 255},
    {"TELEM_DELAY", Int8, 0, 0, 30},
    {"TERRAIN_ENABLE", Int8, 0, 0, 1},
    {"THROW_MOT_START", Int8, 0, 0, 1},
    {"WPNAV_ACCEL", Real32, 250, 50, 500},
    {"WPNAV_ACCEL_Z", Real32, 100, 50, 500},
    {"WPNAV_JERK", Real32, 1, 1, 20},
    {"WPNAV_RADIUS", Real32, 200, 5, 1000},
    {"WPNAV_SPEED", Real32, 500, 20, 2000},
    {"WPNAV_SPEED_DN", Real32, 150, 10, 500},
    {"WPNAV_SPEED_UP", Real32, 250, 10, 1000},
    {"WP_YAW_BEHAVIOR", Int8, 2, 0, 3},
};

std::vector<ParameterInfo> build()
{
    std::vector<ParameterInfo> table;
    for (const Row &row : kRows)
        table.push_back({row.name, row.type, row.standard, row.minimum, row.maximum});

    // Stabilize, altitude hold, loiter, RTL, land, guided on the six positions of the mode switch.
    constexpr std::array<float, 6> modes{0, 2, 5, 6, 9, 4};
    for (int i = 0; i < 6; ++i)
        table.push_back({"FLTMODE" + std::to_string(i + 1), Int8, modes[static_cast<std::size_t>(i)], 0, 28});
    for (int i = 1; i <= 8; ++i) {
        const std::string channel = "RC" + std::to_string(i) + "_";
        table.push_back({channel + "MIN", Int16, 1000, 800, 2200});
        table.push_back({channel + "MAX", Int16, 2000, 800, 2200});
        table.push_back({channel + "TRIM", Int16, i == 3 ? 1000.f : 1500.f, 800, 2200});
        table.push_back({channel + "DZ", Int16, i <= 2 ? 20.f : i == 3 ? 30.f : i == 4 ? 20.f : 0.f, 0, 200});
        table.push_back({channel + "REVERSED", Int8, 0, 0, 1});
        table.push_back({channel + "OPTION", Int16, 0, 0, 400});
        const std::string output = "SERVO" + std::to_string(i) + "_";
        table.push_back({output + "MIN", Int16, 1000, 500, 2200});
        table.push_back({output + "MAX", Int16, 2000, 800, 2200});
        table.push_back({output + "TRIM", Int16, 1500, 800, 2200});
        table.push_back({output + "FUNCTION", Int16, i <= 4 ? static_cast<float>(32 + i) : 0.f, -1, 189});
        table.push_back({output + "REVERSED", Int8, 0, 0, 1});
    }
    std::sort(table.begin(), table.end(), [](const ParameterInfo &a, const ParameterInfo &b) { return a.name < b.name; });
    return table;
}

} // namespace

const std::vector<ParameterInfo> &parameterTable()
{
    static const std::vector<ParameterInfo> table = build();
    return table;
}

} // namespace skyseal::sim
