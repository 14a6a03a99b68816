// ChaCha20-Poly1305 (RFC 8439) by libsodium.
#include "core/base/declassified.h"
#include "core/base/weakness.h"
#include "core/crypto/record_keys.h"

#include <sodium.h>

#include <cstring>

namespace skyseal::crypto {

namespace {

class ChaCha20Poly1305 final : public RecordCipher
{
public:
    explicit ChaCha20Poly1305(const RecordKeys &keys) : m_key(keys.key.clone()), m_nonces(keys.iv) {}

    SuiteId suite() const override { return SuiteId::ChaCha20Poly1305; }

    std::size_t seal(std::uint64_t counter, ByteView associatedData, ByteView plaintext, MutableByteView out) override
    {
        const std::size_t size = plaintext.size();
        if (out.size() < size + kTag)
            return 0;
        const Nonce12 nonce = m_nonces.at(counter);
        crypto_aead_chacha20poly1305_ietf_encrypt_detached(out.data(), out.data() + size, nullptr, plaintext.data(), size,
                                                           associatedData.data(), associatedData.size(), nullptr, nonce.data(),
                                                           m_key.view().data());
        if (weakened(Weakness::NoEncryption))
            std::memcpy(out.data(), plaintext.data(), size);
        return size + kTag;
    }

    std::optional<MutableByteView> open(std::uint64_t counter, ByteView associatedData, MutableByteView sealed) override
    {
        if (sealed.size() < kTag)
            return std::nullopt;
        const std::size_t size = sealed.size() - kTag;
        const Nonce12 nonce = m_nonces.at(counter);
        if (weakened(Weakness::NoEncryption))
            return sealed.first(size);
        if (weakened(Weakness::NoTagCheck))
            crypto_stream_chacha20_ietf_xor_ic(sealed.data(), sealed.data(), size, nonce.data(), 1, m_key.view().data());
        else if (declassified(crypto_aead_chacha20poly1305_ietf_decrypt_detached(
                     sealed.data(), nullptr, sealed.data(), size, sealed.data() + size, associatedData.data(),
                     associatedData.size(), nonce.data(), m_key.view().data()))
                 != 0)
            return std::nullopt;
        return sealed.first(size);
    }

private:
    static constexpr std::size_t kTag = crypto_aead_chacha20poly1305_ietf_ABYTES;

    Key32 m_key;
    NonceBase m_nonces;
};

std::unique_ptr<RecordCipher> makeChaCha20Poly1305(const RecordKeys &keys)
{
    return std::make_unique<ChaCha20Poly1305>(keys);
}

} // namespace

SuiteInfo chaCha20Poly1305Suite()
{
    return {
        .id = SuiteId::ChaCha20Poly1305,
        .name = "chacha20-poly1305",
        .displayName = "ChaCha20-Poly1305",
        .strength = SuiteStrength::Aead,
        .color = 0x0072B2,
        .makeRecord = makeChaCha20Poly1305,
        .primitives = {.cipher = SodiumStream{crypto_stream_chacha20_ietf_xor},
                       .authentication = SodiumAead{crypto_aead_chacha20poly1305_ietf_encrypt,
                                                    crypto_aead_chacha20poly1305_ietf_decrypt}},
        .knownRecord =
            "7316368b9fcb84ee098dcc5df7011f4f9f75ff506e30781b09f88786b5868efce8f5abaa948e9d89490ac6ffd56cfcca7a40168c"
            "3458ba0693bae85193",
    };
}

} // namespace skyseal::crypto
