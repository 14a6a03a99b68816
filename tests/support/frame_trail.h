// The frames of one autopilot that passed a place, in their order: those of two places agree if nothing was lost, repeated or
// changed between them.
#pragma once

#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_intake.h"

#include <mutex>
#include <vector>

namespace skyseal::test {

class FrameTrail
{
public:
    /// Of the autopilot with system id 1. Any thread.
    void take(ByteView datagram)
    {
        const std::lock_guard lock(m_mutex);
        mavlink::scanFrames(datagram, mavlink::Dialect::builtin(), [this](const mavlink::ScanItem &item) {
            if (!item.frame || item.frame->systemId() != 1 || item.frame->componentId() != 1)
                return;
            ++m_frames;
            if (m_writing)
                m_marks.push_back(hashOf(item.bytes));
        });
    }
    /// Remembers the frames from now on, in place of those before.
    void begin()
    {
        const std::lock_guard lock(m_mutex);
        m_marks.clear();
        m_writing = true;
    }
    /// One number for each frame since begin().
    std::vector<std::uint64_t> marks() const
    {
        const std::lock_guard lock(m_mutex);
        return m_marks;
    }
    std::uint64_t frames() const
    {
        const std::lock_guard lock(m_mutex);
        return m_frames;
    }

private:
    static std::uint64_t hashOf(ByteView bytes)
    {
        std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a
        for (const std::uint8_t byte : bytes)
            hash = (hash ^ byte) * 0x100000001b3;
        return hash;
    }

    mutable std::mutex m_mutex; ///< of all
    std::vector<std::uint64_t> m_marks;
    std::uint64_t m_frames = 0;
    bool m_writing = false;
};

} // namespace skyseal::test
