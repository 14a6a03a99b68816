// All vehicles of a station by system id. The heartbeat of an autopilot announces a vehicle; ground stations, gimbals, cameras
// and companion computers are not vehicles. Where several components of a system claim to be its autopilot, the one with the
// greatest claim is, whichever was heard first.
//
// Sans-I/O. Frames of unknown vehicles are ignored, except the heartbeat that announces one. The engine keeps the route to
// each vehicle.
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

    /// Returns true if the frame announced a new vehicle, or another component as the autopilot of a known one; find() then
    /// returns the vehicle.
    bool handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    /// True for the heartbeat of an autopilot.
    bool announcesVehicle(const mavlink::Frame &frame) const;
    /// True for the heartbeat of an autopilot that has the system id of this station.
    bool claimsOwnId(const mavlink::Frame &frame) const;
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// Null for an unknown vehicle. Valid until the vehicle is forgotten.
    Vehicle *find(std::uint8_t systemId);
    /// Its next heartbeat announces it anew. Its requests end without a result.
    void forget(std::uint8_t systemId) { m_vehicles.erase(systemId); }
    /// By system id, in rising order.
    std::map<std::uint8_t, Vehicle> &all() { return m_vehicles; }
    const std::map<std::uint8_t, Vehicle> &all() const { return m_vehicles; }
    bool empty() const { return m_vehicles.empty(); }

    /// For every vehicle, present and future.
    void setStreams(TimePoint now, StreamProfile profile, double rate = 0);

private:
    VehicleConfig m_config;
    std::map<std::uint8_t, Vehicle> m_vehicles;
};

} // namespace skyseal::vehicle
