// Onboard parameters: the value, the requests of the parameter protocol and their result.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/base/reason.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/request_id.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

struct Parameter
{
    std::string name;                                   ///< up to 16 characters
    double value = 0;                                   ///< ArduPilot sends a float whatever the type
    std::uint8_t type = mavlink::MAV_PARAM_TYPE_REAL32; ///< MAV_PARAM_TYPE
    std::uint16_t index = 0;
    std::uint8_t componentId = 0; ///< whose parameter it is; 0: that of the autopilot, whatever its number is
};

/// Reads the whole list. The values appear in Vehicle::parameters().
struct ReadParameters
{};
struct ReadParameter
{
    std::string name;
};
struct WriteParameter
{
    std::string name;
    double value = 0;
};

enum class ParameterAction : std::uint8_t { Write, Read, ReadList };

/// The end of a request.
struct ParameterResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    Parameter parameter{}; ///< with the value that the vehicle reports, if it reported one; without a name for a list
    bool ok = false;
    Reason reason = {};            ///< why it failed
    bool changeUnanswered = false; ///< a write that got no answer at all
    ParameterAction action = ParameterAction::Write;
    std::shared_ptr<const std::vector<Parameter>> all = {}; ///< of ReadList, sorted by name
};

} // namespace skyseal::vehicle
