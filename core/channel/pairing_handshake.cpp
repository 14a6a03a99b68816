#include "core/channel/pairing_handshake.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/base/weakness.h"
#include "core/crypto/kdf.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kFirstHead = 1 + 4 + 16;
constexpr std::size_t kAnswerHead = 1 + 4;
constexpr std::size_t kSealedHead = 1 + 4 + 1;
constexpr std::size_t kFirstPadding = kPairingLength - kFirstHead - 32 - 16;
constexpr std::size_t kNameLength = PairingAbout::kLength - 2;
constexpr std::uint8_t kWordMark = 0x80; ///< of a word's number, which is 0 for the third message
enum Flag : std::uint8_t { WantsPresharedKey = 1, HasPassphrase = 2 };

static_assert(kPairingLength == kAnswerHead + 32 + 48 + PairingAbout::kLength + 16);
static_assert(kThirdLength == kSealedHead + 48 + PairingAbout::kLength + 16);
static_assert(kWordLength == kSealedHead + noise::kTagLength);

void writeHead(MutableByteView out, PairingMessage message, PairingId id)
{
    out[0] = firstByte(message);
    for (unsigned i = 0; i < 4; ++i)
        out[1 + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(id) >> 8 * i);
}

PairingId idIn(ByteView datagram)
{
    ByteReader in(datagram.subspan(1, 4));
    return PairingId{in.u32()};
}

/// Cut between two characters of UTF-8.
std::string_view fitting(std::string_view name)
{
    if (name.size() <= kNameLength)
        return name;
    std::size_t size = kNameLength;
    while (size > 0 && (static_cast<std::uint8_t>(name[size]) & 0xc0) == 0x80)
        --size;
    return name.substr(0, size);
}

/// Characters that the peers file accepts, so that a received name can be stored.
char fitCharacter(char c)
{
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_'
        || c == '.' || static_cast<std::uint8_t>(c) >= 0x80;
    return fits ? c : '-';
}

} // namespace

std::array<std::uint8_t, PairingAbout::kLength> PairingAbout::write() const
{
    std::array<std::uint8_t, kLength> out{};
    out[0] = static_cast<std::uint8_t>((wantPresharedKey ? WantsPresharedKey : 0) | (hasPassphrase ? HasPassphrase : 0));
    out[1] = static_cast<std::uint8_t>(roleAsked);
    const std::string_view sent = fitting(name);
    std::copy(sent.begin(), sent.end(), out.begin() + 2);
    return out;
}

std::optional<PairingAbout> PairingAbout::read(ByteView bytes)
{
    if (bytes.size() != kLength)
        return std::nullopt;
    PairingAbout about;
    about.wantPresharedKey = bytes[0] & WantsPresharedKey;
    about.hasPassphrase = bytes[0] & HasPassphrase;
    about.roleAsked = bytes[1] == static_cast<std::uint8_t>(PeerRole::Pilot) ? PeerRole::Pilot : PeerRole::Observer;
    const ByteView name = bytes.subspan(2);
    const auto end = std::find(name.begin(), name.end(), 0);
    std::transform(name.begin(), end, std::back_inserter(about.name),
                   [](std::uint8_t c) { return fitCharacter(static_cast<char>(c)); });
    return about;
}

// ---- words

PairingVoice::PairingVoice(PairingId id, noise::Role role, noise::TransportSecrets &&secrets) : m_id(id)
{
    const bool initiator = role == noise::Role::Initiator;
    const Key32 &stations = initiator ? secrets.send : secrets.receive;
    const Key32 &agents = initiator ? secrets.receive : secrets.send;
    SecretBytes<64> both;
    std::copy(stations.view().begin(), stations.view().end(), both.mutableView().begin());
    std::copy(agents.view().begin(), agents.view().end(), both.mutableView().begin() + 32);
    const Key32 extracted = crypto::hkdfExtractSha256(secrets.handshakeHash, both.view());
    m_presharedKey = std::make_shared<const Key32>(
        crypto::hkdfExpandKey(extracted, asBytes("skyseal v1 pairing preshared key")));
    m_send.initializeKey(std::move(secrets.send));
    m_receive.initializeKey(std::move(secrets.receive));
}

WordDatagram PairingVoice::say(const Word &word)
{
    WordDatagram out{};
    writeHead(out, PairingMessage::Sealed, m_id);
    out[5] = static_cast<std::uint8_t>(kWordMark | static_cast<unsigned>(word.mine) << 2 | static_cast<unsigned>(word.heard));
    // The number is the nonce: the content for one nonce never changes.
    m_send.setNonce(out[5]);
    const MutableByteView tag = MutableByteView(out).subspan(kSealedHead);
    if (!m_send.encryptWithAd(ByteView(out).first(kSealedHead), {}, tag))
        out.fill(0);
    return out;
}

std::optional<Word> PairingVoice::hear(ByteView datagram)
{
    if (!isWord(datagram) || idIn(datagram) != m_id)
        return std::nullopt;
    const std::uint8_t number = datagram[5];
    const Word word{static_cast<Decision>(number >> 2 & 3), static_cast<Heard>(number & 3)};
    if ((number & 0xf0) != kWordMark || word.mine > Decision::No)
        return std::nullopt;
    m_receive.setNonce(number);
    if (!m_receive.decryptWithAd(datagram.first(kSealedHead), datagram.subspan(kSealedHead), {}))
        return std::nullopt;
    return word;
}

