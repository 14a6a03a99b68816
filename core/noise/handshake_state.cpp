// Each message is one function: its tokens in their order, then the payload. The functions change a copy of the symmetric state
// and local keys, and store them when nothing can fail any more. In "es" and "se" the first letter is the initiator's key.
#include "core/noise/handshake_state.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

#include <algorithm>

namespace skyseal::noise {

using Done = Result<void, NoiseError>;

/// MixKey(DH(own, theirs)).
static Done mixDh(SymmetricState &symmetric, const X25519KeyPair &own, const PublicKey &theirs)
{
    const std::optional<Key32> shared = crypto::x25519(own.secret, theirs);
    if (!shared)
        return tl::unexpected(NoiseError::BadPublicKey);
    symmetric.mixKey(shared->view());
    return {};
}

/// The token "e". An ephemeral key is mixed into ck too, since the handshake has a psk (9.2).
static void mixE(SymmetricState &symmetric, const PublicKey &e)
{
    symmetric.mixHash(e);
    symmetric.mixKey(e);
}

static PublicKey readKey(ByteReader &in)
{
    PublicKey key{};
    std::ranges::copy(in.bytes(key.size()), key.begin());
    return key;
}

HandshakeState HandshakeState::initiator(ByteView prologue, X25519KeyPair &&s, const PublicKey &rs)
{
    return {true, prologue, std::move(s), rs};
}

HandshakeState HandshakeState::responder(ByteView prologue, X25519KeyPair &&s)
{
    return {false, prologue, std::move(s), std::nullopt};
}

/// <- s
HandshakeState::HandshakeState(bool initiator, ByteView prologue, X25519KeyPair &&s, const std::optional<PublicKey> &rs)
    : m_initiator(initiator), m_s(std::move(s)), m_rs(rs)
{
    m_symmetric.mixHash(prologue);
    m_symmetric.mixHash(m_initiator ? *m_rs : m_s.publicKey);
}

/// -> e, es, s, ss
Done HandshakeState::writeFirst(ByteView payload, MutableByteView out, RandomSource &random)
{
    ByteWriter message(out);
    SymmetricState symmetric = m_symmetric.clone();
    X25519KeyPair e = X25519KeyPair::generate(random);
    message.bytes(e.publicKey);
    mixE(symmetric, e.publicKey);
    if (const Done es = mixDh(symmetric, e, *m_rs); !es)
        return es;
    if (const Done s = symmetric.encryptAndHash(m_s.publicKey, message.reserve(sizeof(PublicKey) + kTagLength)); !s)
        return s;
    if (const Done ss = mixDh(symmetric, m_s, *m_rs); !ss)
        return ss;
    if (const Done sealed = symmetric.encryptAndHash(payload, message.reserve(payload.size() + kTagLength)); !sealed)
        return sealed;
    m_symmetric = std::move(symmetric);
    m_e = std::move(e);
    return {};
}

/// -> e, es, s, ss
Done HandshakeState::readFirst(ByteView bytes, MutableByteView payloadOut)
{
    ByteReader message(bytes);
    SymmetricState symmetric = m_symmetric.clone();
    const PublicKey re = readKey(message);
    mixE(symmetric, re);
    if (const Done es = mixDh(symmetric, m_s, re); !es)
        return es;
    PublicKey rs{};
    if (const Done s = symmetric.decryptAndHash(message.bytes(sizeof(PublicKey) + kTagLength), rs); !s)
        return s;
    if (const Done ss = mixDh(symmetric, m_s, rs); !ss)
        return ss;
    if (const Done opened = symmetric.decryptAndHash(message.rest(), payloadOut); !opened)
        return opened;
    m_symmetric = std::move(symmetric);
    m_re = re;
    m_rs = rs;
    return {};
}

/// <- e, ee, se, psk
Done HandshakeState::writeSecond(ByteView payload, MutableByteView out, RandomSource &random)
{
    if (!m_psk)
        return tl::unexpected(NoiseError::MissingKey);
    ByteWriter message(out);
    SymmetricState symmetric = m_symmetric.clone();
    const X25519KeyPair e = X25519KeyPair::generate(random);
    message.bytes(e.publicKey);
    mixE(symmetric, e.publicKey);
    if (const Done ee = mixDh(symmetric, e, m_re); !ee)
        return ee;
    if (const Done se = mixDh(symmetric, e, *m_rs); !se)
        return se;
    symmetric.mixKeyAndHash(m_psk->view());
    if (const Done sealed = symmetric.encryptAndHash(payload, message.reserve(payload.size() + kTagLength)); !sealed)
        return sealed;
    m_symmetric = std::move(symmetric);
    return {};
}

/// <- e, ee, se, psk
Done HandshakeState::readSecond(ByteView bytes, MutableByteView payloadOut)
{
    if (!m_psk)
        return tl::unexpected(NoiseError::MissingKey);
    ByteReader message(bytes);
    SymmetricState symmetric = m_symmetric.clone();
    const PublicKey re = readKey(message);
    mixE(symmetric, re);
    if (const Done ee = mixDh(symmetric, m_e, re); !ee)
        return ee;
    if (const Done se = mixDh(symmetric, m_s, re); !se)
        return se;
    symmetric.mixKeyAndHash(m_psk->view());
    if (const Done opened = symmetric.decryptAndHash(message.rest(), payloadOut); !opened)
        return opened;
    m_symmetric = std::move(symmetric);
    return {};
}

Done HandshakeState::writeMessage(ByteView payload, MutableByteView out, RandomSource &random)
{
    if (m_messages.value != (m_initiator ? 0u : 1u))
        return tl::unexpected(NoiseError::OutOfTurn);
    const std::size_t size = payload.size() + (m_initiator ? kFirstOverhead : kSecondOverhead);
    if (size > kMaxMessageLength)
        return tl::unexpected(NoiseError::TooLong);
    if (out.size() < size)
        return tl::unexpected(NoiseError::NoRoom);
    const Done written = m_initiator ? writeFirst(payload, out, random) : writeSecond(payload, out, random);
    return written.map([this] { ++m_messages.value; });
}

Done HandshakeState::readMessage(ByteView message, MutableByteView payloadOut)
{
    if (m_messages.value != (m_initiator ? 1u : 0u))
        return tl::unexpected(NoiseError::OutOfTurn);
    if (message.size() > kMaxMessageLength)
        return tl::unexpected(NoiseError::TooLong);
    const std::size_t overhead = m_initiator ? kSecondOverhead : kFirstOverhead;
    if (message.size() < overhead)
        return tl::unexpected(NoiseError::Truncated);
    if (payloadOut.size() < message.size() - overhead)
        return tl::unexpected(NoiseError::NoRoom);
    const Done read = m_initiator ? readSecond(message, payloadOut) : readFirst(message, payloadOut);
    return read.map([this] { ++m_messages.value; });
}

Result<TransportSecrets, NoiseError> HandshakeState::finish() &&
{
    const HandshakeState state = std::move(*this);
    if (state.m_messages.value != 2)
        return tl::unexpected(NoiseError::Unfinished);
    auto [send, receive] = state.m_symmetric.split(); // in the view of the initiator
    if (!state.m_initiator)
        std::swap(send, receive);
    return TransportSecrets{std::move(send), std::move(receive), state.m_symmetric.handshakeHash()};
}

} // namespace skyseal::noise
