#include "core/noise/handshake_state.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::noise {

using Done = Result<void, NoiseError>;

/// A message being written or read: copies of the state that it changes, discarded if it fails.
struct HandshakeState::Attempt
{
    const HandshakeState &state;
    SymmetricState symmetric;
    std::optional<X25519KeyPair> newEphemeral;
    std::optional<PublicKey> remoteStatic;
    std::optional<PublicKey> remoteEphemeral;
    std::size_t pskIndex;

    const std::optional<X25519KeyPair> &localEphemeral() const
    {
        return newEphemeral ? newEphemeral : state.m_keys.localEphemeral;
    }
    void mixEphemeral(const PublicKey &key)
    {
        symmetric.mixHash(key);
        if (state.m_pattern.usesPsk())
            symmetric.mixKey(key); // 9.2: an ephemeral key must randomize the psk
    }
    Done mixDh(const std::optional<X25519KeyPair> &local, const std::optional<PublicKey> &remote);
    Done mixToken(Token token);
    Done writeEphemeral(ByteWriter &out, RandomSource &random);
    Done writeStatic(ByteWriter &out);
    Done readEphemeral(ByteReader &in);
    Done readStatic(ByteReader &in);
};

Done HandshakeState::Attempt::mixDh(const std::optional<X25519KeyPair> &local, const std::optional<PublicKey> &remote)
{
    if (!local || !remote)
        return tl::unexpected(NoiseError::MissingKey);
    const std::optional<Key32> shared = crypto::x25519(local->secret, *remote);
    if (!shared)
        return tl::unexpected(NoiseError::BadPublicKey);
    symmetric.mixKey(shared->view());
    return {};
}

/// Processes a token without bytes on the wire. In "es" and "se" the first letter is the initiator's key.
Done HandshakeState::Attempt::mixToken(Token token)
{
    const bool initiator = state.m_role == Party::Initiator;
    if (token == Token::Psk) {
        if (pskIndex >= state.m_psks.size())
            return tl::unexpected(NoiseError::MissingKey);
        symmetric.mixKeyAndHash(state.m_psks[pskIndex++].view());
        return {};
    }
    if (token == Token::EE && weakened(Weakness::NoEphemeralMix))
        return {};
    if (token == Token::EE)
        return mixDh(localEphemeral(), remoteEphemeral);
    if (token == Token::SS)
        return mixDh(state.m_keys.localStatic, remoteStatic);
    if ((token == Token::ES) == initiator)
        return mixDh(localEphemeral(), remoteStatic);
    return mixDh(state.m_keys.localStatic, remoteEphemeral);
}

Done HandshakeState::Attempt::writeEphemeral(ByteWriter &out, RandomSource &random)
{
    newEphemeral = X25519KeyPair::generate(random);
    out.bytes(newEphemeral->publicKey);
    mixEphemeral(newEphemeral->publicKey);
    return {};
}

Done HandshakeState::Attempt::writeStatic(ByteWriter &out)
{
    if (!state.m_keys.localStatic)
        return tl::unexpected(NoiseError::MissingKey);
    const MutableByteView place = out.reserve(state.m_keys.localStatic->publicKey.size() + symmetric.overhead());
    const auto written = symmetric.encryptAndHash(state.m_keys.localStatic->publicKey, place);
    return written ? Done() : tl::unexpected(written.error());
}

Done HandshakeState::Attempt::readEphemeral(ByteReader &in)
{
    PublicKey key{};
    const ByteView raw = in.bytes(key.size());
    if (raw.empty())
        return tl::unexpected(NoiseError::Truncated);
    std::copy(raw.begin(), raw.end(), key.begin());
    remoteEphemeral = key;
    mixEphemeral(key);
    return {};
}

Done HandshakeState::Attempt::readStatic(ByteReader &in)
{
    PublicKey key{};
    const ByteView raw = in.bytes(key.size() + symmetric.overhead());
    if (raw.empty())
        return tl::unexpected(NoiseError::Truncated);
    const auto read = symmetric.decryptAndHash(raw, key);
    if (!read)
        return tl::unexpected(read.error());
    remoteStatic = key;
    return {};
}

Result<HandshakeState, NoiseError> HandshakeState::initialize(HandshakeConfig &&config)
{
    std::optional<HandshakePattern> pattern = handshakePattern(config.pattern);
    if (!pattern)
        return tl::unexpected(NoiseError::UnknownPattern);
    HandshakeState state;
    state.m_pattern = std::move(*pattern);
    state.m_role = config.role;
    state.m_psks = std::move(config.psks);
    state.m_keys.localStatic = std::move(config.localStatic);
    state.m_keys.remoteStatic = config.remoteStatic;
    state.m_symmetric.initializeSymmetric(state.m_pattern.protocolName());
    if (!weakened(Weakness::NoPrologue))
        state.m_symmetric.mixHash(config.prologue);
    if (const Done mixed = state.mixPreMessages(); !mixed)
        return tl::unexpected(mixed.error());
    return state;
}

