// Sums of counters over epochs, sessions and runs.
#pragma once

#include "core/channel/stats.h"

namespace skyseal::channel {

void add(ReceiveCounters &sum, const ReceiveCounters &part);
void add(SendCounters &sum, const SendCounters &part);

} // namespace skyseal::channel
