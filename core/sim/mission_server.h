// MAVLink's mission protocol, the vehicle's side (https://mavlink.io/en/services/mission.html): passes each message to the
// transfer of its list (flight plan, fence, rally points), and reports the progress of the flight plan.
#pragma once

#include "core/sim/item_lists.h"
#include "core/sim/item_transfer.h"

#include <array>

namespace skyseal::sim {

class MissionServer
{
public:
    MissionServer(Autopilot &autopilot, ParameterServer &parameters, FrameQueue &outbox);
    MissionServer(const MissionServer &) = delete;
    MissionServer &operator=(const MissionServer &) = delete;

    // `type` is a MAV_MISSION_TYPE; a type that the vehicle does not have is refused.
    void handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count, std::uint8_t type);
    /// MISSION_ITEM and MISSION_ITEM_INT of an upload.
    void handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item, std::uint8_t type);
    void handleRequestList(const FrameSender &peer, std::uint8_t type);
    /// MISSION_REQUEST, answered in floats, and MISSION_REQUEST_INT.
    void handleRequest(const FrameSender &peer, std::uint16_t sequence, std::uint8_t type, bool asInt);
    /// Clears one list, or with MAV_MISSION_TYPE_ALL every list.
    void handleClear(const FrameSender &peer, std::uint8_t type);
    void handleSetCurrent(std::uint16_t sequence);
    /// MISSION_ACK of the station: it gave up an upload.
    void handleAck(const FrameSender &peer, std::uint8_t result, std::uint8_t type);
    /// Answers an item that was no part of an upload but an order to fly there.
    void acknowledge(const FrameSender &peer, std::uint8_t result, std::uint8_t type = 0);

    /// MISSION_ITEM_REACHED and MISSION_CURRENT where they changed.
    void reportProgress();

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    static constexpr std::size_t kLists = 3;
    using StoredLists = std::array<std::vector<StoredItem>, kLists>;
    /// All lists as they are stored, to keep them over a reboot.
    StoredLists stored() const;
    void restore(StoredLists lists);

private:
    /// The transfer of a type; null, and the peer was refused, if the vehicle has no such list.
    ItemTransfer *transfer(const FrameSender &peer, std::uint8_t type);

    Autopilot &m_autopilot;
    FrameQueue &m_outbox;
    FlightPlanList m_plan;
    FenceList m_fence;
    RallyList m_rally;
    std::array<ItemTransfer, kLists> m_transfers; ///< by MAV_MISSION_TYPE
    std::uint16_t m_reportedCurrent = 0;
};

} // namespace skyseal::sim
