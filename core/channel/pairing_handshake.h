// The messages of pairing: Noise_XXpsk3_25519_ChaChaPoly_BLAKE2b in its framing, and the sealed words after it.
//
//   call     agent -> station   0x5C | token 16 | zeros 110                                                      127 bytes
//   first    station -> agent   0x5D | id 4 | token 16 | Noise message 1: e 32, zeros 58 + 16                    127 bytes
//   answer   agent -> station   0x5E | id 4 | Noise message 2: e 32, s 48, about 26 + 16                         127 bytes
//   third    station -> agent   0x5F | id 4 | 0 1 | Noise message 3: s 48, about 26 + 16                          96 bytes
//   word     both ways          0x5F | id 4 | number 1 | tag 16                                                   22 bytes
//
// about: flags 1 | role asked 1 | name 24, padded with zeros. The token belongs to the window: a sender that returns it has
// received a call. The number of a word, 0x80 | mine * 4 | heard, holds the decision at this end and the acknowledged one of
// the other end; the bytes of a word depend on nothing else. PROTOCOL.md, section 13.
#pragma once

#include "core/channel/policy.h"
#include "core/channel/wire_format.h"
#include "core/noise/handshake_state.h"

#include <array>
#include <optional>

namespace skyseal::channel {

enum class PairingMessage : std::uint8_t { Call = 0, First = 1, Answer = 2, Sealed = 3 };
enum class PairingId : std::uint32_t {};

inline constexpr std::size_t kPairingLength = 127; ///< of call, first and answer: no end sends more than it received
inline constexpr std::size_t kThirdLength = 96;
inline constexpr std::size_t kWordLength = 22;

using PairingToken = std::array<std::uint8_t, 16>;
using PairingDatagram = std::array<std::uint8_t, kPairingLength>;
using ThirdDatagram = std::array<std::uint8_t, kThirdLength>;
using WordDatagram = std::array<std::uint8_t, kWordLength>;

constexpr std::uint8_t firstByte(PairingMessage message)
{
    return firstByte(DatagramKind::Pairing, static_cast<std::uint8_t>(message));
}

/// Properties of an end that it sends within the handshake.
struct PairingAbout
{
    static constexpr std::size_t kLength = 26;
    bool wantPresharedKey = false;
    bool hasPassphrase = false;
    PeerRole roleAsked = PeerRole::Pilot; ///< a number that is unknown here is read as Observer
    std::string name;                     ///< at most 24 bytes on the wire; read with unfit characters replaced by "-"

    std::array<std::uint8_t, kLength> write() const;
    /// Returns nullopt for a wrong length only: the handshake has accepted the message by then and must go on.
    static std::optional<PairingAbout> read(ByteView bytes);
};

/// Decision of a person; Yes and No are final.
enum class Decision : std::uint8_t { None = 0, Yes = 1, No = 2 };

/// Acknowledgement of the other end's decision, and finally of its acknowledgement, so that both can stop.
enum class Heard : std::uint8_t { Nothing = 0, Yes = 1, No = 2, AllIsSaid = 3 };

struct Word
{
    Decision mine{};
    Heard heard{};
};

/// The sealed messages of one end ("words"), under the keys of a finished handshake.
class PairingVoice
{
public:
    PairingVoice(PairingId id, noise::Role role, noise::TransportSecrets &&secrets);

    PairingId id() const { return m_id; }
    WordDatagram say(const Word &word);
    std::optional<Word> hear(ByteView datagram);
    /// The pre-shared key that both ends can derive from this handshake.
    const std::shared_ptr<const Key32> &presharedKey() const { return m_presharedKey; }

private:
    PairingId m_id;
    std::shared_ptr<const Key32> m_presharedKey;
    noise::CipherState m_send;
    noise::CipherState m_receive;
};

/// One end's handshake. A message that fails changes nothing.
class PairingHandshake
{
public:
    static std::optional<PairingHandshake> begin(noise::Role role, const crypto::X25519KeyPair &identity,
                                                 const Key32 *passphraseKey, PairingId id, const PairingToken &token,
                                                 Carrier carrier = Carrier::Datagram);

    PairingId id() const { return m_id; }
    /// The other end's key; authentic once the last message was read.
    const PublicKey &peer() const { return *m_noise.remoteStatic(); }

    // the station's
    std::optional<PairingDatagram> first(RandomSource &random);
    std::optional<PairingAbout> readAnswer(ByteView datagram);
    std::optional<ThirdDatagram> third(const PairingAbout &about, RandomSource &random);
    // the agent's
    bool takeFirst(ByteView datagram);
    std::optional<PairingDatagram> answer(const PairingAbout &about, RandomSource &random);
    std::optional<PairingAbout> takeThird(ByteView datagram);

    std::optional<PairingVoice> finish() &&;

private:
    PairingHandshake(noise::HandshakeState &&noise, noise::Role role, PairingId id, const PairingToken &token)
        : m_noise(std::move(noise)), m_role(role), m_id(id), m_token(token)
    {}

    noise::HandshakeState m_noise;
    noise::Role m_role;
    PairingId m_id;
    PairingToken m_token;
};

/// The token and id of messages whose length is right; nullopt for others.
PairingDatagram pairingCall(const PairingToken &token);
std::optional<PairingToken> calledToken(ByteView datagram);
struct FirstHead
{
    PairingId id{};
    PairingToken token{};
};
std::optional<FirstHead> firstHead(ByteView datagram);
std::optional<PairingId> answeredPairing(ByteView datagram);
bool isThird(ByteView datagram);
bool isWord(ByteView datagram);
/// Of a third message or a word.
PairingId sealedPairing(ByteView datagram);

} // namespace skyseal::channel
