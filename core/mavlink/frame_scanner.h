// Splits a buffer into valid frames and the damaged regions between them.
#pragma once

#include "core/mavlink/frame.h"
#include "core/mavlink/overlapping_crc.h"

#include <optional>

namespace skyseal::mavlink {

/// A valid frame or a damaged region.
struct ScanItem
{
    std::optional<Frame> frame;
    FrameFault fault{}; ///< when there is no frame
    std::size_t offset = 0;
    ByteView bytes; ///< of the frame or the damaged region; an UnknownMessage is whole and may be forwarded
};

/// Meaning of the end of a buffer.
enum class BufferEnd : std::uint8_t {
    Final, ///< no more bytes: a datagram, or a stream that has ended
    Open   ///< more bytes may follow: an incomplete frame is left for later
};

/// Resynchronises by trying every later byte, so that no valid frame after damage is lost, even if the damaged header claims
/// a wrong length. Each byte is tried once and goes through the CRC about once, regardless of the content (OverlappingCrc). If
/// its work is limited, a frame that would exceed the limit is skipped as if its checksum were wrong.
class FrameScanner
{
public:
    /// For an independent buffer, such as a datagram.
    explicit FrameScanner(ByteView buffer, const Dialect &dialect, BufferEnd end = BufferEnd::Final,
                          WastedWork limit = WastedWork::Unlimited)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end), m_ownCrc(limit), m_crc(m_ownCrc), m_streamOffset(0)
    {}
    /// For the next part of a stream, which begins at `offset` of it. `crc` is that of the stream and must outlive this object.
    FrameScanner(ByteView buffer, const Dialect &dialect, BufferEnd end, OverlappingCrc &crc, std::size_t offset)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end), m_crc(crc), m_streamOffset(offset)
    {}
    FrameScanner(const FrameScanner &) = delete;
    FrameScanner &operator=(const FrameScanner &) = delete;

    /// The next item; nullopt at the end. A frame cut by a final end is reported as Truncated, with its remaining
    /// bytes; at an open end `position()` stays before it.
    std::optional<ScanItem> next();

    /// Position of the next item.
    std::size_t position() const { return m_position; }
    /// The number of bytes that went through the CRC: the measure of the work.
    std::uint64_t crcBytes() const { return m_crc.bytesProcessed(); }
    /// The number of possible frames that were not checked, because of the limit.
    std::size_t passedOver() const { return m_passedOver; }

private:
    Result<Frame, FrameError> readAt(std::size_t offset);
    std::size_t nextCandidate(std::size_t from, std::size_t limit);
    std::size_t nextStart(std::size_t from) const;
    ScanItem bad(FrameFault fault, std::size_t end);

    ByteView m_buffer;
    const Dialect *m_dialect;
    std::size_t m_position = 0;
    BufferEnd m_end;
    OverlappingCrc m_ownCrc; ///< unused for a stream
    OverlappingCrc &m_crc;
    std::size_t m_streamOffset; ///< of the buffer
    std::size_t m_passedOver = 0;
};

} // namespace skyseal::mavlink
