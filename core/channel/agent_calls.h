// The order in which a station calls agents that listen. Such agents do not announce themselves, and which one listens at an
// address is not known before it answers: so each agent is called at each address, a few at a time. No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/handshake_attempt.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace skyseal::channel {

/// Fair, even if agents and addresses are added and removed: addresses wait in a queue, and each address has a queue of agents.
/// A turn serves the first address: the agents that have waited there longest are called, also at the next addresses in the
/// queue. Addresses that would call the same agents next are served as well.
class AgentCalls
{
public:
    /// Agents that are called at the same time, and addresses at which they are.
    static constexpr std::size_t kAtOnce = HandshakeAttempt::kMaxPlaces - 1;
    static constexpr Duration kTurn = std::chrono::seconds(5);
    /// Addresses that are remembered after they were removed, so that one that returns goes on with its next agents.
    static constexpr std::size_t kKept = 32;

    /// A turn ends by time alone, so that a change of the lists cannot make the station call more agents at a time.
    TimePoint nextTurn() const { return m_next; }

    struct Turn
    {
        std::vector<PublicKey> agents;
        std::vector<Path> places;
    };
    /// Begins the next turn, among the agents and addresses that can be called at present.
    Turn take(TimePoint now, const std::vector<PublicKey> &agents, const std::vector<Path> &places);
    /// Time at which a turn last called an agent there; nullopt if that was long ago, or never.
    std::optional<TimePoint> lastCall(const Path &place) const;

private:
    struct Place
    {
        std::uint64_t waitsSince = 0; ///< number of the end of its last turn, or of the begin of the turn in which it was added
        bool listed = false;
        std::optional<TimePoint> called;
        std::map<PublicKey, std::uint64_t> agents; ///< the same number of each agent at this address
    };

    void update(std::vector<PublicKey> agents, const std::vector<Path> &places);
    void forgetRemoved();
    static std::vector<PublicKey> nextAgents(const Place &place);

    TimePoint m_next = TimePoint::min();
    std::uint64_t m_begin = 0, m_end = 0; ///< of the latest turn; turns are numbered
    std::map<Path, Place> m_places;
};

} // namespace skyseal::channel
