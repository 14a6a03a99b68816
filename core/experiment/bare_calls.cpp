// SHA-256's states can be copied only through the functions that OpenSSL 3 calls deprecated.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/experiment/bare_calls.h"

#include <openssl/evp.h>
#include <openssl/provider.h>
#include <openssl/sha.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace skyseal::experiment {

namespace {

using crypto::SuiteId;

constexpr std::size_t kAssociated = 9; // first byte, connection id, counter, suite, direction, carrier
constexpr std::size_t kTag = 16;

struct FreeContext
{
    void operator()(EVP_CIPHER_CTX *context) const { EVP_CIPHER_CTX_free(context); }
};
using Context = std::shared_ptr<EVP_CIPHER_CTX>;

/// Bytes and keys that a call works on; their values do not matter for its time.
struct Material
{
    std::array<std::uint8_t, 32> key{};
    std::array<std::uint8_t, 16> nonce{};
    std::array<std::uint8_t, kAssociated> associated{};
    std::array<std::uint8_t, kMostBareBytes + 64> text{}, sealed{};
    std::array<std::uint8_t, 32> tag{};
    SHA256_CTX inner{}, outer{};

    Material()
    {
        std::array<std::uint8_t, 64> pad{};
        SHA256_Init(&inner);
        SHA256_Update(&inner, pad.data(), pad.size());
        outer = inner;
    }

