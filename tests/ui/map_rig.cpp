#include "map_rig.h"

#include "core/mavlink/enums.h"
#include "scripted_snapshots.h"

namespace skyseal::ui {

void MapRig::show(const ChangeState &change)
{
    engine::Snapshot snapshot = sealedSnapshot(++m_time);
    vehicle::VehicleState &state = snapshot.vehicles.front().state;
    state.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    state.type = mavlink::MAV_TYPE_QUADROTOR;
    enterMode(state, "GUIDED");
    state.armed = true;
    state.altitudeRelative = m_altitude;
    if (change)
        change(state);
    snapshot.vehicles.front().mission = m_mission;
    snapshot.vehicles.front().missionOutdated = m_missionOutdated;
    m_station->show(snapshot);
}

} // namespace skyseal::ui
