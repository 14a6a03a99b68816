// Extracts frames from a byte stream that arrives in pieces (TCP, serial line): keeps an incomplete frame until its end
// arrives.
#pragma once

#include "core/mavlink/frame_scanner.h"

#include <algorithm>
#include <array>
#include <concepts>

namespace skyseal::mavlink {

class StreamParser
{
public:
    explicit StreamParser(const Dialect &dialect, WastedWork limit = WastedWork::OfStream) : m_dialect(&dialect), m_crc(limit)
    {}

    /// Takes the next piece and calls `deliver(const ScanItem &)` for each complete item; views are valid during that
    /// call. Offsets count from the beginning of the stream.
    template<std::invocable<const ScanItem &> Deliver> void feed(ByteView piece, Deliver &&deliver)
    {
        while (!piece.empty()) {
            const ByteView taken = piece.first(std::min(piece.size(), m_buffer.size() - m_size));
            std::copy(taken.begin(), taken.end(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_size));
            m_size += taken.size();
            piece = piece.subspan(taken.size());
            deliverComplete(deliver, BufferEnd::Open);
        }
    }

    /// The stream has ended: reports the rest as damaged.
    template<std::invocable<const ScanItem &> Deliver> void finish(Deliver &&deliver)
    {
        deliverComplete(deliver, BufferEnd::Final);
        reset();
    }

    /// Drops an incomplete frame; offsets continue.
    void reset()
    {
        m_streamOffset += m_size;
        m_size = 0;
    }

    /// The number of bytes of the stream that went through the CRC: the measure of the work.
    std::uint64_t crcBytes() const { return m_crc.bytesProcessed(); }
    /// As FrameScanner::passedOver().
    std::size_t passedOver() const { return m_passedOver; }

private:
    template<typename Deliver> void deliverComplete(Deliver &deliver, BufferEnd end)
    {
        FrameScanner scanner(ByteView(m_buffer.data(), m_size), *m_dialect, end, m_crc, m_streamOffset);
        while (std::optional<ScanItem> item = scanner.next()) {
            item->offset += m_streamOffset;
            deliver(static_cast<const ScanItem &>(*item));
        }
        m_passedOver += scanner.passedOver();
        const std::size_t used = scanner.position();
        m_streamOffset += used;
        m_size -= used;
        std::copy_n(m_buffer.begin() + static_cast<std::ptrdiff_t>(used), m_size, m_buffer.begin());
    }

    const Dialect *m_dialect;
    std::array<std::uint8_t, 4096> m_buffer;
    std::size_t m_size = 0; ///< at most kMaxFrameLength between two calls
    std::size_t m_streamOffset = 0;
    OverlappingCrc m_crc;
    std::size_t m_passedOver = 0;
};

} // namespace skyseal::mavlink
