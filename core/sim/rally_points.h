// Rally points: places, besides home, at which RTL may end.
#pragma once

#include "core/sim/mission.h"

namespace skyseal::sim {

class RallyPoints
{
public:
    static constexpr std::size_t kMostItems = 50;

    /// nullopt if the item can be a rally point.
    static std::optional<ItemError> checkItem(const StoredItem &item);

    void load(std::vector<StoredItem> items) { m_items = std::move(items); }
    const std::vector<StoredItem> &items() const { return m_items; }

    /// Where RTL from `here` ends, NED from the origin: the nearest rally point within `limit` m (0: any), or home if that is
    /// nearer and `orHome`, or if there is no such point.
    Vector3 bestFor(const Vector3 &here, const Vector3 &home, const GeoFrame &world, double limit, bool orHome) const;

private:
    std::vector<StoredItem> m_items;
};

} // namespace skyseal::sim
