#include "ui/map/geodesic.h"

#include <GeographicLib/Geodesic.hpp>

namespace skyseal::ui {

Geodesic geodesicBetween(const LatLong &from, const LatLong &to)
{
    Geodesic out;
    double bearing = 0, arrival = 0;
    GeographicLib::Geodesic::WGS84().Inverse(from.latitude, from.longitude, to.latitude, to.longitude, out.metres, bearing,
                                             arrival);
    out.bearing = bearing < 0 ? bearing + 360 : bearing;
    return out;
}

} // namespace skyseal::ui
