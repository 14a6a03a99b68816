// Onboard parameters: the value, the requests of the parameter protocol and their result.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/base/reason.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/request_id.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

struct Parameter
{
    std::string name = {};                              ///< up to 16 characters
    double value = 0;                                   ///< ArduPilot sends a float whatever the type
    std::uint8_t type = mavlink::MAV_PARAM_TYPE_REAL32; ///< MAV_PARAM_TYPE
    std::uint16_t index = 0;                            ///< in the list of its component
    std::uint8_t componentId = 0; ///< whose parameter it is; 0: that of the autopilot, whatever its number is
};

/// Reads the parameters of the autopilot and of the other components of the vehicle. The values appear in
/// Vehicle::parameters().
struct ReadParameters
{};
struct ReadParameter
{
    std::string name;
    std::uint8_t componentId = 0; ///< as in Parameter
};
struct WriteParameter
{
    std::string name;
    double value = 0;
    std::uint8_t componentId = 0; ///< as in Parameter
};

enum class ParameterAction : std::uint8_t { Write, Read, ReadList };

/// The end of a request.
struct ParameterResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    Parameter parameter{}; ///< with the value that the vehicle reports, if it reported one; without a name for a list
    bool ok = false;
    Reason reason = {};            ///< why it failed; of a list that is ok, which part of another component is missing
    bool changeUnanswered = false; ///< a write that got no answer at all
    ParameterAction action = ParameterAction::Write;
    std::shared_ptr<const std::vector<Parameter>> all = {}; ///< of ReadList, sorted by component and name
};

/// The name as operators read and write it: that of the autopilot's parameter alone, that of another component with its number
/// before it: "154:G_PARAM_PAN".
std::string parameterLabel(const Parameter &parameter);

/// A label, taken apart. A text without the number of a component (1 to 255) before a colon is a name of the autopilot's.
struct ParameterName
{
    std::uint8_t componentId = 0;
    std::string name;
};
ParameterName parameterName(std::string_view label);

/// The least and the greatest value of a type (MAV_PARAM_TYPE); nullopt for a type that is not known.
struct ParameterRange
{
    double least = 0, greatest = 0;
    bool isWhole = true; ///< whole numbers only
};
std::optional<ParameterRange> rangeOfType(std::uint8_t type);

/// True if the vehicle has this value: exactly for whole numbers, within the precision of its float for others.
bool hasValue(const Parameter &present, double wanted);

} // namespace skyseal::vehicle
