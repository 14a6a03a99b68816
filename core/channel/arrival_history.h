// Remembers which record was the newest at which time, to tell for how long a late record has been overtaken (PROTOCOL.md,
// section 6.1). One for each session and direction.
#pragma once

#include "core/base/clock.h"
#include "core/channel/stats.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

/// Place of a record among all records of its session and direction, in the order in which they were sealed.
enum class RecordPosition : std::uint64_t {};

/// `counter` is below 2^24.
constexpr RecordPosition positionOf(Epoch epoch, std::uint32_t counter)
{
    return RecordPosition{std::uint64_t{static_cast<std::uint32_t>(epoch)} << 24 | counter};
}

class ArrivalHistory
{
public:
    explicit ArrivalHistory(Duration limit) : m_limit(limit) {}

    /// An authentic record arrived. Call in the order of arrival.
    void add(TimePoint now, RecordPosition position)
    {
        if (position < m_slots[m_last].newest)
            return;
        if (now >= m_slots[m_last].start + m_limit / kSteps) {
            m_last = (m_last + 1) % m_slots.size();
            m_slots[m_last].start = now;
        }
        m_slots[m_last].newest = position;
    }

    /// A newer record arrived `limit` before `now`, or earlier. The result may become true up to a sixteenth of the limit
    /// too early, but never too late.
    bool overtaken(TimePoint now, RecordPosition position) const
    {
        if (position >= m_slots[m_last].newest) // Nearly every record: no search.
            return false;
        for (std::size_t i = 0; i < m_slots.size(); ++i) {
            const Slot &slot = m_slots[(m_last + m_slots.size() - i) % m_slots.size()];
            if (slot.start + m_limit <= now)
                return position < slot.newest;
        }
        return false;
    }

private:
    static constexpr int kSteps = 16;
    /// Newest record of a sixteenth of the limit that began at `start` with an arrival.
    struct Slot
    {
        TimePoint start = TimePoint::min();
        RecordPosition newest{};
    };

    Duration m_limit;
    std::array<Slot, kSteps + 2> m_slots; ///< a ring; the oldest ones are older than the limit
    std::size_t m_last = 0;
};

} // namespace skyseal::channel
