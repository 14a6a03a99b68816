// Home position: as reported by the vehicle (HOME_POSITION), before that the position at the first arming.
#pragma once

#include "core/vehicle/vehicle_state.h"

namespace skyseal::vehicle {

class HomeTracker
{
public:
    /// A HOME_POSITION, valid until the next one.
    void handleHomePosition(const Position &home, VehicleState &state);
    /// After every change of the position or of the armed flag in `state`; keeps `home` and `distanceHome` up to date.
    void update(VehicleState &state);

private:
    bool m_notified = false;
    bool m_wasArmed = false;
};

} // namespace skyseal::vehicle
