// Vehicle side of the log transfer (LOG_REQUEST_LIST and the messages around it, as ArduPilot answers them): a list and the
// bytes of the logs, at a pace that a radio can carry, while the vehicle is disarmed.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/flight_logs.h"
#include "core/sim/frame_queue.h"
#include "core/sim/frame_sender.h"

namespace skyseal::sim {

class LogServer
{
public:
    LogServer(FlightLogs &logs, Autopilot &autopilot, FrameQueue &outbox)
        : m_logs(logs), m_autopilot(autopilot), m_outbox(outbox)
    {}

    /// Logs are numbered from 1 in a list, oldest first.
    void requestList(TimePoint now, const FrameSender &peer, std::uint16_t start, std::uint16_t end);
    /// Ignored during a transfer to the same peer, as ArduPilot does: stations ask for gaps more often than needed.
    void requestData(TimePoint now, const FrameSender &peer, std::uint16_t id, std::uint32_t offset, std::uint32_t count);
    void requestEnd();
    void erase();

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_due; }

private:
    bool refuses(const FrameSender &peer, bool repetitionIsFine);
    void begin(TimePoint now, const FrameSender &peer);
    bool sendEntry();
    bool sendData();

    FlightLogs &m_logs;
    Autopilot &m_autopilot;
    FrameQueue &m_outbox;

    FrameSender m_peer;
    TimePoint m_due = kNever; ///< of the next message; kNever without a transfer
    bool m_listing = false;
    std::uint16_t m_entry = 0; ///< the next of a list, or the log whose data is sent
    std::uint16_t m_lastEntry = 0;
    std::uint32_t m_offset = 0;
    std::uint32_t m_remaining = 0; ///< bytes
    bool m_warned = false;         ///< since it was disarmed
};

} // namespace skyseal::sim
