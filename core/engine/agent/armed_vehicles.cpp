#include "core/engine/agent/armed_vehicles.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

bool ArmedVehicles::note(const mavlink::Frame &heartbeat)
{
    const std::pair sender(heartbeat.systemId(), heartbeat.componentId());
    if ((mavlink::Heartbeat::decode(heartbeat.payload()).base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) == 0)
        m_armed.erase(sender);
    else
        m_armed.insert(sender);
    return any();
}

} // namespace skyseal::engine
