#include "ui/map/map_content.h"

#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"

#include <cmath>

namespace skyseal::ui {

/// Returns true if another vehicle was shown before.
bool MapContent::startOver(std::uint8_t systemId)
{
    if (systemId == m_systemId)
        return false;
    m_systemId = systemId;
    m_track.clear();
    m_frame.reset();
    m_vehicle.reset();
    m_home.reset();
    return true;
}

MapContent::Changes MapContent::show(const ViewState &view, double metresPerPixel)
{
    Changes changes;
    if (!view.vehicle)
        return changes;
    const auto &state = view.vehicle->state;
    changes.ground = startOver(state.systemId);
    const vehicle::Position &origin = state.home.known() ? state.home : state.position;
    if (!m_frame && origin.known())
        m_frame = LocalFrame{origin.latitude, origin.longitude};
    if (!m_frame)
        return changes;

    changes.vehicle = view.stale() != m_stale;
    m_stale = view.stale();
    m_suite = view.session ? view.session->info.suite : crypto::SuiteId::None;
    if (state.home.known()) {
        const QPointF home = m_frame->toMetres(state.home.latitude, state.home.longitude);
        changes.ground |= m_home != home;
        m_home = home;
    }
    if (m_mission != view.vehicle->mission || m_missionCurrent != state.missionCurrent) {
        m_mission = view.vehicle->mission;
        m_missionCurrent = state.missionCurrent;
        changes.ground = true;
    }
    if (state.position.known()) {
        const QPointF now = m_frame->toMetres(state.position.latitude, state.position.longitude);
        if (!m_stale)
            changes.ground |= m_track.append(now, m_suite);
        if (!m_vehicle || (now - *m_vehicle).manhattanLength() > metresPerPixel * 0.5) {
            m_vehicle = now;
            changes.vehicle = changes.moved = true;
        }
    }
    constexpr double kTurn = 0.7; // degrees
    if (std::isfinite(state.heading) && std::abs(state.heading - m_heading) > kTurn) {
        m_heading = state.heading;
        changes.vehicle = true;
    }
    return changes;
}

} // namespace skyseal::ui
