#include "core/channel/cookie.h"

#include "core/crypto/hash.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kNonceLength = 16;
constexpr std::size_t kSealedLength = std::tuple_size_v<Cookie> + crypto_aead_chacha20poly1305_ietf_ABYTES;
/// Each key seals one cookie, so the cipher's own nonce need not change.
constexpr std::array<std::uint8_t, crypto_aead_chacha20poly1305_ietf_NPUBBYTES> kZeroNonce{};

std::array<std::uint8_t, 32> sealKeyOf(const PublicKey &agent)
{
    std::array<std::uint8_t, 32> out;
    crypto::blake2b(out, {asBytes("skyseal v1 cookie"), agent});
    return out;
}

Key32 messageKey(ByteView sealKey, ByteView nonce, ByteView mac1)
{
    Key32 key;
    crypto::keyedBlake2b(key.mutableView(), sealKey, {nonce, mac1});
    return key;
}

/// SipHash-128: only the agent computes it, and it does so for every message of a flood.
Cookie cookieFor(const SecretBytes<16> &secret, const Path &path)
{
    std::array<std::uint8_t, 22> said;
    std::copy(path.remote.ip.begin(), path.remote.ip.end(), said.begin());
    said[16] = static_cast<std::uint8_t>(path.remote.port);
    said[17] = static_cast<std::uint8_t>(path.remote.port >> 8);
    for (unsigned i = 0; i < 4; ++i)
        said[18 + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(path.link) >> 8 * i);
    Cookie cookie;
    crypto_shorthash_siphashx24(cookie.data(), said.data(), said.size(), secret.view().data());
    return cookie;
}

std::array<std::uint8_t, kMacLength> macUnder(const Cookie &cookie, ByteView said)
{
    std::array<std::uint8_t, kMacLength> mac;
    crypto::keyedBlake2b(mac, cookie, {said});
    return mac;
}

} // namespace

CookieMaker::CookieMaker(const PublicKey &own, RandomSource &random) : m_random(random), m_sealKey(sealKeyOf(own)) {}

void CookieMaker::renew(TimePoint now)
{
    if (m_since && now < *m_since + kCookieSecretLife)
        return;
    m_previous.reset();
    if (m_since && now < *m_since + 2 * kCookieSecretLife)
        m_previous = std::move(m_secret);
    m_random.fill(m_secret.mutableView());
    m_random.fill(MutableByteView(m_nonce).first(8));
    m_since = now;
}

CookieMessage CookieMaker::make(TimePoint now, const Path &from, ByteView first)
{
    renew(now);
    ++m_made;
    for (unsigned i = 0; i < 8; ++i)
        m_nonce[8 + i] = static_cast<std::uint8_t>(m_made >> 8 * i);
    CookieMessage out{};
    out[0] = firstByte(HandshakeMessage::Cookie);
    std::copy(m_nonce.begin(), m_nonce.end(), out.begin() + 1);
    const Cookie cookie = cookieFor(m_secret, from);
    const Key32 key = messageKey(m_sealKey, m_nonce, first.last(kMacLength));
    crypto_aead_chacha20poly1305_ietf_encrypt(out.data() + 1 + kNonceLength, nullptr, cookie.data(), cookie.size(), nullptr, 0,
                                              nullptr, kZeroNonce.data(), key.view().data());
    return out;
}

bool CookieMaker::verify(TimePoint now, const Path &from, ByteView first) const
{
    if (!m_since || first.size() < kMacLength)
        return false;
    const ByteView said = first.first(first.size() - kMacLength);
    const auto isUnder = [&](const Secret &secret) {
        const auto mac = macUnder(cookieFor(secret, from), said);
        return sodium_memcmp(mac.data(), first.last(kMacLength).data(), kMacLength) == 0;
    };
    const Duration age = now - *m_since;
    return (age < 2 * kCookieSecretLife && isUnder(m_secret))
        || (m_previous && age < kCookieSecretLife && isUnder(*m_previous));
}

bool cookieHasForm(ByteView datagram)
{
    if (datagram.size() != kCookieLength || datagram[0] != firstByte(HandshakeMessage::Cookie))
        return false;
    const ByteView padding = datagram.subspan(1 + kNonceLength + kSealedLength);
    return sodium_is_zero(padding.data(), padding.size()) == 1;
}

std::optional<Cookie> openCookie(const PublicKey &agent, ByteView mac1, ByteView datagram)
{
    if (!cookieHasForm(datagram))
        return std::nullopt;
    const Key32 key = messageKey(sealKeyOf(agent), datagram.subspan(1, kNonceLength), mac1);
    const ByteView sealed = datagram.subspan(1 + kNonceLength, kSealedLength);
    Cookie cookie;
    if (crypto_aead_chacha20poly1305_ietf_decrypt(cookie.data(), nullptr, nullptr, sealed.data(), sealed.size(), nullptr, 0,
                                                  kZeroNonce.data(), key.view().data())
        != 0)
        return std::nullopt;
    return cookie;
}

void signWithCookie(const Cookie &cookie, MutableByteView first)
{
    const std::size_t said = first.size() - kMacLength;
    const auto mac = macUnder(cookie, first.first(said));
    std::copy(mac.begin(), mac.end(), first.begin() + static_cast<std::ptrdiff_t>(said));
}

} // namespace skyseal::channel
