#include "core/vehicle/vehicle_set.h"

#include "core/vehicle/message_io.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

/// Whether a heartbeat is that of an autopilot, the one component that makes a vehicle.
bool isAutopilot(const mavlink::Heartbeat &heartbeat)
{
    constexpr std::uint8_t kInvalidAutopilot = 8; // MAV_AUTOPILOT_INVALID: says of itself that it is none
    if (heartbeat.autopilot == kInvalidAutopilot)
        return false;
    switch (heartbeat.type) {
    case 6:  // ground station
    case 18: // onboard controller
    case 26: case 27: case 30: case 31: case 32: case 33: case 34: // gimbal, ADS-B, camera, charging station, FLARM, servo, remote id
    case 36: case 37: case 38: case 39: case 40: case 41: case 42: // battery, parachute, log, OSD, IMU, GPS, winch
    case 44: case 48: case 49: // illuminator, gripper, radio
        return false;
    default:
        return true;
    }
}

} // namespace

bool VehicleSet::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    const std::uint8_t system = frame.systemId();
    const auto known = m_vehicles.find(system);
    if (known != m_vehicles.end()) {
        known->second.handleFrame(now, wall, frame);
        return false;
    }
    if (frame.messageId() != mavlink::Heartbeat::kId || system == 0 || system == m_config.ownSystemId
        || !isAutopilot(unpack<mavlink::Heartbeat>(frame)))
        return false;
    const auto created = m_vehicles.emplace(system, Vehicle(m_config, system, frame.componentId())).first;
    created->second.handleFrame(now, wall, frame);
    return true;
}

void VehicleSet::handleDeadline(TimePoint now)
{
    for (auto &[id, vehicle] : m_vehicles) {
        if (now >= vehicle.nextDeadline())
            vehicle.handleDeadline(now);
    }
}

TimePoint VehicleSet::nextDeadline() const
{
    TimePoint next = kNever;
    for (const auto &[id, vehicle] : m_vehicles)
        next = std::min(next, vehicle.nextDeadline());
    return next;
}

Vehicle *VehicleSet::find(std::uint8_t systemId)
{
    const auto found = m_vehicles.find(systemId);
    return found == m_vehicles.end() ? nullptr : &found->second;
}

void VehicleSet::setStreams(TimePoint now, StreamProfile profile, double rate)
{
    m_config.streams = profile;
    m_config.streamRate = rate;
    for (auto &[id, vehicle] : m_vehicles)
        vehicle.setStreams(now, profile, rate);
}

} // namespace skyseal::vehicle
