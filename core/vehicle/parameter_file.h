// Parameter files of ground stations, in the forms that they, ArduPilot and scripts read and write: a name and a value in each
// line (Mission Planner, MAVProxy), or the five columns of QGroundControl: vehicle, component, name, value, type.
#pragma once

#include "core/base/result.h"
#include "core/vehicle/parameter.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

struct ParameterFile
{
    std::vector<Parameter> parameters;
    std::vector<InputError> unread;  ///< lines that are no parameters
    std::vector<InputError> repeats; ///< parameters that an earlier line gave another value; the latest one counts
};

/// Parses the text of a file; `source` is its name in errors. Blanks, tabs, commas and equals signs separate the columns, a #
/// begins a comment, and ArduPilot's mark @READONLY is skipped. Values are decimal or hexadecimal (0x1f) numbers, NaN or
/// infinite. Lines of five columns say component and type; in the others they are 0 and REAL32. A line that cannot be read
/// costs only itself. A file is refused if no line can be read, if more than kMostUnread cannot, or if it has more than 8192
/// parameters.
Result<ParameterFile, InputError> parseParameters(std::string_view text, const std::string &source);
inline constexpr std::size_t kMostUnread = 100;

/// "NAME,VALUE" lines of the parameters of the autopilot: the form has no place for a component.
std::string parameterText(const std::vector<Parameter> &parameters);
/// QGroundControl's form, of one vehicle whose autopilot is the component `autopilot`.
std::string qgcParameterText(const std::vector<Parameter> &parameters, std::uint8_t systemId, std::uint8_t autopilot);
/// A text that reads back to the same value, of whole numbers without an exponent: of a float, unless the type is a wider one.
std::string valueText(const Parameter &parameter);

} // namespace skyseal::vehicle
