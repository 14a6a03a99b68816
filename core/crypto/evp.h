// Owning pointers to OpenSSL's ciphers and contexts. Ciphers are fetched once, since fetching by name is the slow part of EVP
// in OpenSSL 3.
#pragma once

#include "core/crypto/locked_allocations.h"

#include <openssl/evp.h>

#include <memory>

namespace skyseal::crypto {

struct EvpDeleter
{
    void operator()(EVP_CIPHER_CTX *context) const { EVP_CIPHER_CTX_free(context); } // wipes the key schedule
    void operator()(EVP_CIPHER *cipher) const { EVP_CIPHER_free(cipher); }
};
using EvpContext = std::unique_ptr<EVP_CIPHER_CTX, EvpDeleter>;
using EvpCipher = std::unique_ptr<EVP_CIPHER, EvpDeleter>;

enum class EvpDirection { Encrypt, Decrypt };

/// A context keyed for one direction; null if OpenSSL refuses.
inline EvpContext makeEvpContext(const EVP_CIPHER *cipher, const std::uint8_t *key, EvpDirection direction)
{
    const LockedAllocations locked;
    EvpContext context(EVP_CIPHER_CTX_new());
    if (!cipher || !context)
        return nullptr;
    if (EVP_CipherInit_ex2(context.get(), cipher, key, nullptr, direction == EvpDirection::Encrypt ? 1 : 0, nullptr) != 1)
        return nullptr;
    return context;
}

} // namespace skyseal::crypto
