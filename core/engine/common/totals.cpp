#include "core/engine/common/totals.h"

#include "core/channel/counter_sums.h"

namespace skyseal::engine {

MavlinkTotals &operator+=(MavlinkTotals &sum, const MavlinkTotals &more)
{
    sum.frames += more.frames;
    sum.lost += more.lost;
    sum.late += more.late;
    sum.duplicate += more.duplicate;
    sum.badCrc += more.badCrc;
    sum.sendersEvicted += more.sendersEvicted;
    sum.bytes += more.bytes;
    return sum;
}

channel::ReceiveCounters &operator+=(channel::ReceiveCounters &sum, const channel::ReceiveCounters &more)
{
    channel::add(sum, more);
    return sum;
}

std::optional<channel::FrameCounters> &operator+=(std::optional<channel::FrameCounters> &sum,
                                                  const std::optional<channel::FrameCounters> &more)
{
    if (more)
        sum = channel::FrameCounters{(sum ? sum->taken : 0) + more->taken, (sum ? sum->lost : 0) + more->lost};
    return sum;
}

channel::SendCounters &operator+=(channel::SendCounters &sum, const channel::SendCounters &more)
{
    channel::add(sum, more);
    return sum;
}

} // namespace skyseal::engine
