// The stream cipher RC4 with a 256-bit key and the start of its stream thrown away.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/crypto/evp.h"

#include <array>

namespace skyseal::crypto {

class Rc4Stream
{
public:
    static constexpr std::size_t kDropped = 768;

    /// `ready` is false where OpenSSL has no legacy provider.
    Rc4Stream();
    bool ready() const { return m_context != nullptr; }

    /// Writes `in` xor the stream from byte 768 on to `out`, which has the same length and starts with `in` or apart from
    /// it.
    bool crypt(const Key32 &key, ByteView in, std::uint8_t *out);

private:
    EvpContext m_context;
    std::array<std::uint8_t, kDropped> m_dropped{};
};

} // namespace skyseal::crypto
