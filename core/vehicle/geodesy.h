// Distance on a spherical Earth, accurate to about 0.5 %.
#pragma once

#include "core/vehicle/vehicle_state.h"

namespace skyseal::vehicle {

/// Metres along the great circle; NaN if one of them is unknown.
double distanceMetres(const Position &a, const Position &b);

} // namespace skyseal::vehicle
