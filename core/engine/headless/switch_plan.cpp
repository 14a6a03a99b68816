#include "core/engine/headless/switch_plan.h"

#include <algorithm>

namespace skyseal::engine {

void SwitchPlan::sessionUp(TimePoint now, channel::SessionId session)
{
    Walk walk;
    walk.due = now + m_every;
    m_walks[session] = walk;
}

void SwitchPlan::switchDone(const channel::SwitchDone &done)
{
    if (std::find(m_suites.begin(), m_suites.end(), done.to) == m_suites.end())
        return; // requested elsewhere: by the peer, or over the control socket
    const auto walk = m_walks.find(done.session);
    // A session also rekeys by itself, and a requested switch to the suite in use is reported as a rekey too.
    if (done.rekey && (walk == m_walks.end() || walk->second.pending != done.to))
        return;
    (done.failure == channel::SwitchFailure::None ? m_committed : m_failed).insert(done.to);
    if (walk != m_walks.end())
        walk->second.pending.reset();
}

std::vector<SwitchPlan::Order> SwitchPlan::poll(TimePoint now)
{
    std::vector<Order> out;
    if (m_suites.empty())
        return out;
    for (auto &[session, walk] : m_walks) {
        if (walk.pending || now < walk.due)
            continue;
        const crypto::SuiteId suite = m_suites[walk.next++ % m_suites.size()];
        out.push_back({session, suite});
        walk.due += m_every;
        if (walk.due <= now)
            walk.due = now + m_every; // a late switch does not shorten the next period
        walk.pending = suite;
    }
    return out;
}

bool SwitchPlan::isPending() const
{
    return std::any_of(m_walks.begin(), m_walks.end(), [](const auto &walk) { return walk.second.pending.has_value(); });
}

std::vector<crypto::SuiteId> SwitchPlan::notReached() const
{
    std::vector<crypto::SuiteId> out;
    std::set_difference(m_failed.begin(), m_failed.end(), m_committed.begin(), m_committed.end(), std::back_inserter(out));
    return out;
}

} // namespace skyseal::engine
