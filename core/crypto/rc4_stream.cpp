#include "core/crypto/rc4_stream.h"

#include <openssl/provider.h>

namespace skyseal::crypto {

namespace {

constexpr int kKeyLength = 32;

/// RC4 from OpenSSL's legacy provider, in a library context of its own, so that the legacy ciphers are not available to the
/// rest of the process.
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

} // namespace

Rc4Stream::Rc4Stream()
{
    static const LegacyRc4 legacy;
    if (!legacy.cipher())
        return;
    m_context.reset(EVP_CIPHER_CTX_new());
    if (!m_context || EVP_EncryptInit_ex2(m_context.get(), legacy.cipher(), nullptr, nullptr, nullptr) != 1
        || EVP_CIPHER_CTX_set_key_length(m_context.get(), kKeyLength) != 1)
        m_context.reset();
}

bool Rc4Stream::crypt(const Key32 &key, ByteView in, std::uint8_t *out)
{
    int written = 0;
    return EVP_EncryptInit_ex2(m_context.get(), nullptr, key.view().data(), nullptr, nullptr) == 1
        && EVP_EncryptUpdate(m_context.get(), m_dropped.data(), &written, m_dropped.data(), static_cast<int>(kDropped)) == 1
        && (in.empty() || EVP_EncryptUpdate(m_context.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1);
}

} // namespace skyseal::crypto
