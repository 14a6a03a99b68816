#include "ui/map/mission_route.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::ui {

namespace {

using namespace mavlink;
using Loiter = RouteStop::Loiter;

constexpr double kUnknownAltitude = std::numeric_limits<double>::quiet_NaN();

/// Commands that the vehicle executes at or on the way to a place; the others below MAV_CMD_NAV_LAST change nothing of the
/// route.
bool isFlownTo(std::uint16_t command)
{
    switch (command) {
    case MAV_CMD_NAV_ROI:
    case MAV_CMD_NAV_RETURN_TO_LAUNCH:
    case MAV_CMD_NAV_CONTINUE_AND_CHANGE_ALT:
    case MAV_CMD_NAV_ALTITUDE_WAIT:
    case MAV_CMD_NAV_GUIDED_ENABLE:
    case MAV_CMD_NAV_DELAY: return false;
    default: return command < MAV_CMD_NAV_LAST;
    }
}

bool isTakeOff(std::uint16_t command)
{
    return command == MAV_CMD_NAV_TAKEOFF || command == MAV_CMD_NAV_VTOL_TAKEOFF;
}

double finite(float value)
{
    return std::isfinite(value) ? static_cast<double>(value) : 0;
}

/// A sequence or a number of times; -1 is for ever.
int whole(float value)
{
    return static_cast<int>(std::clamp(finite(value), -1.0, 65535.0));
}

void describeLoiter(RouteStop &stop, const vehicle::MissionItem &item)
{
    const double first = finite(item.parameters[0]), third = finite(item.parameters[2]);
    switch (item.command) {
    case MAV_CMD_NAV_LOITER_UNLIM: stop.loiter = Loiter::Unlimited; break;
    case MAV_CMD_NAV_LOITER_TURNS: stop.loiter = Loiter::Turns; break;
    case MAV_CMD_NAV_LOITER_TIME: stop.loiter = Loiter::Time; break;
    case MAV_CMD_NAV_LOITER_TO_ALT: stop.loiter = Loiter::ToAltitude; break;
    default: return;
    }
    const bool toAltitude = stop.loiter == Loiter::ToAltitude;
    stop.radius = std::abs(toAltitude ? finite(item.parameters[1]) : third); // negative: counter-clockwise
    stop.amount = stop.loiter == Loiter::Turns || stop.loiter == Loiter::Time ? first : 0;
}

/// The jump of an item, to the first stop at or after the item that it names.
void addJump(MissionRoute &route, const std::vector<vehicle::MissionItem> &items, const vehicle::MissionItem &item, int from)
{
    int target = whole(item.parameters[0]);
    if (item.command == MAV_CMD_DO_JUMP_TAG) {
        const auto tag = std::ranges::find_if(items, [&](const vehicle::MissionItem &one) {
            return one.command == MAV_CMD_JUMP_TAG && one.parameters[0] == item.parameters[0];
        });
        if (tag == items.end())
            return;
        target = tag->sequence;
    }
    const auto to = std::ranges::find_if(route.stops, [&](const RouteStop &stop) { return stop.sequence >= target; });
    if (to != route.stops.end())
        route.jumps.push_back({from, to->sequence, whole(item.parameters[1])});
}

/// The velocity at a stop of a spline, in metres per leg: along the line between its neighbours.
QPointF velocityAt(const std::vector<RouteStop> &stops, std::size_t i)
{
    const QPointF before = i == 0 ? stops[i].at : stops[i - 1].at;
    const QPointF after = i + 1 == stops.size() ? stops[i].at : stops[i + 1].at;
    return (after - before) / 2;
}

void bendSplines(std::vector<RouteStop> &stops)
{
    for (std::size_t i = 1; i < stops.size(); ++i) {
        RouteStop &stop = stops[i];
        if (!stop.spline)
            continue;
        // A spline after a straight leg begins in the direction of that leg.
        const QPointF begin = stops[i - 1].spline || i < 2 ? velocityAt(stops, i - 1) : (stops[i - 1].at - stops[i - 2].at) / 2;
        stop.controlIn = stops[i - 1].at + begin / 3;
        stop.controlOut = stop.at - velocityAt(stops, i) / 3;
    }
}

} // namespace

const RouteStop *MissionRoute::stopOf(int sequence) const
{
    const auto found = std::ranges::find(stops, sequence, &RouteStop::sequence);
    return found == stops.end() ? nullptr : &*found;
}

MissionRoute routeOf(const std::vector<vehicle::MissionItem> &items, std::optional<QPointF> home, bool firstIsHome)
{
    MissionRoute route;
    struct PendingJump
    {
        const vehicle::MissionItem *item;
        int from;
    };
    std::vector<PendingJump> jumps; // their targets may follow
    for (const vehicle::MissionItem &item : items) {
        if (firstIsHome && item.sequence == 0)
            continue;
        if (route.stops.empty() && home && isTakeOff(item.command))
            route.stops.push_back({.at = *home, .sequence = -1});
        const bool place = hasPlace(item);
        if (item.command == MAV_CMD_DO_JUMP || item.command == MAV_CMD_DO_JUMP_TAG) {
            if (!route.stops.empty())
                jumps.push_back({&item, route.stops.back().sequence});
            continue;
        }
        if (item.command == MAV_CMD_NAV_RETURN_TO_LAUNCH && home) {
            // The vehicle returns at an altitude of its own parameters.
            route.stops.push_back({.at = *home, .sequence = item.sequence, .altitude = kUnknownAltitude});
            continue;
        }
        if (!isFlownTo(item.command)) {
            if (place)
                route.marks.push_back({mercator::project({item.latitude, item.longitude}), item.sequence});
            continue;
        }
        if (!place && route.stops.empty())
            continue;
        // Without a place, the command is executed where the vehicle is.
        RouteStop stop{.at = place ? mercator::project({item.latitude, item.longitude}) : route.stops.back().at,
                       .sequence = item.sequence,
                       .spline = item.command == MAV_CMD_NAV_SPLINE_WAYPOINT};
        stop.altitude = static_cast<double>(item.altitude);
        stop.reference = vehicle::altitudeReferenceOf(item.frame);
        describeLoiter(stop, item);
        route.stops.push_back(stop);
    }
    for (const PendingJump &jump : jumps)
        addJump(route, items, *jump.item, jump.from);
    bendSplines(route.stops);
    return route;
}

} // namespace skyseal::ui
