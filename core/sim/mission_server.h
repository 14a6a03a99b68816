// MAVLink's mission protocol, the vehicle's side (https://mavlink.io/en/services/mission.html): upload, download, clear and
// set current, with the repetitions that a lossy link needs.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/frame_queue.h"
#include "core/sim/frame_sender.h"

namespace skyseal::sim {

class MissionServer
{
public:
    MissionServer(Autopilot &autopilot, FrameQueue &outbox) : m_autopilot(autopilot), m_outbox(outbox) {}

    void handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count, std::uint8_t type);
    /// MISSION_ITEM and MISSION_ITEM_INT of an upload.
    void handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item, std::uint8_t type);
    void handleRequestList(const FrameSender &peer, std::uint8_t type);
    /// MISSION_REQUEST, answered in floats, and MISSION_REQUEST_INT.
    void handleRequest(const FrameSender &peer, std::uint16_t sequence, std::uint8_t type, bool asInt);
    void handleClear(const FrameSender &peer, std::uint8_t type);
    void handleSetCurrent(std::uint16_t sequence);
    /// MISSION_ACK of the station: it gave up an upload.
    void handleAck(const FrameSender &peer, std::uint8_t result);
    /// Answers an item that was no part of an upload but an order to fly there.
    void acknowledge(const FrameSender &peer, std::uint8_t result, std::uint8_t type = 0);

    /// MISSION_ITEM_REACHED and MISSION_CURRENT where they changed.
    void reportProgress();

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_receiving ? m_askAgain : kNever; }

private:
    void askFor(TimePoint now);
    void finish(std::uint8_t result);

    Autopilot &m_autopilot;
    FrameQueue &m_outbox;

    bool m_receiving = false;
    FrameSender m_sender;
    std::uint16_t m_expected = 0; ///< items that are to come in all
    Mission m_incoming;
    TimePoint m_askAgain = kNever;
    int m_asked = 0;          ///< times that the present item was asked for
    FrameSender m_finishedBy; ///< whose last upload was accepted, with how many items: its last item may come twice
    std::uint16_t m_finishedCount = 0;
    std::uint16_t m_reportedCurrent = 0;
};

} // namespace skyseal::sim
