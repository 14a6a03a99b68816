// OpenSSL 3 deprecates the only functions whose SHA-256 state can be copied without an allocation.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/experiment/bare_calls.h"

#include <openssl/evp.h>
#include <openssl/provider.h>
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace skyseal::experiment {

namespace {

using crypto::HmacSha256Tag;
using crypto::OpensslAead;
using crypto::OpensslCipher;
using crypto::SodiumAead;
using crypto::SodiumStream;
using crypto::SuiteId;
using crypto::SuiteInfo;

constexpr std::size_t kTag = 16;

struct FreeContext
{
    void operator()(EVP_CIPHER_CTX *context) const { EVP_CIPHER_CTX_free(context); }
};
using Context = std::shared_ptr<EVP_CIPHER_CTX>;

/// The buffers and keys of a call. The values do not change its time.
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

/// OpenSSL's legacy provider in a library context of its own, loaded until the program ends; null if it is missing.
OSSL_LIB_CTX *legacyLibrary()
{
    static OSSL_LIB_CTX *const library = [] {
        OSSL_LIB_CTX *made = OSSL_LIB_CTX_new();
        return OSSL_PROVIDER_load(made, "legacy") ? made : nullptr;
    }();
    return library;
}

/// A context for a cipher by its name, keyed; null if OpenSSL does not provide it.
Context keyed(const OpensslCipher &primitive, const Material &material, RecordOperation operation)
{
    if (!primitive.name)
        return nullptr;
    EVP_CIPHER *cipher = EVP_CIPHER_fetch(primitive.legacy ? legacyLibrary() : nullptr, primitive.name, nullptr);
    if (!cipher)
        return nullptr;
    Context context(EVP_CIPHER_CTX_new(), FreeContext());
    const int encrypt = operation == RecordOperation::Seal ? 1 : 0;
    EVP_CipherInit_ex2(context.get(), cipher, nullptr, nullptr, encrypt, nullptr);
    if (primitive.keyedPerRecord)
        EVP_CIPHER_CTX_set_key_length(context.get(), static_cast<int>(material.key.size()));
    EVP_CipherInit_ex2(context.get(), nullptr, material.key.data(), material.nonce.data(), encrypt, nullptr);
    if (EVP_CIPHER_get_block_size(cipher) > 1)
        EVP_CIPHER_CTX_set_padding(context.get(), 0);
    EVP_CIPHER_free(cipher);
    return context;
}

// The cipher alone, one function for each kind of primitive. `suite` gives the lengths.

BareCall cipherCall(const OpensslCipher &primitive, const SuiteInfo &suite, const SharedMaterial &m, RecordOperation operation)
{
    const Context context = keyed(primitive, *m, operation);
    if (!context)
        return {};
    if (primitive.keyedPerRecord) {
        return [m, context, discarded = std::vector<std::uint8_t>(primitive.discardedBytes)](std::size_t size) mutable {
            int written = 0;
            EVP_EncryptInit_ex2(context.get(), nullptr, m->key.data(), nullptr, nullptr);
            EVP_EncryptUpdate(context.get(), discarded.data(), &written, discarded.data(), static_cast<int>(discarded.size()));
            EVP_EncryptUpdate(context.get(), m->text.data(), &written, m->text.data(), static_cast<int>(size));
        };
    }
    return [m, context, &suite](std::size_t size) {
        int written = 0;
        const int length = static_cast<int>(suite.ciphertextSize(size));
        EVP_CipherInit_ex2(context.get(), nullptr, nullptr, m->nonce.data(), -1, nullptr);
        EVP_CipherUpdate(context.get(), m->text.data(), &written, m->text.data(), length);
    };
}

BareCall cipherCall(const SodiumStream &primitive, const SuiteInfo &, const SharedMaterial &m, RecordOperation)
{
    return [m, primitive](std::size_t size) {
        primitive.apply(m->text.data(), m->text.data(), size, m->nonce.data(), m->key.data());
    };
}

BareCall cipherOn(const SharedMaterial &m, const SuiteInfo &suite, RecordOperation operation)
{
    return std::visit([&](const auto &primitive) { return cipherCall(primitive, suite, m, operation); },
                      suite.primitives.cipher);
}

// Cipher and authentication, one function for each kind of primitive.

BareCall recordCall(HmacSha256Tag, const SuiteInfo &suite, const SharedMaterial &m, RecordOperation operation)
{
    const BareCall cipher = cipherOn(m, suite, operation);
    if (!cipher)
        return {};
    if (operation == RecordOperation::Seal) {
        return [cipher, m, &suite](std::size_t size) {
            cipher(size);
            m->hmac(suite.ciphertextSize(size));
        };
    }
    return [cipher, m, &suite](std::size_t size) {
        std::copy_n(m->sealed.begin(), suite.ciphertextSize(size) + kTag, m->text.begin());
        m->hmac(suite.ciphertextSize(size));
        cipher(size);
    };
}

BareCall recordCall(const SodiumAead &aead, const SuiteInfo &, const SharedMaterial &m, RecordOperation operation)
{
    const auto sealInto = [aead, m](std::uint8_t *out, std::size_t size) {
        aead.seal(out, nullptr, out, size, m->associated.data(), m->associated.size(), nullptr, m->nonce.data(), m->key.data());
    };
    if (operation == RecordOperation::Seal)
        return [m, sealInto](std::size_t size) { sealInto(m->text.data(), size); };
    return [aead, m, sealInto, sealedSize = std::size_t(0)](std::size_t size) mutable {
        if (sealedSize != size) { // a correct tag: with a wrong one the call would return early
            sealInto(m->sealed.data(), size);
            sealedSize = size;
        }
        std::copy_n(m->sealed.begin(), size + kTag, m->text.begin());
        const int refused = aead.open(m->text.data(), nullptr, nullptr, m->text.data(), size + kTag, m->associated.data(),
                                      m->associated.size(), m->nonce.data(), m->key.data());
        m->tag[0] = static_cast<std::uint8_t>(refused);
    };
}

BareCall recordCall(const OpensslAead &aead, const SuiteInfo &, const SharedMaterial &m, RecordOperation operation)
{
    const Context keyedContext = keyed({.name = aead.name}, *m, operation);
    if (!keyedContext)
        return {};
    if (operation == RecordOperation::Seal) {
        return [m, keyedContext](std::size_t size) {
            int written = 0;
            EVP_CIPHER_CTX *const context = keyedContext.get();
            EVP_EncryptInit_ex2(context, nullptr, nullptr, m->nonce.data(), nullptr);
            EVP_EncryptUpdate(context, nullptr, &written, m->associated.data(), static_cast<int>(m->associated.size()));
            EVP_EncryptUpdate(context, m->text.data(), &written, m->text.data(), static_cast<int>(size));
            EVP_EncryptFinal_ex(context, m->tag.data(), &written);
            EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_GET_TAG, static_cast<int>(kTag), m->tag.data());
        };
    }
    return [m, keyedContext](std::size_t size) {
        int written = 0;
        EVP_CIPHER_CTX *const context = keyedContext.get();
        std::copy_n(m->sealed.begin(), size + kTag, m->text.begin());
        EVP_DecryptInit_ex2(context, nullptr, nullptr, m->nonce.data(), nullptr);
        EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_SET_TAG, static_cast<int>(kTag), m->text.data() + size);
        EVP_DecryptUpdate(context, nullptr, &written, m->associated.data(), static_cast<int>(m->associated.size()));
        EVP_DecryptUpdate(context, m->text.data(), &written, m->text.data(), static_cast<int>(size));
        EVP_DecryptFinal_ex(context, m->tag.data(), &written); // the tag is wrong, which takes as long
    };
}

} // namespace

BareCall bareCipher(SuiteId suite, RecordOperation operation)
{
    return cipherOn(std::make_shared<Material>(), crypto::suiteInfo(suite), operation);
}

BareCall bareRecord(SuiteId suite, RecordOperation operation)
{
    const SuiteInfo &info = crypto::suiteInfo(suite);
    const auto m = std::make_shared<Material>();
    return std::visit([&](const auto &primitive) { return recordCall(primitive, info, m, operation); },
                      info.primitives.authentication);
}

} // namespace skyseal::experiment
