#include "core/vehicle/parameter_client.h"

#include "core/base/printable.h"
#include "core/vehicle/result_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace skyseal::vehicle {

namespace {

constexpr std::uint16_t kNoIndex = 65535; // of a PARAM_VALUE that answers a write

/// Integers of 8, 16 and 32 bits.
constexpr bool isInteger(std::uint8_t type)
{
    return type >= mavlink::MAV_PARAM_TYPE_UINT8 && type <= mavlink::MAV_PARAM_TYPE_INT32;
}

/// True if the values are equal within the precision of the float on the wire.
bool sameValue(double requested, double reported)
{
    return requested == reported || static_cast<float>(requested) == static_cast<float>(reported);
}

} // namespace

bool ParameterClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (std::holds_alternative<ReadParameters>(request))
        read(now, id);
    else if (const auto *change = std::get_if<WriteParameter>(&request))
        write(now, id, *change);
    else
        return false;
    return true;
}

bool ParameterClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::ParamValue::kId)
        return false;
    handleValue(now, unpack<mavlink::ParamValue>(frame));
    return true;
}

void ParameterClient::handleDeadline(TimePoint now)
{
    if (now >= m_publishDue)
        publish(now);
    if (now >= m_giveUp)
        giveUp();
    else if (now >= m_listDeadline)
        handleListDeadline(now);
    else if (isReading())
        requestGaps(now);
    if (!m_writes.empty() && now >= m_writes.front().deadline)
        handleWriteDeadline(now);
}

TimePoint ParameterClient::nextDeadline() const
{
    const TimePoint gaps = isReading() ? m_window.nextDeadline() : kNever;
    return std::min({m_publishDue, m_listDeadline, m_giveUp, gaps, m_writes.empty() ? kNever : m_writes.front().deadline});
}

std::shared_ptr<const std::vector<Parameter>> ParameterClient::parameters() const
{
    if (!m_shared && !m_values.empty()) {
        auto list = std::make_shared<std::vector<Parameter>>();
        list->reserve(m_values.size());
        for (const auto &entry : m_values)
            list->push_back(entry.second);
        m_shared = std::move(list);
    }
    return m_shared;
}

bool ParameterClient::isBytewise() const
{
    return kind().isPx4() || (state().capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE) != 0;
}

double ParameterClient::decode(float raw, std::uint8_t type) const
{
    if (!isBytewise() || !isInteger(type))
        return raw;
    const auto bits = std::bit_cast<std::uint32_t>(raw);
    switch (type) {
    case mavlink::MAV_PARAM_TYPE_UINT8: return static_cast<std::uint8_t>(bits);
    case mavlink::MAV_PARAM_TYPE_INT8: return static_cast<std::int8_t>(bits);
    case mavlink::MAV_PARAM_TYPE_UINT16: return static_cast<std::uint16_t>(bits);
    case mavlink::MAV_PARAM_TYPE_INT16: return static_cast<std::int16_t>(bits);
    case mavlink::MAV_PARAM_TYPE_UINT32: return bits;
    default: return static_cast<std::int32_t>(bits);
    }
}

float ParameterClient::encode(double value, std::uint8_t type) const
{
    if (!isBytewise() || !isInteger(type))
        return static_cast<float>(value);
    const double whole = std::clamp(std::round(value), -2147483648.0, 4294967295.0);
    return std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
}

void ParameterClient::read(TimePoint now, RequestId id)
{
    m_read = id;
    m_window.begin();
    m_reached = 0;
    m_interval = m_variation = Duration::zero();
    m_giveUp = now + kGiveUp;
    requestList(now);
}

void ParameterClient::write(TimePoint now, RequestId id, const WriteParameter &request)
{
    if (request.name.empty() || request.name.size() > 16 || !std::isfinite(request.value)) {
        report(ParameterResult{id,
                               addressing().system,
                               {request.name, request.value},
                               false,
                               "nothing was sent: a name of up to 16 characters and a number are needed"});
        return;
    }
    m_writes.push_back({id, request});
    if (m_writes.size() == 1)
        sendWrite(now);
}

void ParameterClient::handleValue(TimePoint now, const mavlink::ParamValue &value)
{
    const std::string name(mavlink::textOf(value.param_id));
    if (name.empty() || !isPrintable(name))
        return;
    const bool wasReading = isReading();
    if (value.param_count > 0 && value.param_index < value.param_count)
        noteIndex(now, value.param_index, value.param_count);
    const Parameter parameter{name, decode(value.param_value, value.param_type), value.param_type, value.param_index};
    const bool changed = store(parameter);
    const bool answersWrite = checkWrite(now, parameter);
    const bool readIsComplete = wasReading && !isReading();
    if (readIsComplete || (changed && (answersWrite || m_published == TimePoint::min() || now >= m_published + kCollectFor)))
        publish(now);
    else if (changed)
        m_publishDue = m_published + kCollectFor;
}

