// The place in a mission: which item is flown, and which one follows it, with the jumps that are left. Knows nothing of flying.
#pragma once

#include "core/sim/mission.h"

#include <map>
#include <optional>
#include <utility>

namespace skyseal::sim {

class MissionCursor
{
public:
    const Mission &mission() const { return m_mission; }
    void load(Mission mission);
    /// The item that is flown, or that a start begins with; 0 when there is none.
    std::uint16_t current() const { return m_current; }
    const StoredItem &item() const { return m_mission[m_current]; }
    /// False when there is no such item.
    bool setCurrent(std::uint16_t sequence);
    /// The current item is to be begun anew; after the end of the mission its first one.
    void resume();

    /// True after enter(), until the item is completed.
    bool isEntered() const { return m_isEntered; }
    void enter() { m_isEntered = true; }
    bool isFinished() const { return m_isFinished; }
    void finish() { m_isFinished = true; }

    /// Moves to item `first` if it is before that. Returns false, and finishes, behind the last item.
    bool moveToItem(std::uint16_t first);
    /// Passes an item that takes no time.
    void skip() { ++m_current; }
    /// Follows the DO_JUMP that is the current item, as often as it says, else passes it.
    void jump();
    /// The current item was flown.
    void complete();
    /// The item that was reached since the last call.
    std::optional<std::uint16_t> takeReached() { return std::exchange(m_reached, std::nullopt); }

private:
    void restart(std::uint16_t sequence);

    Mission m_mission;
    std::uint16_t m_current = 0;
    bool m_isEntered = false;
    bool m_isFinished = false;
    std::optional<std::uint16_t> m_reached;
    std::map<std::uint16_t, int> m_jumpsLeft; ///< by the item of the jump; negative: without limit
};

} // namespace skyseal::sim
