// The route that a vehicle flies on its mission, as the map draws it: legs, splines, circles of loiters and jumps. Follows
// ArduPilot's reading of the MAV_CMD_NAV_* commands. https://mavlink.io/en/messages/common.html#mav_commands
#pragma once

#include "core/vehicle/mission_place.h"
#include "ui/tiles/mercator.h"

#include <QtCore/QPointF>

#include <optional>
#include <vector>

namespace skyseal::ui {

/// A place that the vehicle flies to. Positions are in metres of the projection, see mercator.h.
struct RouteStop
{
    enum class Loiter : std::uint8_t { None, Unlimited, Turns, Time, ToAltitude };
    using Reference = vehicle::AltitudeReference;

    QPointF at;
    int sequence = 0;                        ///< of its item; -1: the place where the route begins, or home at its end
    bool spline = false;                     ///< the leg to this stop is a spline
    QPointF controlIn = {}, controlOut = {}; ///< control points of that spline, after its beginning and before `at`
    Loiter loiter = Loiter::None;
    double radius = 0;   ///< metres on the ground; 0: the one that the vehicle is configured for
    double amount = 0;   ///< turns or seconds
    double altitude = 0; ///< metres above the reference; NaN: the vehicle decides
    Reference reference = Reference::Home;
};

/// A jump back or forward in the list (DO_JUMP), drawn between two stops.
struct RouteJump
{
    int from = 0, to = 0; ///< sequences of the stops
    int times = 0;        ///< -1: for ever
};

/// An item with a place that is not flown to: region of interest, home, start of a landing sequence.
struct RouteMark
{
    QPointF at;
    int sequence = 0;
};

struct MissionRoute
{
    std::vector<RouteStop> stops; ///< in the order of the flight
    std::vector<RouteJump> jumps;
    std::vector<RouteMark> marks;

    const RouteStop *stopOf(int sequence) const;
};

/// `home` is where take-offs without a place begin and returns to launch end. With `firstIsHome`, item 0 is home and no stop,
/// as ArduPilot keeps it.
MissionRoute routeOf(const std::vector<vehicle::MissionItem> &items, std::optional<QPointF> home, bool firstIsHome);

} // namespace skyseal::ui
