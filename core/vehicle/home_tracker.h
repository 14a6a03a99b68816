// Where home is: where the vehicle says (HOME_POSITION), and until it says so, where it was when it was armed first.
#pragma once

#include "core/vehicle/vehicle_state.h"

namespace skyseal::vehicle {

class HomeTracker
{
public:
    /// The vehicle's own word, which stands until it gives another.
    void handleHomePosition(const Position &home, VehicleState &state);
    /// After every change of the position or of the armed flag in `state`; keeps `home` and `distanceHome` up to date.
    void update(VehicleState &state);

private:
    bool m_notified = false;
    bool m_wasArmed = false;
};

} // namespace skyseal::vehicle
