// The projection of the map, Web Mercator (EPSG:3857): metres on the equator, x to the east and y to the north. Shapes stay
// true; lengths grow with the latitude. https://epsg.io/3857
#pragma once

#include <QtCore/QPointF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skyseal::ui {

/// A place on the globe, in degrees (WGS84).
struct LatLong
{
    double latitude = 0, longitude = 0;
    bool operator==(const LatLong &) const = default;
};

namespace mercator {

inline constexpr double kRadius = 6378137; ///< metres: WGS84's semi-major axis
inline constexpr double kHalfWorld = std::numbers::pi * kRadius;
inline constexpr double kRadians = std::numbers::pi / 180;
inline constexpr double kMetresPerDegree = kRadius * kRadians; ///< on the equator
inline constexpr double kLastLatitude = 85.0511287798066;      ///< degrees; there the map is a square

inline QPointF project(const LatLong &place)
{
    const double latitude = std::clamp(place.latitude, -kLastLatitude, kLastLatitude) * kRadians;
    return {place.longitude * kMetresPerDegree, kRadius * std::asinh(std::tan(latitude))};
}

inline LatLong unproject(const QPointF &metres)
{
    const double turns = std::floor(metres.x() / (2 * kHalfWorld) + 0.5); // around the globe
    return {std::atan(std::sinh(metres.y() / kRadius)) / kRadians, metres.x() / kMetresPerDegree - 360 * turns};
}

/// `x` moved by whole turns around the globe, nearest to `to`.
inline double nearestTurn(double x, double to)
{
    return x + 2 * kHalfWorld * std::round((to - x) / (2 * kHalfWorld));
}

/// How many metres of the map a metre on the ground has, at a height of the map.
inline double stretch(double y)
{
    return std::cosh(y / kRadius);
}

} // namespace mercator

} // namespace skyseal::ui
