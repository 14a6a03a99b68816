// ChaCha20-Poly1305 (RFC 8439) by libsodium.
#include "core/base/declassified.h"
#include "core/crypto/aead_record.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

class ChaCha20Poly1305
{
public:
    explicit ChaCha20Poly1305(const Key32 &key) : m_key(key.clone()) {}

    bool ready() const { return true; }

    bool seal(const Nonce12 &nonce, ByteView associatedData, ByteView plaintext, std::uint8_t *out, AeadTag tag)
    {
        return crypto_aead_chacha20poly1305_ietf_encrypt_detached(out, tag.data(), nullptr, plaintext.data(), plaintext.size(),
                                                                  associatedData.data(), associatedData.size(), nullptr,
                                                                  nonce.data(), m_key.view().data())
            == 0;
    }

    bool open(const Nonce12 &nonce, ByteView associatedData, MutableByteView body, AeadTag tag)
    {
        return declassified(crypto_aead_chacha20poly1305_ietf_decrypt_detached(
                   body.data(), nullptr, body.data(), body.size(), tag.data(), associatedData.data(), associatedData.size(),
                   nonce.data(), m_key.view().data()))
            == 0;
    }

private:
    Key32 m_key;
};

static_assert(kAeadTagLength == crypto_aead_chacha20poly1305_ietf_ABYTES);

} // namespace

SuiteInfo chaCha20Poly1305Suite()
{
    return {
        .id = SuiteId::ChaCha20Poly1305,
        .name = "chacha20-poly1305",
        .displayName = "ChaCha20-Poly1305",
        .strength = SuiteStrength::Aead,
        .color = 0x0072B2,
        .makeRecord = AeadRecord<ChaCha20Poly1305>::make<SuiteId::ChaCha20Poly1305>,
        .primitives = {.cipher = SodiumStream{crypto_stream_chacha20_ietf_xor},
                       .authentication = SodiumAead{crypto_aead_chacha20poly1305_ietf_encrypt,
                                                    crypto_aead_chacha20poly1305_ietf_decrypt}},
        .knownRecord =
            "7316368b9fcb84ee098dcc5df7011f4f9f75ff506e30781b09f88786b5868efce8f5abaa948e9d89490ac6ffd56cfcca7a40168c"
            "3458ba0693bae85193",
    };
}

} // namespace skyseal::crypto
