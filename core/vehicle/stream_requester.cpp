#include "core/vehicle/stream_requester.h"

#include "core/vehicle/message_io.h"

#include <algorithm>
#include <cmath>

namespace skyseal::vehicle {

namespace {

using namespace mavlink;

/// A group of ArduPilot's streams, with the messages by which one sees that it comes.
struct Group
{
    std::uint8_t stream;           ///< MAV_DATA_STREAM
    double standard, lowBandwidth; ///< Hz, 0 = stop
    std::array<std::uint32_t, 3> witnesses;
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

/// Single messages: what is in no group of ArduPilot's, and for other autopilots what the groups give there.
struct Single
{
    std::uint32_t message;
    double standard, lowBandwidth; ///< Hz
    bool inGroups;                 ///< ArduPilot sends it with a group
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

void StreamRequester::Expectation::ask(TimePoint now)
{
    due = now;
    unasked = true;
}

void StreamRequester::Expectation::asked(TimePoint now)
{
    unasked = false;
    due = now + patience;
    patience = std::min(patience * 2, kLongestSilence);
}

void StreamRequester::Expectation::came(TimePoint now)
{
    if (due == kNever || unasked)
        return;
    patience = kSilence;
    due = now + kSilence;
}

StreamRequester::StreamRequester(const Addressing &addressing, StreamProfile profile, double rate)
    : m_addressing(addressing), m_profile(profile), m_rate(rate)
{
    static_assert(kStreamGroups.size() == kGroups && kSingleMessages.size() == kMessages);
}

void StreamRequester::setProfile(TimePoint now, StreamProfile profile, double rate)
{
    m_profile = profile;
    m_rate = rate;
    restart(now);
}

void StreamRequester::handleHeartbeat(TimePoint now, VehicleKind kind)
{
    if (m_kind && *m_kind == kind)
        return;
    m_kind = kind;
    restart(now);
}

void StreamRequester::handleMessage(TimePoint now, std::uint32_t messageId)
{
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto &witnesses = kStreamGroups[i].witnesses;
        if (std::find(witnesses.begin(), witnesses.end(), messageId) != witnesses.end())
            m_groups[i].came(now);
    }
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (kSingleMessages[i].message == messageId)
            m_messages[i].came(now);
    }
}

void StreamRequester::handleReturn(TimePoint now)
{
    restart(now);
}

void StreamRequester::handleIntervalResult(std::uint8_t result)
{
    if (result == MAV_RESULT_UNSUPPORTED)
        m_intervalsUnderstood = false;
    if (!m_intervalsUnderstood)
        m_messages.fill({});
}

void StreamRequester::handleDeadline(TimePoint now, MessageQueue &outbox)
{
    const bool low = m_profile == StreamProfile::LowBandwidth;
    for (std::size_t i = 0; i < kGroups; ++i) {
        if (now < m_groups[i].due)
            continue;
        const Group &group = kStreamGroups[i];
        const double rate = m_rate > 0 ? m_rate : low ? group.lowBandwidth : group.standard;
        mavlink::RequestDataStream request;
        request.target_system = m_addressing.system;
        request.target_component = m_addressing.component;
        request.req_stream_id = group.stream;
        request.req_message_rate = static_cast<std::uint16_t>(std::clamp(std::ceil(rate), 0.0, 1000.0));
        request.start_stop = rate > 0;
        push(outbox, request);
        m_groups[i].asked(now);
        if (!(rate > 0))
            m_groups[i] = {}; // stopped: silence is what was asked for
    }
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (now < m_messages[i].due)
            continue;
        const Single &single = kSingleMessages[i];
        // What is in no group changes slowly and is not worth a higher rate.
        const double rate = m_rate > 0 && single.inGroups ? m_rate : low ? single.lowBandwidth : single.standard;
        mavlink::CommandLong request;
        request.target_system = m_addressing.system;
        request.target_component = m_addressing.component;
        request.command = MAV_CMD_SET_MESSAGE_INTERVAL;
        request.param1 = static_cast<float>(single.message);
        request.param2 = static_cast<float>(1e6 / rate); // microseconds
        push(outbox, request);
        m_messages[i].asked(now);
    }
}

TimePoint StreamRequester::nextDeadline() const
{
    TimePoint next = kNever;
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
    if (!isActive())
        return;
    if (m_kind->isArduPilot()) {
        for (Expectation &group : m_groups)
            group.ask(now);
    }
    if (!m_intervalsUnderstood)
        return;
    for (std::size_t i = 0; i < kMessages; ++i) {
        if (!kSingleMessages[i].inGroups || !m_kind->isArduPilot())
            m_messages[i].ask(now);
    }
}

bool StreamRequester::isActive() const
{
    return m_profile != StreamProfile::Quiet && m_kind && !m_kind->isPx4();
}

} // namespace skyseal::vehicle
