// HMAC-SHA-256 (RFC 2104, FIPS 198-1) by OpenSSL's EVP_MAC: keyed once, and only reset for each message.
#pragma once

#include "core/base/bytes.h"

#include <openssl/evp.h>

#include <initializer_list>
#include <memory>

namespace skyseal::crypto {

inline constexpr std::size_t kSha256Length = 32;

/// Not for several threads at a time.
class HmacSha256
{
public:
    explicit HmacSha256(ByteView key);

    /// False if OpenSSL refused the algorithm or lacked memory. compute() then fails as well.
    bool ready() const { return m_context != nullptr; }

    /// Writes the MAC of the concatenated parts, truncated to the size of `out` (at most 32 bytes). Returns false, with zeros
    /// in `out`, if the library fails. OpenSSL 3.0 allocates two states of 112 bytes for each MAC, and wipes and releases
    /// them; this code allocates nothing.
    [[nodiscard]] bool compute(MutableByteView out, std::initializer_list<ByteView> parts);

private:
    struct Deleter
    {
        void operator()(EVP_MAC_CTX *context) const { EVP_MAC_CTX_free(context); } // wipes the key and the states
    };
    std::unique_ptr<EVP_MAC_CTX, Deleter> m_context;
};

} // namespace skyseal::crypto
