// What this station knows of one list of the vehicle (mission, fence or rally points), and the signs that another station has
// changed it since: the ids and the count of MISSION_CURRENT, and the mission protocol that the vehicle speaks with others.
// https://mavlink.io/en/services/mission.html#detecting_changes
//
// PX4 names an id of each list (a checksum of the items, MISSION_CURRENT.mission_id and its like) and, in MISSION_COUNT and
// MISSION_ACK, the id of the list that it sends or has taken. ArduPilot names none, so that of a change that this station does
// not overhear it only tells the number of the items of a mission. isWatched() says which it is.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/mission.h"

#include <optional>

namespace skyseal::vehicle {

class PlanCopy
{
public:
    /// After a change that this station made, MISSION_CURRENT may tell of the list before for so long.
    static constexpr Duration kSettling = std::chrono::seconds(3);
    /// And after a transfer that failed, which the vehicle may go on with: ArduPilot gives an upload up after 8 s.
    static constexpr Duration kSettlingFailed = std::chrono::seconds(10);
    /// Of an id that was heard last; autopilots send MISSION_CURRENT once a second or more often.
    static constexpr Duration kFresh = std::chrono::seconds(5);

    /// As last read, or as accepted by the vehicle; null before.
    const MissionItems &items() const { return m_items; }
    /// Why the vehicle may have another list by now; empty while there is no sign of it.
    const Reason &outdated() const { return m_outdated; }
    bool isChangedByOther() const { return m_isChangedByOther; }
    /// True if the vehicle names the id of the list that it has, and it is that of items().
    bool isWatched(TimePoint now) const;

    // Transfers of this station. Between begin() and end() MISSION_CURRENT says nothing about the copy.
    void begin();
    /// The id in the MISSION_COUNT or MISSION_ACK that answers this station; 0 = none.
    void answered(std::uint32_t id) { m_answeredId = id; }
    /// The vehicle has these items now. `changed`: by this station.
    void end(TimePoint now, MissionItems items, bool changed);
    /// `mayHaveChanged`: the vehicle may have a part of a list that this station sent, or none.
    void fail(TimePoint now, bool mayHaveChanged);

    // What is heard.
    /// The part of MISSION_CURRENT about this list. `id` = 0: none, or the list is empty. `total`: of a mission, without home.
    void handleCurrent(TimePoint now, std::uint32_t id, std::optional<std::uint16_t> total);
    /// Another station was sent the number of items. `id` = 0: not named.
    void handleCount(std::uint16_t count, std::uint32_t id);
    /// Another station was sent this item. `skipsHome`: item 0 is the home position, which moves.
    void handleItem(const MissionItem &item, bool skipsHome);
    /// The vehicle has taken a list, is taking one, or has cleared its own. `id` = 0: not named. `isToUs`: it says so to the
    /// ids of this station, which another one may have as well; soon after a transfer of this station it speaks of that.
    void handleChange(TimePoint now, std::uint32_t id, bool isToUs);

    /// True if `read`, as the vehicle returned it during a transfer of this station, is the list `expected`, and no other
    /// station was seen to change it meanwhile.
    bool matches(const std::vector<MissionItem> &read, const MissionItems &expected, bool skipsHome) const;

private:
    void changedByOther(Reason reason);

    MissionItems m_items;
    bool m_isRead = false; ///< items() are in the form in which the vehicle returns them
    bool m_isBusy = false; ///< a transfer of this station is under way
    Reason m_outdated, m_disturbed;
    bool m_isChangedByOther = false;
    TimePoint m_settled{};
    std::uint32_t m_answeredId = 0;
    std::optional<std::uint32_t> m_id; ///< of the list that items() show; nullopt: not known yet
    bool m_isIdAnswered = false;       ///< the vehicle named it for this copy
    bool m_namesIds = false;           ///< in MISSION_CURRENT
    TimePoint m_idHeard{};
    std::optional<std::uint16_t> m_total; ///< as MISSION_CURRENT counts; nullopt: not known yet
};

} // namespace skyseal::vehicle
