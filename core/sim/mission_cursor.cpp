#include "core/sim/mission_cursor.h"

#include "core/sim/parameter_number.h"

#include <algorithm>

namespace skyseal::sim {

void MissionCursor::restart(std::uint16_t sequence)
{
    m_current = sequence;
    m_isEntered = m_isFinished = false;
    m_jumpsLeft.clear();
}

void MissionCursor::load(Mission mission)
{
    m_mission = std::move(mission);
    restart(0);
}

bool MissionCursor::setCurrent(std::uint16_t sequence)
{
    if (sequence >= m_mission.size())
        return false;
    restart(sequence);
    return true;
}

void MissionCursor::resume()
{
    m_isEntered = false;
    if (m_isFinished)
        restart(0);
}

bool MissionCursor::moveToItem(std::uint16_t first)
{
    m_current = std::max(m_current, first);
    if (m_current < m_mission.size())
        return true;
    m_isFinished = true;
    m_current = static_cast<std::uint16_t>(m_mission.empty() ? 0 : m_mission.size() - 1);
    return false;
}

void MissionCursor::jump()
{
    const StoredItem &item = m_mission[m_current];
    const auto left = m_jumpsLeft.try_emplace(m_current, wholeNumber(item.parameters[1], -1, 32767)).first;
    const int target = wholeNumber(item.parameters[0], 0, static_cast<int>(m_mission.size()));
    if (left->second == 0 || target == 0 || target >= static_cast<int>(m_mission.size()))
        return skip();
    left->second -= left->second > 0 ? 1 : 0;
    m_current = static_cast<std::uint16_t>(target);
}

void MissionCursor::complete()
{
    m_reached = m_current;
    ++m_current;
    m_isEntered = false;
}

} // namespace skyseal::sim
