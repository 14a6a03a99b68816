#include "core/vehicle/vehicle_set.h"

#include "core/vehicle/message_io.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

/// True for the heartbeat of an autopilot, the only component that announces a vehicle.
bool isAutopilot(const mavlink::Heartbeat &heartbeat)
{
    using namespace mavlink;
    if (heartbeat.autopilot == MAV_AUTOPILOT_INVALID) // the component declares that it is no autopilot
        return false;
    constexpr std::array<std::uint8_t, 19> kNoVehicles{MAV_TYPE_GCS,         MAV_TYPE_ONBOARD_CONTROLLER,
                                                       MAV_TYPE_GIMBAL,      MAV_TYPE_ADSB,
                                                       MAV_TYPE_CAMERA,      MAV_TYPE_CHARGING_STATION,
                                                       MAV_TYPE_FLARM,       MAV_TYPE_SERVO,
                                                       MAV_TYPE_ODID,        MAV_TYPE_BATTERY,
                                                       MAV_TYPE_PARACHUTE,   MAV_TYPE_LOG,
                                                       MAV_TYPE_OSD,         MAV_TYPE_IMU,
                                                       MAV_TYPE_GPS,         MAV_TYPE_WINCH,
                                                       MAV_TYPE_ILLUMINATOR, MAV_TYPE_GRIPPER,
                                                       MAV_TYPE_RADIO};
    return std::find(kNoVehicles.begin(), kNoVehicles.end(), heartbeat.type) == kNoVehicles.end();
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
    if (!announcesVehicle(frame))
        return false;
    const auto created = m_vehicles.emplace(system, Vehicle(m_config, system, frame.componentId())).first;
    created->second.handleFrame(now, wall, frame);
    return true;
}

bool VehicleSet::announcesVehicle(const mavlink::Frame &frame) const
{
    return frame.messageId() == mavlink::Heartbeat::kId && frame.systemId() != 0 && frame.systemId() != m_config.ownSystemId
        && isAutopilot(unpack<mavlink::Heartbeat>(frame));
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
