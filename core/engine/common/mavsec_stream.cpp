#include "core/engine/common/mavsec_stream.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/mavlink/crc.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

MavsecStream::MavsecStream(crypto::MavsecCipher cipher, const mavlink::Dialect &dialect)
    : m_cipher(std::make_unique<crypto::MavsecCipher>(std::move(cipher))), m_dialect(&dialect)
{}

MavsecStream::MavsecStream(MavsecStream &&) noexcept = default;
MavsecStream &MavsecStream::operator=(MavsecStream &&) noexcept = default;
MavsecStream::~MavsecStream() = default;

mavlink::Frame MavsecStream::passed(const mavlink::Frame &from)
{
    const ByteView bytes = from.bytes();
    const MutableByteView frame = MutableByteView(m_frame).first(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.begin());
    const std::size_t header = from.version() == 2 ? 10 : 6;
    const std::size_t end = header + from.payload().size();
    m_cipher->apply(frame.subspan(header, from.payload().size()));
    std::uint16_t crc = mavlink::crcAccumulate(mavlink::kCrcStart, ByteView(frame).subspan(1, end - 1));
    crc = mavlink::crcAccumulate(crc, {&from.info().crcExtra, 1});
    frame[end] = static_cast<std::uint8_t>(crc);
    frame[end + 1] = static_cast<std::uint8_t>(crc >> 8);
    return *mavlink::readFrame(frame, *m_dialect); // the same message, length and flags: it cannot fail
}

} // namespace skyseal::engine
