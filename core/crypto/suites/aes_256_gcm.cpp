// AES-256-GCM (NIST SP 800-38D) by OpenSSL, which supports it on every CPU; only the nonce is set for each record.
#include "core/crypto/aead_record.h"
#include "core/crypto/evp.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

const EVP_CIPHER *aes256Gcm()
{
    static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr));
    return cipher.get();
}

class Aes256Gcm
{
public:
    explicit Aes256Gcm(const Key32 &key) : m_context(makeEvpContext(aes256Gcm(), key.view().data(), EvpDirection::Encrypt)) {}

    bool ready() const { return m_context != nullptr; }

    bool seal(const Nonce12 &nonce, ByteView associatedData, ByteView plaintext, std::uint8_t *out, AeadTag tag)
    {
        int written = 0;
        return EVP_EncryptInit_ex2(m_context.get(), nullptr, nullptr, nonce.data(), nullptr) == 1
            && update(nullptr, associatedData) && update(out, plaintext)
            && EVP_EncryptFinal_ex(m_context.get(), tag.data(), &written) == 1
            && EVP_CIPHER_CTX_ctrl(m_context.get(), EVP_CTRL_AEAD_GET_TAG, kTagLength, tag.data()) == 1;
    }

    bool open(const Nonce12 &nonce, ByteView associatedData, MutableByteView body, AeadTag tag)
    {
        int written = 0;
        if (EVP_DecryptInit_ex2(m_context.get(), nullptr, nullptr, nonce.data(), nullptr) == 1
            && EVP_CIPHER_CTX_ctrl(m_context.get(), EVP_CTRL_AEAD_SET_TAG, kTagLength, tag.data()) == 1
            && update(nullptr, associatedData) && update(body.data(), body)
            && EVP_DecryptFinal_ex(m_context.get(), tag.data(), &written) == 1)
            return true;
        // OpenSSL's GCM decrypts before it verifies the tag: the unverified plaintext is wiped.
        sodium_memzero(body.data(), body.size());
        return false;
    }

private:
    static constexpr int kTagLength = kAeadTagLength;

    /// Associated data if `out` is null.
    bool update(std::uint8_t *out, ByteView in)
    {
        int written = 0;
        return in.empty() || EVP_CipherUpdate(m_context.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1;
    }

    EvpContext m_context;
};

} // namespace

SuiteInfo aes256GcmSuite()
{
    return {
        .id = SuiteId::Aes256Gcm,
        .name = "aes-256-gcm",
        .displayName = "AES-256-GCM",
        .strength = SuiteStrength::Aead,
        .color = 0x009E73,
        .makeRecord = AeadRecord<Aes256Gcm>::make<SuiteId::Aes256Gcm>,
        .primitives = {.cipher = OpensslCipher{.name = "AES-256-CTR"}, .authentication = OpensslAead{"AES-256-GCM"}},
        .knownRecord =
            "a5c5a0e25339018f1c9fdde8cc41f02097826f3b9ad4dc451e4a426bacdee91f5e85ce4a885679800ceb13e73202f3dcc8d0b94a"
            "d851022093a6c0ecd5",
    };
}

} // namespace skyseal::crypto
