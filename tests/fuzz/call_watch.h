// Where a station calls agents that listen, seen from outside: at udpout links, few agents and addresses at a time, and not
// where MAVLink comes from. Addresses from which an agent has answered are left out: what goes there belongs to a session.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/mac1.h"
#include "tests/fuzz/oracle.h"

#include <algorithm>
#include <deque>
#include <set>
#include <vector>

namespace skyseal::test {

class CallWatch
{
public:
    /// An agent that the station has listed.
    void addAgent(const channel::PublicKey &key) { m_macs.emplace_back(key); }
    /// What may be called has changed, so that a turn may have ended early.
    void changed(TimePoint now) { m_countFrom = now + kNoticed; }
    bool isMavlinkAt(LinkId link) const { return m_mavlinkAt.contains(link); }
    void mavlinkCame(LinkId link) { m_mavlinkAt.insert(link); }
    void agentAnswered(LinkId link) { m_agentsAt.insert(link); }

    /// A first message of the station.
    void sent(TimePoint now, LinkId link, ByteView message)
    {
        if (m_agentsAt.contains(link))
            return;
        if (isMavlinkAt(link))
            violated("nobody is called where MAVLink comes from");
        const auto called = std::ranges::find_if(m_macs, [&](const channel::Mac1 &mac) { return mac.verify(message); });
        if (called == m_macs.end() || now < m_countFrom)
            return;
        m_calls.push_back({now, called - m_macs.begin(), link});
        while (m_calls.front().time < std::max(m_countFrom, now - kNearlyATurn))
            m_calls.pop_front();
        std::set<std::ptrdiff_t> agents;
        std::set<LinkId> links;
        for (const Call &call : m_calls) {
            agents.insert(call.agent);
            links.insert(call.link);
        }
        // One turn may end and the next one begin within this time.
        if (agents.size() > 2 * kAtOnce || links.size() > 2 * kAtOnce)
            violated("few are called at a time");
    }

private:
    static constexpr std::size_t kAtOnce = 4; ///< agents, and addresses
    static constexpr Duration kNearlyATurn = std::chrono::milliseconds(4900);
    static constexpr Duration kNoticed = std::chrono::milliseconds(1100); ///< the station looks once a second

    struct Call
    {
        TimePoint time;
        std::ptrdiff_t agent = 0; ///< in m_macs
        LinkId link{};
    };

    std::vector<channel::Mac1> m_macs;
    std::deque<Call> m_calls;
    TimePoint m_countFrom{};
    std::set<LinkId> m_agentsAt, m_mavlinkAt;
};

} // namespace skyseal::test
