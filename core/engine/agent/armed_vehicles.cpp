#include "core/engine/agent/armed_vehicles.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

bool ArmedVehicles::note(const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Heartbeat::kId)
        return false;
    const mavlink::Heartbeat heartbeat = mavlink::Heartbeat::decode(frame.payload());
    if (heartbeat.autopilot == mavlink::MAV_AUTOPILOT_INVALID)
        return false;
    const std::pair sender(frame.systemId(), frame.componentId());
    if ((heartbeat.base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) == 0)
        m_armed.erase(sender);
    else
        m_armed.insert(sender);
    return any();
}

} // namespace skyseal::engine
