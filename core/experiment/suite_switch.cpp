#include "core/experiment/suite_switch.h"

#include <algorithm>

namespace skyseal::experiment {

void SuiteSwitch::begin(crypto::SuiteId wanted)
{
    *this = {};
    m_wanted = wanted;
}

bool SuiteSwitch::order(channel::SessionId session, double now)
{
    if (m_ordered == session)
        return false;
    m_ordered = session;
    if (m_orders++ == 0)
        m_firstOrder = now;
    return true;
}

SuiteSwitch::Outcome SuiteSwitch::finish(const channel::SwitchDone &done, bool linkUp, double now)
{
    using Failure = channel::SwitchFailure;
    if (done.rekey || done.to != m_wanted)
        return Outcome::Unrelated;
    switch (done.failure) {
    case Failure::None:
        m_milliseconds = 1000 * secondsOf(done, now);
        m_orders = 0; // a later session of this run may need an order of its own
        return Outcome::Committed;
    case Failure::NotAllowedHere:
    case Failure::NotAllowedByPeer:
        m_problem = sentence("Reason", "the other end did not take this suite");
        return Outcome::Failed;
    case Failure::SessionEnded: return Outcome::LinkLost;
    case Failure::NotConfirmed:
    case Failure::Superseded: break;
    }
    m_ordered.reset();
    if (!linkUp)
        return Outcome::LinkLost;
    if (++m_failures < kMostOrders)
        return Outcome::Retry;
    m_problem = done.failure == Failure::NotConfirmed
        ? sentence("Reason", "the switch was not confirmed in time, %1 times")(kMostOrders)
        : sentence("Reason", "another switch took the place of this one, %1 times")(kMostOrders);
    return Outcome::Failed;
}

/// The switch's own time, unless orders that failed or a session before belong to it as well.
double SuiteSwitch::secondsOf(const channel::SwitchDone &done, double now) const
{
    const bool firstOrder = m_orders <= 1 && m_ordered == done.session;
    const double sinceOrder = m_orders > 0 ? now - m_firstOrder : 0;
    return firstOrder ? seconds(done.took) : std::max(sinceOrder, seconds(done.took));
}

} // namespace skyseal::experiment
