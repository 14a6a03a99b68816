// Decrypts the stream of the autopilot that was published with the paper MAVSec (2019): frames with an encrypted payload and
// the checksum of the encrypted frame. INSECURE (core/crypto/mavsec_cipher.h). The same operation encrypts, for the simulator.
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
    mavlink::Frame open(const mavlink::Frame &encrypted) { return passed(encrypted); }
    /// The encrypted frame, valid until the next call. A signature stays as it was: that of the clear frame.
    mavlink::Frame seal(const mavlink::Frame &clear) { return passed(clear); }

private:
    mavlink::Frame passed(const mavlink::Frame &from);

    std::unique_ptr<crypto::MavsecCipher> m_cipher;
    const mavlink::Dialect *m_dialect;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> m_frame{};
};

} // namespace skyseal::engine
