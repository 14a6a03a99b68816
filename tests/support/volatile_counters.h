// Counters of the channel that are lost with the program.
#pragma once

#include "core/channel/counter_store.h"

#include <map>
#include <optional>

namespace skyseal::test {

class VolatileCounters final : public channel::CounterStore
{
public:
    std::optional<std::uint64_t> next() override { return ++m_own; }
    std::uint64_t lastSeen(const channel::PublicKey &peer) override { return m_seen[peer]; }
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override
    {
        m_seen[peer] = counter;
        return true;
    }

private:
    std::uint64_t m_own = 0;
    std::map<channel::PublicKey, std::uint64_t> m_seen;
};

} // namespace skyseal::test
