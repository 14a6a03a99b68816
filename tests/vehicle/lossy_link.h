// A Vehicle and a scripted peer with a bad radio between them, on a simulated clock: each direction delays and drops, from a
// seed that a failing test prints.
#pragma once

#include "vehicle_harness.h"

#include <algorithm>
#include <functional>
#include <random>

namespace skyseal::vehicle {

/// A message on its way to the station, packed only when it arrives.
using ToStation = std::function<void(Harness &)>;

/// The vehicle at the other end of the radio link.
class ScriptedPeer
{
public:
    virtual ~ScriptedPeer() = default;
    /// Answers are appended to `out`.
    virtual void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) = 0;
    /// Repeats what was not answered; called at nextDeadline().
    virtual void handleDeadline(TimePoint, std::vector<ToStation> &) {}
    virtual TimePoint nextDeadline() const { return kNever; }

protected:
    template<typename Message> static ToStation send(const Message &message)
    {
        return [message](Harness &harness) { harness.feed(message); };
    }
};

class LossyLink
{
public:
    enum class Direction : std::uint8_t { Both, Up, Down };

    LossyLink(Harness &harness, ScriptedPeer &peer, double loss, unsigned seed, Duration delay = std::chrono::milliseconds(20))
        : m_harness(harness), m_peer(peer), m_random(seed), m_lost(loss), m_delay(delay)
    {}

    /// Runs until `done` or the end of the time; false when it ran out.
    bool run(Duration limit, const std::function<bool()> &done)
    {
        const TimePoint end = m_harness.now + limit;
        for (;;) {
            for (const OutMessage &message : m_harness.sent())
                carry(Direction::Up,
                      [this, message](std::vector<ToStation> &out) { m_peer.handle(m_harness.now, message, out); });
            if (done())
                return true;
            const TimePoint next = std::min(
                {m_harness.vehicle.nextDeadline(), m_peer.nextDeadline(), m_events.empty() ? kNever : m_events.begin()->first});
            if (next > end)
                return false;
            m_harness.now = std::max(m_harness.now, next);
            std::vector<ToStation> out;
            if (m_harness.vehicle.nextDeadline() <= m_harness.now)
                m_harness.vehicle.handleDeadline(m_harness.now);
            else if (m_peer.nextDeadline() <= m_harness.now)
                m_peer.handleDeadline(m_harness.now, out);
            else {
                auto event = m_events.extract(m_events.begin());
                event.mapped()(out);
            }
            for (const ToStation &message : out)
                carry(Direction::Down, [this, message](std::vector<ToStation> &) { message(m_harness); });
        }
    }

    /// Nothing that is sent in this direction from `begin` to `end` arrives.
    void addOutage(TimePoint begin, TimePoint end, Direction direction = Direction::Both)
    {
        m_outages.push_back({begin, end, direction});
    }

    /// Loses the frames that were sent and have not arrived yet.
    void loseAllUnderWay() { m_events.clear(); }

    int dropped() const { return m_dropped; }
    int carried() const { return m_carried; }

private:
    struct Outage
    {
        TimePoint begin, end;
        Direction direction;
    };

    bool isDown(Direction direction) const
    {
        return std::ranges::any_of(m_outages, [&](const Outage &outage) {
            return m_harness.now >= outage.begin && m_harness.now < outage.end
                && (outage.direction == Direction::Both || outage.direction == direction);
        });
    }

    void carry(Direction direction, std::function<void(std::vector<ToStation> &)> arrival)
    {
        if (isDown(direction) || m_lost(m_random)) {
            ++m_dropped;
            return;
        }
        ++m_carried;
        m_events.emplace(m_harness.now + m_delay, std::move(arrival));
    }

    Harness &m_harness;
    ScriptedPeer &m_peer;
    std::mt19937 m_random;
    std::bernoulli_distribution m_lost;
    const Duration m_delay;
    std::multimap<TimePoint, std::function<void(std::vector<ToStation> &)>> m_events;
    std::vector<Outage> m_outages;
    int m_dropped = 0;
    int m_carried = 0;
};

} // namespace skyseal::vehicle
