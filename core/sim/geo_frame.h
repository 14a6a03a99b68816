// Places on the globe and the flat frame around one of them, with the spherical scale that ArduPilot uses.
#pragma once

#include "core/sim/attitude.h"

namespace skyseal::sim {

struct GeoPoint
{
    double latitude = 0;  ///< degrees
    double longitude = 0; ///< degrees
    double altitude = 0;  ///< metres above mean sea level
};

/// North, east, down in metres around an origin; good for some tens of kilometres.
class GeoFrame
{
public:
    explicit GeoFrame(const GeoPoint &origin) : m_origin(origin) {}

    const GeoPoint &origin() const { return m_origin; }

    Vector3 toLocal(const GeoPoint &point) const
    {
        return {(point.latitude - m_origin.latitude) * kMetresPerDegree,
                degrees(wrapPi(radians(point.longitude - m_origin.longitude))) * kMetresPerDegree * shrink(),
                m_origin.altitude - point.altitude};
    }

    GeoPoint toGeo(const Vector3 &ned) const
    {
        return {std::clamp(m_origin.latitude + ned.x / kMetresPerDegree, -90.0, 90.0),
                degrees(wrapPi(radians(m_origin.longitude + ned.y / (kMetresPerDegree * shrink())))),
                m_origin.altitude - ned.z};
    }

private:
    static constexpr double kMetresPerDegree = 111318.84502145034;
    double shrink() const { return std::max(std::cos(radians(m_origin.latitude)), 0.01); }

    GeoPoint m_origin;
};

} // namespace skyseal::sim
