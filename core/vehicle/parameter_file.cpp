#include "core/vehicle/parameter_file.h"

#include "core/base/number_text.h"
#include "core/vehicle/text_fields.h"

#include <algorithm>
#include <set>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kMostParameters = 8192;
constexpr std::size_t kLongestName = 16;

bool isName(std::string_view text)
{
    return !text.empty() && text.size() <= kLongestName
        && std::ranges::all_of(text, [](char c) { return c > ' ' && c < 127 && c != ','; });
}

/// A line of either form; nullopt if it is neither.
std::optional<Parameter> parameterIn(std::string_view line)
{
    const bool hasTabs = line.find('\t') != std::string_view::npos;
    const auto cells = fieldsOf(line, hasTabs ? "\t" : ", ");
    const bool isQgc = cells.size() == 5;
    if (!isQgc && cells.size() != 2)
        return std::nullopt;
    const auto value = finiteNumber(cells[isQgc ? 3 : 1]);
    const std::string_view name = cells[isQgc ? 2 : 0];
    if (!value || !isName(name))
        return std::nullopt;
    Parameter out{.name = std::string(name), .value = *value};
    if (isQgc) {
        const auto type = finiteNumber(cells[4]);
        if (!type || *type < int(mavlink::MAV_PARAM_TYPE_UINT8) || *type > int(mavlink::MAV_PARAM_TYPE_REAL64))
            return std::nullopt;
        out.type = static_cast<std::uint8_t>(*type);
    }
    return out;
}

} // namespace

Result<std::vector<Parameter>, InputError> parseParameters(std::string_view text, const std::string &source)
{
    std::vector<Parameter> out;
    std::set<std::string, std::less<>> names;
    const auto wrong = [&source](Reason message, std::size_t line) {
        return tl::unexpected(InputError{std::move(message), source, line});
    };
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = takeLine(text);
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string_view::npos || line[first] == '#')
            continue;
        auto parameter = parameterIn(line);
        if (!parameter)
            return wrong(sentence("Reason", "NAME,VALUE or QGroundControl's five columns are expected"), number);
        if (!names.insert(parameter->name).second)
            return wrong(sentence("Reason", "%1 occurs twice")(parameter->name), number);
        if (out.size() == kMostParameters)
            return wrong(sentence("Reason", "more than %1 parameters")(kMostParameters), number);
        out.push_back(std::move(*parameter));
    }
    if (out.empty())
        return wrong(sentence("Reason", "contains no parameters"), 0);
    return out;
}

std::string valueText(const Parameter &parameter)
{
    const auto narrow = static_cast<float>(parameter.value);
    if (static_cast<double>(narrow) == parameter.value)
        return numberText(narrow);
    return numberText(parameter.value);
}

std::string parameterText(const std::vector<Parameter> &parameters)
{
    std::string out;
    for (const Parameter &parameter : parameters)
        out += parameter.name + "," + valueText(parameter) + "\n";
    return out;
}

std::string qgcParameterText(const std::vector<Parameter> &parameters, std::uint8_t systemId, std::uint8_t componentId)
{
    std::string out = "# Vehicle-Id Component-Id Name Value Type\n";
    const std::string begin = std::to_string(systemId) + "\t" + std::to_string(componentId) + "\t";
    for (const Parameter &parameter : parameters)
        out += begin + parameter.name + "\t" + valueText(parameter) + "\t" + std::to_string(parameter.type) + "\n";
    return out;
}

} // namespace skyseal::vehicle
