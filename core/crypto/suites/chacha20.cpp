// ChaCha20 (RFC 8439 2.4) by libsodium, then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_then_mac.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

class ChaCha20Body : public SameLength
{
public:
    explicit ChaCha20Body(const RecordKeys &keys) : m_key(keys.key.clone()), m_nonces(keys.iv) {}

    bool ready() const { return true; }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        if (plaintext.empty()) // libsodium declares its pointers nonnull
            return true;
        const Nonce12 nonce = m_nonces.at(counter);
        return crypto_stream_chacha20_ietf_xor(out.data(), plaintext.data(), plaintext.size(), nonce.data(),
                                               m_key.view().data())
            == 0;
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return encrypt(counter, body, body) ? std::optional(body.size()) : std::nullopt;
    }

private:
    Key32 m_key;
    NonceBase m_nonces;
};

} // namespace

SuiteInfo chaCha20Suite()
{
    return {
        .id = SuiteId::ChaCha20,
        .name = "chacha20",
        .displayName = "ChaCha20",
        .strength = SuiteStrength::CipherWithHmac,
        .color = 0xE69F00,
        .makeRecord = EncryptThenMac<ChaCha20Body>::make<SuiteId::ChaCha20>,
        .makeInline = InlineThenMac<ChaCha20Body>::make<SuiteId::ChaCha20>,
        .primitives = {.cipher = SodiumStream{crypto_stream_chacha20_ietf_xor}, .authentication = HmacSha256Tag()},
        .knownRecord =
            "b2be041111a07541f14b6e7db908bb127463771363eae62e0e228943d85a5ae1d9df99ebf0d3e6d61b41aa805d129bcfe8096037"
            "f74d7193f9790c128a",
    };
}

} // namespace skyseal::crypto
