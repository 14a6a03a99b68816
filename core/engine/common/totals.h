// Sums over a whole run for reports and scripts: they never decrease, even when sessions end and vehicles are removed. Used by
// the station and the agent.
#pragma once

#include "core/channel/policy.h"
#include "core/channel/stats.h"

#include <cstdint>
#include <optional>

namespace skyseal::engine {

/// Accepted MAVLink frames, and their loss by sequence numbers.
struct MavlinkTotals
{
    std::uint64_t frames = 0;
    std::uint64_t lost = 0;
    std::uint64_t late = 0;
    std::uint64_t duplicate = 0;
    std::uint64_t badCrc = 0;
    std::uint64_t sendersEvicted = 0; ///< by more senders than are tracked, a sign of forgery; see metrics::SequenceTable
    std::uint64_t bytes = 0;          ///< of all these frames
};

/// Cost of the suite in use, over the last second: elapsed time from the datagram to the opened frames (session look-up,
/// replay window, tag, decryption, counters) and back, control messages not counted.
///
/// The first record after the thread slept meets cold caches and costs several microseconds with any suite; at the rate of
/// telemetry, nearly every record is such a record. The later records of the same wake-up show the cost of the suite itself.
struct SuiteCost
{
    double openNsP50 = 0, openNsP99 = 0, sealNsP50 = 0, sealNsP99 = 0;
    double openNextNsP50 = 0, openNextNsP99 = 0; ///< of records after the first of a wake-up; 0 without any
    double openedRecordsPerSecond = 0, openedFramesPerSecond = 0, openedBytesPerSecond = 0;
    double cpuPercent = 0; ///< of one core, spent in seal and open
};

/// Bytes of the channel's datagrams (including handshakes and control messages, without UDP and IP headers), and of the frames
/// that they carried.
struct WireTotals
{
    std::uint64_t received = 0, receivedFrames = 0;
    std::uint64_t sent = 0, sentFrames = 0;
};

/// The sealed link, both directions. `rx` includes datagrams that belong to no session, such as garbage.
struct ChannelTotals
{
    bool up = false;         ///< a session is up
    crypto::SuiteId suite{}; ///< of that session; None without one
    std::uint32_t epoch = 0;
    channel::Framing framing{}; ///< of its sent frames
    channel::ReceiveCounters rx;
    channel::ReceiveCounters unmatched; ///< contained in rx: datagrams that belong to no session
    channel::SendCounters tx;
    channel::ReceiveCounters peerRx; ///< ours, as the other end counts them; at most a second old
    /// This end's MAVLink frames as the agents counted them; nullopt if no agent reports them.
    std::optional<channel::FrameCounters> peerFrames;
    SuiteCost cost;
    WireTotals wire;
    Duration roundTrip{}; ///< of the channel's own reports, smoothed; zero until measured
    std::size_t sessions = 0;
};

MavlinkTotals &operator+=(MavlinkTotals &sum, const MavlinkTotals &more);
channel::ReceiveCounters &operator+=(channel::ReceiveCounters &sum, const channel::ReceiveCounters &more);
std::optional<channel::FrameCounters> &operator+=(std::optional<channel::FrameCounters> &sum,
                                                  const std::optional<channel::FrameCounters> &more);
channel::SendCounters &operator+=(channel::SendCounters &sum, const channel::SendCounters &more);

} // namespace skyseal::engine
