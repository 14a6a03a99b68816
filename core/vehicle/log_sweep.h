// Steers a vehicle that streams a log from a requested chunk on, and of which each request replaces the one before (PX4's
// mavlink_log_handler.cpp). While it streams, it is sent past what has arrived, from one missing chunk to the next and again
// from the first one: its radio is never idle, and no answer is waited for. No I/O and no clock.
//
// Where the vehicle is follows from the latest request and the pace that was measured of a long run. Two requests that are as
// far apart in time as the chunks between them take are served without a gap, whatever the round trip. If the guess is wrong,
// or a request was lost, a missing chunk comes in the next sweep.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/log_content.h"

#include <optional>

namespace skyseal::vehicle {

class LogSweep
{
public:
    /// Least time between requests. PX4 serves one every 10 ms (MavlinkReceiver::run()), and those that it replaced before cost
    /// nothing: all that it sends was missing.
    static constexpr Duration kLeastSpacing = std::chrono::milliseconds(5);
    /// Chunks that come in bursts, at most so far apart, are sent by a radio that serves a request for each burst: a second
    /// request in that time would replace the first one.
    static constexpr Duration kMostSpacing = std::chrono::milliseconds(20);
    /// The pace is measured over at least so many chunks.
    static constexpr std::size_t kMeasured = 64;
    /// Sweeps in a round trip, when few chunks are missing: each is requested so often before its answer can have come.
    static constexpr int kInRoundTrip = 4;

    /// The first missing chunk and all that follow were requested. Steers when the pace is known.
    void begin(TimePoint now, const LogContent &content);
    /// Steers no more before begin().
    void stop() { m_due = kNever; }
    void arrived(TimePoint now, std::size_t chunk);

    /// The chunk to request now, with all that follow; nullopt if the vehicle is to go on. `roundTrip`: the shortest one.
    std::optional<std::size_t> poll(TimePoint now, const LogContent &content, Duration roundTrip);
    /// When poll() is to be called; kNever before the pace is known.
    TimePoint nextDeadline() const { return m_due; }

private:
    struct Arrival
    {
        TimePoint time{};
        std::size_t chunk = 0;
    };

    TimePoint timeOf(std::size_t chunk) const { return m_requested + m_interval * static_cast<int>(chunk - m_from); }
    std::size_t place(TimePoint now) const;

    std::size_t m_from = 0;     ///< requested latest
    std::size_t m_until = 0;    ///< the first one behind it that is not wanted
    TimePoint m_requested{};    ///< time of the request
    TimePoint m_began{};        ///< of the sweep
    bool m_isMeasuring = false; ///< nothing was requested since begin()
    std::optional<Arrival> m_first;
    TimePoint m_latest{};               ///< arrival while it is measured
    int m_bursts = 0;                   ///< since m_first
    Duration m_interval{};              ///< between chunks; zero before it is known
    Duration m_spacing = kLeastSpacing; ///< between requests
    TimePoint m_due = kNever;
};

} // namespace skyseal::vehicle
