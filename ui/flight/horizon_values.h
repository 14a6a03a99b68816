// The values that the artificial horizon draws, in the units of its tapes.
#pragma once

#include "core/vehicle/vehicle_state.h"

namespace skyseal::ui {

struct HorizonValues
{
    double roll = vehicle::kUnknown;     ///< degrees, right wing down positive
    double pitch = vehicle::kUnknown;    ///< degrees, nose up positive
    double heading = vehicle::kUnknown;  ///< degrees
    double speed = vehicle::kUnknown;    ///< in the unit of the tape
    double altitude = vehicle::kUnknown; ///< in the unit of the tape
    double climb = vehicle::kUnknown;
    bool stale = false;
};

} // namespace skyseal::ui
