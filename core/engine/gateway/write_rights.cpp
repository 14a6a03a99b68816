#include "core/engine/gateway/write_rights.h"

#include "core/mavlink/message_ids.h"

#include <array>

namespace skyseal::engine {

namespace {

constexpr std::array kClasses{WriteClass::Mission, WriteClass::Parameter, WriteClass::Command, WriteClass::Ftp, WriteClass::Rc};

constexpr std::uint8_t bitOf(WriteClass writeClass)
{
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(writeClass));
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

std::optional<WriteClass> writeClassOf(std::uint32_t messageId)
{
    using enum WriteClass;
    switch (messageId) {
    case mavlink::MAVLINK_MSG_ID_MISSION_COUNT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ACK:
    case mavlink::MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
    case mavlink::MAVLINK_MSG_ID_MISSION_SET_CURRENT:
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

Result<WriteRights, std::string> WriteRights::parse(std::string_view text)
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
            return tl::unexpected("'" + std::string(name)
                                  + "': none, all, or mission, param, command, ftp and rc are expected");
        if (comma == std::string_view::npos)
            return out;
        text.remove_prefix(comma + 1);
    }
}

bool WriteRights::mayWrite(std::uint32_t messageId) const
{
    if (m_all)
        return true;
    const auto writeClass = writeClassOf(messageId);
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
