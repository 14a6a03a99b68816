// Sums over a whole run, as reports and scripts want them: they never go back, whatever sessions and vehicles came and
// went. The station and the agent both keep them.
#pragma once

#include "core/channel/policy.h"
#include "core/channel/stats.h"

#include <cstdint>
#include <optional>

namespace skyseal::engine {

/// MAVLink frames that were taken in, and what their sequence numbers tell.
struct MavlinkTotals
{
    std::uint64_t frames = 0;
    std::uint64_t lost = 0;
    std::uint64_t late = 0;
    std::uint64_t duplicate = 0;
    std::uint64_t badCrc = 0;
    std::uint64_t sendersEvicted = 0; ///< more senders than anybody has: made up; see metrics::SequenceTable
    std::uint64_t bytes = 0;          ///< of all these frames
};

/// Cost of the suite in use, over the last second: elapsed time from the datagram to the opened frames (session look-up,
/// replay window, tag, decryption, counters) and back, control messages not counted.
///
/// The first record after the thread slept finds cold caches and costs several microseconds whatever the suite; at the pace
/// of telemetry that is nearly every record. Those that come in the same wake-up behind it show what the suite itself costs.
struct SuiteCost
{
    double openNsP50 = 0, openNsP99 = 0, sealNsP50 = 0, sealNsP99 = 0;
    double openNextNsP50 = 0, openNextNsP99 = 0; ///< of records behind the first of a wake-up; 0 when there were none
    double openedRecordsPerSecond = 0, openedFramesPerSecond = 0, openedBytesPerSecond = 0;
    double cpuPercent = 0; ///< of one core, spent in seal and open
};

/// Bytes of the channel's datagrams (handshakes and control messages included, UDP and IP headers not) beside those of the
/// frames that they carried.
struct WireTotals
{
    std::uint64_t received = 0, receivedFrames = 0;
    std::uint64_t sent = 0, sentFrames = 0;
};

/// The sealed link, both directions. `rx` contains what belongs to no session, such as garbage and unknown connections.
struct ChannelTotals
{
    bool up = false;         ///< a session is up now
    crypto::SuiteId suite{}; ///< of that session; None without one
    std::uint32_t epoch = 0;
    channel::Framing framing{}; ///< how its frames are sent now
    channel::ReceiveCounters rx;
    channel::ReceiveCounters unmatched; ///< contained in rx: what belongs to no session
    channel::SendCounters tx;
    channel::ReceiveCounters peerRx; ///< ours, as the other end counts them; at most a second old
    /// MAVLink frames that the agents took of ours; nothing where none tells.
    std::optional<channel::FrameCounters> peerFrames;
    SuiteCost cost;
    WireTotals wire;
    Duration roundTrip{}; ///< of the channel's own reports, smoothed; zero until measured
    std::size_t sessions = 0;
};

channel::ReceiveCounters &operator+=(channel::ReceiveCounters &sum, const channel::ReceiveCounters &more);
std::optional<channel::FrameCounters> &operator+=(std::optional<channel::FrameCounters> &sum,
                                                  const std::optional<channel::FrameCounters> &more);
channel::SendCounters &operator+=(channel::SendCounters &sum, const channel::SendCounters &more);

} // namespace skyseal::engine
