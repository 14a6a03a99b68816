#include "core/vehicle/geodesy.h"

#include <algorithm>
#include <numbers>

namespace skyseal::vehicle {

double distanceMetres(const Position &a, const Position &b)
{
    if (!a.known() || !b.known())
        return kUnknown;
    constexpr double kEarthRadius = 6371008.8; // IUGG mean radius
    constexpr double kRadians = std::numbers::pi / 180;
    const double latitudes = std::sin((b.latitude - a.latitude) * kRadians / 2);
    const double longitudes = std::sin((b.longitude - a.longitude) * kRadians / 2);
    const double h = latitudes * latitudes
        + std::cos(a.latitude * kRadians) * std::cos(b.latitude * kRadians) * longitudes * longitudes;
    return 2 * kEarthRadius * std::asin(std::sqrt(std::clamp(h, 0.0, 1.0)));
}

} // namespace skyseal::vehicle
