#include "core/channel/handshake.h"

namespace skyseal::channel {

namespace {

class Prologue
{
public:
    explicit Prologue(Carrier carrier) { m_bytes.back() = static_cast<std::uint8_t>(carrier); }
    ByteView view() const { return m_bytes; }

private:
    std::array<std::uint8_t, 19> m_bytes{
        's', 'k', 'y', 's', 'e', 'a', 'l', ' ', 'c', 'h', 'a', 'n', 'n', 'e', 'l', ' ', 'v', '0' + kProtocolVersion, 0};
};

Key32 presharedKeyOf(const Peer &peer)
{
    return peer.presharedKey ? peer.presharedKey->clone() : Key32();
}

static_assert(kFirstNoiseLength == noise::kFirstOverhead + FirstPayload::kLength);
static_assert(kAnswerNoiseLength == noise::kSecondOverhead + AnswerPayload::kLength);
static_assert(kNumberNoiseLength == noise::kSecondOverhead + NumberPayload::kLength);

void writeHead(MutableByteView message, HandshakeMessage kind, ConnectionId to)
{
    message[0] = firstByte(kind);
    message[1] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(to));
    message[2] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(to) >> 8);
}

} // namespace

std::optional<Initiator> Initiator::begin(const crypto::X25519KeyPair &identity, const Peer &peer, FirstPayload payload,
                                          RandomSource &random, Carrier carrier)
{
    auto noise = noise::HandshakeState::initiator(Prologue(carrier).view(), identity.clone(), peer.key);
    noise.setPsk(presharedKeyOf(peer));
    Initiator out(std::move(noise), std::move(payload), identity.publicKey);
    out.m_message[0] = firstByte(HandshakeMessage::First);
    if (!out.m_noise.writeMessage(out.m_payload.write(), MutableByteView(out.m_message).subspan(1, kFirstNoiseLength), random))
        return std::nullopt;
    Mac1(peer.key).sign(out.m_message);
    return out;
}

Result<Agreement, RefusalReason> Initiator::readAnswer(ByteView datagram)
{
    if (datagram.size() != kAnswerLength || !m_answerMac.verify(datagram))
        return tl::unexpected(RefusalReason::WrongKey);
    std::array<std::uint8_t, AnswerPayload::kLength> plain;
    if (!m_noise.readMessage(datagram.subspan(3, kAnswerNoiseLength), plain))
        return tl::unexpected(RefusalReason::WrongKey);

    const auto answer = AnswerPayload::read(plain);
    if (!answer)
        return tl::unexpected(RefusalReason::OfferTampered);
    if (chooseSuite(m_payload.offer, answer->offer) != answer->chosen)
        return tl::unexpected(RefusalReason::OfferTampered);
    const auto secrets = std::move(m_noise).finish();
    if (!secrets)
        return tl::unexpected(RefusalReason::WrongKey);
    return Agreement{answer->connection, answer->offer, answer->chosen,
                     KeyChain(secrets->send, secrets->receive, secrets->handshakeHash)};
}

std::optional<std::uint64_t> Initiator::readNumber(ByteView datagram)
{
    std::array<std::uint8_t, NumberPayload::kLength> plain;
    if (datagram.size() != kNumberLength || !m_answerMac.verify(datagram)
        || !m_noise.readMessage(datagram.subspan(3, kNumberNoiseLength), plain))
        return std::nullopt;
    return NumberPayload::read(plain)->lastSeen;
}

Result<Responder, RefusalReason> Responder::read(const crypto::X25519KeyPair &identity, ByteView datagram, Carrier carrier)
{
    auto noise = noise::HandshakeState::responder(Prologue(carrier).view(), identity.clone());
    std::array<std::uint8_t, FirstPayload::kLength> plain;
    if (!noise.readMessage(datagram.subspan(1, kFirstNoiseLength), plain))
        return tl::unexpected(RefusalReason::WrongKey);
    const auto payload = FirstPayload::read(plain);
    if (!payload)
        return tl::unexpected(RefusalReason::WrongKey);
    const PublicKey peer = *noise.remoteStatic();
    return Responder(std::move(noise), peer, *payload);
}

bool Responder::hasCommonSuite(const SuiteOffer &offer) const
{
    return chooseSuite(m_payload.offer, offer).has_value();
}

Result<Responder::Answer, RefusalReason> Responder::answer(const Peer &known, ConnectionId ours, const SuiteOffer &offer,
                                                           RandomSource &random) &&
{
    m_noise.setPsk(presharedKeyOf(known));
    const auto suite = chooseSuite(m_payload.offer, offer);
    if (!suite)
        return tl::unexpected(RefusalReason::NoCommonSuite);

    AnswerMessage message{};
    writeHead(message, HandshakeMessage::Answer, m_payload.connection);
    const AnswerPayload payload{ours, offer, *suite};
    if (!m_noise.writeMessage(payload.write(), MutableByteView(message).subspan(3, kAnswerNoiseLength), random))
        return tl::unexpected(RefusalReason::WrongKey);
    Mac1(m_peer).sign(message);

    const auto secrets = std::move(m_noise).finish();
    if (!secrets)
        return tl::unexpected(RefusalReason::WrongKey);
    return Answer{message,
                  Agreement{m_payload.connection, m_payload.offer, *suite,
                            KeyChain(secrets->receive, secrets->send, secrets->handshakeHash)}};
}

std::optional<NumberMessage> Responder::writeNumber(const Peer &known, std::uint64_t lastSeen, RandomSource &random) &&
{
    m_noise.setPsk(presharedKeyOf(known));
    NumberMessage message{};
    writeHead(message, HandshakeMessage::Cookie, m_payload.connection);
    if (!m_noise.writeMessage(NumberPayload{lastSeen}.write(), MutableByteView(message).subspan(3, kNumberNoiseLength), random))
        return std::nullopt;
    Mac1(m_peer).sign(message);
    return message;
}

std::optional<ConnectionId> answeredConnection(ByteView datagram)
{
    const bool answer = datagram.size() == kAnswerLength && datagram[0] == firstByte(HandshakeMessage::Answer);
    const bool number = datagram.size() == kNumberLength && datagram[0] == firstByte(HandshakeMessage::Cookie);
    if (!answer && !number)
        return std::nullopt;
    return static_cast<ConnectionId>(datagram[1] | datagram[2] << 8);
}

} // namespace skyseal::channel
