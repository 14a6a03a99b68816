// The library functions that a cipher suite is built on, as plain data. From them the benchmark derives what a record costs
// at least (core/experiment/bare_calls.h), so that none of its code is linked into the programs that seal records.
#pragma once

#include <cstddef>
#include <variant>

namespace skyseal::crypto {

/// An OpenSSL cipher by the name that EVP_CIPHER_fetch() takes; null: no cipher.
struct OpensslCipher
{
    const char *name = nullptr;
    bool legacy = false;            ///< found in the legacy provider
    bool keyedPerRecord = false;    ///< takes a new key for each record, and no IV
    std::size_t discardedBytes = 0; ///< of the key stream, at the start of each record
};

/// A libsodium stream cipher: output, input, length, 12-byte nonce, 32-byte key.
struct SodiumStream
{
    int (*apply)(unsigned char *, const unsigned char *, unsigned long long, const unsigned char *, const unsigned char *);
};

/// The suite is its cipher, then HMAC-SHA-256 over the ciphertext.
struct HmacSha256Tag
{};

/// An OpenSSL AEAD by name, with a 12-byte nonce and a 16-byte tag.
struct OpensslAead
{
    const char *name;
};

/// A libsodium AEAD in its combined form (ciphertext, then tag), with the library's order of parameters.
struct SodiumAead
{
    int (*seal)(unsigned char *, unsigned long long *, const unsigned char *, unsigned long long, const unsigned char *,
                unsigned long long, const unsigned char *, const unsigned char *, const unsigned char *);
    int (*open)(unsigned char *, unsigned long long *, unsigned char *, const unsigned char *, unsigned long long,
                const unsigned char *, unsigned long long, const unsigned char *, const unsigned char *);
};

struct SuitePrimitives
{
    /// Encryption alone; of an AEAD, the stream cipher inside.
    std::variant<OpensslCipher, SodiumStream> cipher;
    /// How a record is authenticated; an AEAD replaces `cipher` as well.
    std::variant<HmacSha256Tag, OpensslAead, SodiumAead> authentication;
};

} // namespace skyseal::crypto
