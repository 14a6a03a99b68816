#include "tests/sim/reference_conversation.h"

#include "core/base/number_text.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/field_value.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/messages.h"
#include "tests/support/command_long.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace skyseal::sim {

namespace {

using namespace mavlink;
using test::commandLong;

/// Messages that answer something, with the fields that a fact keeps.
struct Answer
{
    std::uint32_t message;
    std::vector<std::string_view> fields;
};
const std::vector<Answer> kAnswers{
    {CommandAck::kId, {"command", "result"}},
    {ParamValue::kId, {"param_id", "param_value", "param_type", "param_index"}},
    {AutopilotVersion::kId, {}},
    {MissionCount::kId, {"target_system", "target_component", "count", "mission_type"}},
    {MissionRequest::kId, {"target_system", "target_component", "seq", "mission_type"}},
    {MissionRequestInt::kId, {"target_system", "target_component", "seq", "mission_type"}},
    {MissionAck::kId, {"target_system", "target_component", "type", "mission_type"}},
    {MissionItem::kId, {"seq", "frame", "command", "current", "autocontinue", "z"}},
    {MissionItemInt::kId, {"seq", "frame", "command", "current", "autocontinue", "param1", "x", "y", "z"}},
    {LogEntry::kId, {"num_logs", "last_log_num"}},
    {LogData::kId, {"id", "ofs", "count"}},
    {Timesync::kId, {"ts1"}},
    {Ping::kId, {"seq", "target_system", "target_component"}},
    {HomePosition::kId, {}},
    {MessageInterval::kId, {"message_id", "interval_us"}},
};

/// Fields whose ranges are facts; the others are times, or not measured at rest.
const std::set<std::string> kRangeFields{"ATTITUDE.roll",
                                         "ATTITUDE.pitch",
                                         "ATTITUDE.yaw",
                                         "EKF_STATUS_REPORT.flags",
                                         "EKF_STATUS_REPORT.compass_variance",
                                         "EKF_STATUS_REPORT.pos_horiz_variance",
                                         "EKF_STATUS_REPORT.pos_vert_variance",
                                         "EKF_STATUS_REPORT.velocity_variance",
                                         "GLOBAL_POSITION_INT.alt",
                                         "GLOBAL_POSITION_INT.hdg",
                                         "GLOBAL_POSITION_INT.lat",
                                         "GLOBAL_POSITION_INT.lon",
                                         "GLOBAL_POSITION_INT.relative_alt",
                                         "GLOBAL_POSITION_INT.vx",
                                         "GLOBAL_POSITION_INT.vy",
                                         "GLOBAL_POSITION_INT.vz",
                                         "GPS_RAW_INT.eph",
                                         "GPS_RAW_INT.epv",
                                         "GPS_RAW_INT.fix_type",
                                         "GPS_RAW_INT.satellites_visible",
                                         "HEARTBEAT.autopilot",
                                         "HEARTBEAT.base_mode",
                                         "HEARTBEAT.custom_mode",
                                         "HEARTBEAT.mavlink_version",
                                         "HEARTBEAT.system_status",
                                         "HEARTBEAT.type",
                                         "MISSION_CURRENT.seq",
                                         "POWER_STATUS.Vcc",
                                         "RAW_IMU.xmag",
                                         "RAW_IMU.ymag",
                                         "RAW_IMU.zmag",
                                         "RAW_IMU.xacc",
                                         "RAW_IMU.yacc",
                                         "RAW_IMU.zacc",
                                         "RC_CHANNELS.chan1_raw",
                                         "RC_CHANNELS.chan2_raw",
                                         "RC_CHANNELS.chan3_raw",
                                         "RC_CHANNELS.chan4_raw",
                                         "RC_CHANNELS.chan5_raw",
                                         "RC_CHANNELS.chancount",
                                         "SCALED_PRESSURE.press_abs",
                                         "SERVO_OUTPUT_RAW.servo1_raw",
                                         "SERVO_OUTPUT_RAW.servo5_raw",
                                         "SYS_STATUS.battery_remaining",
                                         "SYS_STATUS.voltage_battery",
                                         "VFR_HUD.airspeed",
                                         "VFR_HUD.alt",
                                         "VFR_HUD.climb",
                                         "VFR_HUD.groundspeed",
                                         "VFR_HUD.heading",
                                         "VFR_HUD.throttle"};

std::string describe(const Frame &frame)
{
    const auto kind = std::find_if(kAnswers.begin(), kAnswers.end(),
                                   [&](const Answer &answer) { return answer.message == frame.messageId(); });
    if (kind == kAnswers.end())
        return {};
    const MessageInfo &info = frame.info();
    std::string out(info.name);
    for (const std::string_view name : kind->fields) {
        const FieldInfo &field = *info.field(name);
        out += ' ' + std::string(name) + '=';
        if (field.type == FieldType::Char)
            out += mavlink::fieldText(frame.payload(), field);
        else
            out += toText(fieldValue(frame.payload(), field));
    }
    return out;
}

class Conversation
{
public:
    explicit Conversation(ReferencePeer &peer) : m_peer(peer) {}

