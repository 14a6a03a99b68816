// Additional sums for measurements, read on request. They only grow and are read on the I/O thread together with the rest of a
// snapshot, so that the difference of two snapshots is exactly the traffic between them. The CPU times are read first, so that
// the cost of a probe belongs to the time after it.
#pragma once

#include "core/base/clock.h"
#include "core/metrics/histogram.h"

#include <cstdint>
#include <map>

namespace skyseal::engine {

struct Probe
{
    Duration processCpu{};         ///< all threads
    Duration ioThreadCpu{};        ///< the thread that receives, opens, parses and sends
    Duration watchingCpu{};        ///< of ioThreadCpu: time lines, snapshots and probes, made and handed out
    std::uint64_t wakeUps = 0;     ///< of the I/O thread: voluntary context switches
    std::uint64_t preemptions = 0; ///< of the I/O thread: involuntary context switches
    std::uint64_t residentBytes = 0;
    metrics::Histogram open; ///< ns per record, session look-up and replay window included
    metrics::Histogram seal;
    /// Datagrams of agents that wait for a session while this end uses plain MAVLink; not part of the plain traffic.
    std::uint64_t waitingBytes = 0, waitingDatagrams = 0;
    std::map<std::uint32_t, std::uint64_t> messages; ///< accepted frames by message id, see MessageCounts
};

} // namespace skyseal::engine
