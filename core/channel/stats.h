// Counters of a session, per direction and epoch, for the owner and for the reports to the peer.
#pragma once

#include "core/base/clock.h"
#include "core/channel/freshness.h"
#include "core/crypto/suite.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::channel {

/// Number of an epoch of one session, from 0. Records carry its two low bits.
enum class Epoch : std::uint32_t {};

/// The records of one direction, counted by the receiver. `lost` follows from gaps in the record counters; a record that
/// arrives late moves from `lost` to `late`.
struct ReceiveCounters
{
    std::uint64_t good = 0;
    std::uint64_t late = 0; ///< good, but received after a newer one; included in good
    std::uint64_t lost = 0;
    std::uint64_t replayed = 0; ///< received before, or older than the replay window
    std::uint64_t forged = 0;   ///< tag did not verify
    std::uint64_t malformed = 0;
    std::uint64_t plaintextDropped = 0; ///< clear MAVLink frames of a peer that must be sealed
    std::uint64_t openedBytes = 0;      ///< plaintext bytes delivered
    std::uint64_t stale = 0;            ///< good, with frames that may not command any more: see Freshness
};

/// Records of one direction, counted by the sender.
struct SendCounters
{
    std::uint64_t records = 0;
    std::uint64_t sealedBytes = 0; ///< record bytes on the wire
};

/// MAVLink frames from the peer, counted by the session's owner from their sequence numbers; the channel only transports the
/// counts. `lost` includes frames that were lost before they were sealed.
struct FrameCounters
{
    std::uint64_t taken = 0; ///< without duplicates
    std::uint64_t lost = 0;
};

/// Cost of a session for the reporting end: cumulative, except for the memory. Measured by the session's owner; the channel
/// only transports it, to a peer that requests it.
struct EndCosts
{
    std::uint64_t cpuMicroseconds = 0; ///< CPU time of the whole process, all threads
    std::uint64_t residentBytes = 0;   ///< of the process
    std::uint64_t opened = 0;          ///< records with frames, or inline frames, of this session
    std::uint64_t openNanoseconds = 0; ///< spent on them
    std::uint64_t sealed = 0;
    std::uint64_t sealNanoseconds = 0;
};

/// Counters of one epoch. Readers add up the epochs of one suite where they need that.
struct EpochStats
{
    Epoch epoch{};
    crypto::SuiteId suite{};
    ReceiveCounters rx;
    SendCounters tx;
};

/// Both directions as known here: `rx` counted by this end, `peerRx` counted by the peer and taken from its latest report
/// (usually at most a second old).
struct SessionStats
{
    ReceiveCounters rx;
    SendCounters tx;
    ReceiveCounters peerRx;
    SendCounters peerTx;
    bool peerReported = false;
    std::optional<FrameCounters> peerFrames;      ///< our frames as counted by the peer, if it counts them
    std::optional<EndCosts> peerCosts;            ///< only if requested, and if the peer measures them
    std::optional<FreshnessReport> freshness;     ///< delay of the peer's records; at an agent only
    std::optional<FreshnessReport> peerFreshness; ///< delay of our records; from an agent only
    bool peerCannotStore = false;                 ///< an agent that cannot store the counters of handshakes
    std::uint32_t peerStamp = 0;                  ///< microseconds of the peer's clock at that report, modulo 2^32
    std::vector<EpochStats> epochs;               ///< newest last, the latest 16 at most
    Duration roundTrip{};                         ///< smoothed, zero until measured
};

} // namespace skyseal::channel
