#include "ui/map/altitude_profile.h"

#include <QtGui/QPainterPath>

#include <cmath>
#include <limits>

namespace skyseal::ui {

namespace {

/// An altitude as received may be any number; nothing flies beyond this one.
double knownOrNothing(double altitude)
{
    constexpr double kHighest = 100'000; // metres
    return std::abs(altitude) <= kHighest ? altitude : std::numeric_limits<double>::quiet_NaN();
}

/// Metres on the ground from `from` to the stop.
double legLength(const QPointF &from, const RouteStop &stop)
{
    QPainterPath leg(from);
    if (stop.spline)
        leg.cubicTo(stop.controlIn, stop.controlOut, stop.at);
    else
        leg.lineTo(stop.at);
    return leg.length() / mercator::stretch((from.y() + stop.at.y()) / 2);
}

} // namespace

std::vector<ProfilePoint> profileOf(const MissionRoute &route, double homeAltitude)
{
    std::vector<ProfilePoint> points;
    points.reserve(route.stops.size());
    double distance = 0;
    for (std::size_t i = 0; i < route.stops.size(); ++i) {
        const RouteStop &stop = route.stops[i];
        if (i > 0)
            distance += legLength(route.stops[i - 1].at, stop);
        const bool fromSea = stop.reference == RouteStop::Reference::SeaLevel;
        points.push_back({stop.sequence, distance, knownOrNothing(fromSea ? stop.altitude - homeAltitude : stop.altitude),
                          stop.reference == RouteStop::Reference::Terrain});
    }
    return points;
}

} // namespace skyseal::ui
