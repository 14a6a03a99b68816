#include "core/vehicle/mode_list.h"

#include "core/mavlink/dialect.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

/// The mode's own name; standard modes may come without, and have the name of the autopilot's table or of the standard.
std::string ownName(VehicleKind kind, const mavlink::AvailableModes &mode)
{
    std::string name;
    for (const char letter : mavlink::textOf(mode.mode_name))
        name += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    if (!name.empty())
        return name;
    name = modeName(kind, mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, mode.custom_mode);
    if (!name.starts_with("MODE(") || mode.standard_mode == mavlink::MAV_STANDARD_MODE_NON_STANDARD)
        return name;
    static const mavlink::EnumInfo *const kStandard = mavlink::Dialect::builtin().enumeration("MAV_STANDARD_MODE");
    constexpr std::string_view kPrefix = "MAV_STANDARD_MODE_";
    const std::string_view entry = kStandard->nameOf(mode.standard_mode);
    return entry.starts_with(kPrefix) ? std::string(entry.substr(kPrefix.size())) : name;
}

} // namespace

bool ModeList::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() == mavlink::AvailableModes::kId) {
        handleMode(now, unpack<mavlink::AvailableModes>(frame));
        return true;
    }
    if (frame.messageId() == mavlink::CommandAck::kId)
        handleResult(unpack<mavlink::CommandAck>(frame));
    if (frame.messageId() != mavlink::AvailableModesMonitor::kId)
        return false;
    const std::uint8_t sequence = unpack<mavlink::AvailableModesMonitor>(frame).seq;
    if (m_kind && m_sequence && sequence != *m_sequence)
        start(now);
    m_sequence = sequence;
    return true;
}

void ModeList::handleHeartbeat(TimePoint now)
{
    if (m_profile != StreamProfile::Standard || state().firmware.empty() || m_kind == kind() || state().mavlinkVersion == 1)
        return; // MAVLink 1 has no place for AVAILABLE_MODES
    m_kind = kind();
    start(now);
}

void ModeList::start(TimePoint now)
{
    m_modes.clear();
    m_expected = 0;
    m_attempts = 0;
    m_next = now;
}

void ModeList::handleMode(TimePoint now, const mavlink::AvailableModes &mode)
{
    if (mode.number_modes == 0 || mode.mode_index == 0 || mode.mode_index > mode.number_modes)
        return;
    if (mode.number_modes != m_expected) // another list
        m_modes.clear();
    m_expected = mode.number_modes;
    m_modes.insert_or_assign(mode.mode_index, mode);
    m_attempts = 0;
    m_next = now + kSilence;
    if (m_modes.size() == m_expected) {
        m_next = kNever;
        publish();
    }
}

void ModeList::handleResult(const mavlink::CommandAck &ack)
{
    const bool isRefused = ack.result == mavlink::MAV_RESULT_UNSUPPORTED || ack.result == mavlink::MAV_RESULT_DENIED
        || ack.result == mavlink::MAV_RESULT_FAILED;
    if (ack.command == mavlink::MAV_CMD_REQUEST_MESSAGE && isRefused && m_attempts > 0 && m_modes.empty()
        && addressing().isForUs(ack.target_system, ack.target_component))
        m_next = kNever;
}

void ModeList::handleDeadline(TimePoint now)
{
    if (now < m_next)
        return;
    std::uint8_t missing = 0; // all
    if (!m_modes.empty()) {
        missing = 1;
        while (m_modes.contains(missing))
            ++missing;
    }
    mavlink::CommandLong request;
    request.command = mavlink::MAV_CMD_REQUEST_MESSAGE;
    request.param1 = mavlink::AvailableModes::kId;
    request.param2 = missing;
    send(request, false);
    ++m_attempts;
    m_next = m_attempts < kAttempts ? now + kSilence : kNever;
}

void ModeList::publish()
{
    std::vector<OwnMode> modes;
    for (const auto &[index, mode] : m_modes) {
        if (std::ranges::find(modes, mode.custom_mode, &OwnMode::number) == modes.end())
            modes.push_back({mode.custom_mode, ownName(kind(), mode),
                             (mode.properties & mavlink::MAV_MODE_PROPERTY_NOT_USER_SELECTABLE) == 0});
    }
    // Programs beside the autopilot choose the names of their modes freely. A mode of the autopilot keeps its name.
    std::vector<std::string> names;
    for (const OwnMode &mode : modes) {
        const auto owner = modeNumber(kind(), mode.name), first = modeNumber({}, mode.name, modes);
        const bool isOwner = (owner ? owner : first) == mode.number;
        names.push_back(isOwner ? mode.name : mode.name + " (" + std::to_string(mode.number) + ")");
    }
    for (std::size_t i = 0; i < modes.size(); ++i)
        modes[i].name = std::move(names[i]);
    std::ranges::sort(modes, {}, &OwnMode::number);
    VehicleState &s = state();
    s.ownModes = std::move(modes);
    const auto isVertical = [this](const OwnMode &mode) { return isVerticalMode(kind(), mode.number); };
    s.verticalTakeOff = s.verticalTakeOff || std::ranges::any_of(s.ownModes, isVertical);
    s.modes = modeNames(kind(), s.verticalTakeOff, s.ownModes);
    s.mode = modeName(kind(), s.baseMode, s.customMode, s.ownModes);
}

} // namespace skyseal::vehicle
