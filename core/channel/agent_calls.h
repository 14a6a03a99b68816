// The order in which a station calls agents that listen. Such agents do not announce themselves, and which one listens at an
// address is not known before it answers: so each agent is called at each address, a few at a time. No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/handshake_attempt.h"

#include <algorithm>
#include <span>
#include <vector>

namespace skyseal::channel {

class AgentCalls
{
public:
    /// Agents that are called at the same time, and addresses at which they are.
    static constexpr std::size_t kAtOnce = HandshakeAttempt::kMaxPlaces - 1;
    static constexpr Duration kTurn = std::chrono::seconds(5);

    TimePoint nextTurn() const { return m_next; }
    /// The addresses have changed: the next turn begins at once.
    void hurry() { m_next = TimePoint::min(); }

    /// Calls `call(agent, place)` for the pairs of the next turn: each group of agents in turn at the first group of places,
    /// then at the next one.
    template<typename Call>
    void take(TimePoint now, const std::vector<PublicKey> &agents, const std::vector<Path> &places, Call &&call)
    {
        m_next = now + kTurn;
        const std::size_t turn = m_turn++;
        for (const PublicKey &agent : group(agents, turn)) {
            for (const Path &place : group(places, turn / groups(agents)))
                call(agent, place);
        }
    }

private:
    template<typename T> static std::size_t groups(const std::vector<T> &all)
    {
        return std::max<std::size_t>((all.size() + kAtOnce - 1) / kAtOnce, 1);
    }
    template<typename T> static std::span<const T> group(const std::vector<T> &all, std::size_t turn)
    {
        const std::size_t begin = turn % groups(all) * kAtOnce;
        return std::span(all).subspan(begin, std::min(kAtOnce, all.size() - begin));
    }

    TimePoint m_next = TimePoint::min();
    std::size_t m_turn = 0;
};

} // namespace skyseal::channel
