#include "core/vehicle/vehicle_set.h"

#include "core/vehicle/message_io.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

/// None for anything but a heartbeat, or what stands for one.
mavlink::AutopilotClaim claimOf(const mavlink::Frame &frame)
{
    const auto heartbeat = mavlink::heartbeatOf(frame);
    return heartbeat ? mavlink::autopilotClaim(frame.componentId(), *heartbeat) : mavlink::AutopilotClaim::None;
}

} // namespace

bool VehicleSet::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    const std::uint8_t system = frame.systemId();
    const auto known = m_vehicles.find(system);
    if (known != m_vehicles.end()) {
        Vehicle &vehicle = known->second;
        const bool replaces = frame.componentId() != vehicle.componentId() && claimOf(frame) > vehicle.claim();
        if (replaces)
            vehicle.replaceAutopilot(m_config, frame.componentId());
        vehicle.handleFrame(now, wall, frame);
        return replaces;
    }
    if (!announcesVehicle(frame))
        return false;
    const auto created = m_vehicles.emplace(system, Vehicle(m_config, system, frame.componentId())).first;
    created->second.handleFrame(now, wall, frame);
    return true;
}

bool VehicleSet::announcesVehicle(const mavlink::Frame &frame) const
{
    return frame.systemId() != 0 && frame.systemId() != m_config.ownSystemId && claimOf(frame) != mavlink::AutopilotClaim::None;
}

bool VehicleSet::claimsOwnId(const mavlink::Frame &frame) const
{
    return frame.systemId() == m_config.ownSystemId && claimOf(frame) != mavlink::AutopilotClaim::None;
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
