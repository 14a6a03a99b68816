// The share of bytes that the secure channel adds to the frames it carries. Fed with counters at a steady pace; no clock.
#pragma once

#include "core/engine/common/loss_meter.h"

#include <optional>

namespace skyseal::engine {

class OverheadMeter
{
public:
    /// Totals so far: bytes of the channel's datagrams, and of the MAVLink frames in them.
    void note(std::uint64_t wireBytes, std::uint64_t frameBytes)
    {
        m_wire.note(wireBytes);
        m_frames.note(frameBytes);
    }

    /// Percent over the last four readings: 25 means five bytes on the wire for four bytes of frames. nullopt without frames.
    std::optional<double> percent() const
    {
        const auto frames = static_cast<double>(m_frames.value());
        if (frames <= 0)
            return std::nullopt;
        return 100 * (static_cast<double>(m_wire.value()) / frames - 1);
    }

private:
    Growth<4> m_wire, m_frames;
};

} // namespace skyseal::engine
