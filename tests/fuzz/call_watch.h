// Where a station calls agents that listen, seen from outside: at udpout links, few agents and addresses at a time, and hardly
// where MAVLink comes from. Addresses from which an agent has answered are left out: what goes there belongs to a session.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/mac1.h"
#include "tests/fuzz/oracle.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace skyseal::test {

class CallWatch
{
public:
    /// An agent that the station has listed.
    void addAgent(const channel::PublicKey &key) { m_macs.emplace_back(key); }
    /// A clear frame came from the address of the link; `now` is when the station received it.
    void mavlinkCame(TimePoint now, LinkId link)
    {
        auto &there = m_mavlinkAt[link];
        if (!there.latest || now - *there.latest > kForgotten + kTolerance)
            there = {};
        there.latest = now;
    }
    void agentAnswered(LinkId link) { m_agentsAt.insert(link); }

    /// A first message of the station.
    void sent(TimePoint now, LinkId link, ByteView message)
    {
        if (m_agentsAt.contains(link))
            return;
        if (const auto there = m_mavlinkAt.find(link); there != m_mavlinkAt.end())
            judgeRouter(now, there->second);
        const auto called = std::ranges::find_if(m_macs, [&](const channel::Mac1 &mac) { return mac.verify(message); });
        if (called == m_macs.end())
            return;
        m_calls.push_back({now, called - m_macs.begin(), link});
        while (m_calls.front().time < now - kNearlyATurn)
            m_calls.pop_front();
        std::set<std::ptrdiff_t> agents;
        std::set<LinkId> links;
        for (const Call &call : m_calls) {
            agents.insert(call.agent);
            links.insert(call.link);
        }
        // One turn may end and the next one begin within this time, whatever has changed.
        if (agents.size() > 2 * kAtOnce || links.size() > 2 * kAtOnce)
            violated("few are called at a time");
    }

private:
    struct Router
    {
        std::optional<TimePoint> latest; ///< frame
        std::optional<TimePoint> called; ///< the first message of the newest second of calls
    };

    void judgeRouter(TimePoint now, Router &there)
    {
        if (now - *there.latest > kForgotten - kTolerance || (there.called && now - *there.called <= kNoticed))
            return;
        // The station counts from its last call, which may have been before the first frame.
        if (there.called && now - *there.called < kSparingly - kNoticed)
            violated("hardly anybody is called where MAVLink comes from");
        there.called = now;
    }

    static constexpr Duration kForgotten = std::chrono::seconds(10), kSparingly = std::chrono::seconds(30),
                              kTolerance = std::chrono::milliseconds(100);
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
    std::set<LinkId> m_agentsAt;
    std::map<LinkId, Router> m_mavlinkAt;
};

} // namespace skyseal::test
