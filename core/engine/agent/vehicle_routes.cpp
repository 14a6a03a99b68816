#include "core/engine/agent/vehicle_routes.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

void VehicleRoutes::heard(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Heartbeat::kId)
        return;
    // Ground stations, companion computers and gimbals send heartbeats as well, with MAV_AUTOPILOT_INVALID.
    const mavlink::Heartbeat heartbeat = mavlink::Heartbeat::decode(frame.payload());
    if (heartbeat.autopilot == mavlink::MAV_AUTOPILOT_INVALID)
        return;
    m_systems.set(frame.systemId());
    m_routes[frame.systemId()] = {from, now};
}

void VehicleRoutes::streamChanged(const Path &path)
{
    std::erase_if(m_routes, [&path](const auto &entry) { return entry.second.path == path; });
}

void VehicleRoutes::forgetSilent(TimePoint now)
{
    std::erase_if(m_routes, [now](const auto &entry) { return now - entry.second.heard > kForgetAfter; });
}

} // namespace skyseal::engine
