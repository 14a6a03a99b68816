#include "core/sim/rally_points.h"

#include <limits>

namespace skyseal::sim {

using namespace mavlink;

std::optional<ItemError> RallyPoints::checkItem(const StoredItem &item)
{
    if (item.command != MAV_CMD_NAV_RALLY_POINT)
        return ItemError::Unsupported;
    if (item.frame != MAV_FRAME_GLOBAL_RELATIVE_ALT && item.frame != MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
        return ItemError::UnsupportedFrame;
    if (std::abs(static_cast<double>(item.x)) > 90e7)
        return ItemError::InvalidX;
    if (std::abs(static_cast<double>(item.y)) > 180e7)
        return ItemError::InvalidY;
    if (!(std::abs(item.z) <= 32767)) // m, in 16 bits of ArduPilot's storage
        return ItemError::InvalidZ;
    return std::nullopt;
}

Vector3 RallyPoints::bestFor(const Vector3 &here, const Vector3 &home, const GeoFrame &world, double limit, bool orHome) const
{
    Vector3 best = home;
    double nearest = limit > 0 ? limit : std::numeric_limits<double>::infinity();
    if (orHome)
        nearest = std::min(nearest, (here - home).horizontal());
    for (const StoredItem &item : m_items) {
        const Vector3 place = placeOf(item, world, home, here);
        if (const double distance = (here - place).horizontal(); distance < nearest) {
            nearest = distance;
            best = place;
        }
    }
    return best;
}

} // namespace skyseal::sim
