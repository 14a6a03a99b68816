// What a measurement needs beside the counters: sums that only grow, read on the I/O thread together with everything else in
// a snapshot, so that two snapshots subtracted are exactly what happened between them.
#pragma once

#include "core/base/clock.h"
#include "core/metrics/histogram.h"

#include <cstdint>

namespace skyseal::engine {

struct Probe
{
    Duration processCpu{};  ///< all threads
    Duration ioThreadCpu{}; ///< the thread that receives, opens, parses and sends
    std::uint64_t residentBytes = 0;
    metrics::Histogram open; ///< ns per record, session look-up and replay window included
    metrics::Histogram seal;
    /// Datagrams of agents that wait for a session while this end speaks plain MAVLink: no part of that.
    std::uint64_t waitingBytes = 0, waitingDatagrams = 0;
};

} // namespace skyseal::engine
