// The handshake of a pairing (PROTOCOL.md, section 13): a CPace exchange in which the agent commits to its opening; then the
// station shows its own, and the agent shows what it committed to. An end must show one opening in a window at most.
#pragma once

#include "core/base/result.h"
#include "core/channel/pairing_messages.h"
#include "core/crypto/cpace.h"
#include "core/noise/cipher_state.h"

#include <memory>
#include <optional>

namespace skyseal::channel {

/// The sealed messages of one end ("words"), under the keys of a finished handshake.
class WordCipher
{
public:
    WordCipher(PairingId id, Key32 &&send, Key32 &&receive, Key32 &&presharedKey);

    PairingId id() const { return m_id; }
    /// The bytes of a word depend on its number alone.
    WordDatagram seal(const Word &word);
    std::optional<Word> open(ByteView datagram);
    /// The pre-shared key of the pair.
    const std::shared_ptr<const Key32> &presharedKey() const { return m_presharedKey; }

private:
    PairingId m_id;
    std::shared_ptr<const Key32> m_presharedKey;
    noise::CipherState m_send;
    noise::CipherState m_receive;
};

enum class OpeningError : std::uint8_t {
    Unreadable, ///< not of this handshake, changed on its way, or the passphrases differ
    Broken,     ///< not what the agent committed to
};

/// One end's handshake, for one pairing id. A message that fails changes nothing. Call in the order of the messages.
class PairingHandshake
{
public:
    /// Takes 0.1 ms. Draws 16 and 32 random bytes: nonce and scalar.
    static PairingHandshake begin(const PairingConfig &config, PairingId id, const PairingToken &token, Carrier carrier,
                                  RandomSource &random);

    PairingId id() const { return m_id; }

    // the station's
    const PairingDatagram &first() const { return m_first; }
    /// Takes 0.1 ms, like takeFirst(). False if the share is invalid. Afterwards opening() is the message to send.
    bool takeAnswer(ByteView datagram);

    // the agent's
    bool takeFirst(ByteView datagram);
    const PairingAnswer &answer() const { return m_answer; }

    // of both
    const OpeningDatagram &opening() const { return m_sentOpening; }
    Result<PairingOpening, OpeningError> takeOpening(ByteView datagram);
    /// After the openings: the six digits.
    std::string code() const;
    /// After the openings. Its words prove that their sender holds the private key of its opening. nullopt for a weak key.
    std::optional<WordCipher> finish() const;

private:
    explicit PairingHandshake(crypto::Cpace &&cpace) : m_cpace(std::move(cpace)) {}
    bool agree(const PairingHello &station, const PairingHello &agent);

    Role m_role{};
    PairingId m_id{};
    PairingToken m_token{};
    std::shared_ptr<const crypto::X25519KeyPair> m_identity;
    crypto::Cpace m_cpace;
    PairingOpening m_mine;
    PairingOpening m_theirs;
    Commitment m_promised{}; ///< the agent's, at the station
    PairingDatagram m_first{};
    PairingAnswer m_answer{};
    OpeningDatagram m_sentOpening{};
    OpeningDatagram m_readOpening{};
    Key32 m_root; ///< of all keys of this handshake
    noise::CipherState m_receive;
};

} // namespace skyseal::channel
