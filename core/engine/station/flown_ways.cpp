#include "core/engine/station/flown_ways.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace skyseal::engine {

namespace {

bool areClose(const FlownPlace &a, const FlownPlace &b)
{
    constexpr double kApart = 1.0, kMetresPerDegree = 111'320;
    const double north = (a.latitude - b.latitude) * kMetresPerDegree;
    const double east = (a.longitude - b.longitude) * kMetresPerDegree * std::cos(a.latitude * std::numbers::pi / 180);
    return north * north + east * east < kApart * kApart;
}

} // namespace

void FlownWays::note(std::uint8_t systemId, FlownPlace place)
{
    Entry &entry = m_ways[systemId];
    if (!entry.interrupted && areClose(place, entry.way.back()))
        return;
    place.begins = std::exchange(entry.interrupted, false);
    entry.way.push_back(place);
    ++m_places;
    if (entry.way.size() <= kMostOfOne && m_places <= kMost)
        return;
    Way &longest = std::ranges::max_element(m_ways, {}, [](const auto &one) { return one.second.way.size(); })->second.way;
    longest.pop_front();
    --m_places;
}

const FlownWays::Way &FlownWays::of(std::uint8_t systemId) const
{
    static const Way kNone;
    const auto found = m_ways.find(systemId);
    return found == m_ways.end() ? kNone : found->second.way;
}

} // namespace skyseal::engine
