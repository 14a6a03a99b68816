#include "core/vehicle/home_tracker.h"

#include "core/vehicle/geodesy.h"

namespace skyseal::vehicle {

void HomeTracker::handleHomePosition(const Position &home, VehicleState &state)
{
    if (!home.known())
        return;
    m_notified = true;
    state.home = home;
    update(state);
}

void HomeTracker::update(VehicleState &state)
{
    const bool justArmed = state.armed && !m_wasArmed;
    if (!m_notified && state.position.known() && (justArmed || (state.armed && !state.home.known())))
        state.home = state.position;
    m_wasArmed = state.armed;
    state.distanceHome = distanceMetres(state.position, state.home);
}

} // namespace skyseal::vehicle
