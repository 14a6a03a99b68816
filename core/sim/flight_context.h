// State that the parts of an autopilot share: the vehicle and its world, its parameters and orders, and its estimate. Arming,
// Failsafes and FlightRequests act on it.
#pragma once

#include "core/sim/battery_watch.h"
#include "core/sim/estimator_watch.h"
#include "core/sim/fence.h"
#include "core/sim/flight_modes.h"
#include "core/sim/flight_physics.h"
#include "core/sim/home.h"
#include "core/sim/land_detector.h"
#include "core/sim/parameters.h"
#include "core/sim/radio_watch.h"
#include "core/sim/rally_points.h"
#include "core/sim/status_texts.h"

namespace skyseal::sim {

struct AutopilotConfig
{
    std::uint64_t seed = 1;
    GeoPoint start{-35.363261, 149.165230, 584}; ///< the field in Canberra that ArduPilot's simulator starts from
    double heading = 353;                        ///< degrees
    double firstFix = 3;                         ///< s of flight time until the GPS has a fix
    VehicleType type;
};

struct FlightContext
{
    explicit FlightContext(const AutopilotConfig &config);
    FlightContext(const FlightContext &) = delete;
    FlightContext &operator=(const FlightContext &) = delete;

    Situation situation() const;
    const Estimate &estimate() const { return physics.estimate(); }
    /// A vehicle that does not fly is never at the end of a flight.
    bool landed() const { return !type.isRover() && landDetector.landed(); }
    double parameter(const char *name) const { return static_cast<double>(parameters.value(name)); }

    const VehicleType type;
    std::uint64_t time = 0; ///< µs of flight time since power-on
    Parameters parameters;
    FlightSettings settings;
    GeoFrame world;
    FlightPhysics physics;
    PilotInput pilot;
    FlightModes modes;
    LandDetector landDetector;
    BatteryWatch batteryWatch;
    RadioWatch radioWatch;
    Fence fence{parameters};
    RallyPoints rallyPoints;
    Home home;
    StatusTexts texts;

private:
    Vector3 returnPoint() const;
};

} // namespace skyseal::sim
