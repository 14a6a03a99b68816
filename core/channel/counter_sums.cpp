#include "core/channel/counter_sums.h"

namespace skyseal::channel {

void add(ReceiveCounters &sum, const ReceiveCounters &part)
{
    sum.good += part.good;
    sum.late += part.late;
    sum.lost += part.lost;
    sum.replayed += part.replayed;
    sum.forged += part.forged;
    sum.malformed += part.malformed;
    sum.plaintextDropped += part.plaintextDropped;
    sum.openedBytes += part.openedBytes;
    sum.stale += part.stale;
}

void add(SendCounters &sum, const SendCounters &part)
{
    sum.records += part.records;
    sum.sealedBytes += part.sealedBytes;
}

} // namespace skyseal::channel
