#include "core/engine/agent/armed_vehicles.h"

#include "core/mavlink/autopilot_heartbeat.h"
#include "core/mavlink/enums.h"

namespace skyseal::engine {

bool ArmedVehicles::note(const mavlink::Frame &heartbeat)
{
    const std::pair sender(heartbeat.systemId(), heartbeat.componentId());
    constexpr std::uint8_t kArmed = mavlink::MAV_MODE_FLAG_SAFETY_ARMED;
    const mavlink::Heartbeat before{.base_mode = m_armed.contains(sender) ? kArmed : std::uint8_t(0)};
    const auto message = mavlink::heartbeatOf(heartbeat, before);
    if (message && (message->base_mode & kArmed) != 0)
        m_armed.insert(sender);
    else if (message)
        m_armed.erase(sender);
    return any();
}

} // namespace skyseal::engine
