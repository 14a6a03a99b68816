// The shortest way between two places on the WGS84 ellipsoid, exact to a few nanometres. C. F. F. Karney, Algorithms for
// geodesics, J. Geodesy 87, 43–55 (2013).
#pragma once

#include "ui/tiles/mercator.h"

namespace skyseal::ui {

struct Geodesic
{
    double metres = 0;
    double bearing = 0; ///< degrees, 0 to 360, at the first place
};

Geodesic geodesicBetween(const LatLong &from, const LatLong &to);

} // namespace skyseal::ui
