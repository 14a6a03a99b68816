#include "core/sim/frame_router.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/sim/wire_units.h"

namespace skyseal::sim {

namespace {

constexpr std::uint8_t kComponent = mavlink::MAV_COMP_ID_AUTOPILOT1;
constexpr int kWithoutFtp = 2; // of BRD_OPTIONS

} // namespace

bool FrameRouter::isForUs(const mavlink::Frame &frame) const
{
    if (frame.systemId() == systemId && frame.componentId() == kComponent)
        return false; // an echo of an own frame
    const std::uint8_t system = frame.targetSystem(), component = frame.targetComponent();
    return (system == 0 || system == systemId) && (component == 0 || component == kComponent);
}

void FrameRouter::route(TimePoint now, const mavlink::Frame &frame) const
{
    if (!isForUs(frame))
        return;
    const FrameSender peer{frame.systemId(), frame.componentId(), frame.version()};
    routeCommand(now, peer, frame) || routeMission(now, peer, frame) || routeParameter(now, frame) || control.handle(now, frame)
        || routeFile(now, peer, frame) || routeLink(now, peer, frame);
}

bool FrameRouter::routeCommand(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const
{
    if (frame.messageId() == mavlink::CommandLong::kId) {
        const auto in = mavlink::CommandLong::decode(frame.payload());
        const bool above = in.command != mavlink::MAV_CMD_DO_SET_HOME; // heights above home, as GCS_Common.cpp assumes
        commands.handle(now, peer,
                        {in.command,
                         std::uint8_t(above ? mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT : mavlink::MAV_FRAME_GLOBAL),
                         {in.param1, in.param2, in.param3, in.param4},
                         static_cast<double>(in.param5),
                         static_cast<double>(in.param6),
                         in.param7});
        return true;
    }
    if (frame.messageId() == mavlink::CommandInt::kId) {
        const auto in = mavlink::CommandInt::decode(frame.payload());
        commands.handle(now, peer,
                        {in.command, in.frame, {in.param1, in.param2, in.param3, in.param4}, in.x * 1e-7, in.y * 1e-7, in.z});
        return true;
    }
    return false;
}

bool FrameRouter::routeMission(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const
{
    using namespace mavlink;
    switch (frame.messageId()) {
    case MissionCount::kId: {
        const auto in = MissionCount::decode(frame.payload());
        missions.handleCount(now, peer, in.count, in.mission_type);
        return true;
    }
    case MissionItemInt::kId: {
        const auto in = MissionItemInt::decode(frame.payload());
        const StoredItem item{in.frame, in.command, in.autocontinue != 0, {in.param1, in.param2, in.param3, in.param4}, in.x,
                              in.y,     in.z};
        if (in.current >= 2)
            flyTo(peer, item, in.current);
        else
            missions.handleItem(now, peer, in.seq, item, in.mission_type);
        return true;
    }
    case mavlink::MissionItem::kId: {
        const auto in = mavlink::MissionItem::decode(frame.payload());
        const double scale = integerScale(in.command);
        const StoredItem item{in.frame,
                              in.command,
                              in.autocontinue != 0,
                              {in.param1, in.param2, in.param3, in.param4},
                              scaled<std::int32_t>(static_cast<double>(in.x), scale),
                              scaled<std::int32_t>(static_cast<double>(in.y), scale),
                              in.z};
        if (in.current >= 2)
            flyTo(peer, item, in.current);
        else
            missions.handleItem(now, peer, in.seq, item, in.mission_type);
        return true;
    }
    case MissionRequestList::kId:
        missions.handleRequestList(peer, MissionRequestList::decode(frame.payload()).mission_type);
        return true;
    case MissionRequest::kId: {
        const auto in = MissionRequest::decode(frame.payload());
        missions.handleRequest(peer, in.seq, in.mission_type, false);
        return true;
    }
    case MissionRequestInt::kId: {
        const auto in = MissionRequestInt::decode(frame.payload());
        missions.handleRequest(peer, in.seq, in.mission_type, true);
        return true;
    }
    case MissionClearAll::kId: missions.handleClear(peer, MissionClearAll::decode(frame.payload()).mission_type); return true;
    case MissionSetCurrent::kId: missions.handleSetCurrent(MissionSetCurrent::decode(frame.payload()).seq); return true;
    case MissionAck::kId: {
        const auto in = MissionAck::decode(frame.payload());
        missions.handleAck(peer, in.type, in.mission_type);
        return true;
    }
    default: return false;
    }
}

void FrameRouter::flyTo(const FrameSender &peer, const StoredItem &item, std::uint8_t kind) const
{
    auto place = CommandServer::place(autopilot, item.frame, item.x * 1e-7, item.y * 1e-7, static_cast<double>(item.z));
    if (place && kind == 3) { // only the height
        place->x = autopilot.modes().guided().place().north;
        place->y = autopilot.modes().guided().place().east;
    }
    const Refusal refusal = place ? autopilot.requests().goTo(*place) : Refusal("Goto: bad place");
    if (refusal)
        autopilot.texts().say(Severity::Warning, *refusal);
    missions.acknowledge(peer, refusal ? mavlink::MAV_MISSION_ERROR : mavlink::MAV_MISSION_ACCEPTED);
}

bool FrameRouter::routeParameter(TimePoint now, const mavlink::Frame &frame) const
{
    switch (frame.messageId()) {
    case mavlink::ParamRequestList::kId: parameters.requestList(now); return true;
    case mavlink::ParamRequestRead::kId: {
        const auto in = mavlink::ParamRequestRead::decode(frame.payload());
        parameters.requestRead(in.param_index, mavlink::textOf(in.param_id));
        return true;
    }
    case mavlink::ParamSet::kId: {
        const auto in = mavlink::ParamSet::decode(frame.payload());
        parameters.set(mavlink::textOf(in.param_id), in.param_value);
        return true;
    }
    default: return false;
    }
}

bool FrameRouter::routeFile(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const
{
    switch (frame.messageId()) {
    case mavlink::LogRequestList::kId: {
        const auto in = mavlink::LogRequestList::decode(frame.payload());
        logs.requestList(now, peer, in.start, in.end);
        return true;
    }
    case mavlink::LogRequestData::kId: {
        const auto in = mavlink::LogRequestData::decode(frame.payload());
        logs.requestData(now, peer, in.id, in.ofs, in.count);
        return true;
    }
    case mavlink::LogErase::kId: logs.erase(); return true;
    case mavlink::LogRequestEnd::kId: logs.requestEnd(); return true;
    case mavlink::FileTransferProtocol::kId:
        if ((autopilot.parameters().integer("BRD_OPTIONS") & kWithoutFtp) != 0) {
            autopilot.texts().say(Severity::Info, "FTP disabled"); // and no answer
            return true;
        }
        ftp.handle(now, peer, FtpMessage::decode(mavlink::FileTransferProtocol::decode(frame.payload()).payload));
        return true;
    default: return false;
    }
}

bool FrameRouter::routeLink(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const
{
    switch (frame.messageId()) {
    case mavlink::Heartbeat::kId:
        if (autopilot.parameters().isPilot(peer.system))
            station.heartbeat(now);
        return true;
    case mavlink::RequestDataStream::kId: {
        const auto in = mavlink::RequestDataStream::decode(frame.payload());
        if (StreamScheduler::requestGroup(autopilot.parameters(), in.req_stream_id,
                                          in.start_stop != 0 ? in.req_message_rate : 0)) {
            streams.forgetSingles(in.req_stream_id);
            streams.applyParameters(now, autopilot.parameters());
        }
        return true;
    }
    case mavlink::Timesync::kId: {
        const auto in = mavlink::Timesync::decode(frame.payload());
        if (in.tc1 != 0)
            return true; // an answer; this vehicle sends no requests
        mavlink::Timesync out;
        out.tc1 = std::max<std::int64_t>((now - boot).count(), 1);
        out.ts1 = in.ts1;
        out.target_system = peer.system;
        out.target_component = peer.component;
        outbox.send(out);
        return true;
    }
    case mavlink::Ping::kId: {
        auto ping = mavlink::Ping::decode(frame.payload());
        if (ping.target_system != 0)
            return true; // an answer
        ping.target_system = peer.system;
        ping.target_component = peer.component;
        outbox.send(ping);
        return true;
    }
    default: return false;
    }
}

} // namespace skyseal::sim
