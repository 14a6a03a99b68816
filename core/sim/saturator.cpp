#include "core/sim/saturator.h"

#include "core/mavlink/messages.h"

#include <algorithm>

namespace skyseal::sim {

namespace {

// Several round trips, so that the delay of a slow link does not count as loss.
constexpr Duration kLeastPatience = std::chrono::milliseconds(100);
constexpr Duration kMostPatience = std::chrono::seconds(10);
constexpr Duration kFirstPatience = std::chrono::seconds(3); ///< while nothing is known of the link
constexpr unsigned kLostAfter = 3;                           // as in TCP (RFC 5681)

/// Bursts that may queue at a line: one is transmitted while the next waits. Requested telemetry queues between them.
constexpr double kMostQueued = 2;
/// Waiting of less is a busy processor's or jitter, and no line's.
constexpr Duration kNoQueue = std::chrono::milliseconds(60);

} // namespace

Duration Saturator::patience() const
{
    return m_trip == Duration() ? kFirstPatience : std::clamp(m_trip * 4, kLeastPatience, kMostPatience);
}

void Saturator::noteTrip(Duration trip)
{
    m_trip = m_trip == Duration() ? trip : (m_trip * 7 + trip) / 8;
    m_leastTrip = std::min(m_leastTrip, trip);
}

/// As many bursts are on the way at once as the time says that a trip takes longer than it must (Brakmo and Peterson, "TCP
/// Vegas", 1995).
bool Saturator::fillsTheQueue(Duration trip) const
{
    const Duration waiting = trip - m_leastTrip;
    return waiting > kNoQueue && m_window * seconds(waiting) > kMostQueued * seconds(trip);
}

void Saturator::missed()
{
    m_window = std::max(1.0, m_window / 2);
}

void Saturator::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    m_heard = true;
    if (frame.messageId() != mavlink::Timesync::kId)
        return;
    const auto answer = mavlink::Timesync::decode(frame.payload());
    if (answer.tc1 == 0)
        return;
    const auto found = std::find_if(m_open.begin(), m_open.end(), [&](const Ticket &t) { return t.number == answer.ts1; });
    if (found == m_open.end())
        return takeLate(now, answer.ts1);
    const Duration trip = now - found->sent;
    noteTrip(trip);
    const double step = 1 / m_window;
    m_window = fillsTheQueue(trip) ? std::max(1.0, m_window - step) : std::min(kWidest, m_window + step);
    std::for_each(m_open.begin(), found, [](Ticket &earlier) { ++earlier.overtaken; });
    m_open.erase(found);
    if (std::erase_if(m_open, [](const Ticket &ticket) { return ticket.overtaken >= kLostAfter; }) > 0)
        missed();
}

/// Nothing is waited for any longer. How long the next ones are waited for stays as it is: a link that was gone for a while
/// must not be left alone for a while when it is back.
void Saturator::giveUp()
{
    missed();
    for (const Ticket &ticket : m_open) {
        if (m_given.size() == static_cast<std::size_t>(kWidest))
            m_given.pop_front();
        m_given.push_back(ticket);
    }
    m_open.clear();
}

/// It was not lost, only given up too early: the trips are longer than was known.
void Saturator::takeLate(TimePoint now, std::int64_t number)
{
    const auto found = std::find_if(m_given.begin(), m_given.end(), [&](const Ticket &t) { return t.number == number; });
    if (found == m_given.end())
        return;
    m_trip = std::max(m_trip, now - found->sent);
    m_given.erase(found);
}

bool Saturator::advance(TimePoint now, SimulatedVehicle &vehicle)
{
    if (!m_heard)
        return false;
    if (!m_open.empty() && now - m_open.front().sent > patience())
        giveUp();
    for (std::size_t i = 0; i < kAtOnce && m_open.size() < static_cast<std::size_t>(m_window); ++i) {
        m_open.push_back({m_next, now, 0});
        vehicle.sendBurst(now, kBurst, m_next++);
    }
    return m_open.size() < static_cast<std::size_t>(m_window);
}

} // namespace skyseal::sim
