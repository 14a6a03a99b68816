// Cycles through a list of suites on every session: one switch per period, and none while another is pending.
#pragma once

#include "core/base/clock.h"
#include "core/channel/events.h"
#include "core/crypto/suite.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace skyseal::engine {

class SwitchPlan
{
public:
    SwitchPlan(std::vector<crypto::SuiteId> suites, Duration every) : m_suites(std::move(suites)), m_every(every) {}

    void sessionUp(TimePoint now, channel::SessionId session);
    void sessionDown(channel::SessionId session) { m_walks.erase(session); }
    void switchDone(const channel::SwitchDone &done);

    struct Order
    {
        channel::SessionId session{};
        crypto::SuiteId suite{};
    };
    /// Returns the switches that are due.
    std::vector<Order> poll(TimePoint now);

    /// Whether a switch was requested whose result is not known yet.
    bool isPending() const;
    /// Suites that were tried and never used.
    std::vector<crypto::SuiteId> notReached() const;

private:
    struct Walk
    {
        std::size_t next = 0;
        TimePoint due{};
        std::optional<crypto::SuiteId> pending; ///< requested, and not done yet
    };

    std::vector<crypto::SuiteId> m_suites;
    Duration m_every;
    std::map<channel::SessionId, Walk> m_walks;
    std::set<crypto::SuiteId> m_committed, m_failed;
};

} // namespace skyseal::engine
