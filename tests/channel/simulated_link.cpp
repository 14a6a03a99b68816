#include "simulated_link.h"

#include <utility>

namespace skyseal::test {

SimulatedLink::SimulatedLink(WireModel linkModel, std::uint64_t seed) : model(linkModel), m_random(seed) {}

SimulatedLink::~SimulatedLink() = default;

void SimulatedLink::inject(TimePoint at, SentDatagram flight)
{
    m_flying.emplace(at, std::move(flight));
}

void SimulatedLink::cut()
{
    m_flying.clear();
}

bool SimulatedLink::inBurst(Side from)
{
    return m_inBurst[from] = model.burst > 0 && chance(m_inBurst[from] ? 1 - model.burstEnd : model.burst);
}

bool SimulatedLink::chance(double p)
{
    return p > 0 && std::uniform_real_distribution<>(0, 1)(m_random) < p;
}

bool SimulatedLink::send(TimePoint now, SentDatagram flight)
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
        SentDatagram copy = flight;
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

Duration SimulatedLink::delay()
{
    Duration d = model.delay;
    if (model.jitter > Duration::zero())
        d += Duration(std::uniform_int_distribution<Duration::rep>(0, 2 * model.jitter.count())(m_random));
    return chance(model.reorder) ? d + model.reorderBy : d;
}

SentDatagram SimulatedLink::take()
{
    SentDatagram flight = std::move(m_flying.begin()->second);
    m_flying.erase(m_flying.begin());
    return flight;
}

} // namespace skyseal::test
