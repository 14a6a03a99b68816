// Counters of a station's received datagrams and frames.
#pragma once

#include <cstdint>

namespace skyseal::engine {

/// Those that led to neither a frame that was accepted nor a record that was opened.
struct DatagramCounters
{
    std::uint64_t garbage = 0;                        ///< neither records nor MAVLink
    std::uint64_t waitingBytes = 0, waitingCount = 0; ///< records while plain MAVLink is in use; see Probe
    std::uint64_t unreadable = 0;                     ///< frames that the cipher of a measurement did not decrypt, see BareSink
};

} // namespace skyseal::engine
