#include "core/sim/log_server.h"

#include "core/mavlink/messages.h"

namespace skyseal::sim {

namespace {
constexpr Duration kLogPace = std::chrono::milliseconds(4); // 22 kB a second
constexpr Duration kWhileArmed = std::chrono::seconds(1);
} // namespace

bool LogServer::refuses(const FrameSender &peer, bool repetitionIsFine)
{
    if (m_autopilot.armed()) {
        if (!std::exchange(m_warned, true))
            m_autopilot.texts().say(Severity::Error, "Disarm for log download");
        return true;
    }
    m_warned = false;
    if (m_due == kNever)
        return false;
    if (!repetitionIsFine || !m_peer.sameSender(peer))
        m_autopilot.texts().say(Severity::Info, "Log download in progress");
    return true;
}

void LogServer::begin(TimePoint now, const FrameSender &peer)
{
    m_peer = peer;
    m_due = now;
}

void LogServer::requestList(TimePoint now, const FrameSender &peer, std::uint16_t start, std::uint16_t end)
{
    if (refuses(peer, m_autopilot.flight().type.isPx4())) // which has no text for it
        return;
    const auto count = static_cast<std::uint16_t>(m_logs.count());
    m_lastEntry = std::min(end, count);
    m_entry = count == 0 ? std::uint16_t(0) : std::max<std::uint16_t>(start, 1);
    if (m_entry > m_lastEntry)
        return; // none of these exists
    m_listing = true;
    begin(now, peer);
}

void LogServer::requestData(TimePoint now, const FrameSender &peer, std::uint16_t id, std::uint32_t offset, std::uint32_t count)
{
    if (refuses(peer, true) || id < 1 || id > m_logs.count())
        return;
    const auto size = static_cast<std::uint32_t>(m_logs.log(id - 1u).bytes.size());
    m_listing = false;
    m_entry = id;
    m_offset = offset;
    m_remaining = offset < size ? std::min(count, size - offset) : 0; // nothing left: an empty LOG_DATA tells the end
    begin(now, peer);
}

void LogServer::requestEnd()
{
    m_due = kNever;
}

void LogServer::erase()
{
    if (m_autopilot.armed())
        return;
    m_logs.clear();
    m_due = kNever;
}

void LogServer::handleDeadline(TimePoint now)
{
    while (m_due <= now) {
        if (m_autopilot.armed()) { // goes on when the vehicle is disarmed
            m_due = now + kWhileArmed;
            return;
        }
        m_due += kLogPace;
        if (m_outbox.room() < FrameQueue::kKeptForTelemetry)
            continue;
        if (!(m_listing ? sendEntry() : sendData()))
            m_due = kNever;
    }
}

/// False after the last.
bool LogServer::sendEntry()
{
    mavlink::LogEntry out;
    out.id = m_entry;
    out.num_logs = static_cast<std::uint16_t>(m_logs.count());
    out.last_log_num = m_lastEntry;
    if (m_entry > m_logs.count())
        return false; // erased meanwhile
    if (m_entry > 0) {
        const FlightLog &log = m_logs.log(m_entry - 1u);
        out.time_utc = log.startedAt;
        out.size = static_cast<std::uint32_t>(log.bytes.size());
    }
    m_outbox.send(out);
    return m_entry++ < m_lastEntry;
}

/// False after the last.
bool LogServer::sendData()
{
    if (m_entry > m_logs.count())
        return false;
    const Bytes &bytes = m_logs.log(m_entry - 1u).bytes;
    mavlink::LogData out;
    const std::size_t size = std::min<std::size_t>(m_remaining, out.data.size());
    if (size > 0 && (bytes.size() < size || m_offset > bytes.size() - size))
        return false; // erased meanwhile
    out.id = m_entry;
    out.ofs = m_offset;
    out.count = static_cast<std::uint8_t>(size);
    if (size > 0)
        std::copy_n(bytes.begin() + m_offset, size, out.data.begin());
    m_outbox.send(out);
    m_offset += static_cast<std::uint32_t>(size);
    m_remaining -= static_cast<std::uint32_t>(size);
    return m_remaining > 0;
}

} // namespace skyseal::sim
