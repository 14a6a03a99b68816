// The live switch before a run: which session is ordered to switch, how often, and how long it takes. An order that the far
// end does not confirm in time is repeated; on a full 57,600-baud line about every other one fails. Plain object: times go in,
// decisions come out.
#pragma once

#include "core/base/reason.h"
#include "core/channel/events.h"

#include <limits>
#include <optional>

namespace skyseal::experiment {

class SuiteSwitch
{
public:
    static constexpr unsigned kMostOrders = 8; ///< that may fail while the link is up

    /// Begins with a new suite and no order given.
    void begin(crypto::SuiteId wanted);
    crypto::SuiteId wanted() const { return m_wanted; }
    /// True if this session is to be ordered to switch; the order counts as given then. One order for each session, and
    /// another one after a failure. `now`: seconds of any clock that does not go back.
    bool order(channel::SessionId session, double now);

    enum class Outcome : std::uint8_t { Unrelated, Committed, Retry, LinkLost, Failed };
    /// Takes the end of a switch. `linkUp`: a session is alive; without one a failure does not count. After Retry and LinkLost
    /// order() repeats the order. After Failed, problem() says why.
    Outcome finish(const channel::SwitchDone &done, bool linkUp, double now);

    /// Milliseconds from the first order to the confirmation, failed orders included; NaN without a switch.
    double milliseconds() const { return m_milliseconds; }
    const Reason &problem() const { return m_problem; }

private:
    double secondsOf(const channel::SwitchDone &done, double now) const;

    crypto::SuiteId m_wanted{};
    std::optional<channel::SessionId> m_ordered;
    unsigned m_orders = 0, m_failures = 0;
    double m_firstOrder = 0; ///< seconds
    double m_milliseconds = std::numeric_limits<double>::quiet_NaN();
    Reason m_problem;
};

} // namespace skyseal::experiment
