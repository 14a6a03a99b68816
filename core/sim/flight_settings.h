// The parameters that control needs, in SI units; built again after every change of a parameter.
#pragma once

#include "core/sim/attitude.h"
#include "core/sim/faults.h"
#include "core/sim/flight_mode.h"

#include <optional>

namespace skyseal::sim {

class Parameters;

/// Actions of the failsafes; nullopt: report only.
struct FailsafeSettings
{
    using Action = std::optional<FlightMode>;

    Action lowBattery, criticalBattery;
    bool radioWatched = false;
    int radioThrottle = 0; ///< µs: a throttle below means that the receiver hears nothing
    Action radio;
    bool goesOnInAuto = false, goesOnInGuided = false; ///< when the radio is lost
    double estimatorLimit = 0;                         ///< of the variances; 0: not watched
    Action estimator;
    bool estimatorAlways = false; ///< also in modes that need no position
    double stationTimeout = 5;    ///< s
    Action station;
    bool crashCheck = true;
};

struct FlightSettings
{
    // Abilities of the craft.
    bool hovers = true;        ///< stands still in the air
    bool flies = true;         ///< leaves the ground
    double loiterRadius = 60;  ///< m, of an aeroplane around a place
    double takeOffHeight = 10; ///< m above home, of the mode that takes off
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
    double inputLag = 0.15;   ///< s
    double guidedTimeout = 3; ///< s until a velocity of the station must be renewed
    double yawSlew = radians(60);
    double positionP = 1;
    double velocityP = 2;
    double velocityI = 1;
    double altitudeP = 1;
    double climbP = 5;
    double hoverThrottle = 0.35;
    double spoolTime = 0.5; ///< s
    // The ground and the air.
    double disarmDelay = 10;      ///< s on the ground; 0: never
    double disarmAfterFlight = 0; ///< s after a landing in any mode; 0: only in modes that land
    double windSpeed = 0;
    double windFrom = 0; ///< rad
    Faults faults;
    FailsafeSettings failsafes;
};

FlightSettings flightSettings(const Parameters &parameters, const GeoFrame &world);

} // namespace skyseal::sim
