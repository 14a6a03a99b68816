// Parameter files of ground stations. Both forms in use are read: "NAME,VALUE" or "NAME VALUE" (Mission Planner, MAVProxy), and
// the five columns of QGroundControl, separated by tabs: vehicle, component, name, value, type. Lines that begin with # are
// comments.
#pragma once

#include "core/base/result.h"
#include "core/vehicle/parameter.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// Parses the text of a file, of at most 8192 parameters; `source` is its name in errors. A parameter that occurs twice, or
/// whose name is longer than 16 characters or not printable ASCII, is an error. The types are those of QGroundControl's form,
/// REAL32 in the others.
Result<std::vector<Parameter>, InputError> parseParameters(std::string_view text, const std::string &source);
/// "NAME,VALUE" lines.
std::string parameterText(const std::vector<Parameter> &parameters);
/// QGroundControl's form, of one vehicle's component.
std::string qgcParameterText(const std::vector<Parameter> &parameters, std::uint8_t systemId, std::uint8_t componentId);
/// The shortest text that reads back to the same value: of a float, unless the type is a wider one.
std::string valueText(const Parameter &parameter);

} // namespace skyseal::vehicle
