#include "core/mavlink/frame_scanner.h"

#include "core/mavlink/frame_reader.h"

namespace skyseal::mavlink {

Result<Frame, FrameError> FrameScanner::readAt(std::size_t offset)
{
    return FrameReader::read(m_buffer.subspan(offset), *m_dialect,
                             [&](ByteView covered, std::uint8_t crcExtra, std::uint16_t expected) {
                                 const std::size_t at = m_streamOffset + offset + 1;
                                 if (m_crc.affords(at, covered.size(), m_streamOffset + m_buffer.size()))
                                     return m_crc.matches(at, covered, crcExtra, expected);
                                 ++m_passedOver;
                                 return false;
                             });
}

std::optional<ScanItem> FrameScanner::next()
{
    if (m_position >= m_buffer.size())
        return std::nullopt;
    const auto frame = readAt(m_position);
    if (frame) {
        const ScanItem item{*frame, {}, m_position, frame->bytes()};
        m_position += frame->bytes().size();
        return item;
    }
    const auto [fault, length] = frame.error();
    switch (fault) {
    case FrameFault::UnknownIncompatFlags: return bad(fault, m_position + length); // its checksum verifies its length
    case FrameFault::UnknownMessage: {
        // The length is not verified: accept it if the buffer ends there or another frame follows, and no valid frame is
        // inside.
        const std::size_t end = m_position + length;
        if (end != m_buffer.size() && !isMagic(m_buffer[end]))
            return bad(FrameFault::Garbage, nextStart(m_position + 1));
        const std::size_t inner = nextCandidate(m_position + 1, end);
        return bad(inner == end ? fault : FrameFault::Garbage, inner);
    }
    case FrameFault::BadCrc: return bad(fault, nextCandidate(m_position + 1, m_position + length));
    case FrameFault::Truncated:
        if (m_end == BufferEnd::Open)
            return std::nullopt;
        return bad(fault, nextCandidate(m_position + 1, m_buffer.size()));
    default: return bad(FrameFault::Garbage, nextStart(m_position + 1));
    }
}

/// The first offset in [from, limit) at which a valid frame begins, or may turn out to begin when more bytes have
/// arrived; `limit` if there is none.
std::size_t FrameScanner::nextCandidate(std::size_t from, std::size_t limit)
{
    m_crc.expectOverlap();
    for (std::size_t at = from; at < limit; ++at) {
        if (!isMagic(m_buffer[at]))
            continue;
        const auto frame = readAt(at);
        if (frame || (m_end == BufferEnd::Open && frame.error().fault == FrameFault::Truncated))
            return at;
    }
    return limit;
}

/// The first offset from `from` at which a frame might begin.
std::size_t FrameScanner::nextStart(std::size_t from) const
{
    while (from < m_buffer.size() && !isMagic(m_buffer[from]))
        ++from;
    return from;
}

ScanItem FrameScanner::bad(FrameFault fault, std::size_t end)
{
    const ScanItem item{std::nullopt, fault, m_position, m_buffer.subspan(m_position, end - m_position)};
    m_position = end;
    return item;
}

} // namespace skyseal::mavlink
