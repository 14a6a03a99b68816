#include "core/engine/headless/fleet_feed.h"

#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/frame_header.h"
#include "core/mqtt/topics.h"

namespace skyseal::engine {

void FleetFeed::take(const Snapshot &snapshot, WallTime now)
{
    m_vehicles.clear();
    for (const VehicleSnapshot &vehicle : snapshot.vehicles)
        m_vehicles.emplace(vehicle.state.systemId, vehicle.session);
    if (snapshot.time < m_nextState)
        return;
    const bool inTime = snapshot.time < m_nextState + kStateEvery; // otherwise the schedule starts anew
    m_nextState = (inTime ? m_nextState : snapshot.time) + kStateEvery;
    for (const VehicleSnapshot &vehicle : snapshot.vehicles)
        m_sink->putState(mqtt::vehicleState(vehicle.state.systemId), vehicleStateEvent(snapshot, vehicle, now));
}

void FleetFeed::handleEvent(const Event &event)
{
    m_names.note(event);
    const std::string line = eventJson(event, m_names);
    if (line.empty())
        return;
    const std::vector<std::uint8_t> vehicles = vehiclesOf(event);
    for (const std::uint8_t systemId : vehicles)
        m_sink->putEvent(mqtt::vehicleEvent(systemId), line);
    if (vehicles.empty())
        m_sink->putEvent(mqtt::kGatewayEvent, line);
}

void FleetFeed::takeFrame(ByteView frame)
{
    if (m_raw)
        m_sink->putRaw(mavlink::systemIdOf(frame), frame);
}

/// An event of a session concerns the vehicles behind it. A system id without a vehicle is the claim of a stranger and gets no
/// topic.
std::vector<std::uint8_t> FleetFeed::vehiclesOf(const Event &event) const
{
    return std::visit(
        [this](const auto &e) -> std::vector<std::uint8_t> {
            if constexpr (requires { e.session; })
                return vehiclesOver(e.session);
            else if constexpr (std::is_same_v<std::decay_t<decltype(e)>, VehicleFound>)
                return {e.systemId};
            else if constexpr (requires { e.systemId; })
                return m_vehicles.contains(e.systemId) ? std::vector{e.systemId} : std::vector<std::uint8_t>();
            else
                return {};
        },
        event);
}

std::vector<std::uint8_t> FleetFeed::vehiclesOver(channel::SessionId session) const
{
    std::vector<std::uint8_t> out;
    for (const auto &[systemId, over] : m_vehicles) {
        if (over == session)
            out.push_back(systemId);
    }
    return out;
}

} // namespace skyseal::engine
