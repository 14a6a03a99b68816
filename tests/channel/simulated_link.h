// A link between two ends on a virtual clock: seeded delay, jitter, loss, duplication, reordering, corruption, and a
// hook for an attacker.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"

#include <array>
#include <functional>
#include <map>
#include <random>

namespace skyseal::test {

struct LinkModel
{
    double loss = 0;
    double duplicate = 0;
    double corrupt = 0;
    double reorder = 0; ///< share that takes `reorderBy` longer
    Duration delay = std::chrono::milliseconds(1);
    Duration jitter{}; ///< delay is uniform in [delay, delay + 2 jitter]
    Duration reorderBy = std::chrono::milliseconds(20);
    double burst =
        0; ///< chance of each datagram to begin a burst, in which all are lost (Gilbert's model, each way for itself)
    double burstEnd = .1; ///< chance of each to end it
};

enum Side { Ground = 0, Air = 1 };

/// One datagram under way.
struct Flight
{
    Side from = Ground;
    std::uint16_t sourcePort = 0;
    std::uint64_t tag = 0; ///< number of the frame inside, for the harness; 0 = none
    Bytes bytes;
};

class SimulatedLink
{
public:
    SimulatedLink(LinkModel linkModel, std::uint64_t seed) : model(linkModel), m_random(seed) {}

    /// Called for each datagram before random loss; may change it; returns false to drop it.
    std::function<bool(TimePoint, Flight &)> attacker;
    LinkModel model;

    /// Sends; returns whether at least one intact copy will arrive.
    bool send(TimePoint now, Flight flight);
    /// Puts a datagram on the wire, unaffected by the attacker and by random loss.
    void inject(TimePoint at, Flight flight) { m_flying.emplace(at, std::move(flight)); }

    TimePoint next() const { return m_flying.empty() ? kNever : m_flying.begin()->first; }
    Flight take();
    void cut() { m_flying.clear(); }

private:
    bool inBurst(Side from)
    {
        return m_inBurst[from] = model.burst > 0 && chance(m_inBurst[from] ? 1 - model.burstEnd : model.burst);
    }
    bool chance(double p) { return p > 0 && std::uniform_real_distribution<>(0, 1)(m_random) < p; }
    Duration delay();

    std::mt19937_64 m_random;
    std::array<bool, 2> m_inBurst{};
    std::multimap<TimePoint, Flight> m_flying;
};

inline bool SimulatedLink::send(TimePoint now, Flight flight)
{
    if (attacker && !attacker(now, flight))
        return false;
    if (inBurst(flight.from))
        return false;
    bool intact = false;
    const int copies = chance(model.duplicate) ? 2 : 1;
    for (int i = 0; i < copies; ++i) {
        if (chance(model.loss))
            continue;
        Flight copy = flight;
        if (chance(model.corrupt) && !copy.bytes.empty()) {
            const std::size_t bit = std::uniform_int_distribution<std::size_t>(0, copy.bytes.size() * 8 - 1)(m_random);
            copy.bytes[bit / 8] = static_cast<std::uint8_t>(copy.bytes[bit / 8] ^ 1u << bit % 8);
        } else {
            intact = true;
        }
        m_flying.emplace(now + delay(), std::move(copy));
    }
    return intact;
}

inline Duration SimulatedLink::delay()
{
    Duration d = model.delay;
    if (model.jitter > Duration::zero())
        d += Duration(std::uniform_int_distribution<Duration::rep>(0, 2 * model.jitter.count())(m_random));
    return chance(model.reorder) ? d + model.reorderBy : d;
}

inline Flight SimulatedLink::take()
{
    Flight flight = std::move(m_flying.begin()->second);
    m_flying.erase(m_flying.begin());
    return flight;
}

} // namespace skyseal::test
