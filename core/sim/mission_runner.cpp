#include "core/sim/mission_runner.h"

#include "core/mavlink/enums.h"
#include "core/sim/parameter_number.h"

namespace skyseal::sim {

using namespace mavlink;

const char *MissionRunner::refusal(bool landed) const
{
    const Mission &mission = m_cursor.mission();
    if (mission.size() <= first())
        return "no mission";
    if (!landed || !m_type.hovers())
        return nullptr;
    for (std::size_t i = std::max(m_cursor.current(), first()); i < mission.size(); ++i) {
        if (isNavigation(mission[i]))
            return mission[i].command == MAV_CMD_NAV_TAKEOFF ? nullptr : "Missing Takeoff Cmd";
    }
    return "Missing Takeoff Cmd";
}

void MissionRunner::begin(const Situation &s)
{
    m_started = !s.landed || !s.settings.hovers; // the others begin as soon as they are armed
    m_cursor.resume();
    m_speed.reset();
    m_climb.reset();
    m_descent.reset();
    m_yaw.reset(s);
    m_place = {stoppingPoint(s).north, stoppingPoint(s).east, s.estimate.position.z};
}

FlightDemand MissionRunner::update(double dt, const Situation &s)
{
    if (!m_started) {
        if (s.sticks.throttle <= 0.1)
            return hold(s);
        m_started = true;
    }
    if (!m_cursor.isFinished() && !m_cursor.isEntered())
        startItem(s);
    if (!m_cursor.isFinished() && itemDone(dt, s)) {
        m_cursor.complete();
        startItem(s);
    }
    if (m_cursor.isFinished())
        return hold(s);

    const StoredItem &item = m_cursor.item();
    if (item.command == MAV_CMD_NAV_TAKEOFF)
        return m_takeOff.update(dt, s);
    if (item.command == MAV_CMD_NAV_RETURN_TO_LAUNCH)
        return m_return.update(dt, s);
    if (item.command == MAV_CMD_NAV_LAND && m_arrived)
        return m_landing.update(s);
    return hold(s);
}

/// Begins the current item. Items without a place take effect at once, up to the next place to fly to.
void MissionRunner::startItem(const Situation &s)
{
    for (int steps = 0; steps < 200; ++steps) {
        if (!m_cursor.moveToItem(first()))
            return;
        if (execute(m_cursor.item(), s))
            return m_cursor.enter();
    }
    m_cursor.finish(); // jumps that lead nowhere
}

/// True when the item, the current one, takes time; otherwise it is done and the next one is current.
bool MissionRunner::execute(const StoredItem &item, const Situation &s)
{
    m_arrived = false;
    m_timeAtPlace = 0;
    switch (item.command) {
    case MAV_CMD_DO_JUMP: m_cursor.jump(); return false;
    case MAV_CMD_DO_CHANGE_SPEED:
        if (item.parameters[1] > 0) {
            const auto speed = static_cast<double>(std::min(item.parameters[1], 30.0f));
            switch (wholeNumber(item.parameters[0], SPEED_TYPE_AIRSPEED, SPEED_TYPE_DESCENT_SPEED)) {
            case SPEED_TYPE_CLIMB_SPEED: m_climb = speed; break;
            case SPEED_TYPE_DESCENT_SPEED: m_descent = speed; break;
            default: m_speed = speed;
            }
        }
        m_cursor.skip();
        return false;
    case MAV_CMD_CONDITION_YAW:
        m_yaw.fix(radians(static_cast<double>(item.parameters[0]))
                  + (item.parameters[3] == 1 ? s.estimate.attitude.euler().yaw : 0));
        m_cursor.skip();
        return false;
    case MAV_CMD_NAV_TAKEOFF:
        m_place = {s.estimate.position.x, s.estimate.position.y, placeOf(item, m_world, s.home, s.estimate.position).z};
        m_takeOff.begin(s, std::max(s.home.z - m_place.z, 1.0));
        return true;
    case MAV_CMD_NAV_RETURN_TO_LAUNCH: m_return.begin(s); return true;
    case MAV_CMD_NAV_DELAY: return true;
    case MAV_CMD_NAV_LAND:
        m_place = placeOf(item, m_world, s.home, s.estimate.position);
        m_place.z = s.estimate.position.z; // flies there at the present height, then descends
        return true;
    default: m_place = placeOf(item, m_world, s.home, s.estimate.position); return true;
    }
}

bool MissionRunner::nearPlace(const Situation &s) const
{
    const Vector3 way = m_place - s.estimate.position;
    return way.horizontal() < s.settings.waypointRadius
        && (!s.settings.hovers || std::abs(way.z) < std::max(s.settings.waypointRadius, 1.0));
}

/// Seconds at the place of an item before the next one begins.
double MissionRunner::timeToStay(const StoredItem &item, const Situation &s) const
{
    if (item.command == MAV_CMD_NAV_LOITER_TURNS)
        return durationOf(item.parameters[0]) * 2 * kPi * s.settings.loiterRadius / std::max(s.settings.speed, 1.0);
    const bool passesBy = item.command == MAV_CMD_NAV_WAYPOINT && m_type.kind == CraftKind::Plane;
    return passesBy ? 0 : durationOf(item.parameters[0]);
}

bool MissionRunner::itemDone(double dt, const Situation &s)
{
    const StoredItem &item = m_cursor.item();
    switch (item.command) {
    case MAV_CMD_NAV_TAKEOFF: return m_takeOff.done(s);
    case MAV_CMD_NAV_RETURN_TO_LAUNCH: return m_return.phase() == ReturnFlight::Phase::Land && s.landed;
    case MAV_CMD_NAV_LAND:
        if (!m_arrived && nearPlace(s)) {
            m_arrived = true;
            m_landing.begin(s, {m_place.x, m_place.y, s.settings.speed});
        }
        return m_arrived && s.landed;
    case MAV_CMD_NAV_LOITER_UNLIM: return false;
    case MAV_CMD_NAV_DELAY: return (m_timeAtPlace += dt) >= durationOf(item.parameters[0]);
    default:
        m_arrived = m_arrived || nearPlace(s);
        if (m_arrived)
            m_timeAtPlace += dt;
        return m_arrived && m_timeAtPlace >= timeToStay(item, s);
    }
}

FlightDemand MissionRunner::hold(const Situation &s)
{
    const HoldPosition place{m_place.x, m_place.y, m_speed.value_or(s.settings.speed)};
    FlightDemand demand;
    demand.horizontal = place;
    demand.vertical = HoldAltitude{-m_place.z, m_climb.value_or(s.settings.climb), m_descent.value_or(s.settings.descent)};
    demand.yaw = m_yaw.towards(s, place);
    demand.idle = s.landed;
    return demand;
}

} // namespace skyseal::sim
