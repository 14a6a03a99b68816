// The tracks that the vehicles of a recording have flown up to a position; a map that jumps there draws them.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <deque>
#include <map>

namespace skyseal::engine {

struct FlownPoint
{
    Duration at{};                      ///< position in the recording
    double latitude = 0, longitude = 0; ///< degrees
    float quality = 0;                  ///< arrived frames, percent
    float altitude = 0, speed = 0;      ///< metres above home, metres a second over ground; NaN if unknown
    bool begins = false;                ///< the vehicle was lost before: nothing is known of the way from the last point
};

/// Points at least about a metre apart. Bounded: of the longest track, the oldest point is dropped.
class FlownTracks
{
public:
    static constexpr std::size_t kMostOfOne = 10'000, kMost = 100'000;

    using Points = std::deque<FlownPoint>;

    /// Call four times a second; ignores a point that is too close to the last one.
    void note(std::uint8_t systemId, FlownPoint point);
    /// The next point of this vehicle does not continue its track.
    void interrupt(std::uint8_t systemId) { m_tracks[systemId].interrupted = true; }
    /// Empty for a vehicle that has no point yet.
    const Points &of(std::uint8_t systemId) const;

private:
    struct Entry
    {
        Points points;
        bool interrupted = true;
    };

    std::map<std::uint8_t, Entry> m_tracks;
    std::size_t m_count = 0;
};

} // namespace skyseal::engine
