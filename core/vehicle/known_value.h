// Values of messages that a vehicle cannot mean, which count as not known.
#pragma once

#include "core/vehicle/vehicle_state.h"

#include <cmath>

namespace skyseal::vehicle {

/// kUnknown for NaN and for what is beyond the limit, in either direction.
inline double within(double value, double limit)
{
    return std::abs(value) <= limit ? value : kUnknown;
}

} // namespace skyseal::vehicle
