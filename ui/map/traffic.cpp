#include "ui/map/traffic.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/tiles/mercator.h"

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

/// NaN, of an unknown height, equals itself here.
bool sameMark(const AircraftMark &a, const AircraftMark &b)
{
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.at == b.at && same(a.heading, b.heading) && a.sight.name == b.sight.name && a.sight.isNear == b.sight.isNear
        && same(a.sight.metresAbove, b.sight.metresAbove);
}

} // namespace

bool TrafficContent::show(const ViewState &view)
{
    std::vector<AircraftMark> marks;
    if (view.vehicle) {
        const vehicle::VehicleState &state = view.vehicle->state;
        for (const vehicle::Aircraft &aircraft : state.traffic)
            if (aircraft.position.known())
                marks.push_back({mercator::project({aircraft.position.latitude, aircraft.position.longitude}), aircraft.heading,
                                 sightOf(aircraft, state.position)});
    }
    if (std::ranges::equal(marks, m_marks, sameMark))
        return false;
    m_marks = std::move(marks);
    return true;
}

} // namespace skyseal::ui
