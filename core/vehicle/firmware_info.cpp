#include "core/vehicle/firmware_info.h"

#include "core/vehicle/message_io.h"

namespace skyseal::vehicle {

namespace {

std::string productName(VehicleKind kind)
{
    if (kind.isPx4())
        return "PX4";
    if (!kind.isArduPilot())
        return "autopilot " + std::to_string(kind.autopilot);
    if (kind.isCopter())
        return "ArduCopter";
    if (kind.isPlane())
        return "ArduPlane";
    if (kind.isRover())
        return "ArduRover";
    if (kind.isSubmarine())
        return "ArduSub";
    return "ArduPilot";
}

/// Of a FIRMWARE_VERSION_TYPE; numbers between two entries count as the lower one.
std::string suffix(std::uint8_t type)
{
    if (type == mavlink::FIRMWARE_VERSION_TYPE_OFFICIAL)
        return {};
    if (type >= mavlink::FIRMWARE_VERSION_TYPE_RC)
        return "-rc";
    if (type >= mavlink::FIRMWARE_VERSION_TYPE_BETA)
        return "-beta";
    if (type >= mavlink::FIRMWARE_VERSION_TYPE_ALPHA)
        return "-alpha";
    return "-dev";
}

} // namespace

void FirmwareInfo::start(TimePoint now)
{
    if (m_attempts == 0 && m_text.empty())
        m_next = now;
}

void FirmwareInfo::handleVersion(std::uint32_t version, VehicleKind kind)
{
    m_next = kNever;
    m_text = productName(kind);
    if (version == 0)
        return;
    m_text += " " + std::to_string(version >> 24) + "." + std::to_string(version >> 16 & 0xff) + "."
        + std::to_string(version >> 8 & 0xff) + suffix(static_cast<std::uint8_t>(version & 0xff));
}

void FirmwareInfo::handleDeadline(TimePoint now, MessageQueue &outbox)
{
    if (now < m_next)
        return;
    mavlink::CommandLong request;
    request.target_system = m_addressing.system;
    request.target_component = m_addressing.component;
    const bool oldWay = m_attempts % 2 == 1;
    request.command = oldWay ? mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES : mavlink::MAV_CMD_REQUEST_MESSAGE;
    request.param1 = oldWay ? 1 : mavlink::AutopilotVersion::kId;
    push(outbox, request);
    ++m_attempts;
    m_next = m_attempts < kAttempts ? now + kInterval : kNever;
}

} // namespace skyseal::vehicle
