// The two messages of Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b in their framing:
//
//   first    0x59 | Noise message 110 (e 32, s 48, payload 14 + 16) | mac1 16                                127 bytes
//   answer   0x5A | connection id of the initiator 2 | Noise message 58 (e 32, payload 10 + 16) | mac1 16     77 bytes
//   number   0x5B | connection id of the initiator 2 | Noise message 53 (e 32, payload 5 + 16) | mac1 16      72 bytes
//
// The agent sends the number instead of an answer if the station's counter is behind the one that the agent remembers. Each
// message fits the 128 bytes of a MAVLink TUNNEL. The psk is all zero if the two ends share none. The prologue holds version
// and carrier, so that ends which differ in these cannot agree. PROTOCOL.md, section 4.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/channel/events.h"
#include "core/channel/handshake_messages.h"
#include "core/channel/key_chain.h"
#include "core/noise/handshake_state.h"

namespace skyseal::channel {

/// Result of a handshake at one end.
struct Agreement
{
    ConnectionId peerConnection{};
    SuiteOffer peerOffer;
    crypto::SuiteId suite{};
    KeyChain chain;
};

/// The station's half. Its message may be sent any number of times; a wrong answer changes nothing.
class Initiator
{
public:
    /// Returns nullopt if the peer's key is unusable. `carrier`: of the path on which the message is sent.
    static std::optional<Initiator> begin(const crypto::X25519KeyPair &identity, const Peer &peer, FirstPayload payload,
                                          RandomSource &random, Carrier carrier = Carrier::Datagram);

    const FirstMessage &message() const { return m_message; }
    ConnectionId connection() const { return m_payload.connection; }
    std::uint64_t counter() const { return m_payload.counter; }
    Result<Agreement, RefusalReason> readAnswer(ByteView datagram);
    /// Returns the greatest counter that the agent remembers of us. The handshake is void after that.
    std::optional<std::uint64_t> readNumber(ByteView datagram);

private:
    Initiator(noise::HandshakeState noise, FirstPayload payload, const PublicKey &identity)
        : m_noise(std::move(noise)), m_payload(std::move(payload)), m_answerMac(identity)
    {}

    noise::HandshakeState m_noise;
    FirstPayload m_payload;
    Mac1 m_answerMac;
    FirstMessage m_message{};
};

/// The agent's half: a first message that was read and not answered yet.
class Responder
{
public:
    /// Precondition: kFirstLength bytes, and mac1 or the MAC under a cookie was verified.
    static Result<Responder, RefusalReason> read(const crypto::X25519KeyPair &identity, ByteView datagram,
                                                 Carrier carrier = Carrier::Datagram);

    const PublicKey &peer() const { return m_peer; }
    const FirstPayload &payload() const { return m_payload; }

    /// Returns false if answer() would fail with NoCommonSuite.
    bool hasCommonSuite(const SuiteOffer &offer) const;

    struct Answer
    {
        AnswerMessage message{};
        Agreement agreement;
    };
    /// `known`: the listed peer with the key peer(). Fails with NoCommonSuite, or WrongKey if the library fails.
    Result<Answer, RefusalReason> answer(const Peer &known, ConnectionId ours, const SuiteOffer &offer,
                                         RandomSource &random) &&;
    /// Written in place of an answer. Only the station that wrote the first message can read it.
    std::optional<NumberMessage> writeNumber(const Peer &known, std::uint64_t lastSeen, RandomSource &random) &&;

private:
    Responder(noise::HandshakeState noise, const PublicKey &peer, FirstPayload payload)
        : m_noise(std::move(noise)), m_peer(peer), m_payload(std::move(payload))
    {}

    noise::HandshakeState m_noise;
    PublicKey m_peer;
    FirstPayload m_payload;
};

/// Returns the connection id that an answer or a number is addressed to; nullopt for other datagrams.
std::optional<ConnectionId> answeredConnection(ByteView datagram);

} // namespace skyseal::channel
