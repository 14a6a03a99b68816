// State that the sessions of an endpoint share with it.
#pragma once

#include "core/base/random_source.h"
#include "core/channel/cost_source.h"
#include "core/channel/counter_store.h"
#include "core/channel/datagram_queue.h"
#include "core/channel/events.h"
#include "core/channel/freshness.h"
#include "core/channel/message_traits.h"
#include "core/channel/negotiation.h"
#include "core/channel/timing.h"

#include <deque>

namespace skyseal::channel {

/// Owned by the endpoint; outlives its sessions.
struct SessionContext
{
    RandomSource &random;
    const CounterStore &counters;
    DatagramQueue outgoing;
    std::deque<Event> events;
    SuiteOffer offer; ///< of our present policy
    Timing timing;
    FreshnessLimits freshness;
    const MessageTraits *traits = nullptr; ///< null: no inline framing
    CostSource costs = {};                 ///< empty: this end does not measure
    bool askCosts = false;                 ///< request the costs of the peers
};

} // namespace skyseal::channel
