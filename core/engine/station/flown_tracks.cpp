#include "core/engine/station/flown_tracks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace skyseal::engine {

namespace {

bool areClose(const FlownPoint &a, const FlownPoint &b)
{
    constexpr double kApart = 1.0, kMetresPerDegree = 111'320;
    const double north = (a.latitude - b.latitude) * kMetresPerDegree;
    const double east = (a.longitude - b.longitude) * kMetresPerDegree * std::cos(a.latitude * std::numbers::pi / 180);
    return north * north + east * east < kApart * kApart;
}

} // namespace

void FlownTracks::note(std::uint8_t systemId, FlownPoint point)
{
    Entry &entry = m_tracks[systemId];
    if (!entry.interrupted && areClose(point, entry.points.back()))
        return;
    point.begins = std::exchange(entry.interrupted, false);
    entry.points.push_back(point);
    ++m_count;
    if (entry.points.size() <= kMostOfOne && m_count <= kMost)
        return;
    Points &longest = std::ranges::max_element(m_tracks, {}, [](const auto &one) {
                          return one.second.points.size();
                      })->second.points;
    longest.pop_front();
    --m_count;
}

const FlownTracks::Points &FlownTracks::of(std::uint8_t systemId) const
{
    static const Points kNone;
    const auto found = m_tracks.find(systemId);
    return found == m_tracks.end() ? kNone : found->second.points;
}

} // namespace skyseal::engine
