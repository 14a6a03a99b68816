// Writes the flight log: from arming to disarming, what the autopilot measured and did, in the messages and units of
// ArduPilot's logs.
#pragma once

#include "core/base/clock.h"
#include "core/sim/autopilot.h"
#include "core/sim/flight_logs.h"

namespace skyseal::sim {

class FlightRecorder
{
public:
    explicit FlightRecorder(FlightLogs &logs) : m_logs(logs) {}

    /// Wall time of the flight steps that follow.
    void setWallTime(WallTime time) { m_wallTime = time; }
    /// To be called after each step of the autopilot.
    void step(const Autopilot &autopilot);

private:
    void begin(const Autopilot &autopilot);
    void writeChanges(const Autopilot &autopilot);
    void writeSamples(const Autopilot &autopilot);
    void writeGps(const Autopilot &autopilot);
    void event(const Autopilot &autopilot, std::uint8_t id);

    FlightLogs &m_logs;
    WallTime m_wallTime{};
    bool m_armed = false;
    bool m_landed = true;
    FlightMode m_mode = FlightMode::Stabilize;
    std::uint64_t m_gpsTakenAt = 0;
};

} // namespace skyseal::sim
