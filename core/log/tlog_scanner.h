// Splits a buffer of a .tlog into entries and resynchronizes behind damage.
#pragma once

#include "core/log/tlog_entry.h"
#include "core/mavlink/frame_scanner.h"

namespace skyseal::tlog {

/// A frame with its time, or a damaged spot.
struct TlogItem
{
    std::optional<mavlink::Frame> frame;
    mavlink::FrameFault fault{};  ///< set if there is no frame
    std::optional<WallTime> time; ///< of a frame with an intact timestamp, or of a spot with a known length
    std::size_t offset = 0;
    std::size_t length = 0; ///< of the entry including its timestamp, or of the damaged spot
    ByteView bytes;         ///< of the frame, or of the damaged spot without its timestamp
};

/// Finds every valid frame, even if its timestamp or the entry before it is damaged.
class TlogScanner
{
public:
    TlogScanner(ByteView buffer, const mavlink::Dialect &dialect, mavlink::BufferEnd end)
        : m_buffer(buffer), m_dialect(&dialect), m_end(end)
    {}

    /// Returns the next item; nullopt at the end of the buffer, or when an open buffer needs more bytes first.
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
