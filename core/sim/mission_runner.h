// AUTO: flies the mission item by item.
#pragma once

#include "core/sim/auto_yaw.h"
#include "core/sim/mission_cursor.h"
#include "core/sim/return_flight.h"
#include "core/sim/take_off_climb.h"

#include <optional>
#include <utility>

namespace skyseal::sim {

class MissionRunner
{
public:
    MissionRunner(const GeoFrame &world, const VehicleType &type) : m_world(world), m_type(type) {}

    /// Number of the first item that is flown: ArduPilot keeps home in item 0.
    std::uint16_t first() const { return m_type.isPx4() ? 0 : 1; }

    const Mission &mission() const { return m_cursor.mission(); }
    void load(Mission mission) { m_cursor.load(std::move(mission)); }
    /// The item that is flown, or that a start begins with; 0 when there is none.
    std::uint16_t current() const { return m_cursor.current(); }
    /// False when there is no such item.
    bool setCurrent(std::uint16_t sequence) { return m_cursor.setCurrent(sequence); }

    /// Whether AUTO can be entered: there is something besides home, and it starts with a take-off if on the ground.
    const char *refusal(bool landed) const;
    /// Entering AUTO: goes on with the current item.
    void begin(const Situation &s);
    /// MISSION_START, or the raised throttle: a vehicle on the ground may now take off.
    void start() { m_started = true; }
    bool started() const { return m_started; }
    FlightDemand update(double dt, const Situation &s);

    bool finished() const { return m_cursor.isFinished(); }
    /// The item that was reached since the last call.
    std::optional<std::uint16_t> takeReached() { return m_cursor.takeReached(); }
    /// Where it is heading for now, NED.
    const Vector3 &place() const { return m_place; }

    void setSpeed(double speed) { m_speed = speed; }
    void setClimb(double speed) { m_climb = speed; }
    void setDescent(double speed) { m_descent = speed; }
    AutoYaw &yaw() { return m_yaw; }

private:
    void startItem(const Situation &s);
    bool execute(const StoredItem &item, const Situation &s);
    bool itemDone(double dt, const Situation &s);
    bool nearPlace(const Situation &s) const;
    double timeToStay(const StoredItem &item, const Situation &s) const;
    FlightDemand hold(const Situation &s);

    const GeoFrame m_world;
    const VehicleType m_type;
    MissionCursor m_cursor;
    bool m_started = false;
    Vector3 m_place;
    double m_timeAtPlace = 0; ///< s
    bool m_arrived = false;
    std::optional<double> m_speed, m_climb, m_descent;
    TakeOffClimb m_takeOff;
    Landing m_landing;
    ReturnFlight m_return;
    AutoYaw m_yaw;
};

} // namespace skyseal::sim
