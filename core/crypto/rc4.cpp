// RC4 with a key of its own for each record and the start of its stream thrown away, then HMAC. Broken as a cipher all the
// same (RFC 7465): it is here to be measured.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/suite_factories.h"

#include <openssl/provider.h>

namespace skyseal::crypto {

namespace {

constexpr std::size_t kDropped = 768;
constexpr int kKeyLength = 32;

/// RC4 lives in OpenSSL's legacy provider, loaded into a library context of our own so that nothing else in the process
/// gets old ciphers to choose from.
class LegacyRc4
{
public:
    LegacyRc4() : m_library(OSSL_LIB_CTX_new())
    {
        m_provider = m_library ? OSSL_PROVIDER_load(m_library, "legacy") : nullptr;
        if (m_provider)
            m_cipher.reset(EVP_CIPHER_fetch(m_library, "RC4", nullptr));
    }
    ~LegacyRc4()
    {
        m_cipher.reset();
        if (m_provider)
            OSSL_PROVIDER_unload(m_provider);
        OSSL_LIB_CTX_free(m_library);
    }
    LegacyRc4(const LegacyRc4 &) = delete;
    LegacyRc4 &operator=(const LegacyRc4 &) = delete;

    const EVP_CIPHER *cipher() const { return m_cipher.get(); }

private:
    OSSL_LIB_CTX *m_library;
    OSSL_PROVIDER *m_provider;
    EvpCipher m_cipher;
};

class Rc4Body : public SameLength
{
public:
    Rc4Body(const DirectionSecret &secret, SuiteId suite) : m_keys(deriveRecordKey(secret, suite, "key").view())
    {
        static const LegacyRc4 legacy;
        if (!legacy.cipher())
            return;
        m_context.reset(EVP_CIPHER_CTX_new());
        if (!m_context || EVP_EncryptInit_ex2(m_context.get(), legacy.cipher(), nullptr, nullptr, nullptr) != 1
            || EVP_CIPHER_CTX_set_key_length(m_context.get(), kKeyLength) != 1)
            m_context.reset();
    }

    bool ready() const { return m_context != nullptr; }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        return crypt(counter, plaintext, out.data());
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return crypt(counter, body, body.data()) ? std::optional(body.size()) : std::nullopt;
    }

private:
    bool crypt(std::uint64_t counter, ByteView in, std::uint8_t *out)
    {
        std::array<std::uint8_t, 8> message;
        storeLittleEndian64(message.data(), counter);
        Key32 key;
        m_keys.compute(key.mutableView(), {message});
        int written = 0;
        return EVP_EncryptInit_ex2(m_context.get(), nullptr, key.view().data(), nullptr, nullptr) == 1
            && EVP_EncryptUpdate(m_context.get(), m_dropped.data(), &written, m_dropped.data(), static_cast<int>(kDropped)) == 1
            && (in.empty() || EVP_EncryptUpdate(m_context.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1);
    }

    HmacSha256 m_keys;
    EvpContext m_context;
    std::array<std::uint8_t, kDropped> m_dropped{};
};

} // namespace

std::unique_ptr<RecordCipher> makeRc4(const DirectionSecret &secret)
{
    return EncryptThenMac<Rc4Body>::make(SuiteId::Rc4, secret);
}

} // namespace skyseal::crypto
