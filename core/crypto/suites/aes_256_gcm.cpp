// AES-256-GCM (NIST SP 800-38D) by OpenSSL, which supports it on every CPU; only the nonce is set for each record.
#include "core/base/weakness.h"
#include "core/crypto/evp.h"
#include "core/crypto/record_keys.h"

#include <sodium.h>

#include <cstring>

namespace skyseal::crypto {

namespace {

class Aes256Gcm final : public RecordCipher
{
public:
    Aes256Gcm(const RecordKeys &keys, const EVP_CIPHER *cipher)
        : m_context(makeEvpContext(cipher, keys.key.view().data(), EvpDirection::Encrypt)), m_nonces(keys.iv)
    {}

    bool ready() const { return m_context != nullptr; }
    SuiteId suite() const override { return SuiteId::Aes256Gcm; }

    std::size_t seal(std::uint64_t counter, ByteView associatedData, ByteView plaintext, MutableByteView out) override
    {
        const std::size_t size = plaintext.size();
        if (out.size() < size + kTag)
            return 0;
        const Nonce12 nonce = m_nonces.at(counter);
        int written = 0;
        if (EVP_EncryptInit_ex2(m_context.get(), nullptr, nullptr, nonce.data(), nullptr) != 1 || !addAssociated(associatedData)
            || !update(out.data(), plaintext) || EVP_EncryptFinal_ex(m_context.get(), out.data() + size, &written) != 1
            || EVP_CIPHER_CTX_ctrl(m_context.get(), EVP_CTRL_AEAD_GET_TAG, kTag, out.data() + size) != 1)
            return 0;
        if (weakened(Weakness::NoEncryption))
            std::memcpy(out.data(), plaintext.data(), size);
        return size + kTag;
    }

    std::optional<MutableByteView> open(std::uint64_t counter, ByteView associatedData, MutableByteView sealed) override
    {
        if (sealed.size() < kTag)
            return std::nullopt;
        const MutableByteView body = sealed.first(sealed.size() - kTag);
        if (weakened(Weakness::NoEncryption))
            return body;
        const Nonce12 nonce = m_nonces.at(counter);
        int written = 0;
        if (EVP_DecryptInit_ex2(m_context.get(), nullptr, nullptr, nonce.data(), nullptr) == 1
            && EVP_CIPHER_CTX_ctrl(m_context.get(), EVP_CTRL_AEAD_SET_TAG, kTag, body.data() + body.size()) == 1
            && addAssociated(associatedData) && update(body.data(), body)
            && (EVP_DecryptFinal_ex(m_context.get(), body.data() + body.size(), &written) == 1
                || weakened(Weakness::NoTagCheck)))
            return body;
        // OpenSSL's GCM decrypts before it verifies the tag: the unverified plaintext is wiped.
        sodium_memzero(sealed.data(), sealed.size());
        return std::nullopt;
    }

private:
    static constexpr int kTag = 16;

    bool addAssociated(ByteView data)
    {
        int written = 0;
        return data.empty()
            || EVP_CipherUpdate(m_context.get(), nullptr, &written, data.data(), static_cast<int>(data.size())) == 1;
    }

    bool update(std::uint8_t *out, ByteView in)
    {
        int written = 0;
        return in.empty() || EVP_CipherUpdate(m_context.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1;
    }

    EvpContext m_context;
    NonceBase m_nonces;
};

std::unique_ptr<RecordCipher> makeAes256Gcm(const RecordKeys &keys)
{
    static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr));
    auto made = std::make_unique<Aes256Gcm>(keys, cipher.get());
    return made->ready() ? std::move(made) : nullptr;
}

} // namespace

SuiteInfo aes256GcmSuite()
{
    return {
        .id = SuiteId::Aes256Gcm,
        .name = "aes-256-gcm",
        .displayName = "AES-256-GCM",
        .strength = SuiteStrength::Aead,
        .color = 0x009E73,
        .makeRecord = makeAes256Gcm,
        .primitives = {.cipher = OpensslCipher{.name = "AES-256-CTR"}, .authentication = OpensslAead{"AES-256-GCM"}},
        .knownRecord =
            "a5c5a0e25339018f1c9fdde8cc41f02097826f3b9ad4dc451e4a426bacdee91f5e85ce4a885679800ceb13e73202f3dcc8d0b94a"
            "d851022093a6c0ecd5",
    };
}

} // namespace skyseal::crypto