void ParameterClient::noteIndex(TimePoint now, std::uint16_t index, std::uint16_t count)
{
    if (m_expected != count || m_window.count() != count) {
        // The number changes when a write makes further parameters visible; those received before still count.
        m_expected = count;
        m_window.setCount(count);
    }
    const bool isNew = m_window.arrived(now, index);
    if (!isReading())
        return;
    if (m_window.isComplete()) {
        m_giveUp = m_listDeadline = kNever;
        return;
    }
    if (isNew)
        m_giveUp = now + kGiveUp;
    if (index >= m_reached) {
        noteInterval(now);
        m_reached = index + std::size_t(1);
        m_listDeadline = now
            + (m_interval == Duration::zero() ? kListTimeout : std::max(m_interval + m_variation * 4, kLeastPause));
        m_window.openUpTo(m_reached > kReordered ? m_reached - kReordered : 0);
    }
    requestGaps(now);
}

/// Of the list, not of the answers to single requests.
void ParameterClient::noteInterval(TimePoint now)
{
    const Duration interval = m_reached > 0 ? now - m_latest : Duration::zero();
    m_latest = now;
    if (m_interval == Duration::zero()) {
        m_interval = interval;
        m_variation = interval / 2;
    } else {
        const Duration difference = interval > m_interval ? interval - m_interval : m_interval - interval;
        m_variation += (difference - m_variation) / 4;
        m_interval += (interval - m_interval) / 8;
    }
}

/// Returns true if something changed.
bool ParameterClient::store(Parameter parameter)
{
    const auto known = m_values.find(parameter.name);
    if (known == m_values.end()) {
        if (!mayAdd())
            return false;
        m_values.emplace(parameter.name, parameter);
        return true;
    }
    if (parameter.index == kNoIndex)
        parameter.index = known->second.index;
    if (known->second.value == parameter.value && known->second.type == parameter.type
        && known->second.index == parameter.index)
        return false;
    known->second = std::move(parameter);
    return true;
}

/// A vehicle can invent names without end.
bool ParameterClient::mayAdd() const
{
    return m_values.size() < std::min(kMostNames, m_expected + kNamesBeyondCount);
}

/// parameters() shows all changes from now on.
void ParameterClient::publish(TimePoint now)
{
    m_shared.reset();
    m_published = now;
    m_publishDue = kNever;
}

void ParameterClient::requestList(TimePoint now)
{
    send(mavlink::ParamRequestList{});
    m_listDeadline = now + kListTimeout;
}

void ParameterClient::requestGaps(TimePoint now)
{
    while (const auto index = m_window.poll(now)) {
        mavlink::ParamRequestRead request;
        request.param_index = static_cast<std::int16_t>(*index);
        send(request);
    }
}

/// The list is over, or was not answered.
void ParameterClient::handleListDeadline(TimePoint now)
{
    if (m_reached == 0)
        return requestList(now);
    m_listDeadline = kNever;
    m_window.openUpTo(m_window.count());
    requestGaps(now);
}

void ParameterClient::giveUp()
{
    m_giveUp = m_listDeadline = kNever;
    report(ParameterResult{m_read,
                           addressing().system,
                           {},
                           false,
                           m_window.received() == 0 ? "the vehicle does not send its parameters"
                                                    : "only " + std::to_string(m_window.received()) + " of "
                                   + std::to_string(m_expected) + " parameters came"});
}

void ParameterClient::handleWriteDeadline(TimePoint now)
{
    const Write &front = m_writes.front();
    if (front.attempts < kWriteAttempts)
        return sendWrite(now);
    ParameterResult result{front.id, addressing().system};
    if (front.reported) {
        result.parameter = *front.reported;
        result.reason = "the vehicle keeps " + shortNumber(front.reported->value, 6);
    } else {
        result.parameter = {front.request.name, front.request.value};
        result.reason = "no answer to " + std::to_string(kWriteAttempts) + " attempts";
        result.changeUnanswered = true;
    }
    finishWrite(now, std::move(result));
}

void ParameterClient::sendWrite(TimePoint now)
{
    Write &write = m_writes.front();
    const auto known = m_values.find(write.request.name);
    mavlink::ParamSet message;
    message.param_type = known == m_values.end() ? std::uint8_t(mavlink::MAV_PARAM_TYPE_REAL32) : known->second.type;
    message.param_value = encode(write.request.value, message.param_type);
    mavlink::setText(message.param_id, write.request.name);
    send(message);
    ++write.attempts;
    write.deadline = now + kWriteTimeout;
}

/// Returns true if the value answers the write in progress.
bool ParameterClient::checkWrite(TimePoint now, const Parameter &parameter)
{
    if (m_writes.empty() || m_writes.front().request.name != parameter.name)
        return false;
    Write &write = m_writes.front();
    if (sameValue(write.request.value, parameter.value))
        finishWrite(now, {write.id, addressing().system, parameter, true});
    else
        write.reported = parameter; // perhaps sent before the write took effect, so the write is repeated
    return true;
}

void ParameterClient::finishWrite(TimePoint now, ParameterResult result)
{
    report(std::move(result));
    m_writes.pop_front();
    if (!m_writes.empty())
        sendWrite(now);
}

} // namespace skyseal::vehicle
