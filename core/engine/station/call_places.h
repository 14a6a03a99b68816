// The links that may lead to an agent that listens: those that send datagrams to one address, from which no MAVLink comes. A
// router or an autopilot sends MAVLink, and must not receive more than a greeting. I/O thread.
#pragma once

#include "core/engine/common/link_pool.h"

#include <set>
#include <utility>
#include <vector>

namespace skyseal::engine {

class CallPlaces
{
public:
    /// A MAVLink frame came in clear, TUNNEL included. Costs a comparison while frames come on one link.
    void noteMavlink(LinkId link)
    {
        if (link != m_newest)
            m_changed |= m_heard.insert(m_newest = link).second;
    }
    /// Whether there are fewer places since the last call.
    bool takeChanged() { return std::exchange(m_changed, false); }

    std::vector<Path> paths(LinkPool &links) const
    {
        std::vector<Path> out;
        links.forEach([&](const link::Link &link) {
            const bool calls = link.traits().isDatagramClient() && !links.isListenOnly(link.id()) && link.remote() != Address{};
            const bool greeted = link.counters().txBlocks > 0; // a second ago, so that a router could answer
            if (calls && greeted && !m_heard.contains(link.id()))
                out.push_back({link.id(), link.remote()});
        });
        return out;
    }

private:
    std::set<LinkId> m_heard;
    LinkId m_newest{};
    bool m_changed = false;
};

} // namespace skyseal::engine