    ReferenceFacts facts;
    std::string problem;

    void hold()
    {
        listen(facts.silentRates, 6);
        requestStreams();
        require(until([&] { return ready(); }, 90), "no position");
        listen(facts.rates, 20);
        measureRanges();
        askQuestions();
        askForParameters();
        transferMission();
        askForLogs(); // none was written yet, or those of before
        fly();
    }

private:
    template<typename Message> void send(const Message &message)
    {
        std::array<std::uint8_t, kMaxFrameLength> buffer;
        m_peer.send(m_writer.write(message, buffer));
    }

    void require(bool condition, const char *what)
    {
        if (!condition && problem.empty())
            problem = what;
    }

    void run(double seconds) { require(m_peer.run(seconds), "the vehicle stopped"); }

    bool until(const std::function<bool()> &condition, double limit)
    {
        for (double waited = 0; waited < limit && problem.empty(); waited += 0.2) {
            if (condition())
                return true;
            run(0.2);
        }
        return condition();
    }

    template<typename Visit> void visit(std::size_t from, Visit &&each) const
    {
        for (std::size_t i = from; i < m_peer.received.size(); ++i) {
            if (const auto frame = readFrame(m_peer.received[i], Dialect::builtin()))
                each(*frame);
        }
    }

    template<typename Message> Message last() const
    {
        Message out;
        visit(m_peer.received.size() > 2000 ? m_peer.received.size() - 2000 : 0, [&](const Frame &frame) {
            if (frame.messageId() == Message::kId)
                out = Message::decode(frame.payload());
        });
        return out;
    }

    bool ready() const { return (last<EkfStatusReport>().flags & EKF_POS_HORIZ_ABS) && last<GpsRawInt>().fix_type >= 3; }
    bool armed() const { return (last<mavlink::Heartbeat>().base_mode & MAV_MODE_FLAG_SAFETY_ARMED) != 0; }

    void listen(std::map<std::string, double> &rates, double seconds)
    {
        run(1); // what a request changes takes effect
        const std::size_t from = m_peer.received.size();
        run(seconds);
        visit(from, [&](const Frame &frame) {
            if (frame.messageId() != Statustext::kId)
                rates[std::string(frame.info().name)] += 1 / seconds;
        });
    }

    /// As the station of this project does, see StreamRequester.
    void requestStreams()
    {
        constexpr std::array<std::pair<std::uint8_t, std::uint16_t>, 7> kGroups{{{MAV_DATA_STREAM_RAW_SENSORS, 2},
                                                                                 {MAV_DATA_STREAM_EXTENDED_STATUS, 2},
                                                                                 {MAV_DATA_STREAM_RC_CHANNELS, 2},
                                                                                 {MAV_DATA_STREAM_POSITION, 3},
                                                                                 {MAV_DATA_STREAM_EXTRA1, 10},
                                                                                 {MAV_DATA_STREAM_EXTRA2, 10},
                                                                                 {MAV_DATA_STREAM_EXTRA3, 3}}};
        for (const auto &[stream, rate] : kGroups) {
            RequestDataStream request;
            request.target_system = 1;
            request.target_component = 1;
            request.req_stream_id = stream;
            request.req_message_rate = rate;
            request.start_stop = 1;
            send(request);
        }
    }

