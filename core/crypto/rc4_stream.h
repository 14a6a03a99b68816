// The stream cipher RC4 with a 256-bit key; the first 768 bytes of the key stream are discarded.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/crypto/evp.h"

#include <array>

namespace skyseal::crypto {

class Rc4Stream
{
public:
    static constexpr std::size_t kDropped = 768;

    /// ready() is false afterwards if OpenSSL's legacy provider is missing.
    Rc4Stream();
    bool ready() const { return m_context != nullptr; }

    /// Writes `in` xor the key stream from byte 768 on to `out`, which has the same length and either starts at the same
    /// address or does not overlap. Returns false if the library fails.
    bool crypt(const Key32 &key, ByteView in, std::uint8_t *out);

private:
    EvpContext m_context;
    std::array<std::uint8_t, kDropped> m_dropped{};
};

} // namespace skyseal::crypto
