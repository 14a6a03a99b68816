// Distance on the globe, good to the half percent that a sphere is good for.
#pragma once

#include "core/vehicle/vehicle_state.h"

namespace skyseal::vehicle {

/// Metres along the great circle; NaN when one of them is not known.
double distanceMetres(const Position &a, const Position &b);

} // namespace skyseal::vehicle
