// The part of a snapshot that describes one session.
#pragma once

#include "core/channel/session_info.h"
#include "core/engine/common/totals.h"

#include <cstdint>
#include <string>

namespace skyseal::engine {

struct SessionSnapshot
{
    channel::SessionInfo info;
    channel::SessionStats stats;
    SuiteCost cost;
    MavlinkTotals mavlink;   ///< of the vehicles that are heard over it, see Fleet::sealedTotals()
    std::string fingerprint; ///< of the peer's key
    std::string remoteAddress;
    double age = 0; ///< seconds since the session came up
    std::uint64_t forgedLastMinute = 0, replayedLastMinute = 0, goodLastMinute = 0;
    double lossPercent = 0;     ///< from the peer, over the last second
    double peerLossPercent = 0; ///< to the peer, over the last second
};

/// Whether the records that were refused within the last minute indicate an attacker. A wrong tag does: transmission errors are
/// caught by lower checksums. A repeated record alone does not: networks duplicate datagrams, and a copy looks the same in both
/// cases. But a network does not make more copies than there were records, so more copies are replays. Slower replays are
/// refused and counted as well.
inline bool isAttacked(const SessionSnapshot &session)
{
    return session.forgedLastMinute > 0 || session.replayedLastMinute > session.goodLastMinute;
}

} // namespace skyseal::engine
