// OpenSSL calls the SHA256_* functions deprecated in favour of EVP, whose contexts cost more than the hash of a short
// record; nothing else gives out a state that can be copied without an allocation.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/crypto/hmac_sha256.h"

#include "core/base/secret_bytes.h"

#include <algorithm>

namespace skyseal::crypto {

HmacSha256::HmacSha256(ByteView key)
{
    SecretBytes<SHA256_CBLOCK> pad;
    if (key.size() > SHA256_CBLOCK)
        SHA256(key.data(), key.size(), pad.mutableView().data());
    else
        std::copy(key.begin(), key.end(), pad.mutableView().begin());
    for (std::uint8_t &byte : pad.mutableView())
        byte = static_cast<std::uint8_t>(byte ^ 0x36);
    SHA256_Init(&m_inner);
    SHA256_Update(&m_inner, pad.view().data(), SHA256_CBLOCK);
    for (std::uint8_t &byte : pad.mutableView())
        byte = static_cast<std::uint8_t>(byte ^ 0x36 ^ 0x5c);
    SHA256_Init(&m_outer);
    SHA256_Update(&m_outer, pad.view().data(), SHA256_CBLOCK);
}

HmacSha256::~HmacSha256()
{
    sodium_memzero(&m_inner, sizeof m_inner);
    sodium_memzero(&m_outer, sizeof m_outer);
}

void HmacSha256::compute(MutableByteView out, std::initializer_list<ByteView> parts) const
{
    std::array<std::uint8_t, kSha256Length> digest;
    SHA256_CTX state = m_inner;
    for (const ByteView part : parts)
        SHA256_Update(&state, part.data(), part.size());
    SHA256_Final(digest.data(), &state);
    state = m_outer;
    SHA256_Update(&state, digest.data(), digest.size());
    SHA256_Final(digest.data(), &state);
    std::copy_n(digest.begin(), std::min(out.size(), digest.size()), out.begin());
    // What is left of a key in `state` and `digest` are hash outputs behind a one-way function, not the key itself; the
    // whole tag, however, would let its holder forge this one message, so it goes.
    sodium_memzero(digest.data(), digest.size());
}

void hmacSha256(MutableByteView out, ByteView key, std::initializer_list<ByteView> parts)
{
    HmacSha256(key).compute(out, parts);
}

} // namespace skyseal::crypto
