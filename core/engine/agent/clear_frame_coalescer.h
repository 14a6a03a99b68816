// Coalesces the clear frames of one wake-up into datagrams as large as those of a session: a comparison of a sealed link with
// plain MAVLink must measure the sealing, not the number of datagrams. I/O thread; nothing is allocated.
#pragma once

#include "core/channel/sealed.h"
#include "core/engine/common/link_pool.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace skyseal::engine {

class ClearFrameCoalescer
{
public:
    static constexpr std::size_t kRoom = channel::kMaxRecordPayload;

    ClearFrameCoalescer(LinkPool &links, std::vector<Path> to) : m_links(links), m_to(std::move(to)) {}

    /// Adds a whole frame of at most kRoom bytes.
    void add(ByteView frame)
    {
        if (frame.size() > kRoom - m_size)
            flush();
        std::copy(frame.begin(), frame.end(), m_bytes.begin() + static_cast<std::ptrdiff_t>(m_size));
        m_size += frame.size();
    }

    /// Call at the end of each wake-up.
    void flush()
    {
        const ByteView frames = ByteView(m_bytes).first(std::exchange(m_size, 0));
        if (frames.empty())
            return;
        for (const Path &path : m_to)
            m_links.send(path, frames);
    }

private:
    LinkPool &m_links;
    const std::vector<Path> m_to;
    std::size_t m_size = 0;
    std::array<std::uint8_t, kRoom> m_bytes;
};

} // namespace skyseal::engine