    void measureRanges()
    {
        const std::size_t from = m_peer.received.size();
        run(10);
        visit(from, [&](const Frame &frame) {
            for (const FieldInfo &field : frame.info().fields) {
                const std::string name = std::string(frame.info().name) + '.' + std::string(field.name);
                if (!kRangeFields.contains(name))
                    continue;
                const double value = fieldValue(frame.payload(), field).asDouble();
                const auto [range, first] = facts.ranges.try_emplace(name, value, value);
                range->second = {std::min(range->second.first, value), std::max(range->second.second, value)};
            }
        });
    }

    /// The answers that come within `seconds` of a request.
    template<typename Message> void ask(const std::string &step, const Message &message, double seconds = 1)
    {
        const std::size_t from = m_peer.received.size();
        send(message);
        run(seconds);
        std::vector<std::string> &answers = facts.answers[step];
        visit(from, [&](const Frame &frame) {
            std::string text = isUnasked(frame) ? std::string() : describe(frame);
            // A repetition depends on the time that an answer of the station takes.
            if (!text.empty() && (answers.empty() || answers.back() != text))
                answers.push_back(std::move(text));
        });
    }

    /// The vehicle's own questions about the time, and counters that it stores now and then.
    static bool isUnasked(const Frame &frame)
    {
        if (frame.messageId() == Timesync::kId)
            return Timesync::decode(frame.payload()).tc1 == 0;
        return frame.messageId() == ParamValue::kId
            && mavlink::textOf(ParamValue::decode(frame.payload()).param_id).starts_with("STAT_");
    }

