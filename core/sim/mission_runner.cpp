#include "core/sim/mission_runner.h"

#include "core/mavlink/enums.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

/// Seconds out of a parameter that a ground station sent: never negative, never not-a-number.
double duration(float seconds)
{
    return seconds > 0 ? static_cast<double>(seconds) : 0;
}

/// A whole number out of a parameter, within limits.
int whole(float value, int low, int high)
{
    if (!(value >= static_cast<float>(low)))
        return low;
    return value >= static_cast<float>(high) ? high : static_cast<int>(value);
}

} // namespace

void MissionRunner::load(Mission mission)
{
    m_mission = std::move(mission);
    m_current = 0;
    m_entered = m_finished = false;
    m_jumpsLeft.clear();
}

bool MissionRunner::setCurrent(std::uint16_t sequence)
{
    if (sequence >= m_mission.size())
        return false;
    m_current = sequence;
    m_entered = m_finished = false;
    m_jumpsLeft.clear();
    return true;
}

const char *MissionRunner::refusal(bool landed) const
{
    if (m_mission.size() <= first())
        return "no mission";
    if (!landed || !m_type.hovers())
        return nullptr;
    for (std::size_t i = std::max<std::size_t>(m_current, first()); i < m_mission.size(); ++i) {
        if (isNavigation(m_mission[i]))
            return m_mission[i].command == MAV_CMD_NAV_TAKEOFF ? nullptr : "Missing Takeoff Cmd";
    }
    return "Missing Takeoff Cmd";
}

void MissionRunner::begin(const Situation &s)
{
    m_started = !s.landed || !s.settings.hovers; // the others begin as soon as they are armed
    m_entered = false;
    if (m_finished) {
        m_finished = false;
        m_current = 0;
        m_jumpsLeft.clear();
    }
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
    if (!m_finished && !m_entered)
        startItem(s);
    if (!m_finished && itemDone(dt, s))
        advance(s);
    if (m_finished)
        return hold(s);

    const StoredItem &item = m_mission[m_current];
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
        m_current = std::max(m_current, first());
        if (m_current >= m_mission.size()) {
            m_finished = true;
            m_current = static_cast<std::uint16_t>(m_mission.empty() ? 0 : m_mission.size() - 1);
            return;
        }
        const StoredItem item = m_mission[m_current];
        if (execute(item, s)) {
            m_entered = true;
            return;
        }
    }
    m_finished = true; // jumps that lead nowhere
}

/// True when the item takes time; otherwise it is done and `m_current` is the next.
bool MissionRunner::execute(const StoredItem &item, const Situation &s)
{
    m_arrived = false;
    m_timeAtPlace = 0;
    switch (item.command) {
    case MAV_CMD_DO_JUMP: {
        const auto [left, first] = m_jumpsLeft.try_emplace(m_current, whole(item.parameters[1], -1, 32767));
        const int target = whole(item.parameters[0], 0, static_cast<int>(m_mission.size()));
        if (left->second == 0 || target == 0 || target >= static_cast<int>(m_mission.size())) {
            ++m_current;
        } else {
            left->second -= left->second > 0 ? 1 : 0;
            m_current = static_cast<std::uint16_t>(target);
        }
        return false;
    }
    case MAV_CMD_DO_CHANGE_SPEED:
        if (item.parameters[1] > 0) {
            const auto speed = static_cast<double>(std::min(item.parameters[1], 30.0f));
            switch (whole(item.parameters[0], SPEED_TYPE_AIRSPEED, SPEED_TYPE_DESCENT_SPEED)) {
            case SPEED_TYPE_CLIMB_SPEED: m_climb = speed; break;
            case SPEED_TYPE_DESCENT_SPEED: m_descent = speed; break;
            default: m_speed = speed;
            }
        }
        ++m_current;
        return false;
    case MAV_CMD_CONDITION_YAW:
        m_yaw.fix(radians(static_cast<double>(item.parameters[0]))
                  + (item.parameters[3] == 1 ? s.estimate.attitude.euler().yaw : 0));
        ++m_current;
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
        return duration(item.parameters[0]) * 2 * kPi * s.settings.loiterRadius / std::max(s.settings.speed, 1.0);
    const bool passesBy = item.command == MAV_CMD_NAV_WAYPOINT && m_type.kind == CraftKind::Plane;
    return passesBy ? 0 : duration(item.parameters[0]);
}

bool MissionRunner::itemDone(double dt, const Situation &s)
{
    const StoredItem &item = m_mission[m_current];
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
    case MAV_CMD_NAV_DELAY: return (m_timeAtPlace += dt) >= duration(item.parameters[0]);
    default:
        m_arrived = m_arrived || nearPlace(s);
        if (m_arrived)
            m_timeAtPlace += dt;
        return m_arrived && m_timeAtPlace >= timeToStay(item, s);
    }
}

void MissionRunner::advance(const Situation &s)
{
    m_reached = m_current;
    ++m_current;
    m_entered = false;
    startItem(s);
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
