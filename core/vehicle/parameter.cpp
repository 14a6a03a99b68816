#include "core/vehicle/parameter.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace skyseal::vehicle {

std::string parameterLabel(const Parameter &parameter)
{
    return parameter.componentId == 0 ? parameter.name : std::to_string(parameter.componentId) + ":" + parameter.name;
}

ParameterName parameterName(std::string_view label)
{
    const std::size_t colon = label.find(':');
    std::uint8_t component = 0;
    if (colon != std::string_view::npos) {
        const char *const end = label.data() + colon;
        const auto [stop, error] = std::from_chars(label.data(), end, component);
        if (error == std::errc() && stop == end && component != 0)
            return {component, std::string(label.substr(colon + 1))};
    }
    return {0, std::string(label)};
}

std::optional<ParameterRange> rangeOfType(std::uint8_t type)
{
    const auto of = []<typename T>(T) {
        return ParameterRange{static_cast<double>(std::numeric_limits<T>::lowest()),
                              static_cast<double>(std::numeric_limits<T>::max()), std::numeric_limits<T>::is_integer};
    };
    switch (type) {
    case mavlink::MAV_PARAM_TYPE_UINT8: return of(std::uint8_t{});
    case mavlink::MAV_PARAM_TYPE_INT8: return of(std::int8_t{});
    case mavlink::MAV_PARAM_TYPE_UINT16: return of(std::uint16_t{});
    case mavlink::MAV_PARAM_TYPE_INT16: return of(std::int16_t{});
    case mavlink::MAV_PARAM_TYPE_UINT32: return of(std::uint32_t{});
    case mavlink::MAV_PARAM_TYPE_INT32: return of(std::int32_t{});
    case mavlink::MAV_PARAM_TYPE_REAL32: return of(float{});
    case mavlink::MAV_PARAM_TYPE_REAL64: return of(double{});
    default: return std::nullopt;
    }
}

bool hasValue(const Parameter &present, double wanted)
{
    if (std::isnan(wanted) || std::isnan(present.value))
        return std::isnan(wanted) && std::isnan(present.value);
    const auto range = rangeOfType(present.type);
    const bool isWhole = range && range->isWhole;
    return wanted == present.value || (!isWhole && static_cast<float>(wanted) == static_cast<float>(present.value));
}

} // namespace skyseal::vehicle
