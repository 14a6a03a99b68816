// The vehicle without its radio: a simulated quadcopter in a simulated world, and the autopilot that flies it, in steps of
// 2.5 ms. Independent of MAVLink: every request is a method, every refusal a sentence.
#pragma once

#include "core/sim/battery_watch.h"
#include "core/sim/estimator_watch.h"
#include "core/sim/fence.h"
#include "core/sim/flight_modes.h"
#include "core/sim/flight_physics.h"
#include "core/sim/land_detector.h"
#include "core/sim/parameters.h"
#include "core/sim/radio_watch.h"
#include "core/sim/rally_points.h"
#include "core/sim/rotor_control.h"
#include "core/sim/status_texts.h"

namespace skyseal::sim {

struct AutopilotConfig
{
    std::uint64_t seed = 1;
    GeoPoint start{-35.363261, 149.165230, 584}; ///< the field in Canberra that ArduPilot's simulator starts from
    double heading = 353;                        ///< degrees
    double firstFix = 3;                         ///< s of flight time until the GPS has a fix
};

class Autopilot
{
public:
    /// Reason of a refusal, as a sentence for the operator.
    using Refusal = std::optional<std::string>;

    explicit Autopilot(const AutopilotConfig &config);
    Autopilot(const Autopilot &) = delete;
    Autopilot &operator=(const Autopilot &) = delete;

    static constexpr std::uint64_t kStep = 2500; ///< µs
    void step();
    std::uint64_t time() const { return m_time; } ///< µs of flight time since power-on

    Refusal arm(bool force);
    Refusal disarm(bool force);
    Refusal enterMode(FlightMode mode);
    Refusal takeOff(double height);
    /// Goes to a place in GUIDED, NED from the origin.
    Refusal goTo(const Vector3 &place);
    Refusal move(const Vector3 &velocity);
    /// Turns the nose (rad) in GUIDED and AUTO; `rate` in rad/s, 0 = as the parameter says.
    Refusal face(double heading, double rate);
    enum class SpeedKind { Ground, Climb, Descent };
    Refusal changeSpeed(SpeedKind kind, double speed);
    Refusal startMission();
    bool setHome(const Vector3 &place);
    /// Triggers a failsafe: RTL, or landing if RTL is impossible; on the ground it disarms.
    void failsafe(std::string_view cause, FlightMode action);

    bool armed() const { return m_armed; }
    bool landed() const { return m_landDetector.landed(); }
    bool inFailsafe() const { return m_inFailsafe; }
    void setInFailsafe(bool active) { m_inFailsafe = active; }
    /// The first failed arming check, without "PreArm: "; nullopt if all pass.
    Refusal preArm() const;

    Situation situation() const;
    const Estimate &estimate() const { return m_physics.estimate(); }
    const Estimator &estimator() const { return m_physics.estimator(); }
    const BodyState &truth() const { return m_physics.truth(); }
    const Rotors &rotorCommands() const { return m_rotors.commands(); }
    double throttle() const { return m_rotors.thrust(); }
    const AttitudeController &attitudeController() const { return m_rotors.attitude(); }
    const Battery &battery() const { return m_physics.battery(); }
    const BatteryWatch &batteryWatch() const { return m_batteryWatch; }
    const RadioWatch &radioWatch() const { return m_radioWatch; }
    const Faults &faults() const { return m_settings.faults; }
    const GpsReport &gps() const { return m_physics.gps(); }
    const GeoFrame &world() const { return m_world; }
    const Wind &wind() const { return m_physics.wind(); }
    const std::optional<Vector3> &home() const { return m_home; }
    double heightAboveHome() const { return situation().heightAboveHome(); }

    FlightModes &modes() { return m_modes; }
    const FlightModes &modes() const { return m_modes; }
    Parameters &parameters() { return m_parameters; }
    const Parameters &parameters() const { return m_parameters; }
    Fence &fence() { return m_fence; }
    const Fence &fence() const { return m_fence; }
    RallyPoints &rallyPoints() { return m_rallyPoints; }
    const RallyPoints &rallyPoints() const { return m_rallyPoints; }
    PilotInput &pilot() { return m_pilot; }
    const PilotInput &pilot() const { return m_pilot; }
    StatusTexts &texts() { return m_texts; }

private:
    void watch();
    void watchBattery();
    void watchPosition();
    void watchFence();
    void watchRadio();
    void watchEstimator();
    void watchGround();
    void clearFailsafe(std::string_view cause);
    Vector3 returnPoint() const;
    void disarmNow();
    bool landsHere() const;

    Parameters m_parameters;
    FlightSettings m_settings;
    unsigned m_settingsRevision = ~0u;
    GeoFrame m_world;
    FlightPhysics m_physics;
    PilotInput m_pilot;
    FlightModes m_modes;
    RotorControl m_rotors;
    LandDetector m_landDetector;
    BatteryWatch m_batteryWatch;
    RadioWatch m_radioWatch;
    EstimatorWatch m_estimatorWatch;
    Fence m_fence{m_parameters};
    RallyPoints m_rallyPoints;
    StatusTexts m_texts;

    std::uint64_t m_time = 0;
    bool m_armed = false;
    bool m_flown = false; ///< since it was armed
    bool m_inFailsafe = false;
    bool m_aligned = false;
    bool m_hadPosition = false;
    bool m_glitching = false;
    bool m_homeLocked = false;
    std::optional<Vector3> m_home;
};

} // namespace skyseal::sim
