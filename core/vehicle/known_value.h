// Values of messages as numbers of the state: what a vehicle does not know, or cannot mean, is kUnknown.
#pragma once

#include "core/mavlink/payload_bytes.h"
#include "core/vehicle/vehicle_state.h"

#include <cmath>

namespace skyseal::vehicle {

/// A field in a unit of the state, `unit` being one step of it; kUnknown for the values by which it says "not known".
template<auto Field, typename Message> double known(const Message &message, double unit = 1)
{
    const auto value = message.*Field;
    return mavlink::isKnown<Field>(value) ? static_cast<double>(value) * unit : kUnknown;
}

/// The same for fields whose state is a whole number; -1 if it is not known.
template<auto Field, typename Message> int knownWhole(const Message &message)
{
    const auto value = message.*Field;
    return mavlink::isKnown<Field>(value) ? static_cast<int>(value) : -1;
}

/// kUnknown for NaN and for what is beyond the limit, in either direction.
inline double within(double value, double limit)
{
    return std::abs(value) <= limit ? value : kUnknown;
}

} // namespace skyseal::vehicle
