// State of the vehicle as its sensors estimate it. Control and telemetry use this, never the true state.
#pragma once

#include "core/sim/attitude.h"

namespace skyseal::sim {

struct Estimate
{
    Vector3 position; ///< m, NED from the origin
    Vector3 velocity; ///< m/s, NED
    Attitude attitude;
    Vector3 rates; ///< rad/s, body axes
    bool attitudeOk = false;
    bool positionOk = false; ///< horizontal position and velocity are usable

    double altitude() const { return -position.z; }
    double climb() const { return -velocity.z; }
};

} // namespace skyseal::sim
