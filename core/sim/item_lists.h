// The lists that an autopilot has, for the mission protocol. Sizes are shown by the parameters MIS_TOTAL, FENCE_TOTAL and
// RALLY_TOTAL.
#pragma once

#include "core/sim/item_list.h"
#include "core/sim/parameter_server.h"

namespace skyseal::sim {

class FlightPlanList : public ItemList
{
public:
    FlightPlanList(Autopilot &autopilot, ParameterServer &parameters) : m_autopilot(autopilot), m_parameters(parameters) {}

    std::uint8_t type() const override { return mavlink::MAV_MISSION_TYPE_MISSION; }
    const char *name() const override { return "Mission"; }
    const char *receivedText() const override { return "Flight plan received"; }
    std::size_t most() const override { return kMostMissionItems; }
    std::size_t size() const override { return m_autopilot.modes().mission().mission().size(); }
    StoredItem item(std::size_t sequence) const override;
    std::optional<std::uint16_t> current() const override { return m_autopilot.modes().mission().current(); }
    bool inUse() const override;
    std::optional<ItemError> check(std::size_t sequence, const StoredItem &item) const override;
    bool replace(std::vector<StoredItem> items) override;
    std::vector<StoredItem> stored() const override { return m_autopilot.modes().mission().mission(); }

private:
    bool keepsHome() const { return !m_autopilot.flight().type.isPx4(); }

    Autopilot &m_autopilot;
    ParameterServer &m_parameters;
};

class FenceList : public ItemList
{
public:
    explicit FenceList(Autopilot &autopilot) : m_autopilot(autopilot) {}

    std::uint8_t type() const override { return mavlink::MAV_MISSION_TYPE_FENCE; }
    const char *name() const override { return "Fence"; }
    std::size_t most() const override { return FenceAreas::kMostItems; }
    std::size_t size() const override { return m_autopilot.flight().fence.areas().items().size(); }
    StoredItem item(std::size_t sequence) const override;
    std::optional<ItemError> check(std::size_t, const StoredItem &item) const override { return FenceAreas::checkItem(item); }
    bool replace(std::vector<StoredItem> items) override;
    std::vector<StoredItem> stored() const override { return m_autopilot.flight().fence.areas().items(); }

private:
    Autopilot &m_autopilot;
};

class RallyList : public ItemList
{
public:
    explicit RallyList(Autopilot &autopilot) : m_autopilot(autopilot) {}

    std::uint8_t type() const override { return mavlink::MAV_MISSION_TYPE_RALLY; }
    const char *name() const override { return "Rally"; }
    const char *receivedText() const override { return "Rally points received"; }
    std::size_t most() const override { return RallyPoints::kMostItems; }
    std::size_t size() const override { return m_autopilot.flight().rallyPoints.items().size(); }
    StoredItem item(std::size_t sequence) const override;
    std::optional<ItemError> check(std::size_t, const StoredItem &item) const override { return RallyPoints::checkItem(item); }
    bool replace(std::vector<StoredItem> items) override;
    std::vector<StoredItem> stored() const override { return m_autopilot.flight().rallyPoints.items(); }

private:
    Autopilot &m_autopilot;
};

} // namespace skyseal::sim
