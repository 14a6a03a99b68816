// How many frames of each message were accepted, so that a measurement can state of what its traffic consisted. A count for
// each frame, and no more. I/O thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace skyseal::engine {

class MessageCounts
{
public:
    /// Ids from here on are counted in a map, of which a forged sender can fill kMostHigh places.
    static constexpr std::uint32_t kLow = 512;
    static constexpr std::size_t kMostHigh = 256;

    void note(std::uint32_t messageId)
    {
        if (messageId < kLow)
            ++m_low[messageId];
        else if (m_high.size() < kMostHigh || m_high.contains(messageId))
            ++m_high[messageId];
    }

    /// By message id; without messages that never came.
    std::map<std::uint32_t, std::uint64_t> all() const
    {
        std::map<std::uint32_t, std::uint64_t> out = m_high;
        for (std::uint32_t id = 0; id < kLow; ++id) {
            if (m_low[id] > 0)
                out.emplace(id, m_low[id]);
        }
        return out;
    }

private:
    std::array<std::uint64_t, kLow> m_low{};
    std::map<std::uint32_t, std::uint64_t> m_high;
};

} // namespace skyseal::engine
