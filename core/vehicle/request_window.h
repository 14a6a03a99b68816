// Decides which items of a numbered list to ask for, and when, over a link that delays and loses: a window of requests whose
// size follows the round trip. A request without an answer within the retransmission timeout (RFC 6298, section 2) is made
// again. Growing delay shrinks the window, loss does not: radios lose without being overloaded. No I/O and no clock.
#pragma once

#include "core/vehicle/rtt_estimator.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

class RequestWindow
{
public:
    static constexpr std::size_t kFirst = 8, kLeast = 2, kMost = 48; ///< requests without an answer yet
    /// After so many timeouts without any item, requests are made half as often, again and again.
    static constexpr int kSilentTimeouts = 3, kMostBackoff = 64;
    /// With so few items missing each is asked for twice at a time, unless only one may be asked for: the last ones decide
    /// when the list is complete.
    static constexpr std::size_t kAskedTwice = 16;

    /// Begins a list of which nothing has arrived. The estimate of the round trip is kept.
    void begin();
    /// At most so many requests without an answer; 1 for a vehicle that answers in order alone.
    void setMost(std::size_t most);
    /// The list has so many items; those that have arrived stay.
    void setCount(std::size_t count);
    /// Items before this one may be asked for; the others still come by themselves.
    void openUpTo(std::size_t end) { m_end = end; }
    /// Notes an item. Returns false if it had arrived before.
    bool arrived(TimePoint now, std::size_t index);

    /// The next item to ask for now; nullopt if none is due.
    std::optional<std::size_t> poll(TimePoint now);
    /// When poll() returns an item again; TimePoint::min() for at once, kNever if none is missing.
    TimePoint nextDeadline() const;

    std::size_t count() const { return m_items.size(); }
    std::size_t received() const { return m_received; }
    bool isComplete() const { return !m_items.empty() && m_received == m_items.size(); }
    /// The first item that has not arrived; count() if none is missing.
    std::size_t firstMissing() const;
    /// A request for this item has no answer yet.
    bool isAsked(std::size_t index) const;
    /// Of the link: answers to other requests may be measured as well.
    RttEstimator &rtt() { return m_rtt; }
    const RttEstimator &rtt() const { return m_rtt; }

private:
    struct Item
    {
        bool here = false;
        std::uint16_t attempts = 0;
    };
    struct Request
    {
        std::size_t index = 0;
        TimePoint sent{};
    };

    void expire(TimePoint now);
    Duration patience() const;
    void measure(Duration roundTrip);
    std::size_t missing() const { return m_items.size() - m_received; }
    std::optional<std::size_t> nextMissing() const;

    std::vector<Item> m_items;
    std::size_t m_received = 0;
    std::size_t m_end = 0;
    std::size_t m_firstMissing = 0;  ///< nothing before it is missing
    std::vector<Request> m_requests; ///< without an answer, the oldest first
    std::optional<std::size_t> m_again;
    std::optional<TimePoint> m_progress; ///< the latest item, or the start; also set when the timeout was doubled
    int m_backoff = 1;                   ///< the timeout is so much longer while nothing arrives
    std::size_t m_window = kFirst, m_most = kMost;
    RttEstimator m_rtt;
};

} // namespace skyseal::vehicle
