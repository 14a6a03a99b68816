// What the two ends say to each other inside sealed records. A record's plaintext is either MAVLink frames, which begin
// with 0xFD or 0xFE, or one of these, which begin with a type below 0x10. Each one may be lost, repeated and reordered.
#pragma once

#include "core/base/bytes.h"
#include "core/channel/stats.h"
#include "core/crypto/suite.h"

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

namespace skyseal::channel {

using EpochNonce = std::array<std::uint8_t, 16>;

/// Number of a proposal, growing per session and proposer: an older one is void.
enum class ProposalId : std::uint32_t {};

/// "Let us use `suite` in `epoch`": repeated until answered or given up. Only its sender decides what becomes of it.
struct Propose
{
    ProposalId id{};
    Epoch epoch{};
    crypto::SuiteId suite{};
    EpochNonce nonce{};
};

/// "I can read that epoch now": the answer to each copy of the proposal, the same every time.
struct Accept
{
    ProposalId id{};
    EpochNonce nonce{};
};

struct Refuse
{
    ProposalId id{};
};

/// "I send under `epoch` now; I sealed `sentBefore` records under the one before": repeated until `Confirmed` comes.
struct Confirm
{
    Epoch epoch{};
    std::uint32_t sentBefore = 0;
};

/// The same from the other end.
struct Confirmed
{
    Epoch epoch{};
    std::uint32_t sentBefore = 0;
};

/// Once a second: our clock and an echo of the peer's, from which each end knows the round trip, and our counters.
struct Report
{
    std::uint32_t stamp = 0;   ///< microseconds of the sender's session clock, modulo 2^32
    std::uint32_t echo = 0;    ///< the newest stamp that came from the peer, 0 = none yet
    std::uint32_t held = 0;    ///< microseconds since it came
    bool answerAtOnce = false; ///< the sender wants a sign of life now
    bool asksCosts = false;    ///< the sender wants the costs of the other end in its reports from now on
    ReceiveCounters rx;
    SendCounters tx;
    std::optional<FrameCounters> frames; ///< of those that count them
    std::optional<EndCosts> costs;       ///< for a peer that asked
};

/// "I end the session."
struct Close
{};

using ControlMessage = std::variant<Propose, Accept, Refuse, Confirm, Confirmed, Report, Close>;

/// Plaintext that begins with a byte below this is a control message, known or not.
inline constexpr std::uint8_t kFirstFrameByte = 0x10;
/// The longest control message: a report whose eighteen numbers all need ten bytes.
inline constexpr std::size_t kMaxControl = 1 + 3 * 4 + 1 + 18 * 10;

constexpr bool isControl(ByteView plaintext)
{
    return plaintext.empty() || plaintext[0] < kFirstFrameByte;
}

/// Writes the message to `out` (at least kMaxControl bytes) and gives its length.
std::size_t writeControl(const ControlMessage &message, MutableByteView out);
/// nullopt for an unknown type, a short or overlong message, or a value out of range.
std::optional<ControlMessage> readControl(ByteView plaintext);

} // namespace skyseal::channel
