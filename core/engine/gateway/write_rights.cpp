#include "core/engine/gateway/write_rights.h"

#include "core/mavlink/frame_header.h"
#include "core/mavlink/message_ids.h"
#include "core/mavlink/messages.h"

#include <array>

namespace skyseal::engine {

namespace {

constexpr std::array kClasses{WriteClass::Mission, WriteClass::Parameter, WriteClass::Command, WriteClass::Ftp, WriteClass::Rc};

constexpr std::uint8_t bitOf(WriteClass writeClass)
{
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(writeClass));
}

/// An autopilot flies to such an item, or takes its altitude, at once ("guided mode" in the description of the field
/// MISSION_ITEM.current); the mission is not changed.
constexpr std::uint8_t kFirstCommandingCurrent = 2;

bool isCommandingItem(const mavlink::ScanItem &item)
{
    if (!item.frame)
        return false;
    const ByteView payload = item.frame->payload();
    switch (item.frame->messageId()) {
    case mavlink::MissionItem::kId: return mavlink::MissionItem::decode(payload).current >= kFirstCommandingCurrent;
    case mavlink::MissionItemInt::kId: return mavlink::MissionItemInt::decode(payload).current >= kFirstCommandingCurrent;
    default: return false;
    }
}

} // namespace

std::string_view keyword(WriteClass writeClass)
{
    switch (writeClass) {
    case WriteClass::Mission: return "mission";
    case WriteClass::Parameter: return "param";
    case WriteClass::Command: return "command";
    case WriteClass::Ftp: return "ftp";
    case WriteClass::Rc: return "rc";
    }
    return "";
}

std::optional<WriteClass> writeClassOf(const mavlink::ScanItem &item)
{
    using enum WriteClass;
    if (isCommandingItem(item))
        return Command;
    switch (mavlink::messageIdOf(item.bytes)) {
    case mavlink::MAVLINK_MSG_ID_MISSION_COUNT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ACK:
    case mavlink::MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
    case mavlink::MAVLINK_MSG_ID_MISSION_REQUEST_PARTIAL_LIST:
    case mavlink::MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST:
    case mavlink::MAVLINK_MSG_ID_FENCE_POINT:
    case mavlink::MAVLINK_MSG_ID_FENCE_FETCH_POINT:
    case mavlink::MAVLINK_MSG_ID_RALLY_POINT:
    case mavlink::MAVLINK_MSG_ID_RALLY_FETCH_POINT: return Mission;
    case mavlink::MAVLINK_MSG_ID_PARAM_SET:
    case mavlink::MAVLINK_MSG_ID_PARAM_EXT_SET:
    case mavlink::MAVLINK_MSG_ID_PARAM_MAP_RC: return Parameter;
    case mavlink::MAVLINK_MSG_ID_COMMAND_LONG:
    case mavlink::MAVLINK_MSG_ID_COMMAND_INT:
    case mavlink::MAVLINK_MSG_ID_COMMAND_CANCEL:
    case mavlink::MAVLINK_MSG_ID_SET_MODE:
    case mavlink::MAVLINK_MSG_ID_MISSION_SET_CURRENT:
    case mavlink::MAVLINK_MSG_ID_REQUEST_DATA_STREAM:
    case mavlink::MAVLINK_MSG_ID_SET_HOME_POSITION:
    case mavlink::MAVLINK_MSG_ID_SET_GPS_GLOBAL_ORIGIN:
    case mavlink::MAVLINK_MSG_ID_SET_ATTITUDE_TARGET:
    case mavlink::MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED:
    case mavlink::MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT: return Command;
    case mavlink::MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL:
    case mavlink::MAVLINK_MSG_ID_LOG_REQUEST_LIST:
    case mavlink::MAVLINK_MSG_ID_LOG_REQUEST_DATA:
    case mavlink::MAVLINK_MSG_ID_LOG_REQUEST_END:
    case mavlink::MAVLINK_MSG_ID_LOG_ERASE: return Ftp;
    case mavlink::MAVLINK_MSG_ID_RC_CHANNELS_OVERRIDE:
    case mavlink::MAVLINK_MSG_ID_MANUAL_CONTROL: return Rc;
    default: return std::nullopt;
    }
}

WriteRights WriteRights::all()
{
    WriteRights out;
    out.m_all = true;
    return out;
}

Result<WriteRights, Reason> WriteRights::parse(std::string_view text)
{
    if (text == "all")
        return all();
    WriteRights out;
    if (text == "none")
        return out;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view name = text.substr(0, comma);
        bool known = false;
        for (const WriteClass writeClass : kClasses) {
            if (name == keyword(writeClass)) {
                out.m_classes |= bitOf(writeClass);
                known = true;
            }
        }
        if (!known)
            return tl::unexpected(sentence(
                "Reason", "write='%1': none, all, or mission, param, command, ftp and rc are expected")(std::string(name)));
        if (comma == std::string_view::npos)
            return out;
        text.remove_prefix(comma + 1);
    }
}

bool WriteRights::mayWrite(const mavlink::ScanItem &item) const
{
    if (m_all)
        return true;
    const auto writeClass = writeClassOf(item);
    return writeClass && (m_classes & bitOf(*writeClass));
}

std::string WriteRights::toText() const
{
    if (m_all)
        return "all";
    std::string out;
    for (const WriteClass writeClass : kClasses) {
        if (m_classes & bitOf(writeClass))
            out.append(out.empty() ? "" : ",").append(keyword(writeClass));
    }
    return out.empty() ? "none" : out;
}

} // namespace skyseal::engine
