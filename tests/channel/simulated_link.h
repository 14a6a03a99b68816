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

struct WireModel
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
struct SentDatagram
{
    Side from = Ground;
    std::uint16_t sourcePort = 0;
    std::uint64_t tag = 0; ///< number of the frame inside, for the harness; 0 = none
    Bytes bytes;
    std::uint16_t targetPort = 0; ///< to which it was sent; 0: by an address without a port
};

class SimulatedLink
{
public:
    SimulatedLink(WireModel linkModel, std::uint64_t seed);
    ~SimulatedLink();

    /// Called for each datagram before random loss; may change it; returns false to drop it.
    std::function<bool(TimePoint, SentDatagram &)> attacker;
    WireModel model;

    /// Sends; returns whether at least one intact copy will arrive.
    bool send(TimePoint now, SentDatagram flight);
    /// Puts a datagram on the wire, unaffected by the attacker and by random loss.
    void inject(TimePoint at, SentDatagram flight);

    TimePoint next() const { return m_flying.empty() ? kNever : m_flying.begin()->first; }
    SentDatagram take();
    void cut();

private:
    bool inBurst(Side from);
    bool chance(double p);
    Duration delay();

    std::mt19937_64 m_random;
    std::array<bool, 2> m_inBurst{};
    std::multimap<TimePoint, SentDatagram> m_flying;
};

} // namespace skyseal::test
