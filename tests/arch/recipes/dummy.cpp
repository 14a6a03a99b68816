// Example of a cipher suite, for recipes_test: ChaCha20-Poly1305 in its original construction, with a nonce of 64 bits, by
// libsodium. It is no part of the product.
#include "core/base/declassified.h"
#include "core/crypto/aead_record.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

constexpr SuiteId kId{7};

class Dummy
{
public:
    explicit Dummy(const Key32 &key) : m_key(key.clone()) {}

    bool ready() const { return true; }

    bool seal(const Nonce12 &nonce, ByteView associatedData, ByteView plaintext, std::uint8_t *out, AeadTag tag)
    {
        return crypto_aead_chacha20poly1305_encrypt_detached(out, tag.data(), nullptr, plaintext.data(), plaintext.size(),
                                                             associatedData.data(), associatedData.size(), nullptr,
                                                             nonce.data() + 4, m_key.view().data())
            == 0;
    }

    bool open(const Nonce12 &nonce, ByteView associatedData, MutableByteView body, AeadTag tag)
    {
        return declassified(crypto_aead_chacha20poly1305_decrypt_detached(
                   body.data(), nullptr, body.data(), body.size(), tag.data(), associatedData.data(), associatedData.size(),
                   nonce.data() + 4, m_key.view().data()))
            == 0;
    }

private:
    Key32 m_key;
};

static_assert(kAeadTagLength == crypto_aead_chacha20poly1305_ABYTES);

} // namespace

SuiteInfo dummySuite()
{
    return {
        .id = kId,
        .name = "dummy",
        .displayName = "Dummy",
        .strength = SuiteStrength::Aead,
        .color = 0xF0E442,
        .makeRecord = AeadRecord<Dummy>::make<kId>,
        .primitives = {.cipher = SodiumStream{crypto_stream_chacha20_xor},
                       .authentication = SodiumAead{crypto_aead_chacha20poly1305_encrypt,
                                                    crypto_aead_chacha20poly1305_decrypt}},
        .knownRecord =
            "f04e7b0a019fb88ec50f845d3b327024f834cdbe1ab9d07de9d3a3f1442679473d154908fdfd6b0266d64bc2de824e00529cfec1"
            "d31351e4dbf644728a",
    };
}

} // namespace skyseal::crypto
