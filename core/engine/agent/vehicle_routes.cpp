#include "core/engine/agent/vehicle_routes.h"

#include "core/mavlink/autopilot_heartbeat.h"

namespace skyseal::engine {

bool VehicleRoutes::isVehicleHeartbeat(const mavlink::Frame &frame)
{
    const auto heartbeat = mavlink::heartbeatOf(frame);
    return heartbeat && mavlink::autopilotClaim(frame.componentId(), *heartbeat) != mavlink::AutopilotClaim::None;
}

void VehicleRoutes::heard(TimePoint now, const Path &from, std::uint8_t systemId)
{
    m_routes[systemId] = from;
    m_heard[systemId] = now;
}

void VehicleRoutes::forget(std::uint8_t systemId)
{
    m_routes.erase(systemId);
    m_heard.erase(systemId);
}

void VehicleRoutes::streamChanged(const Path &path)
{
    std::erase_if(m_routes, [&path](const auto &entry) { return entry.second == path; });
}

void VehicleRoutes::forgetSilent(TimePoint now)
{
    std::erase_if(m_heard, [now](const auto &entry) { return now - entry.second > kForgetAfter; });
    std::erase_if(m_routes, [this](const auto &entry) { return !m_heard.contains(entry.first); });
}

} // namespace skyseal::engine
