// Writes a .tlog to whatever takes bytes. It holds no file and no thread: the recorder of the engine brings both.
#pragma once

#include "core/log/tlog_entry.h"
#include "core/mavlink/frame.h"

#include <array>
#include <concepts>

namespace skyseal::tlog {

/// Hands `sink(ByteView)` one complete entry after the other; the view lives during the call. The sink says whether it took
/// it.
template<std::predicate<ByteView> Sink> class TlogWriter
{
public:
    explicit TlogWriter(Sink sink) : m_sink(std::move(sink)) {}

    /// False when the sink refused or the frame is longer than any frame can be.
    bool write(WallTime time, ByteView frame)
    {
        const MutableByteView entry = writeEntry(m_buffer, time, frame);
        if (entry.empty() || !m_sink(ByteView(entry)))
            return false;
        ++m_entries;
        m_bytes += entry.size();
        return true;
    }

    std::uint64_t entries() const { return m_entries; }
    std::uint64_t bytes() const { return m_bytes; }

private:
    Sink m_sink;
    std::array<std::uint8_t, kTimeLength + mavlink::kMaxFrameLength> m_buffer;
    std::uint64_t m_entries = 0;
    std::uint64_t m_bytes = 0;
};

} // namespace skyseal::tlog
