// The parameters that control needs, in SI units; built again after every change of a parameter.
#pragma once

#include "core/sim/attitude.h"
#include "core/sim/faults.h"

namespace skyseal::sim {

class Parameters;

struct FlightSettings
{
    // Path following, m, m/s and m/s².
    double speed = 5;
    double climb = 2.5;
    double descent = 1.5;
    double acceleration = 2.5;
    double verticalAcceleration = 1;
    double waypointRadius = 2;
    double landSpeed = 0.5;
    double landSpeedHigh = 0; ///< 0: as `descent`
    double landLow = 10;      ///< m above ground from which `landSpeed` holds
    double rtlAltitude = 15;
    double rtlFinalAltitude = 0;
    double rtlSpeed = 0; ///< 0: as `speed`
    double rtlClimbMin = 0;
    double rtlCone = 3;
    double rtlLoiter = 5; ///< s
    // Pilot.
    double leanLimit = radians(30);
    double pilotClimb = 2.5;
    double pilotDescent = 1.5;
    double pilotYawRate = radians(202.5);
    double loiterSpeed = 12.5;
    double brakeDeceleration = 2.5;
    // Loops.
    double anglePRoll = 4.5;
    double anglePPitch = 4.5;
    double anglePYaw = 4.5;
    double inputLag = 0.15; ///< s
    double yawSlew = radians(60);
    double positionP = 1;
    double velocityP = 2;
    double velocityI = 1;
    double altitudeP = 1;
    double climbP = 5;
    double hoverThrottle = 0.35;
    double spoolTime = 0.5; ///< s
    // The ground and the air.
    double disarmDelay = 10; ///< s; 0: never
    double windSpeed = 0;
    double windFrom = 0; ///< rad
    Faults faults;
};

FlightSettings flightSettings(const Parameters &parameters, const GeoFrame &world);

} // namespace skyseal::sim