    void hmac(std::size_t size)
    {
        SHA256_CTX state = inner;
        SHA256_Update(&state, associated.data(), associated.size());
        SHA256_Update(&state, text.data(), size);
        SHA256_Final(tag.data(), &state);
        state = outer;
        SHA256_Update(&state, tag.data(), tag.size());
        SHA256_Final(tag.data(), &state);
    }
};

using SharedMaterial = std::shared_ptr<Material>;

/// RC4 lives in a provider of its own, in a library context of its own, kept as long as the program runs.
OSSL_LIB_CTX *legacyLibrary()
{
    static OSSL_LIB_CTX *const library = [] {
        OSSL_LIB_CTX *made = OSSL_LIB_CTX_new();
        return OSSL_PROVIDER_load(made, "legacy") ? made : nullptr;
    }();
    return library;
}

Context keyed(const char *name, const Material &material, Direction direction)
{
    const bool legacy = std::string_view(name) == "RC4";
    EVP_CIPHER *cipher = EVP_CIPHER_fetch(legacy ? legacyLibrary() : nullptr, name, nullptr);
    if (!cipher)
        return nullptr;
    const Context context(EVP_CIPHER_CTX_new(), FreeContext());
    const int encrypt = direction == Direction::Seal ? 1 : 0;
    EVP_CipherInit_ex2(context.get(), cipher, nullptr, nullptr, encrypt, nullptr);
    if (legacy)
        EVP_CIPHER_CTX_set_key_length(context.get(), 32);
    EVP_CipherInit_ex2(context.get(), nullptr, material.key.data(), material.nonce.data(), encrypt, nullptr);
    if (EVP_CIPHER_get_block_size(cipher) > 1)
        EVP_CIPHER_CTX_set_padding(context.get(), 0);
    EVP_CIPHER_free(cipher);
    return context;
}

std::size_t padded(SuiteId suite, std::size_t size)
{
    return suite == SuiteId::Aes256Cbc ? (size / 16 + 1) * 16 : size;
}

BareCall rc4(const SharedMaterial &m)
{
    const Context context = keyed("RC4", *m, Direction::Seal);
    if (!context)
        return {};
    return [m, context](std::size_t size) {
        int written = 0;
        std::array<std::uint8_t, 768> dropped;
        EVP_EncryptInit_ex2(context.get(), nullptr, m->key.data(), nullptr, nullptr);
        EVP_EncryptUpdate(context.get(), dropped.data(), &written, dropped.data(), static_cast<int>(dropped.size()));
        EVP_EncryptUpdate(context.get(), m->text.data(), &written, m->text.data(), static_cast<int>(size));
    };
}

BareCall aes(const SharedMaterial &m, SuiteId suite, Direction direction)
{
    const Context context = keyed(suite == SuiteId::Aes256Cbc ? "AES-256-CBC" : "AES-256-CTR", *m, direction);
    if (!context)
        return {};
    return [m, context, suite](std::size_t size) {
        int written = 0;
        EVP_CipherInit_ex2(context.get(), nullptr, nullptr, m->nonce.data(), -1, nullptr);
        EVP_CipherUpdate(context.get(), m->text.data(), &written, m->text.data(), static_cast<int>(padded(suite, size)));
    };
}

BareCall cipherOn(const SharedMaterial &m, SuiteId suite, Direction direction)
{
    switch (suite) {
    case SuiteId::ChaCha20:
    case SuiteId::ChaCha20Poly1305:
        return [m](std::size_t size) {
            crypto_stream_chacha20_ietf_xor(m->text.data(), m->text.data(), size, m->nonce.data(), m->key.data());
        };
    case SuiteId::Aes256Gcm: // counter mode inside
    case SuiteId::Aes256Ctr:
    case SuiteId::Aes256Cbc: return aes(m, suite, direction);
    case SuiteId::Rc4: return rc4(m);
    case SuiteId::None: break;
    }
    return {};
}

BareCall chachaPoly(const SharedMaterial &m, Direction direction)
{
    if (direction == Direction::Seal) {
        return [m](std::size_t size) {
            crypto_aead_chacha20poly1305_ietf_encrypt(m->text.data(), nullptr, m->text.data(), size, m->associated.data(),
                                                      m->associated.size(), nullptr, m->nonce.data(), m->key.data());
        };
    }
    return [m, sealedSize = std::size_t(0)](std::size_t size) mutable {
        if (sealedSize != size) { // a tag that is right: a wrong one would end it early
            crypto_aead_chacha20poly1305_ietf_encrypt(m->sealed.data(), nullptr, m->sealed.data(), size, m->associated.data(),
                                                      m->associated.size(), nullptr, m->nonce.data(), m->key.data());
            sealedSize = size;
        }
        std::copy_n(m->sealed.begin(), size + kTag, m->text.begin());
        const int refused = crypto_aead_chacha20poly1305_ietf_decrypt(m->text.data(), nullptr, nullptr, m->text.data(),
                                                                      size + kTag, m->associated.data(), m->associated.size(),
                                                                      m->nonce.data(), m->key.data());
        m->tag[0] = static_cast<std::uint8_t>(refused);
    };
}

BareCall gcm(const SharedMaterial &m, Direction direction)
{
    const Context context = keyed("AES-256-GCM", *m, direction);
    if (!context)
        return {};
    if (direction == Direction::Seal) {
        return [m, context](std::size_t size) {
            int written = 0;
            EVP_CIPHER_CTX *const gcm = context.get();
            EVP_EncryptInit_ex2(gcm, nullptr, nullptr, m->nonce.data(), nullptr);
            EVP_EncryptUpdate(gcm, nullptr, &written, m->associated.data(), static_cast<int>(m->associated.size()));
            EVP_EncryptUpdate(gcm, m->text.data(), &written, m->text.data(), static_cast<int>(size));
            EVP_EncryptFinal_ex(gcm, m->tag.data(), &written);
            EVP_CIPHER_CTX_ctrl(gcm, EVP_CTRL_AEAD_GET_TAG, static_cast<int>(kTag), m->tag.data());
        };
    }
    return [m, context](std::size_t size) {
        int written = 0;
        EVP_CIPHER_CTX *const gcm = context.get();
        std::copy_n(m->sealed.begin(), size + kTag, m->text.begin());
        EVP_DecryptInit_ex2(gcm, nullptr, nullptr, m->nonce.data(), nullptr);
        EVP_CIPHER_CTX_ctrl(gcm, EVP_CTRL_AEAD_SET_TAG, static_cast<int>(kTag), m->text.data() + size);
        EVP_DecryptUpdate(gcm, nullptr, &written, m->associated.data(), static_cast<int>(m->associated.size()));
        EVP_DecryptUpdate(gcm, m->text.data(), &written, m->text.data(), static_cast<int>(size));
        EVP_DecryptFinal_ex(gcm, m->tag.data(), &written); // refuses, which takes as long
    };
}

} // namespace

BareCall bareCipher(SuiteId suite, Direction direction)
{
    return cipherOn(std::make_shared<Material>(), suite, direction);
}

BareCall bareRecord(SuiteId suite, Direction direction)
{
    const auto m = std::make_shared<Material>();
    if (suite == SuiteId::ChaCha20Poly1305)
        return chachaPoly(m, direction);
    if (suite == SuiteId::Aes256Gcm)
        return gcm(m, direction);
    const BareCall cipher = cipherOn(m, suite, direction);
    if (!cipher)
        return {};
    if (direction == Direction::Seal) {
        return [cipher, m, suite](std::size_t size) {
            cipher(size);
            m->hmac(padded(suite, size));
        };
    }
    return [cipher, m, suite](std::size_t size) {
        std::copy_n(m->sealed.begin(), padded(suite, size) + kTag, m->text.begin());
        m->hmac(padded(suite, size));
        cipher(size);
    };
}

} // namespace skyseal::experiment
