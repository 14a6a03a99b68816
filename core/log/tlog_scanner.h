// Walks through a buffer of a .tlog from entry to entry, and over what is damaged.
#pragma once

#include "core/log/tlog_entry.h"
#include "core/mavlink/frame_scanner.h"

namespace skyseal::tlog {

/// A frame with its time, or what stands where none is.
struct TlogItem
{
    std::optional<mavlink::Frame> frame;
    mavlink::FrameFault fault{};  ///< when there is no frame
    std::optional<WallTime> time; ///< of a frame, unless its bytes are damaged; of a spot whose extent is sure
    std::size_t offset = 0;
    std::size_t length = 0; ///< of the entry with its time, or of the bad spot
    ByteView bytes;         ///< of the frame, or of the bad spot without its time
};

/// Finds every valid frame, also where its time or the entry before it is damaged.
class TlogScanner
{
public:
    TlogScanner(ByteView buffer, const mavlink::Dialect &dialect, mavlink::BufferEnd end)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end)
    {}

    /// The next item; nullopt at the end, and at an open end when more must come first.
    std::optional<TlogItem> next();

    std::size_t position() const { return m_position; }

private:
    std::optional<TlogItem> damaged(mavlink::FrameFault fault);
    std::optional<TlogItem> unknown(std::size_t length);
    TlogItem take(std::optional<mavlink::Frame> frame, mavlink::FrameFault fault, std::size_t length);

    ByteView m_buffer;
    const mavlink::Dialect *m_dialect;
    mavlink::BufferEnd m_end;
    std::size_t m_position = 0;
};

} // namespace skyseal::tlog
