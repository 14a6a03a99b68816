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

/// Fair, whatever is listed and removed meanwhile: addresses wait in a queue, and the agents do in one for each address. A turn
/// serves the first address: the agents that wait there longest are called, also at the next addresses in the queue. Those that
/// would call the same agents next are served as well.
class AgentCalls
{
public:
    /// Agents that are called at the same time, and addresses at which they are.
    static constexpr std::size_t kAtOnce = HandshakeAttempt::kMaxPlaces - 1;
    static constexpr Duration kTurn = std::chrono::seconds(5);
    /// Addresses that are remembered after they were removed, so that one that returns goes on with its next agents.
    static constexpr std::size_t kKept = 32;

    /// A turn ends by time alone: whoever can change the lists must not make the station call more at a time.
    TimePoint nextTurn() const { return m_next; }

    struct Turn
    {
        std::vector<PublicKey> agents;
        std::vector<Path> places;
    };
    /// Begins the next turn, among the agents and addresses that can be called at present.
    Turn take(TimePoint now, const std::vector<PublicKey> &agents, const std::vector<Path> &places);
    /// When a turn called somebody there; nullopt if that was long ago, or never.
    std::optional<TimePoint> lastCall(const Path &place) const;

private:
    struct Place
    {
        std::uint64_t waitsSince = 0; ///< the end of the turn that served it, or the begin of that in which it was listed
        bool listed = false;
        std::optional<TimePoint> called;
        std::map<PublicKey, std::uint64_t> agents; ///< the same of each agent there
    };

    void update(std::vector<PublicKey> agents, const std::vector<Path> &places);
    void forgetRemoved();
    static std::vector<PublicKey> nextAgents(const Place &place);

    TimePoint m_next = TimePoint::min();
    std::uint64_t m_begin = 0, m_end = 0; ///< of the latest turn, counted
    std::map<Path, Place> m_places;
};

} // namespace skyseal::channel
