#include "core/engine/totals.h"

#include "core/channel/counter_sums.h"

namespace skyseal::engine {

channel::ReceiveCounters &operator+=(channel::ReceiveCounters &sum, const channel::ReceiveCounters &more)
{
    channel::add(sum, more);
    return sum;
}

channel::SendCounters &operator+=(channel::SendCounters &sum, const channel::SendCounters &more)
{
    channel::add(sum, more);
    return sum;
}

} // namespace skyseal::engine
