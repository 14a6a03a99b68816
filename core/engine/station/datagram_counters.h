// Counters of a station's received datagrams.
#pragma once

#include <cstdint>

namespace skyseal::engine {

/// Datagrams that led to neither a frame nor a record that was opened.
struct DatagramCounters
{
    std::uint64_t garbage = 0;                        ///< neither records nor MAVLink
    std::uint64_t waitingBytes = 0, waitingCount = 0; ///< records while plain MAVLink is in use; see Probe
};

} // namespace skyseal::engine
