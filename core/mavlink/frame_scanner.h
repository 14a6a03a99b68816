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

/// Resynchronises by trying every later byte, so that no valid frame behind damage is lost, whatever length the damage claims.
class FrameScanner
{
public:
    FrameScanner(ByteView buffer, const Dialect &dialect) : m_buffer(buffer), m_dialect(&dialect) {}

    /// The next item; nullopt at the end. A frame that goes on past the end is reported as Truncated, with all that is left of it.
    std::optional<ScanItem> next();

    /// Where the next item begins.
    std::size_t position() const { return m_position; }

private:
    Result<Frame, FrameError> readAt(std::size_t offset) const { return readFrame(m_buffer.subspan(offset), *m_dialect); }
    std::size_t nextValid(std::size_t from, std::size_t limit) const;
    std::size_t nextStart(std::size_t from) const;
    ScanItem bad(FrameFault fault, std::size_t end);

    ByteView m_buffer;
    const Dialect *m_dialect;
    std::size_t m_position = 0;
};

} // namespace skyseal::mavlink
