#include "ui/map/map_content.h"

#include "core/engine/station/snapshot.h"

#include <cmath>

namespace skyseal::ui {

/// Returns true if another vehicle was shown before.
bool MapContent::startOver(std::uint8_t systemId)
{
    if (systemId == m_systemId)
        return false;
    m_systemId = systemId;
    m_track.clear();
    m_vehicle.reset();
    m_home.reset();
    m_mission.reset();
    m_route.reset();
    return true;
}

/// Returns true if the route or the place on it changed.
bool MapContent::showMission(const engine::VehicleSnapshot &vehicle, bool homeMoved)
{
    const bool another = m_mission != vehicle.mission;
    const bool outdated = !vehicle.missionOutdated.empty();
    if (!another && !homeMoved && m_missionCurrent == vehicle.state.missionCurrent && m_isRouteOutdated == outdated)
        return false;
    m_isRouteOutdated = outdated;
    m_missionCurrent = vehicle.state.missionCurrent;
    m_mission = vehicle.mission;
    const bool homeFirst = vehicle::keepsHomeFirst(vehicle.state.autopilot);
    m_route = m_mission ? std::optional(routeOf(*m_mission, m_home, homeFirst)) : std::nullopt;
    return true;
}

/// Seconds on the clock of the vehicle, which a replay may let run faster or slower.
static double flightSeconds(const engine::Snapshot &snapshot)
{
    return snapshot.replay ? seconds(snapshot.replay->position) : snapshot.time;
}

/// True if nothing can have flown there since the last position: the vehicle was restarted, or its estimate was reset.
bool MapContent::isJump(const QPointF &now, double time) const
{
    constexpr double kFastest = 350, kLeast = 50; // metres a second, metres
    const QPointF way = now - m_lastKnown;
    const double apart = std::hypot(way.x(), way.y()) / mercator::stretch(now.y());
    return apart > kLeast && apart > kFastest * (time - m_positionAt);
}

namespace {

TrackValues trackValues(const ViewState &view)
{
    const double lost = view.session ? view.session->lossPercent : view.vehicle->lossPercent;
    const vehicle::VehicleState &state = view.vehicle->state;
    return {static_cast<float>(100 - lost), static_cast<float>(state.altitudeRelative), static_cast<float>(state.groundSpeed)};
}

} // namespace

/// Takes the way that the vehicle flew before a seek of a replay, or before it was selected. Returns true if there is one.
bool MapContent::showFlown(const engine::Snapshot &snapshot, bool another)
{
    const auto flown = snapshot.replay ? snapshot.replay->flown : nullptr;
    const bool sought = flown != m_flown;
    m_flown = flown;
    if (!flown || (!sought && !another))
        return false;
    m_track.clear();
    for (const engine::FlownPoint &place : flown->of(m_systemId)) {
        const QPointF now = mercator::project({place.latitude, place.longitude});
        if (place.begins || isJump(now, seconds(place.at)))
            m_track.interrupt();
        m_lastKnown = now;
        m_positionAt = seconds(place.at);
        m_track.append(now, crypto::SuiteId::None, {place.quality, place.altitude, place.speed});
    }
    if (!sought)
        m_track.interrupt(); // the part since the seek is not known
    return true;
}

MapContent::Changes MapContent::show(const ViewState &view, double metresPerPixel)
{
    Changes changes;
    if (!view.vehicle)
        return changes;
    const auto &state = view.vehicle->state;
    changes.ground = startOver(state.systemId);
    changes.ground |= showFlown(*view.snapshot, changes.ground);
    std::vector<VehicleMarker> others = otherVehicles(view);
    const int age = staleAge(state);
    changes.vehicle = age != m_age || !looksTheSame(others, m_others, metresPerPixel);
    if (changes.vehicle)
        m_others = std::move(others);
    m_age = age;
    m_suite = linkSuiteOf(view, *view.vehicle);
    bool homeMoved = false;
    if (state.home.known()) {
        const QPointF home = mercator::project({state.home.latitude, state.home.longitude});
        homeMoved = m_home != home;
        m_home = home;
    }
    changes.ground |= homeMoved;
    changes.ground |= showMission(*view.vehicle, homeMoved);
    if (state.position.known()) {
        const QPointF now = mercator::project({state.position.latitude, state.position.longitude});
        if (isStale() || isJump(now, flightSeconds(*view.snapshot)))
            m_track.interrupt();
        if (!isStale()) {
            m_lastKnown = now;
            m_positionAt = flightSeconds(*view.snapshot);
            changes.ground |= m_track.append(now, m_suite.value_or(crypto::SuiteId::None), trackValues(view));
        }
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
