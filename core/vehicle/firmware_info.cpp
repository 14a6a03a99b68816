#include "core/vehicle/firmware_info.h"

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

/// Of a FIRMWARE_VERSION_TYPE; a number between two entries counts as the lower one.
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

/// `version` as flight_sw_version packs it: major, minor, patch, FIRMWARE_VERSION_TYPE from the highest byte down; 0 =
/// unknown.
std::string versionText(std::uint32_t version)
{
    if (version == 0)
        return {};
    return " " + std::to_string(version >> 24) + "." + std::to_string(version >> 16 & 0xff) + "."
        + std::to_string(version >> 8 & 0xff) + suffix(static_cast<std::uint8_t>(version & 0xff));
}

} // namespace

void FirmwareInfo::handleHeartbeat(TimePoint now)
{
    if (m_attempts == 0 && state().firmware.empty())
        m_next = now;
}

void FirmwareInfo::request(TimePoint now)
{
    m_attempts = 0;
    m_next = now;
    m_isNeeded = true;
}

bool FirmwareInfo::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::AutopilotVersion::kId)
        return false;
    const auto m = unpack<mavlink::AutopilotVersion>(frame);
    m_next = kNever;
    m_isNeeded = false;
    state().firmware = productName(kind()) + versionText(m.flight_sw_version);
    state().capabilities = m.capabilities;
    if ((m.capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MAVLINK2) != 0 && m_versionAttempts == 0)
        m_versionDue = now;
    return false; // clients may wait for it
}

void FirmwareInfo::handleDeadline(TimePoint now)
{
    if (mayAsk() && now >= m_versionDue)
        askForVersion2(now);
    if (now < nextRequest())
        return;
    mavlink::CommandLong request;
    const bool older = m_attempts % 2 == 1;
    request.command = older ? mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES : mavlink::MAV_CMD_REQUEST_MESSAGE;
    request.param1 = older ? 1 : mavlink::AutopilotVersion::kId;
    send(request, false);
    ++m_attempts;
    m_next = m_attempts < kAttempts ? now + kInterval : kNever;
}

void FirmwareInfo::askForVersion2(TimePoint now)
{
    m_versionDue = kNever;
    if (state().mavlinkVersion == 2)
        return;
    m_context.sendInVersion2(mavlink::CommandLong{.command = mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION, .param1 = 1});
    if (++m_versionAttempts < kVersionAttempts)
        m_versionDue = now + kInterval;
}

} // namespace skyseal::vehicle
