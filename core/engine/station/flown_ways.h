// The ways that the vehicles of a recording have flown up to a position, of which a map that jumps there draws the tracks.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <deque>
#include <map>

namespace skyseal::engine {

struct FlownPlace
{
    Duration at{};                      ///< position in the recording
    double latitude = 0, longitude = 0; ///< degrees
    float quality = 0;                  ///< arrived frames, percent
    float altitude = 0, speed = 0;      ///< metres above home, metres a second over ground; NaN if unknown
    bool begins = false;                ///< the vehicle was lost before: nothing is known of the way from the last place
};

/// Places at least about a metre apart. Bounded: of the longest way, the oldest place is dropped.
class FlownWays
{
public:
    static constexpr std::size_t kMostOfOne = 10'000, kMost = 100'000;

    using Way = std::deque<FlownPlace>;

    /// Call four times a second; ignores a place that is too close to the last one.
    void note(std::uint8_t systemId, FlownPlace place);
    /// The next place of this vehicle does not continue its way.
    void interrupt(std::uint8_t systemId) { m_ways[systemId].interrupted = true; }
    /// Empty for a vehicle that has no place yet.
    const Way &of(std::uint8_t systemId) const;

private:
    struct Entry
    {
        Way way;
        bool interrupted = true;
    };

    std::map<std::uint8_t, Entry> m_ways;
    std::size_t m_places = 0;
};

} // namespace skyseal::engine
