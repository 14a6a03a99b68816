// Reads the stream of the autopilot that was published with the paper MAVSec (2019): frames whose payload is encrypted and
// whose checksum is that of the encrypted frame. INSECURE (core/crypto/mavsec_cipher.h), and read only: a link that is read
// so is never sent to.
#pragma once

#include "core/crypto/mavsec_cipher.h"
#include "core/mavlink/frame.h"

namespace skyseal::engine {

class MavsecStream
{
public:
    /// `dialect` outlives this.
    MavsecStream(crypto::MavsecCipher cipher, const mavlink::Dialect &dialect)
        : m_cipher(std::move(cipher)), m_dialect(&dialect)
    {}

    /// The plain frame of an encrypted one, MAVLink 1 or 2, with a checksum of its own. Nothing tells whether the key was
    /// right, or whether the frame was encrypted at all. Lives until the next call.
    mavlink::Frame open(const mavlink::Frame &encrypted);

private:
    crypto::MavsecCipher m_cipher;
    const mavlink::Dialect *m_dialect;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> m_frame{};
};

} // namespace skyseal::engine
