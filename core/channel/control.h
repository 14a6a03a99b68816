// Control messages within sealed records (PROTOCOL.md, section 7). The plaintext of a record is either MAVLink frames, which
// begin with 0xFD or 0xFE, or one control message, which begins with a type below 0x10. Any of them may be lost, repeated
// and reordered.
#pragma once

#include "core/base/bytes.h"
#include "core/channel/stats.h"
#include "core/crypto/suite.h"
#include "core/crypto/public_key.h"

#include <cstdint>
#include <optional>
#include <variant>

namespace skyseal::channel {

/// Number of a proposal, growing per session and proposer. An older proposal is void.
enum class ProposalId : std::uint32_t {};

/// Proposes `suite` for `epoch`. Repeated until it is answered or given up; only its sender decides about the switch.
struct Propose
{
    ProposalId id{};
    Epoch epoch{};
    crypto::SuiteId suite{};
    crypto::PublicKey key{}; ///< fresh, the same in each copy
};

/// The sender has the read keys of the proposed epoch. The same answer to each copy of the proposal.
struct Accept
{
    ProposalId id{};
    crypto::PublicKey key{};
};

struct Refuse
{
    ProposalId id{};
};

/// The sender seals under `epoch`, and sealed `sentBefore` records under the epoch before. Repeated until `Confirmed` arrives.
struct Confirm
{
    Epoch epoch{};
    std::uint32_t sentBefore = 0;
};

/// The same from the other end, in answer to each Confirm.
struct Confirmed
{
    Epoch epoch{};
    std::uint32_t sentBefore = 0;
};

/// Sent once a second: the sender's clock and an echo of the peer's clock, for the round trip, and the sender's counters.
struct Report
{
    std::uint32_t stamp = 0;      ///< microseconds of the sender's session clock, modulo 2^32
    std::uint32_t echo = 0;       ///< newest stamp received from the peer, 0 = none yet
    std::uint32_t held = 0;       ///< microseconds since it was received
    bool answerAtOnce = false;    ///< requests a report now
    bool asksCosts = false;       ///< requests the receiver's costs in its reports
    bool cannotStore = false;     ///< an agent that cannot store the counters of handshakes
    bool receivesNothing = false; ///< an agent whose session is quiet: no record of the station arrives
    ReceiveCounters rx;
    SendCounters tx;
    std::optional<FrameCounters> frames;      ///< if the owner counts frames
    std::optional<FreshnessReport> freshness; ///< from an agent
    std::optional<EndCosts> costs;            ///< if the peer requests them
};

/// The sender has ended the session.
struct Close
{};

using ControlMessage = std::variant<Propose, Accept, Refuse, Confirm, Confirmed, Report, Close>;

/// Plaintext whose first byte is below this is a control message, known or not.
inline constexpr std::uint8_t kFirstFrameByte = 0x10;
/// Longest control message: a report with 22 numbers of ten bytes.
inline constexpr std::size_t kMaxControl = 1 + 3 * 4 + 1 + 22 * 10;

constexpr bool isControl(ByteView plaintext)
{
    return plaintext.empty() || plaintext[0] < kFirstFrameByte;
}

/// Writes the message to `out` (at least kMaxControl bytes). Returns its length.
std::size_t writeControl(const ControlMessage &message, MutableByteView out);
/// Returns nullopt for an unknown type, a wrong length, or a value out of range.
std::optional<ControlMessage> readControl(ByteView plaintext);

} // namespace skyseal::channel
