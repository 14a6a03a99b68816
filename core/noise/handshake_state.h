// HandshakeState of the Noise specification (revision 34, 5.3) for the one protocol of the secure channel,
// Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b. The initiator knows the responder's static key in advance:
//
//     <- s
//     ...
//     -> e, es, s, ss
//     <- e, ee, se, psk
//
// No I/O, no clock; randomness is passed in. Not thread-safe.
#pragma once

#include "core/base/random_source.h"
#include "core/crypto/x25519.h"
#include "core/noise/symmetric_state.h"

#include <optional>
#include <utility>

namespace skyseal::noise {

using crypto::PublicKey;
using crypto::X25519KeyPair;

inline constexpr std::size_t kMaxMessageLength = 65535;
/// Bytes of the messages in addition to their payloads: e, s with its tag, and the payload's tag; e and the payload's tag.
inline constexpr std::size_t kFirstOverhead = sizeof(PublicKey) + sizeof(PublicKey) + kTagLength + kTagLength;
inline constexpr std::size_t kSecondOverhead = sizeof(PublicKey) + kTagLength;
static_assert(kFirstOverhead == 96 && kSecondOverhead == 48);

/// The result of a finished handshake at this end: our `send` is the peer's `receive`.
struct TransportSecrets
{
    Key32 send;
    Key32 receive;
    crypto::Hash64 handshakeHash{}; ///< identifies the session uniquely at both ends (11.2)
};

/// One end of a handshake. The initiator writes the first message and reads the second one, the responder the reverse. A call
/// that fails leaves the handshake unchanged, so that a forged message costs nothing but the time to reject it.
class HandshakeState
{
public:
    /// `prologue`: data that both ends must agree on, otherwise the first message is rejected. `s`: the own static key pair.
    /// `rs`: the responder's static key.
    static HandshakeState initiator(ByteView prologue, X25519KeyPair &&s, const PublicKey &rs);
    static HandshakeState responder(ByteView prologue, X25519KeyPair &&s);

    /// Sets or replaces the pre-shared key. The second message fails with MissingKey without one; a responder learns only from
    /// the first message which peer's key applies.
    void setPsk(Key32 &&psk) { m_psk = std::move(psk); }

    /// Writes this end's message to the first bytes of `out`: payload + `kFirstOverhead`, or `kSecondOverhead` as responder.
    Result<void, NoiseError> writeMessage(ByteView payload, MutableByteView out, RandomSource &random);

    /// Reads the peer's message and writes its payload to the first bytes of `payloadOut`: message - `kSecondOverhead`, or
    /// `kFirstOverhead` as responder. The buffers must not overlap. Safe for any bytes.
    Result<void, NoiseError> readMessage(ByteView message, MutableByteView payloadOut);

    /// The peer's static key; a responder has it after the first message. That message may be a replay, and the holder of the
    /// responder's static key can forge it (7.7).
    const std::optional<PublicKey> &remoteStatic() const { return m_rs; }

    /// Ends a handshake after its second message; Unfinished before. The state is wiped, even when this fails.
    Result<TransportSecrets, NoiseError> finish() &&;

private:
    /// The number of messages written and read. A state that was moved from has wiped keys, and counts as over.
    struct MessageCount
    {
        MessageCount() = default;
        MessageCount(MessageCount &&other) noexcept : value(std::exchange(other.value, kOver)) {}
        MessageCount &operator=(MessageCount &&other) noexcept
        {
            value = std::exchange(other.value, kOver);
            return *this;
        }

        static constexpr unsigned kOver = 3;
        unsigned value = 0;
    };

    HandshakeState(bool initiator, ByteView prologue, X25519KeyPair &&s, const std::optional<PublicKey> &rs);
    Result<void, NoiseError> writeFirst(ByteView payload, MutableByteView out, RandomSource &random);
    Result<void, NoiseError> readFirst(ByteView message, MutableByteView payloadOut);
    Result<void, NoiseError> writeSecond(ByteView payload, MutableByteView out, RandomSource &random);
    Result<void, NoiseError> readSecond(ByteView message, MutableByteView payloadOut);

    bool m_initiator;
    MessageCount m_messages;
    SymmetricState m_symmetric;
    X25519KeyPair m_s;
    X25519KeyPair m_e; ///< the initiator's, from its message on
    std::optional<PublicKey> m_rs;
    PublicKey m_re{}; ///< at the responder, from the first message on
    std::optional<Key32> m_psk;
};

} // namespace skyseal::noise