/// Hashes the static keys that both ends know in advance. Pre-messages with ephemeral keys belong to fallback patterns, which
/// are not in the table.
Done HandshakeState::mixPreMessages()
{
    for (const Party side : {Party::Initiator, Party::Responder}) {
        const MessagePattern &known = side == Party::Initiator ? m_pattern.initiatorPreMessage : m_pattern.responderPreMessage;
        if (known.empty())
            continue;
        if (side == m_role ? !m_keys.localStatic : !m_keys.remoteStatic)
            return tl::unexpected(NoiseError::MissingKey);
        m_symmetric.mixHash(side == m_role ? m_keys.localStatic->publicKey : *m_keys.remoteStatic);
    }
    return {};
}

bool HandshakeState::isMyTurnToWrite() const
{
    return !isComplete() && (m_messageIndex % 2 == 0) == (m_role == Party::Initiator);
}

std::size_t HandshakeState::nextOverhead() const
{
    if (isComplete())
        return 0;
    std::size_t size = 0;
    bool keyed = m_symmetric.hasKey();
    for (const Token token : m_pattern.messages[m_messageIndex]) {
        if (token == Token::E)
            size += sizeof(PublicKey);
        else if (token == Token::S)
            size += sizeof(PublicKey) + (keyed ? kTagLength : 0);
        keyed = keyed || (token == Token::E ? m_pattern.usesPsk() : token != Token::S);
    }
    return size + (keyed ? kTagLength : 0);
}

HandshakeState::Attempt HandshakeState::begin() const
{
    return {*this, m_symmetric.clone(), std::nullopt, m_keys.remoteStatic, m_keys.remoteEphemeral, m_pskIndex};
}

void HandshakeState::commit(Attempt &&attempt)
{
    m_symmetric = std::move(attempt.symmetric);
    if (attempt.newEphemeral)
        m_keys.localEphemeral = std::move(attempt.newEphemeral);
    m_keys.remoteStatic = attempt.remoteStatic;
    m_keys.remoteEphemeral = attempt.remoteEphemeral;
    m_pskIndex = attempt.pskIndex;
    ++m_messageIndex;
}

Result<std::size_t, NoiseError> HandshakeState::writeMessage(ByteView payload, MutableByteView out, RandomSource &random)
{
    if (!isMyTurnToWrite())
        return tl::unexpected(NoiseError::OutOfTurn);
    const std::size_t total = payload.size() + nextOverhead();
    if (total > kMaxMessageLength)
        return tl::unexpected(NoiseError::TooLong);
    if (out.size() < total)
        return tl::unexpected(NoiseError::NoRoom);

    Attempt attempt = begin();
    ByteWriter writer(out);
    for (const Token token : m_pattern.messages[m_messageIndex]) {
        const Done done = token == Token::E ? attempt.writeEphemeral(writer, random)
            : token == Token::S             ? attempt.writeStatic(writer)
                                            : attempt.mixToken(token);
        if (!done)
            return tl::unexpected(done.error());
    }
    const auto written = attempt.symmetric.encryptAndHash(payload, out.subspan(writer.size()));
    if (!written)
        return written;
    commit(std::move(attempt));
    return total;
}

Result<std::size_t, NoiseError> HandshakeState::readMessage(ByteView message, MutableByteView payloadOut)
{
    if (isComplete() || isMyTurnToWrite())
        return tl::unexpected(NoiseError::OutOfTurn);
    if (message.size() > kMaxMessageLength)
        return tl::unexpected(NoiseError::TooLong);
    const std::size_t overhead = nextOverhead();
    if (message.size() < overhead)
        return tl::unexpected(NoiseError::Truncated);
    if (payloadOut.size() < message.size() - overhead)
        return tl::unexpected(NoiseError::NoRoom);

    Attempt attempt = begin();
    ByteReader reader(message);
    for (const Token token : m_pattern.messages[m_messageIndex]) {
        const Done done = token == Token::E ? attempt.readEphemeral(reader)
            : token == Token::S             ? attempt.readStatic(reader)
                                            : attempt.mixToken(token);
        if (!done)
            return tl::unexpected(done.error());
    }
    const auto read = attempt.symmetric.decryptAndHash(reader.rest(), payloadOut);
    if (read)
        commit(std::move(attempt));
    return read;
}

Result<TransportSecrets, NoiseError> HandshakeState::finish() &&
{
    const HandshakeState state = std::move(*this);
    // A moved-from state has no pattern and only wiped keys, which must not become those of a session.
    if (!state.isComplete() || state.m_pattern.messages.empty())
        return tl::unexpected(NoiseError::Unfinished);
    auto [sending, receiving] = state.m_symmetric.split(); // in the view of the initiator
    if (state.m_role == Party::Responder)
        std::swap(sending, receiving);
    return TransportSecrets{std::move(sending), std::move(receiving), state.handshakeHash()};
}

} // namespace skyseal::noise
