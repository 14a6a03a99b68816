// Encodes .tlog entries for a sink. Owns no file and no thread; those belong to the recorder in core/engine.
#pragma once

#include "core/log/tlog_entry.h"
#include "core/mavlink/frame.h"

#include <array>
#include <concepts>

namespace skyseal::tlog {

/// Calls `sink(ByteView)` with one complete entry at a time; the view is valid during the call. The sink returns false when
/// it failed.
template<std::predicate<ByteView> Sink> class TlogWriter
{
public:
    explicit TlogWriter(Sink sink) : m_sink(std::move(sink)) {}

    /// Returns false when the sink failed or the frame is longer than kMaxFrameLength.
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
