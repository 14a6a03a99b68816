// Splits a buffer into valid frames and the damaged regions between them.
#pragma once

#include "core/mavlink/frame.h"

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
/// a wrong length.
class FrameScanner
{
public:
    FrameScanner(ByteView buffer, const Dialect &dialect, BufferEnd end = BufferEnd::Final)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end)
    {}

    /// The next item; nullopt at the end. A frame cut by a final end is reported as Truncated, with its remaining
    /// bytes; at an open end `position()` stays before it.
    std::optional<ScanItem> next();

    /// Where the next item begins.
    std::size_t position() const { return m_position; }

private:
    Result<Frame, FrameError> readAt(std::size_t offset) const { return readFrame(m_buffer.subspan(offset), *m_dialect); }
    std::size_t nextCandidate(std::size_t from, std::size_t limit) const;
    std::size_t nextStart(std::size_t from) const;
    ScanItem bad(FrameFault fault, std::size_t end);

    ByteView m_buffer;
    const Dialect *m_dialect;
    std::size_t m_position = 0;
    BufferEnd m_end;
};

} // namespace skyseal::mavlink