// ---- handshake

std::optional<PairingHandshake> PairingHandshake::begin(noise::Role role, const crypto::X25519KeyPair &identity,
                                                        const Key32 *passphraseKey, PairingId id, const PairingToken &token,
                                                        Carrier carrier)
{
    // Fields that must be the same at both ends and are otherwise sent in clear.
    std::array<std::uint8_t, 19 + 4 + 16> prologue;
    ByteWriter out(prologue);
    out.bytes(asBytes("skyseal pairing v1"));
    out.u8(static_cast<std::uint8_t>(carrier));
    out.u32(static_cast<std::uint32_t>(id));
    out.bytes(token);

    noise::HandshakeConfig config;
    config.role = role;
    config.pattern = noise::kPairing;
    config.prologue = prologue;
    config.localStatic = identity.clone();
    config.psks.push_back(passphraseKey && !weakened(Weakness::NoPassphrase) ? passphraseKey->clone() : Key32());
    auto noise = noise::HandshakeState::initialize(std::move(config));
    if (!noise)
        return std::nullopt;
    return PairingHandshake(std::move(*noise), role, id, token);
}

std::optional<PairingDatagram> PairingHandshake::first(RandomSource &random)
{
    PairingDatagram out{};
    writeHead(out, PairingMessage::First, m_id);
    std::copy(m_token.begin(), m_token.end(), out.begin() + 5);
    static constexpr std::array<std::uint8_t, kFirstPadding> kZeros{};
    if (!m_noise.writeMessage(kZeros, MutableByteView(out).subspan(kFirstHead), random))
        return std::nullopt;
    return out;
}

bool PairingHandshake::takeFirst(ByteView datagram)
{
    std::array<std::uint8_t, kFirstPadding> padding;
    return m_noise.readMessage(datagram.subspan(kFirstHead), padding).has_value();
}

std::optional<PairingDatagram> PairingHandshake::answer(const PairingAbout &about, RandomSource &random)
{
    PairingDatagram out{};
    writeHead(out, PairingMessage::Answer, m_id);
    if (!m_noise.writeMessage(about.write(), MutableByteView(out).subspan(kAnswerHead), random))
        return std::nullopt;
    return out;
}

std::optional<PairingAbout> PairingHandshake::readAnswer(ByteView datagram)
{
    std::array<std::uint8_t, PairingAbout::kLength> about;
    if (answeredPairing(datagram) != m_id || !m_noise.readMessage(datagram.subspan(kAnswerHead), about))
        return std::nullopt;
    about[1] = 0; // An agent asks for no role.
    return PairingAbout::read(about);
}

std::optional<ThirdDatagram> PairingHandshake::third(const PairingAbout &about, RandomSource &random)
{
    ThirdDatagram out{};
    writeHead(out, PairingMessage::Sealed, m_id);
    if (!m_noise.writeMessage(about.write(), MutableByteView(out).subspan(kSealedHead), random))
        return std::nullopt;
    return out;
}

std::optional<PairingAbout> PairingHandshake::takeThird(ByteView datagram)
{
    std::array<std::uint8_t, PairingAbout::kLength> about;
    if (!isThird(datagram) || idIn(datagram) != m_id || !m_noise.readMessage(datagram.subspan(kSealedHead), about))
        return std::nullopt;
    return PairingAbout::read(about);
}

std::optional<PairingVoice> PairingHandshake::finish() &&
{
    auto secrets = std::move(m_noise).finish();
    if (!secrets)
        return std::nullopt;
    return PairingVoice(m_id, m_role, std::move(*secrets));
}

// ---- heads

PairingDatagram pairingCall(const PairingToken &token)
{
    PairingDatagram out{};
    out[0] = firstByte(PairingMessage::Call);
    std::copy(token.begin(), token.end(), out.begin() + 1);
    return out;
}

std::optional<PairingToken> calledToken(ByteView datagram)
{
    if (datagram.size() != kPairingLength || datagram[0] != firstByte(PairingMessage::Call))
        return std::nullopt;
    PairingToken token;
    std::copy_n(datagram.begin() + 1, token.size(), token.begin());
    return token;
}

std::optional<FirstHead> firstHead(ByteView datagram)
{
    if (datagram.size() != kPairingLength || datagram[0] != firstByte(PairingMessage::First))
        return std::nullopt;
    FirstHead head;
    head.id = idIn(datagram);
    std::copy_n(datagram.begin() + 5, head.token.size(), head.token.begin());
    return head;
}

std::optional<PairingId> answeredPairing(ByteView datagram)
{
    if (datagram.size() != kPairingLength || datagram[0] != firstByte(PairingMessage::Answer))
        return std::nullopt;
    return idIn(datagram);
}

bool isThird(ByteView datagram)
{
    return datagram.size() == kThirdLength && datagram[0] == firstByte(PairingMessage::Sealed) && datagram[5] == 0;
}

bool isWord(ByteView datagram)
{
    return datagram.size() == kWordLength && datagram[0] == firstByte(PairingMessage::Sealed) && datagram[5] >= kWordMark;
}

PairingId sealedPairing(ByteView datagram)
{
    return idIn(datagram);
}

} // namespace skyseal::channel
