#include "core/sim/item_lists.h"

#include "core/sim/wire_units.h"

namespace skyseal::sim {

using namespace mavlink;

StoredItem FlightPlanList::item(std::size_t sequence) const
{
    StoredItem item = m_autopilot.modes().mission().mission()[sequence];
    if (!hasPlace(item.command)) { // ArduPilot keeps the place of those commands only that have one
        item.frame = MAV_FRAME_GLOBAL;
        item.x = item.y = 0;
        item.z = 0;
    }
    if (keepsHome() && sequence == 0 && m_autopilot.flight().home.position()) { // item 0 is always home
        const GeoPoint home = m_autopilot.flight().world.toGeo(*m_autopilot.flight().home.position());
        item.frame = MAV_FRAME_GLOBAL;
        item.command = MAV_CMD_NAV_WAYPOINT;
        item.x = scaled<std::int32_t>(home.latitude, 1e7);
        item.y = scaled<std::int32_t>(home.longitude, 1e7);
        item.z = static_cast<float>(home.altitude);
    }
    return item;
}

bool FlightPlanList::inUse() const
{
    return m_autopilot.armed() && m_autopilot.modes().current() == FlightMode::Auto;
}

std::optional<ItemError> FlightPlanList::check(std::size_t sequence, const StoredItem &item) const
{
    return keepsHome() && sequence == 0 ? std::nullopt : checkItem(item, m_autopilot.flight().type); // item 0 becomes home
}

bool FlightPlanList::replace(std::vector<StoredItem> items)
{
    m_autopilot.parameters().set("MIS_TOTAL", static_cast<float>(items.size()));
    m_parameters.announce("MIS_TOTAL");
    m_autopilot.modes().mission().load(std::move(items));
    return true;
}

StoredItem FenceList::item(std::size_t sequence) const
{
    // ArduPilot keeps the place and the size of an item only.
    const StoredItem &stored = m_autopilot.flight().fence.areas().items()[sequence];
    StoredItem item;
    item.frame = MAV_FRAME_GLOBAL;
    item.command = stored.command;
    if (stored.command != MAV_CMD_NAV_FENCE_RETURN_POINT)
        item.parameters[0] = stored.parameters[0];
    item.x = stored.x;
    item.y = stored.y;
    return item;
}

bool FenceList::replace(std::vector<StoredItem> items)
{
    const std::size_t count = items.size();
    if (auto problem = m_autopilot.flight().fence.areas().load(std::move(items), m_autopilot.flight().world)) {
        m_autopilot.texts().say(Severity::Warning, std::move(*problem));
        return false;
    }
    m_autopilot.parameters().set("FENCE_TOTAL", static_cast<float>(count));
    return true;
}

StoredItem RallyList::item(std::size_t sequence) const
{
    const StoredItem &stored = m_autopilot.flight().rallyPoints.items()[sequence];
    StoredItem item;
    item.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    item.command = MAV_CMD_NAV_RALLY_POINT;
    item.x = stored.x;
    item.y = stored.y;
    item.z = std::trunc(stored.z); // whole metres, as ArduPilot stores it
    return item;
}

bool RallyList::replace(std::vector<StoredItem> items)
{
    m_autopilot.parameters().set("RALLY_TOTAL", static_cast<float>(items.size()));
    m_autopilot.flight().rallyPoints.load(std::move(items));
    return true;
}

} // namespace skyseal::sim
