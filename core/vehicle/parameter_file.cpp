#include "core/vehicle/parameter_file.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/vehicle/text_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kMostParameters = 8192;
constexpr std::size_t kLongestName = 16;
constexpr std::string_view kSeparators = " \t,=";

/// Why a line is no parameter, and the text in it that shows it.
struct BadCell
{
    Reason message;
    std::string_view cell;
};

tl::unexpected<BadCell> bad(const Sentence &why, std::string_view cell)
{
    return tl::unexpected(BadCell{why(printable(cell.substr(0, 40))), cell});
}

bool isName(std::string_view text)
{
    return text.size() <= kLongestName && std::ranges::all_of(text, [](char c) { return c > ' ' && c < 127; });
}

bool equalsIgnoringCase(std::string_view text, std::string_view lower)
{
    return std::ranges::equal(text, lower, {}, [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 32) : c; });
}

/// NaN and infinity, as vehicles report them and stations write them.
std::optional<double> specialValue(std::string_view text)
{
    const bool isNegative = text.starts_with('-');
    if (isNegative || text.starts_with('+'))
        text.remove_prefix(1);
    if (equalsIgnoringCase(text, "nan"))
        return std::numeric_limits<double>::quiet_NaN();
    if (equalsIgnoringCase(text, "inf") || equalsIgnoringCase(text, "infinity"))
        return isNegative ? -HUGE_VAL : HUGE_VAL;
    return std::nullopt;
}

std::optional<double> hexadecimal(std::string_view text)
{
    if (!text.starts_with("0x") && !text.starts_with("0X"))
        return std::nullopt;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), value, 16);
    return error == std::errc() && end == text.data() + text.size() ? std::optional<double>(value) : std::nullopt;
}

Result<double, BadCell> valueIn(std::string_view cell)
{
    for (const auto read : {finiteNumber, hexadecimal, specialValue}) {
        if (const auto value = read(cell))
            return *value;
    }
    return bad(sentence("Reason", "\"%1\" is not a number"), cell);
}

/// A whole number within these limits.
Result<std::uint8_t, BadCell> wholeIn(std::string_view cell, int least, int most, const Sentence &otherwise)
{
    const auto value = finiteNumber(cell);
    if (!value || !(*value >= least && *value <= most && *value == std::floor(*value)))
        return bad(otherwise, cell);
    return static_cast<std::uint8_t>(*value);
}

/// A column of text with a comma in it is one with a decimal comma, where blanks or tabs separate the columns.
std::optional<std::string_view> decimalComma(std::string_view content)
{
    const auto columns = fieldsOf(content, " \t");
    if (columns.size() < 2)
        return std::nullopt;
    for (const std::string_view column : columns) {
        std::string withPoint(column);
        const std::size_t comma = withPoint.find(',');
        if (comma != std::string::npos && comma > 0 && finiteNumber(withPoint.replace(comma, 1, 1, '.')))
            return column;
    }
    return std::nullopt;
}

/// `content`: of a line, without the comment; not blank.
Result<Parameter, BadCell> parameterIn(std::string_view content)
{
    if (const auto column = decimalComma(content))
        return bad(sentence("Reason", "\"%1\" has a decimal comma; numbers in files have a point"), *column);
    auto cells = fieldsOf(content, kSeparators);
    if (!cells.empty() && equalsIgnoringCase(cells.back(), "@readonly"))
        cells.pop_back();
    const bool isQgc = cells.size() == 5;
    if (!isQgc && cells.size() != 2)
        return bad(sentence("Reason", "a name and a value, or QGroundControl's five columns, are expected, not \"%1\""),
                   content);
    const std::string_view name = cells[isQgc ? 2 : 0];
    if (!isName(name))
        return bad(sentence("Reason", "\"%1\" is not a name of at most 16 letters, digits and signs"), name);
    const auto value = valueIn(cells[isQgc ? 3 : 1]);
    if (!value)
        return tl::unexpected(value.error());
    Parameter out{.name = std::string(name), .value = *value};
    if (isQgc) {
        const auto component = wholeIn(cells[1], 1, 255, sentence("Reason", "\"%1\" is not a component from 1 to 255"));
        const auto type = wholeIn(cells[4], int(mavlink::MAV_PARAM_TYPE_UINT8), int(mavlink::MAV_PARAM_TYPE_REAL64),
                                  sentence("Reason", "\"%1\" is not a type of parameters"));
        if (!component || !type)
            return tl::unexpected(component ? type.error() : component.error());
        out.componentId = *component;
        out.type = *type;
    }
    return out;
}

bool isSame(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace

Result<ParameterFile, InputError> parseParameters(std::string_view text, const std::string &source)
{
    ParameterFile out;
    std::map<std::pair<std::uint8_t, std::string>, std::size_t> places; // in out.parameters
    const auto wrong = [&source](Reason message, std::size_t line) {
        return tl::unexpected(InputError{std::move(message), source, line});
    };
    text = withoutMark(text);
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = takeLine(text);
        const std::string_view content = trimmed(line.substr(0, line.find('#')));
        if (content.empty())
            continue;
        auto parameter = parameterIn(content);
        if (!parameter) {
            if (out.unread.size() == kMostUnread)
                return wrong(sentence("Reason", "not a parameter file: %1 lines before this one cannot be read")(kMostUnread),
                             number);
            const auto column = static_cast<std::size_t>(parameter.error().cell.data() - line.data()) + 1;
            out.unread.push_back({std::move(parameter.error().message), source, number, column});
            continue;
        }
        const auto [known, isNew] = places.try_emplace({parameter->componentId, parameter->name}, out.parameters.size());
        if (!isNew) {
            Parameter &earlier = out.parameters[known->second];
            if (!isSame(earlier.value, parameter->value))
                out.repeats.push_back(
                    {sentence("Reason", "%1 occurs again; this line counts")(parameter->name), source, number});
            earlier = std::move(*parameter);
            continue;
        }
        if (out.parameters.size() == kMostParameters)
            return wrong(sentence("Reason", "more than %1 parameters")(kMostParameters), number);
        out.parameters.push_back(std::move(*parameter));
    }
    if (out.parameters.empty() && !out.unread.empty())
        return tl::unexpected(std::move(out.unread.front()));
    if (out.parameters.empty())
        return wrong(sentence("Reason", "contains no parameters"), 0);
    return out;
}

std::string valueText(const Parameter &parameter)
{
    constexpr double kExact = 9007199254740992; // 2^53: whole numbers up to here have no exponent
    if (std::abs(parameter.value) <= kExact && parameter.value == std::round(parameter.value))
        return fixedText(parameter.value, 0);
    const auto narrow = static_cast<float>(parameter.value);
    if (static_cast<double>(narrow) == parameter.value)
        return numberText(narrow);
    return numberText(parameter.value);
}

std::string parameterText(const std::vector<Parameter> &parameters)
{
    std::string out;
    for (const Parameter &parameter : parameters) {
        if (parameter.componentId == 0)
            out += parameter.name + "," + valueText(parameter) + "\n";
    }
    return out;
}

std::string qgcParameterText(const std::vector<Parameter> &parameters, std::uint8_t systemId, std::uint8_t autopilot)
{
    std::string out = "# Vehicle-Id Component-Id Name Value Type\n";
    for (const Parameter &parameter : parameters) {
        const unsigned component = parameter.componentId ? parameter.componentId : autopilot;
        out += std::to_string(systemId) + "\t" + std::to_string(component) + "\t" + parameter.name + "\t" + valueText(parameter)
            + "\t" + std::to_string(parameter.type) + "\n";
    }
    return out;
}

} // namespace skyseal::vehicle