    void askQuestions()
    {
        ask("version", commandLong(MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, {1}));
        ask("home", commandLong(MAV_CMD_GET_HOME_POSITION));
        ask("request message", commandLong(MAV_CMD_REQUEST_MESSAGE, {float(AutopilotVersion::kId)}));
        ask("message interval", commandLong(MAV_CMD_SET_MESSAGE_INTERVAL, {float(SystemTime::kId), 200'000}));
        ask("unknown command", commandLong(31'999));
        CommandLong other = commandLong(MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, {1});
        other.target_system = 77;
        ask("another vehicle is asked", other);
        Timesync sync;
        sync.ts1 = 123'456;
        ask("time", sync);
        Ping ping;
        ping.seq = 7;
        ask("ping", ping);
    }

    static ParamRequestRead parameterByName(std::string_view name)
    {
        ParamRequestRead out;
        out.target_system = 1;
        out.target_component = 1;
        out.param_index = -1;
        std::copy(name.begin(), name.end(), out.param_id.begin());
        return out;
    }
    static ParamSet parameterChange(std::string_view name, float value)
    {
        ParamSet out;
        out.target_system = 1;
        out.target_component = 1;
        out.param_type = MAV_PARAM_TYPE_REAL32;
        out.param_value = value;
        std::copy(name.begin(), name.end(), out.param_id.begin());
        return out;
    }

    void askForParameters()
    {
        ask("read a parameter", parameterByName("SYSID_MYGCS"));
        ParamRequestRead third = parameterByName({});
        third.param_index = 3;
        const std::size_t from3 = m_peer.received.size();
        send(third);
        run(1);
        visit(from3, [&](const Frame &frame) {
            if (frame.messageId() == ParamValue::kId && !isUnasked(frame))
                facts.answers["read parameter 3"] = {"PARAM_VALUE param_index="
                                                     + std::to_string(ParamValue::decode(frame.payload()).param_index)};
        });
        ask("read an unknown parameter", parameterByName("NO_SUCH_ONE"));
        ask("set an integer", parameterChange("SYSID_MYGCS", 255));
        ask("set a fraction of an integer", parameterChange("RTL_ALT", 2000.4f));
        ask("set a float", parameterChange("WPNAV_SPEED", 750));
        ask("set an unknown parameter", parameterChange("NO_SUCH_ONE", 1));

        ParamRequestList list;
        list.target_system = 1;
        list.target_component = 1;
        const std::size_t from = m_peer.received.size();
        send(list);
        const auto values = [&] {
            std::vector<ParamValue> out;
            visit(from, [&](const Frame &frame) {
                if (frame.messageId() == ParamValue::kId)
                    out.push_back(ParamValue::decode(frame.payload()));
            });
            return out;
        };
        require(until([&] { return !values().empty() && values().size() >= values().front().param_count; }, 120),
                "the list of parameters did not end");
        bool inOrder = true, sameCount = true;
        std::size_t next = 0;
        for (const ParamValue &value : values()) {
            inOrder = inOrder && value.param_index == next++;
            sameCount = sameCount && value.param_count == values().front().param_count;
        }
        facts.answers["list parameters"] = {inOrder && sameCount && next == values().front().param_count
                                                ? "every index once, rising, with one count"
                                                : "irregular"};
    }

    static mavlink::MissionItemInt item(std::uint16_t sequence, std::uint16_t command, float z)
    {
        mavlink::MissionItemInt out;
        out.target_system = 1;
        out.target_component = 1;
        out.seq = sequence;
        out.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
        out.command = command;
        out.autocontinue = 1;
        out.x = -353632000 + sequence * 1000;
        out.y = 1491652000;
        out.z = z;
        return out;
    }
    template<typename Message> static Message toVehicle(std::uint8_t type = 0)
    {
        Message out;
        out.target_system = 1;
        out.target_component = 1;
        out.mission_type = type;
        return out;
    }

    void transferMission()
    {
        auto count = toVehicle<MissionCount>();
        count.count = 4;
        ask("upload a mission", count, 0.5);
        ask("item 0", item(0, MAV_CMD_NAV_WAYPOINT, 0), 0.5);
        ask("item 2 instead of 1", item(2, MAV_CMD_NAV_WAYPOINT, 20), 0.5);
        ask("item 1", item(1, MAV_CMD_NAV_TAKEOFF, 20), 0.5);
        ask("item 1 again", item(1, MAV_CMD_NAV_TAKEOFF, 20), 0.5);
        ask("item 2", item(2, MAV_CMD_NAV_WAYPOINT, 25), 0.5);
        ask("item 3", item(3, MAV_CMD_NAV_RETURN_TO_LAUNCH, 0), 0.5);
        ask("item 3 again", item(3, MAV_CMD_NAV_RETURN_TO_LAUNCH, 0), 0.5);
        ask("list the mission", toVehicle<MissionRequestList>());
        for (const int sequence : {1, 3}) {
            auto request = toVehicle<MissionRequestInt>();
            request.seq = static_cast<std::uint16_t>(sequence);
            ask("read item " + std::to_string(sequence), request);
        }
        auto inFloats = toVehicle<MissionRequest>();
        inFloats.seq = 2;
        ask("read item 2 in floats", inFloats);
        auto beyond = toVehicle<MissionRequestInt>();
        beyond.seq = 9;
        ask("read an item beyond the end", beyond);
        ask("list the fence", toVehicle<MissionRequestList>(MAV_MISSION_TYPE_FENCE));
        ask("list the rally points", toVehicle<MissionRequestList>(MAV_MISSION_TYPE_RALLY));
        ask("clear the mission", toVehicle<MissionClearAll>());
        ask("list an empty mission", toVehicle<MissionRequestList>());
        auto tooMany = toVehicle<MissionCount>();
        tooMany.count = 5000;
        ask("upload too many items", tooMany);
    }

    void askForLogs()
    {
        LogRequestList list;
        list.target_system = 1;
        list.target_component = 1;
        list.end = 0xffff;
        ask("list logs", list);
    }

    void fly()
    {
        SetMode byMessage;
        byMessage.target_system = 1;
        byMessage.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
        byMessage.custom_mode = COPTER_MODE_LAND;
        ask("set a mode by SET_MODE", byMessage);
        ask("arm in LAND", commandLong(MAV_CMD_COMPONENT_ARM_DISARM, {1}));
        byMessage.custom_mode = 99;
        ask("set an unknown mode by SET_MODE", byMessage);
        ask("set an unknown mode by command", commandLong(MAV_CMD_DO_SET_MODE, {1, 99}));
        ask("set GUIDED by command", commandLong(MAV_CMD_DO_SET_MODE, {1, COPTER_MODE_GUIDED}));
        ask("take off disarmed", commandLong(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}));
        require(until(
                    [&] {
                        send(commandLong(MAV_CMD_COMPONENT_ARM_DISARM, {1})); // its checks may need some time
                        run(2);
                        return armed();
                    },
                    90),
                "not armed");
        ask("arm again", commandLong(MAV_CMD_COMPONENT_ARM_DISARM, {1}));
        ask("take off", commandLong(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}));
        require(until([&] { return last<GlobalPositionInt>().relative_alt > 9500; }, 60), "no climb");
        ask("take off in the air", commandLong(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 20}));
        ask("disarm in the air", commandLong(MAV_CMD_COMPONENT_ARM_DISARM, {0}));
        ask("change the speed", commandLong(MAV_CMD_DO_CHANGE_SPEED, {1, 4, -1}));
        ask("turn", commandLong(MAV_CMD_CONDITION_YAW, {90, 20, 1, 0}));
        ask("land", commandLong(MAV_CMD_NAV_LAND));
        require(until([&] { return !armed(); }, 90), "no landing");
        ask("disarm again", commandLong(MAV_CMD_COMPONENT_ARM_DISARM, {0}));
    }

    ReferencePeer &m_peer;
    FrameWriter m_writer{255, 190};
};

} // namespace

ReferenceFacts holdConversation(ReferencePeer &peer, std::string &problem)
{
    Conversation conversation(peer);
    conversation.hold();
    problem = conversation.problem;
    return std::move(conversation.facts);
}

std::string ReferenceFacts::toText() const
{
    std::ostringstream out;
    out.precision(12);
    for (const auto &[message, rate] : silentRates)
        out << "silent|" << message << '|' << rate << '\n';
    for (const auto &[message, rate] : rates)
        out << "rate|" << message << '|' << rate << '\n';
    for (const auto &[step, list] : answers) {
        out << "ask|" << step << '\n';
        for (const std::string &answer : list)
            out << "answer|" << step << '|' << answer << '\n';
    }
    for (const auto &[field, range] : ranges)
        out << "range|" << field << '|' << range.first << '|' << range.second << '\n';
    return out.str();
}

ReferenceFacts ReferenceFacts::fromText(const std::string &text)
{
    ReferenceFacts facts;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> parts;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '|');)
            parts.push_back(cell);
        if (parts.size() == 3 && parts[0] == "silent")
            facts.silentRates[parts[1]] = finiteNumber(parts[2]).value_or(0);
        else if (parts.size() == 3 && parts[0] == "rate")
            facts.rates[parts[1]] = finiteNumber(parts[2]).value_or(0);
        else if (parts.size() == 2 && parts[0] == "ask")
            facts.answers[parts[1]];
        else if (parts.size() == 3 && parts[0] == "answer")
            facts.answers[parts[1]].push_back(parts[2]);
        else if (parts.size() == 4 && parts[0] == "range")
            facts.ranges[parts[1]] = {finiteNumber(parts[2]).value_or(0), finiteNumber(parts[3]).value_or(0)};
    }
    return facts;
}

} // namespace skyseal::sim
