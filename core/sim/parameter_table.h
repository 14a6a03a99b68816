// The parameters that a type of vehicle has: names, types, defaults and limits as its firmware documents them.
#pragma once

#include "core/sim/vehicle_type.h"

#include <cstdint>
#include <string>
#include <vector>

namespace skyseal::sim {

/// Numbered as MAV_PARAM_TYPE.
enum class ParameterType : std::uint8_t {
    Int8 = mavlink::MAV_PARAM_TYPE_INT8,
    Int16 = mavlink::MAV_PARAM_TYPE_INT16,
    Int32 = mavlink::MAV_PARAM_TYPE_INT32,
    Real32 = mavlink::MAV_PARAM_TYPE_REAL32
};

struct ParameterInfo
{
    std::string name; ///< at most 16 characters
    ParameterType type = ParameterType::Real32;
    float standard = 0;
    float minimum = 0;
    float maximum = 0;
};

/// All parameters, sorted by name: the position is the MAVLink index.
const std::vector<ParameterInfo> &parameterTable(const VehicleType &type);

} // namespace skyseal::sim
