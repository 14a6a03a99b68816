#include "core/channel/pairing_handshake.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/base/byte_writer.h"
#include "core/base/locked_memory.h"
#include "core/crypto/hash.h"
#include "core/crypto/kdf.h"

#include <algorithm>
#include <string_view>

namespace skyseal::channel {

namespace {

constexpr std::uint8_t kOpeningNumber = 0;

std::string_view nameOf(Role role)
{
    return role == Role::Station ? "station" : "agent";
}

Role otherThan(Role role)
{
    return role == Role::Station ? Role::Agent : Role::Station;
}

/// HKDF-Expand for one purpose, and for the openings `context`.
Key32 derived(const Key32 &secret, std::string_view purpose, ByteView context = {})
{
    std::array<std::uint8_t, 96> info;
    ByteWriter out(info);
    out.bytes(asBytes("skyseal v1 pairing "));
    out.bytes(asBytes(purpose));
    out.bytes(context);
    return crypto::hkdfExpandKey(secret, out.written());
}

/// CPace's sid.
std::array<std::uint8_t, 20> sessionId(const PairingToken &token, PairingId id)
{
    std::array<std::uint8_t, 20> out;
    ByteWriter writer(out);
    writer.bytes(token);
    writer.u32(static_cast<std::uint32_t>(id));
    return out;
}

noise::CipherState cipher(Key32 &&key)
{
    noise::CipherState out;
    out.initializeKey(std::move(key));
    return out;
}

} // namespace

// ---- words

WordCipher::WordCipher(PairingId id, Key32 &&send, Key32 &&receive, Key32 &&presharedKey)
    : m_id(id), m_presharedKey(shareInLockedMemory(std::move(presharedKey))), m_send(cipher(std::move(send))),
      m_receive(cipher(std::move(receive)))
{}

WordDatagram WordCipher::seal(const Word &word)
{
    WordDatagram out{};
    const auto head = sealedHead(m_id, word.number());
    std::copy(head.begin(), head.end(), out.begin());
    // The number is the nonce: the content for one nonce never changes.
    m_send.setNonce(word.number());
    if (!m_send.encryptWithAd(head, {}, MutableByteView(out).subspan(kSealedHead)))
        out.fill(0);
    return out;
}

std::optional<Word> WordCipher::open(ByteView datagram)
{
    if (!isWord(datagram) || sealedPairing(datagram) != m_id)
        return std::nullopt;
    const auto word = Word::fromNumber(datagram[5]);
    if (!word)
        return std::nullopt;
    m_receive.setNonce(datagram[5]);
    if (!m_receive.decryptWithAd(datagram.first(kSealedHead), datagram.subspan(kSealedHead), {}))
        return std::nullopt;
    return word;
}

// ---- handshake

PairingHandshake PairingHandshake::begin(const PairingConfig &config, PairingId id, const PairingToken &token, Carrier carrier,
                                         RandomSource &random)
{
    PairingOpening mine{config.identity->publicKey, config.systemId, config.name};
    random.fill(mine.nonce);

    std::array<std::uint8_t, 19> channel;
    ByteWriter out(channel);
    out.bytes(asBytes("skyseal pairing v1"));
    out.u8(static_cast<std::uint8_t>(carrier));
    const ByteView passphrase = config.passphrase ? config.passphrase->view() : ByteView();
    const auto role = config.role == Role::Station ? crypto::Cpace::Role::Initiator : crypto::Cpace::Role::Responder;

    PairingHandshake handshake(crypto::Cpace::begin(role, {passphrase, channel, sessionId(token, id)}, random));
    handshake.m_role = config.role;
    handshake.m_id = id;
    handshake.m_token = token;
    handshake.m_identity = config.identity;
    handshake.m_mine = std::move(mine);
    const PairingHello hello{id, handshake.m_cpace.share(), token, commitmentTo(handshake.m_mine.write())};
    if (config.role == Role::Station)
        handshake.m_first = pairingFirst(hello);
    else
        handshake.m_answer = pairingAnswer(hello);
    return handshake;
}

bool PairingHandshake::takeAnswer(ByteView datagram)
{
    const auto answer = readAnswer(datagram);
    if (!answer || answer->id != m_id || !agree(*readFirst(m_first), *answer))
        return false;
    std::copy(datagram.begin(), datagram.end(), m_answer.begin());
    m_promised = answer->commitment;
    return true;
}

bool PairingHandshake::takeFirst(ByteView datagram)
{
    const auto first = readFirst(datagram);
    if (!first || first->id != m_id || first->token != m_token || !agree(*first, *readAnswer(m_answer)))
        return false;
    std::copy(datagram.begin(), datagram.end(), m_first.begin());
    return true;
}

/// Derives the keys of the openings and seals ours.
bool PairingHandshake::agree(const PairingHello &station, const PairingHello &agent)
{
    const auto shared = m_cpace.key(sessionId(m_token, m_id), {station.share, {}}, {agent.share, agent.commitment});
    if (!shared)
        return false;
    m_root = crypto::hkdfExtractSha256(asBytes("skyseal pairing v1"), shared->view());
    const auto openingKey = [this](Role sender) { return derived(m_root, "opening " + std::string(nameOf(sender))); };
    m_receive = cipher(openingKey(otherThan(m_role)));
    const auto head = sealedHead(m_id, kOpeningNumber);
    std::copy(head.begin(), head.end(), m_sentOpening.begin());
    return cipher(openingKey(m_role))
        .encryptWithAd(head, m_mine.write(), MutableByteView(m_sentOpening).subspan(kSealedHead))
        .has_value();
}

Result<PairingOpening, OpeningError> PairingHandshake::takeOpening(ByteView datagram)
{
    PairingOpening::Bytes bytes;
    m_receive.setNonce(kOpeningNumber);
    if (!isOpening(datagram) || sealedPairing(datagram) != m_id
        || !m_receive.decryptWithAd(datagram.first(kSealedHead), datagram.subspan(kSealedHead), bytes))
        return tl::unexpected(OpeningError::Unreadable);
    if (m_role == Role::Station && commitmentTo(bytes) != m_promised)
        return tl::unexpected(OpeningError::Broken);
    std::copy(datagram.begin(), datagram.end(), m_readOpening.begin());
    m_theirs = PairingOpening::read(bytes);
    return m_theirs;
}

std::string PairingHandshake::code() const
{
    const bool isStation = m_role == Role::Station;
    return pairingCode(m_first, m_answer, isStation ? m_mine : m_theirs, isStation ? m_theirs : m_mine);
}

std::optional<WordCipher> PairingHandshake::finish() const
{
    const auto shared = crypto::x25519(m_identity->secret, m_theirs.key);
    if (!shared)
        return std::nullopt;
    const Key32 secret = crypto::hkdfExtractSha256(m_root.view(), shared->view());
    const bool isStation = m_role == Role::Station;
    std::array<std::uint8_t, 32> openings;
    crypto::blake2b(openings, {isStation ? m_sentOpening : m_readOpening, isStation ? m_readOpening : m_sentOpening});
    const auto wordKey = [&](Role sender) { return derived(secret, "words " + std::string(nameOf(sender)), openings); };
    return WordCipher(m_id, wordKey(m_role), wordKey(otherThan(m_role)), derived(secret, "preshared key", openings));
}

} // namespace skyseal::channel
