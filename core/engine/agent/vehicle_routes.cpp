#include "core/engine/agent/vehicle_routes.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

void VehicleRoutes::heard(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Heartbeat::kId)
        return;
    // Ground stations, companions and gimbals beat as well; an autopilot says which one it is.
    const mavlink::Heartbeat beat = mavlink::Heartbeat::decode(frame.payload());
    if (beat.autopilot == mavlink::MAV_AUTOPILOT_INVALID)
        return;
    m_systems.set(frame.systemId());
    m_routes[frame.systemId()] = {from, now};
}

void VehicleRoutes::streamChanged(LinkId, const Path &path)
{
    std::erase_if(m_routes, [&path](const auto &way) { return way.second.path == path; });
}

void VehicleRoutes::forgetSilent(TimePoint now)
{
    std::erase_if(m_routes, [now](const auto &way) { return now - way.second.heard > kForgetAfter; });
}

} // namespace skyseal::engine
