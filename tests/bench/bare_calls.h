// The library calls that a record cannot do without, per suite: what sealing and opening are measured against. "bare" is:
// AEAD, the library's one-shot call (libsodium) or nonce, associated data, text and tag (OpenSSL); others, the cipher's own
// call and the HMAC over the record's bytes, from copied hash states. The IV of AES-CBC is given to the bare call: that the
// record has to make one, unpredictable, is not counted in its favour. RC4 takes a new key and drops 768 bytes each time.
#pragma once

#include "core/crypto/suite.h"

#include <openssl/evp.h>
#include <openssl/provider.h>
#include <openssl/sha.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>

namespace skyseal::bench {

using crypto::SuiteId;

inline constexpr std::size_t kAssociatedSize = 9; // first byte, connection id, counter, suite, direction, carrier
inline constexpr std::array<std::size_t, 4> kSizes{9, 28, 64, 255};

/// The bytes and keys that a bare call works on; their values do not matter for its time.
struct Material
{
    std::array<std::uint8_t, 32> key{};
    std::array<std::uint8_t, 16> nonce{};
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::array<std::uint8_t, 512> text{};
    std::array<std::uint8_t, 32> tag{};
    SHA256_CTX inner{};
    SHA256_CTX outer{};

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

/// One bare call of so many bytes.
using BareCall = std::function<void(std::size_t size)>;

enum class CipherUse { Encrypt, Decrypt };

inline EVP_CIPHER_CTX *keyed(EVP_CIPHER *cipher, const Material &m, bool rc4 = false, CipherUse use = CipherUse::Encrypt)
{
    const int encrypt = use == CipherUse::Encrypt ? 1 : 0;
    EVP_CIPHER_CTX *context = EVP_CIPHER_CTX_new();
    EVP_CipherInit_ex2(context, cipher, nullptr, nullptr, encrypt, nullptr);
    if (rc4)
        EVP_CIPHER_CTX_set_key_length(context, 32);
    EVP_CipherInit_ex2(context, nullptr, m.key.data(), m.nonce.data(), encrypt, nullptr);
    if (EVP_CIPHER_get_block_size(cipher) > 1)
        EVP_CIPHER_CTX_set_padding(context, 0);
    return context;
}

inline BareCall bareCipher(SuiteId suite, Material &m, CipherUse use = CipherUse::Encrypt)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20) {
        return [&m](std::size_t n) {
            crypto_stream_chacha20_ietf_xor(m.text.data(), m.text.data(), n, m.nonce.data(), m.key.data());
        };
    }
    if (suite == SuiteId::Aes256Ctr || suite == SuiteId::Aes256Cbc) {
        EVP_CIPHER_CTX *context =
            keyed(EVP_CIPHER_fetch(nullptr, suite == SuiteId::Aes256Ctr ? "AES-256-CTR" : "AES-256-CBC", nullptr), m, false, use);
        const bool blocks = suite == SuiteId::Aes256Cbc;
        return [&m, context, blocks, written](std::size_t n) mutable {
            EVP_CipherInit_ex2(context, nullptr, nullptr, m.nonce.data(), -1, nullptr);
            const std::size_t size = blocks ? (n / 16 + 1) * 16 : n;
            EVP_CipherUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(size));
        };
    }
    OSSL_LIB_CTX *library = OSSL_LIB_CTX_new();
    OSSL_PROVIDER_load(library, "legacy");
    EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(library, "RC4", nullptr), m, true);
    return [&m, context, written](std::size_t n) mutable {
        std::array<std::uint8_t, 768> dropped;
        EVP_EncryptInit_ex2(context, nullptr, m.key.data(), nullptr, nullptr);
        EVP_EncryptUpdate(context, dropped.data(), &written, dropped.data(), static_cast<int>(dropped.size()));
        EVP_EncryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
    };
}

inline BareCall bareSeal(SuiteId suite, Material &m)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20Poly1305) {
        return [&m](std::size_t n) {
            crypto_aead_chacha20poly1305_ietf_encrypt(m.text.data(), nullptr, m.text.data(), n, m.associated.data(),
                                                      m.associated.size(), nullptr, m.nonce.data(), m.key.data());
        };
    }
    if (suite == SuiteId::Aes256Gcm) {
        EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr), m);
        return [&m, context, written](std::size_t n) mutable {
            EVP_EncryptInit_ex2(context, nullptr, nullptr, m.nonce.data(), nullptr);
            EVP_EncryptUpdate(context, nullptr, &written, m.associated.data(), static_cast<int>(m.associated.size()));
            EVP_EncryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
            EVP_EncryptFinal_ex(context, m.tag.data(), &written);
            EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_GET_TAG, 16, m.tag.data());
        };
    }
    const bool blocks = suite == SuiteId::Aes256Cbc;
    return [cipher = bareCipher(suite, m), &m, blocks](std::size_t n) {
        cipher(n);
        m.hmac(blocks ? (n / 16 + 1) * 16 : n);
    };
}

/// As `open` is measured: from a fresh copy of sealed bytes, since it works in place.
inline BareCall bareOpen(SuiteId suite, Material &m)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20Poly1305) {
        return [&m, sealed = std::array<std::uint8_t, 512>{}, sealedSize = std::size_t(0)](std::size_t n) mutable {
            if (sealedSize != n) {
                crypto_aead_chacha20poly1305_ietf_encrypt(sealed.data(), nullptr, sealed.data(), n, m.associated.data(),
                                                          m.associated.size(), nullptr, m.nonce.data(), m.key.data());
                sealedSize = n;
            }
            std::copy_n(sealed.begin(), n + 16, m.text.begin());
            if (crypto_aead_chacha20poly1305_ietf_decrypt(m.text.data(), nullptr, nullptr, m.text.data(), n + 16, m.associated.data(),
                                                          m.associated.size(), m.nonce.data(), m.key.data()) != 0)
                std::abort();
        };
    }
    if (suite == SuiteId::Aes256Gcm) {
        EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr), m);
        return [&m, context, written, sealed = std::array<std::uint8_t, 512>{}](std::size_t n) mutable {
            std::copy_n(sealed.begin(), n + 16, m.text.begin());
            EVP_DecryptInit_ex2(context, nullptr, nullptr, m.nonce.data(), nullptr);
            EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_SET_TAG, 16, m.text.data() + n);
            EVP_DecryptUpdate(context, nullptr, &written, m.associated.data(), static_cast<int>(m.associated.size()));
            EVP_DecryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
            EVP_DecryptFinal_ex(context, m.tag.data(), &written); // refuses, which takes as long
        };
    }
    const bool blocks = suite == SuiteId::Aes256Cbc;
    return [cipher = bareCipher(suite, m, CipherUse::Decrypt), &m, blocks, sealed = std::array<std::uint8_t, 512>{}](std::size_t n) {
        const std::size_t size = blocks ? (n / 16 + 1) * 16 : n;
        std::copy_n(sealed.begin(), size + 16, m.text.begin());
        m.hmac(size);
        cipher(n);
    };
}

} // namespace skyseal::bench
