// The measurements of a station at one moment, for the charts and their CSV file.
#pragma once

#include "core/crypto/suite.h"
#include "core/vehicle/vehicle_state.h"

#include <cstdint>

namespace skyseal::engine {

/// One point of the diagnostics' time lines, four a second.
struct MetricsSample
{
    std::uint64_t number = 0; ///< increases by one per sample
    double time = 0;          ///< seconds since the station started
    crypto::SuiteId suite{};  ///< None = plain
    std::uint32_t epoch = 0;
    bool linkUp = false;
    double openedFramesPerSecond = 0;
    double openedBytesPerSecond = 0;
    double lossPercent = 0;     ///< channel, from the peer; MAVLink's where plain
    double peerLossPercent = 0; ///< channel, to the peer
    double mavlinkLossPercent = 0;
    double peerMavlinkLossPercent = vehicle::kUnknown; ///< to the vehicle, reported by its agent once a second
    double processCpuPercent = 0;                      ///< of one core, all threads; over the last second
    double ioCpuPercent = 0;                           ///< of the thread that receives, opens, parses and sends
    double watchingCpuPercent = 0;                     ///< of ioCpuPercent: time lines, snapshots and probes
    double suiteCpuPercent = 0;                        ///< of one core, in seal and open
    double openNsP50 = 0, openNsP99 = 0;               ///< see SuiteCost
    double openNextNsP50 = 0, openNextNsP99 = 0;
    double sealNsP50 = 0, sealNsP99 = 0;
    double latency = vehicle::kUnknown;           ///< round-trip time by TIMESYNC in seconds, of the vehicle heard last
    double roundTrip = vehicle::kUnknown;         ///< seconds, of the channel's own reports
    double rxOverheadPercent = vehicle::kUnknown; ///< datagram bytes beyond the frames in them, over the last second
    double txOverheadPercent = vehicle::kUnknown;
    double rxBytesPerSecond = 0, txBytesPerSecond = 0; ///< all links, datagrams as they are
    std::uint64_t residentBytes = 0;
    double sessionBytes = vehicle::kUnknown; ///< heap of a session under this suite; filled in by the reader
    double powerWatts = vehicle::kUnknown;   ///< of the whole processor, by the kernel's counters; over the last second
    /// Signs of an attack so far: forged records, refused clear frames, and replays while they outnumber good records.
    std::uint64_t refused = 0;
};

} // namespace skyseal::engine
