#include "core/vehicle/stream_requester.h"

#include <algorithm>
#include <cmath>

namespace skyseal::vehicle {

namespace {

using namespace mavlink;

/// A stream group of ArduPilot, and messages that show that it arrives.
struct Group
{
    std::uint8_t stream;           ///< MAV_DATA_STREAM
    double standard, lowBandwidth; ///< Hz, 0 = stop
    std::array<std::uint32_t, 3> messages;
};

constexpr std::array<Group, 7> kStreamGroups{{
    {MAV_DATA_STREAM_RAW_SENSORS, 2, 0, {RawImu::kId, ScaledPressure::kId, ScaledImu2::kId}},
    {MAV_DATA_STREAM_EXTENDED_STATUS, 2, 1, {SysStatus::kId, GpsRawInt::kId, MissionCurrent::kId}},
    {MAV_DATA_STREAM_RC_CHANNELS, 2, 0, {RcChannels::kId, RcChannelsRaw::kId, ServoOutputRaw::kId}},
    {MAV_DATA_STREAM_POSITION, 3, 1, {GlobalPositionInt::kId, LocalPositionNed::kId, GlobalPositionInt::kId}},
    {MAV_DATA_STREAM_EXTRA1, 10, 2, {Attitude::kId, Attitude::kId, Attitude::kId}},
    {MAV_DATA_STREAM_EXTRA2, 10, 1, {VfrHud::kId, VfrHud::kId, VfrHud::kId}},
    {MAV_DATA_STREAM_EXTRA3, 3, 1, {EkfStatusReport::kId, Vibration::kId, BatteryStatus::kId}},
}};

/// Single messages: those outside the groups of ArduPilot, and for other autopilots the main messages of the groups.
struct Single
{
    std::uint32_t message;
    double standard, lowBandwidth; ///< Hz
    bool inGroups;                 ///< ArduPilot sends it with a stream group
};

constexpr std::array<Single, 8> kSingleMessages{{
    {HomePosition::kId, 0.5, 0.1, false},
    {ExtendedSysState::kId, 1, 0.5, false},
    {Attitude::kId, 10, 2, true},
    {GlobalPositionInt::kId, 3, 1, true},
    {VfrHud::kId, 10, 1, true},
    {SysStatus::kId, 2, 1, true},
    {GpsRawInt::kId, 2, 1, true},
    {EstimatorStatus::kId, 1, 0.5, true},
}};

} // namespace

void StreamRequester::Expectation::request(TimePoint now)
{
    due = now;
    isRequestPending = true;
}

void StreamRequester::Expectation::requested(TimePoint now)
{
    isRequestPending = false;
    due = now + patience;
    patience = std::min(patience * 2, kLongestSilence);
}

void StreamRequester::Expectation::arrived(TimePoint now)
{
    if (due == kNever || isRequestPending)
        return;
    patience = kSilence;
    due = now + kSilence;
}

StreamRequester::StreamRequester(VehicleContext &context, StreamProfile profile, double rate)
    : MicroProtocol(context), m_profile(profile), m_rate(rate)
{
    static_assert(kStreamGroups.size() == kGroups && kSingleMessages.size() == kMessages);
}

void StreamRequester::setProfile(TimePoint now, StreamProfile profile, double rate)
{
    m_profile = profile;
    m_rate = rate;
    restart(now);
}

void StreamRequester::handleHeartbeat(TimePoint now)
{
    if (m_kind == kind())
        return;
    m_kind = kind();
    restart(now);
}

bool StreamRequester::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    noteArrival(now, frame.messageId());
    if (frame.messageId() == CommandAck::kId) {
        const auto ack = unpack<CommandAck>(frame);
        if (!addressing().isForUs(ack.target_system, ack.target_component))
            return false;
        if (ack.command == MAV_CMD_SET_MESSAGE_INTERVAL)
            handleIntervalResult(now, ack.result);
        else if (ack.command == MAV_CMD_GET_HOME_POSITION && ack.result == MAV_RESULT_UNSUPPORTED)
            m_home = {};
    }
    return false;
}

void StreamRequester::noteArrival(TimePoint now, std::uint32_t messageId)
{
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto &messages = kStreamGroups[i].messages;
        if (std::find(messages.begin(), messages.end(), messageId) != messages.end())
            m_groups[i].arrived(now);
    }
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (kSingleMessages[i].message == messageId)
            m_messages[i].arrived(now);
    }
    if (messageId == HomePosition::kId)
        m_home.arrived(now);
}

void StreamRequester::handleIntervalResult(TimePoint now, std::uint8_t result)
{
    if (result != MAV_RESULT_UNSUPPORTED || !m_intervalsSupported)
        return;
    m_intervalsSupported = false;
    m_messages.fill({});
    m_home.request(now);
}

void StreamRequester::handleDeadline(TimePoint now)
{
    if (!mayAsk())
        return;
    const bool low = m_profile == StreamProfile::LowBandwidth;
    for (std::size_t i = 0; i < kGroups; ++i) {
        if (now < m_groups[i].due)
            continue;
        const Group &group = kStreamGroups[i];
        const double rate = m_rate > 0 ? m_rate : low ? group.lowBandwidth : group.standard;
        mavlink::RequestDataStream request;
        request.req_stream_id = group.stream;
        request.req_message_rate = static_cast<std::uint16_t>(std::clamp(std::ceil(rate), 0.0, 1000.0));
        request.start_stop = rate > 0;
        send(request, false);
        m_groups[i].requested(now);
        if (!(rate > 0))
            m_groups[i] = {}; // stopped: no message is expected
    }
    if (now >= m_home.due) {
        mavlink::CommandLong request;
        request.command = MAV_CMD_GET_HOME_POSITION;
        send(request, false);
        m_home.requested(now);
    }
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (now < m_messages[i].due)
            continue;
        const Single &single = kSingleMessages[i];
        // Messages outside the groups change slowly and do not need a higher rate.
        const double rate = m_rate > 0 && single.inGroups ? m_rate : low ? single.lowBandwidth : single.standard;
        mavlink::CommandLong request;
        request.command = MAV_CMD_SET_MESSAGE_INTERVAL;
        request.param1 = static_cast<float>(single.message);
        request.param2 = static_cast<float>(1e6 / rate); // microseconds
        send(request, false);
        m_messages[i].requested(now);
    }
}

TimePoint StreamRequester::nextDeadline() const
{
    if (!mayAsk())
        return kNever;
    TimePoint next = m_home.due;
    for (const Expectation &group : m_groups)
        next = std::min(next, group.due);
    for (const Expectation &message : m_messages)
        next = std::min(next, message.due);
    return next;
}

void StreamRequester::restart(TimePoint now)
{
    m_groups.fill({});
    m_messages.fill({});
    m_home = {};
    if (!isActive())
        return;
    if (m_kind->isArduPilot()) {
        for (Expectation &group : m_groups)
            group.request(now);
    }
    if (!m_intervalsSupported) {
        m_home.request(now);
        return;
    }
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (!kSingleMessages[i].inGroups || !m_kind->isArduPilot())
            m_messages[i].request(now);
    }
}

bool StreamRequester::isActive() const
{
    return m_profile != StreamProfile::Quiet && m_kind && !m_kind->isPx4();
}

} // namespace skyseal::vehicle
