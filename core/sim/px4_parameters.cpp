#include "core/sim/parameter_rows.h"

namespace skyseal::sim {

namespace {

using enum ParameterType;

// Names, types and defaults as PX4 1.14 documents them (params.c of Commander, Navigator, the controllers and MAVLink). All
// integers have 32 bits there.
constexpr ParameterRow kPx4Rows[] = {
    {"BAT1_CAPACITY", Real32, 3300, -1, 100000},
    {"BAT1_N_CELLS", Int32, 3, 0, 16},
    {"BAT1_V_CHARGED", Real32, 4.05f, 0, 5},
    {"BAT1_V_EMPTY", Real32, 3.6f, 0, 5},
    {"BAT_CRIT_THR", Real32, 0.07f, 0.05f, 0.25f},
    {"BAT_EMERGEN_THR", Real32, 0.05f, 0.03f, 0.1f},
    {"BAT_LOW_THR", Real32, 0.15f, 0.12f, 0.5f},
    {"CBRK_SUPPLY_CHK", Int32, 894281, 0, 894281},
    {"COM_ARM_WO_GPS", Int32, 1, 0, 1},
    {"COM_DISARM_LAND", Real32, 2, -1, 20},
    {"COM_DISARM_PRFLT", Real32, 10, -1, 60},
    {"COM_DL_LOSS_T", Int32, 10, 5, 300},
    {"COM_LOW_BAT_ACT", Int32, 0, 0, 3},
    {"COM_OBL_RC_ACT", Int32, 0, 0, 7},
    {"COM_OF_LOSS_T", Real32, 1, 0, 60},
    {"COM_POSCTL_NAVL", Int32, 0, 0, 1},
    {"COM_RC_IN_MODE", Int32, 3, 0, 4},
    {"COM_RC_LOSS_T", Real32, 0.5f, 0, 35},
    {"EKF2_EN", Int32, 1, 0, 1},
    {"EKF2_GPS_CHECK", Int32, 245, 0, 511},
    {"EKF2_HGT_REF", Int32, 1, 0, 3},
    {"GF_ACTION", Int32, 2, 0, 5},
    {"GF_MAX_HOR_DIST", Real32, 0, 0, 10000},
    {"GF_MAX_VER_DIST", Real32, 0, 0, 10000},
    {"GPS_1_CONFIG", Int32, 201, 0, 401},
    {"IMU_GYRO_CUTOFF", Real32, 40, 0, 1000},
    {"MAV_0_MODE", Int32, 0, 0, 13},
    {"MAV_0_RATE", Int32, 1200, 0, 100000},
    {"MAV_COMP_ID", Int32, 1, 1, 250},
    {"MAV_PROTO_VER", Int32, 0, 0, 2},
    {"MAV_SYS_ID", Int32, 1, 1, 250},
    {"MAV_TYPE", Int32, 2, 0, 22},
    {"MC_PITCHRATE_P", Real32, 0.15f, 0.01f, 0.6f},
    {"MC_PITCH_P", Real32, 6.5f, 0, 12},
    {"MC_ROLLRATE_P", Real32, 0.15f, 0.01f, 0.5f},
    {"MC_ROLL_P", Real32, 6.5f, 0, 12},
    {"MC_YAWRATE_P", Real32, 0.2f, 0, 0.6f},
    {"MC_YAW_P", Real32, 2.8f, 0, 5},
    {"MIS_DIST_1WP", Real32, 900, -1, 100000},
    {"MIS_TAKEOFF_ALT", Real32, 2.5f, 0, 80},
    {"MPC_ACC_HOR", Real32, 3, 2, 15},
    {"MPC_LAND_SPEED", Real32, 0.7f, 0.6f, 10},
    {"MPC_MAN_TILT_MAX", Real32, 35, 0, 90},
    {"MPC_MAN_Y_MAX", Real32, 150, 0, 400},
    {"MPC_THR_HOVER", Real32, 0.35f, 0.1f, 0.8f},
    {"MPC_TKO_RAMP_T", Real32, 0.5f, 0, 5},
    {"MPC_TKO_SPEED", Real32, 1.5f, 1, 5},
    {"MPC_VEL_MANUAL", Real32, 10, 3, 20},
    {"MPC_XY_CRUISE", Real32, 5, 3, 20},
    {"MPC_XY_P", Real32, 0.95f, 0, 2},
    {"MPC_XY_VEL_MAX", Real32, 12, 0, 20},
    {"MPC_Z_P", Real32, 1, 0.1f, 1.5f},
    {"MPC_Z_V_AUTO_DN", Real32, 1.5f, 0.5f, 4},
    {"MPC_Z_V_AUTO_UP", Real32, 3, 0.5f, 8},
    {"NAV_ACC_RAD", Real32, 2, 0.05f, 200},
    {"NAV_DLL_ACT", Int32, 0, 0, 6},
    {"NAV_LOITER_RAD", Real32, 80, 25, 1000},
    {"NAV_RCL_ACT", Int32, 2, 1, 6},
    {"RTL_DESCEND_ALT", Real32, 30, 0, 100},
    {"RTL_LAND_DELAY", Real32, 0, -1, 300},
    {"RTL_RETURN_ALT", Real32, 60, 0, 150},
    {"RTL_TYPE", Int32, 0, 0, 5},
    {"SDLOG_MODE", Int32, 0, -1, 4},
    {"SYS_AUTOCONFIG", Int32, 0, 0, 1},
    {"SYS_AUTOSTART", Int32, 4001, 0, 9999999},
    {"SYS_HAS_GPS", Int32, 1, 0, 1},
};

} // namespace

std::span<const ParameterRow> px4Rows()
{
    return kPx4Rows;
}

} // namespace skyseal::sim
