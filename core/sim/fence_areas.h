// Areas of an uploaded fence: polygons and circles that the vehicle must stay in or out of, made from the items of the mission
// protocol (https://mavlink.io/en/services/mission.html, geofence).
#pragma once

#include "core/sim/mission.h"

#include <string>

namespace skyseal::sim {

class FenceAreas
{
public:
    static constexpr std::size_t kMostItems = 84; ///< ArduPilot's number depends on the board's storage

    /// nullopt if the item can be part of a fence. Whether items belong together is checked by load().
    static std::optional<ItemError> checkItem(const StoredItem &item);

    /// Replaces the fence. Returns a sentence if the items are not whole areas; the fence is unchanged then.
    std::optional<std::string> load(std::vector<StoredItem> items, const GeoFrame &world);

    const std::vector<StoredItem> &items() const { return m_items; }
    bool empty() const { return m_areas.empty(); }
    /// Whether a place (m, NED from the origin) is within every inclusion area and outside every exclusion area.
    bool allow(const Vector3 &place) const;

private:
    struct Corner
    {
        double north = 0; ///< m from the origin
        double east = 0;
    };
    struct Area
    {
        bool inclusion = true;
        double radius = 0;           ///< m; of a polygon 0
        std::vector<Corner> corners; ///< of a circle its centre
    };
    static bool within(const Area &area, const Vector3 &place);

    std::vector<StoredItem> m_items;
    std::vector<Area> m_areas;
};

} // namespace skyseal::sim
