#include "core/vehicle/gcs_heartbeat.h"

#include "core/vehicle/message_io.h"

namespace skyseal::vehicle {

OutMessage gcsHeartbeatMessage()
{
    mavlink::Heartbeat heartbeat;
    heartbeat.type = mavlink::MAV_TYPE_GCS;
    heartbeat.autopilot = mavlink::MAV_AUTOPILOT_INVALID;
    heartbeat.system_status = mavlink::MAV_STATE_ACTIVE;
    return pack(heartbeat, true);
}

} // namespace skyseal::vehicle
