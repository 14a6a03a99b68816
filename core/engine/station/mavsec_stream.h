// Decrypts the stream of the autopilot that was published with the paper MAVSec (2019): frames with an encrypted payload and
// the checksum of the encrypted frame. INSECURE (core/crypto/mavsec_cipher.h); nothing is sent on such a link.
#pragma once

#include "core/mavlink/frame.h"

#include <array>
#include <memory>

namespace skyseal::crypto {
class MavsecCipher;
}

namespace skyseal::engine {

class MavsecStream
{
public:
    /// `dialect` must outlive this object.
    MavsecStream(crypto::MavsecCipher cipher, const mavlink::Dialect &dialect);
    MavsecStream(MavsecStream &&) noexcept;
    MavsecStream &operator=(MavsecStream &&) noexcept;
    ~MavsecStream();

    /// Returns the decrypted frame, MAVLink 1 or 2, with a checksum of its own; valid until the next call. A wrong key, or a
    /// frame that was not encrypted, cannot be detected.
    mavlink::Frame open(const mavlink::Frame &encrypted);

private:
    std::unique_ptr<crypto::MavsecCipher> m_cipher;
    const mavlink::Dialect *m_dialect;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> m_frame{};
};

} // namespace skyseal::engine
