// What a session counts, per direction and epoch, and how it is shown to people and to the other end.
#pragma once

#include "core/base/clock.h"
#include "core/crypto/suite.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::channel {

/// Number of an epoch of one session; the first one is 0. Only its two low bits travel.
enum class Epoch : std::uint32_t {};

/// What became of the records of one direction, as its receiver saw it. `lost` is what the counters say is missing: records
/// that arrive after all move from `lost` to `late`.
struct ReceiveCounters
{
    std::uint64_t good = 0;
    std::uint64_t late = 0; ///< good, but after a newer one; included in good
    std::uint64_t lost = 0;
    std::uint64_t replayed = 0; ///< seen before, or older than the window
    std::uint64_t forged = 0;   ///< tag did not verify
    std::uint64_t malformed = 0;
    std::uint64_t plaintextDropped = 0; ///< clear MAVLink of a peer that must be sealed
    std::uint64_t openedBytes = 0;      ///< plaintext bytes delivered
};

/// What one end sent in one direction.
struct SendCounters
{
    std::uint64_t records = 0;
    std::uint64_t sealedBytes = 0; ///< record bytes on the wire
};

/// MAVLink frames from the peer, as the owner of a session counted them by their sequence numbers: the channel only carries
/// this. Lost are also those that were lost before they were sealed.
struct FrameCounters
{
    std::uint64_t taken = 0; ///< second copies left out
    std::uint64_t lost = 0;
};

/// What a session costs the end that tells it: sums that only grow, but for the memory. Measured by the owner of the session;
/// the channel only carries this, to a peer that asks.
struct EndCosts
{
    std::uint64_t cpuMicroseconds = 0; ///< CPU time of the whole process, all threads
    std::uint64_t residentBytes = 0;   ///< of the process
    std::uint64_t opened = 0;          ///< records with frames, or frames sealed in place, of this session
    std::uint64_t openNanoseconds = 0; ///< spent on them
    std::uint64_t sealed = 0;
    std::uint64_t sealNanoseconds = 0;
};

/// One epoch's share, newest last; finished epochs of the same suite are added up by the reader where wanted.
struct EpochStats
{
    Epoch epoch{};
    crypto::SuiteId suite{};
    ReceiveCounters rx;
    SendCounters tx;
};

/// Both directions as known here: `rx` counted by us, `peerRx` counted by the other end and reported over the channel
/// (at most a second old).
struct SessionStats
{
    ReceiveCounters rx;
    SendCounters tx;
    ReceiveCounters peerRx;
    SendCounters peerTx;
    bool peerReported = false;
    std::optional<FrameCounters> peerFrames; ///< ours, as the peer counted them; nothing where it does not
    std::optional<EndCosts> peerCosts;       ///< nothing unless asked for, and where the peer does not measure itself
    std::uint32_t peerStamp = 0;             ///< microseconds of the peer's clock at that report, modulo 2^32
    std::vector<EpochStats> epochs;          ///< the last 16 at most
    Duration roundTrip{};                    ///< smoothed, zero until measured
};

} // namespace skyseal::channel
