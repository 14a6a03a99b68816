// HandshakeState of the Noise specification (revision 34, 5.3): runs the messages of a pattern, one call each, and ends
// with the transport secrets. No I/O, no clock; randomness is passed in. Not thread-safe.
#pragma once

#include "core/base/random_source.h"
#include "core/crypto/x25519.h"
#include "core/noise/handshake_pattern.h"
#include "core/noise/symmetric_state.h"

#include <optional>
#include <vector>

namespace skyseal::noise {

using crypto::PublicKey;
using crypto::X25519KeyPair;

enum class Party : std::uint8_t { Initiator, Responder };

inline constexpr std::size_t kMaxMessageLength = 65535;

/// The inputs of a handshake. `prologue` is only read by initialize().
struct HandshakeConfig
{
    Party role = Party::Initiator;
    std::string_view pattern = kKnownPeers;
    ByteView prologue; ///< data both ends must agree on; if it differs, the first encrypted message fails
    std::optional<X25519KeyPair> localStatic;
    std::optional<PublicKey> remoteStatic;
    std::vector<Key32> psks; ///< in the order of the pattern's psk tokens; may be given later, see `setPsks`
};

/// The result of a finished handshake at this end: our `send` is the peer's `receive`.
struct TransportSecrets
{
    Key32 send;
    Key32 receive;
    crypto::Hash64 handshakeHash{}; ///< identifies the session uniquely at both ends (11.2)
};

/// A call that fails leaves the handshake unchanged, so that a forged message costs nothing but the time to reject it.
class HandshakeState
{
public:
    static Result<HandshakeState, NoiseError> initialize(HandshakeConfig &&config);

    HandshakeState(HandshakeState &&) noexcept = default;
    HandshakeState &operator=(HandshakeState &&) noexcept = default;

    bool isComplete() const { return m_messageIndex >= m_pattern.messages.size(); }
    bool isMyTurnToWrite() const;
    /// Bytes of the next message, ours or the peer's, in addition to its payload. 0 when complete.
    std::size_t nextOverhead() const;

    /// Replaces the pre-shared keys: a responder learns only from the first message which peer's keys apply.
    void setPsks(std::vector<Key32> &&psks) { m_psks = std::move(psks); }

    /// Writes the next message to `out`, which needs payload + `nextOverhead()` bytes, and returns its length.
    Result<std::size_t, NoiseError> writeMessage(ByteView payload, MutableByteView out, RandomSource &random);

    /// Reads the peer's next message, writes its payload to `payloadOut`, which needs message - `nextOverhead()` bytes, and
    /// returns its length. The buffers must not overlap. Safe for any bytes.
    Result<std::size_t, NoiseError> readMessage(ByteView message, MutableByteView payloadOut);

    /// The peer's static key once it is known. How far it is authenticated depends on the messages so far (7.7).
    const std::optional<PublicKey> &remoteStatic() const { return m_keys.remoteStatic; }
    const crypto::Hash64 &handshakeHash() const { return m_symmetric.handshakeHash(); }

    /// Ends a complete handshake. The state is wiped, even when this fails.
    Result<TransportSecrets, NoiseError> finish() &&;

private:
    /// The four key variables of 5.3 that messages change, with the static pair they are used with.
    struct Keys
    {
        std::optional<X25519KeyPair> localStatic;
        std::optional<X25519KeyPair> localEphemeral;
        std::optional<PublicKey> remoteStatic;
        std::optional<PublicKey> remoteEphemeral;
    };
    struct Attempt;

    HandshakeState() = default;
    Result<void, NoiseError> mixPreMessages();
    Attempt begin() const;
    void commit(Attempt &&attempt);

    HandshakePattern m_pattern;
    Party m_role = Party::Initiator;
    std::size_t m_messageIndex = 0;
    std::size_t m_pskIndex = 0;
    std::vector<Key32> m_psks;
    SymmetricState m_symmetric;
    Keys m_keys;
};

} // namespace skyseal::noise
