#include "core/engine/totals.h"

namespace skyseal::engine {

channel::ReceiveCounters &operator+=(channel::ReceiveCounters &sum, const channel::ReceiveCounters &more)
{
    sum.good += more.good;
    sum.late += more.late;
    sum.lost += more.lost;
    sum.replayed += more.replayed;
    sum.forged += more.forged;
    sum.malformed += more.malformed;
    sum.plaintextDropped += more.plaintextDropped;
    sum.openedBytes += more.openedBytes;
    return sum;
}

channel::SendCounters &operator+=(channel::SendCounters &sum, const channel::SendCounters &more)
{
    sum.records += more.records;
    sum.sealedBytes += more.sealedBytes;
    return sum;
}

} // namespace skyseal::engine
