// All vehicles of a station by system id. A vehicle comes to exist by a heartbeat of an autopilot; ground stations, gimbals,
// cameras and companion computers are no vehicles.
//
// Sans-I/O. Frames that no known vehicle sent are ignored, apart from the heartbeat that makes one known. Which path leads
// to a vehicle is the engine's business.
#pragma once

#include "core/vehicle/vehicle.h"

#include <cstdint>
#include <map>
#include <optional>

namespace skyseal::vehicle {

class VehicleSet
{
public:
    explicit VehicleSet(const VehicleConfig &config) : m_config(config) {}

    /// True when the frame made a new vehicle known (then `find(frame's system id)` has it).
    bool handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    /// Whether the frame would make a vehicle known: a heartbeat of an autopilot.
    bool announcesVehicle(const mavlink::Frame &frame) const;
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// Null when not known. Stays valid until the set dies.
    Vehicle *find(std::uint8_t systemId);
    /// By system id, in rising order.
    std::map<std::uint8_t, Vehicle> &all() { return m_vehicles; }
    const std::map<std::uint8_t, Vehicle> &all() const { return m_vehicles; }
    bool empty() const { return m_vehicles.empty(); }

    /// For every vehicle, those that come later included.
    void setStreams(TimePoint now, StreamProfile profile, double rate = 0);

private:
    VehicleConfig m_config;
    std::map<std::uint8_t, Vehicle> m_vehicles;
};

} // namespace skyseal::vehicle
