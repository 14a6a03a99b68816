// Converts degrees to metres and back around one origin. A plane is exact enough for the few kilometres of a radio link.
#pragma once

#include <QtCore/QPointF>

#include <cmath>
#include <numbers>

namespace skyseal::ui {

struct LocalFrame
{
    double latitude = 0, longitude = 0; ///< of the origin, degrees

    static constexpr double kMetresPerDegree = 111319.49079327358; ///< on WGS84's equator

    /// Metres east (x) and north (y).
    QPointF toMetres(double lat, double lon) const
    {
        return {(lon - longitude) * kMetresPerDegree * shrink(), (lat - latitude) * kMetresPerDegree};
    }

private:
    double shrink() const { return std::cos(latitude * std::numbers::pi / 180); }
};

} // namespace skyseal::ui
