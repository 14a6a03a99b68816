// Walks through a buffer from frame to frame: valid ones, and the spots between them that are not.
#pragma once

#include "core/mavlink/frame.h"

#include <optional>

namespace skyseal::mavlink {

/// A valid frame, or what stands where none is.
struct ScanItem
{
    std::optional<Frame> frame;
    FrameFault fault{}; ///< when there is no frame
    std::size_t offset = 0;
    ByteView bytes; ///< of the frame or of the bad spot; an UnknownMessage is whole and may be forwarded as it is
};

/// What stands behind the end of a buffer.
enum class BufferEnd : std::uint8_t {
    Final, ///< nothing: a datagram, or a stream that has ended
    Open   ///< more bytes may come: a frame that goes on past the end is left for later
};

/// Resynchronises by trying every later byte, so that no valid frame behind damage is lost, whatever length the damage
/// claims.
class FrameScanner
{
public:
    FrameScanner(ByteView buffer, const Dialect &dialect, BufferEnd end = BufferEnd::Final)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end)
    {}

    /// The next item; nullopt at the end. A frame that goes on past a final end is reported as Truncated, with all that is
    /// left of it; at an open end `position()` stays before it.
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
