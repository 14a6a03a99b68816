// The flight logs that a vehicle keeps, oldest first: bounded in number and size, as a small memory card is.
#pragma once

#include "core/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace skyseal::sim {

struct FlightLog
{
    std::uint32_t number = 0;    ///< of the file, rises from 1
    std::uint32_t startedAt = 0; ///< s since 1970, UTC
    Bytes bytes;                 ///< DataFlash, see log_record.h
};

class FlightLogs
{
public:
    static constexpr std::size_t kMost = 6;
    static constexpr std::size_t kMostBytes = 512 * 1024; ///< of one log: about a quarter of an hour

    /// Begins a log, which takes the place of the oldest one if there are too many.
    void begin(std::uint32_t startedAt)
    {
        if (m_logs.size() == kMost)
            m_logs.pop_front();
        m_logs.push_back({++m_lastNumber, startedAt, {}});
        m_open = true;
    }
    /// Appends a record. A log that is full or was removed takes no more.
    void append(ByteView record)
    {
        if (m_open && m_logs.back().bytes.size() + record.size() <= kMostBytes)
            m_logs.back().bytes.insert(m_logs.back().bytes.end(), record.begin(), record.end());
    }
    void end() { m_open = false; }

    std::size_t count() const { return m_logs.size(); }
    const FlightLog &log(std::size_t index) const { return m_logs[index]; }

    void remove(std::size_t index)
    {
        m_open = m_open && index + 1 != m_logs.size();
        m_logs.erase(m_logs.begin() + static_cast<std::ptrdiff_t>(index));
    }
    void clear()
    {
        m_logs.clear();
        m_open = false;
    }

private:
    std::deque<FlightLog> m_logs;
    std::uint32_t m_lastNumber = 0;
    bool m_open = false; ///< the newest is being written
};

} // namespace skyseal::sim
