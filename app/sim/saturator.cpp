#include "app/sim/saturator.h"

#include "core/mavlink/messages.h"

#include <algorithm>

namespace skyseal::app {

namespace {
// Several round trips, so that a slow link is not asked to carry more because it is slow.
constexpr Duration kLeastPatience = std::chrono::milliseconds(100);
constexpr Duration kMostPatience = std::chrono::seconds(3);
constexpr unsigned kLostAfter = 3; // as in TCP (RFC 5681)
}

Duration Saturator::patience() const
{
    return std::clamp(m_trip * 4, kLeastPatience, kMostPatience);
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
    const auto found = std::find_if(m_open.begin(), m_open.end(), [&](const Ticket &t) { return t.number == answer.ts1; });
    if (answer.tc1 == 0 || found == m_open.end())
        return;
    m_trip = (m_trip * 7 + (now - found->sent)) / 8;
    m_window = std::min(kWidest, m_window + 1 / m_window);
    std::for_each(m_open.begin(), found, [](Ticket &earlier) { ++earlier.overtaken; });
    m_open.erase(found);
    if (std::erase_if(m_open, [](const Ticket &ticket) { return ticket.overtaken >= kLostAfter; }) > 0)
        missed();
}

bool Saturator::advance(TimePoint now, sim::SimulatedVehicle &vehicle)
{
    if (!m_heard)
        return false;
    if (!m_open.empty() && now - m_open.front().sent > patience()) {
        missed();
        m_trip = std::max(m_trip * 2, kLeastPatience / 4); // the next ones are waited for longer
        m_open.clear();
    }
    for (std::size_t i = 0; i < kAtOnce && m_open.size() < static_cast<std::size_t>(m_window); ++i) {
        m_open.push_back({m_next, now, 0});
        vehicle.sendBurst(now, kBurst, m_next++);
    }
    return m_open.size() < static_cast<std::size_t>(m_window);
}

} // namespace skyseal::app
