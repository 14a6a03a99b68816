// Conversion of the simulation's doubles to the integers of the wire: rounded and clamped to the range of the field.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::sim {

/// `value * scale` as an integer field, clamped to its range; NaN becomes 0.
template<typename Integer> Integer scaled(double value, double scale = 1)
{
    const double wanted = std::round(value * scale);
    if (std::isnan(wanted))
        return 0;
    constexpr auto low = static_cast<double>(std::numeric_limits<Integer>::lowest());
    constexpr auto high = static_cast<double>(std::numeric_limits<Integer>::max());
    if (wanted >= high)
        return std::numeric_limits<Integer>::max();
    return wanted <= low ? std::numeric_limits<Integer>::lowest() : static_cast<Integer>(wanted);
}

} // namespace skyseal::sim
