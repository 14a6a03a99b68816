#include "core/vehicle/parameter_client.h"

#include "core/vehicle/message_io.h"
#include "core/vehicle/result_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace skyseal::vehicle {

namespace {

constexpr std::uint16_t kNoIndex = 65535;

/// Integers of 8, 16 and 32 bits.
constexpr bool isInteger(std::uint8_t type)
{
    return type >= mavlink::MAV_PARAM_TYPE_UINT8 && type <= mavlink::MAV_PARAM_TYPE_INT32;
}

/// Whether the vehicle has what was asked for, as exactly as a float can say it.
bool sameValue(double asked, double has)
{
    return asked == has || static_cast<float>(asked) == static_cast<float>(has);
}

} // namespace

void ParameterClient::readAll(TimePoint now, MessageQueue &outbox)
{
    m_have.clear();
    m_received = 0;
    m_fruitless = 0;
    requestList(now, outbox);
}

void ParameterClient::write(TimePoint now, std::string name, double value, MessageQueue &outbox)
{
    if (name.empty() || name.size() > 16 || !std::isfinite(value)) {
        m_results.push_back(
            {{std::move(name), value}, false, "nothing was sent: a name of up to 16 characters and a number are needed"});
        return;
    }
    m_writes.push_back({std::move(name), value, 0, kNever, std::nullopt});
    if (m_writes.size() == 1)
        sendWrite(now, outbox);
}

void ParameterClient::handleValue(TimePoint now, const ParameterValue &value, MessageQueue &outbox)
{
    if (value.name.empty())
        return;
    Parameter parameter{std::string(value.name), decode(value.value, value.type), value.type, value.index};
    if (value.count > 0 && value.index < value.count) {
        if (m_expected != value.count || m_have.size() != value.count) {
            // The number changes when a switch makes more of them visible; what is known already counts still.
            m_expected = value.count;
            m_have.resize(value.count, false);
            m_received = static_cast<std::size_t>(std::count(m_have.begin(), m_have.end(), true));
        }
        if (!m_have[value.index]) {
            m_have[value.index] = true;
            ++m_received;
            m_fruitless = 0;
        }
        if (isReading())
            m_listDeadline = m_received == m_expected ? kNever : now + kListTimeout;
    }
    const auto known = m_values.find(value.name);
    if (known == m_values.end()) {
        // A vehicle has at most 65535 parameters; more names than that are not its own.
        if (m_values.size() < kNoIndex)
            m_values.emplace(parameter.name, parameter);
        m_shared.reset();
    } else {
        if (parameter.index == kNoIndex)
            parameter.index = known->second.index;
        if (known->second.value != parameter.value || known->second.type != parameter.type
            || known->second.index != parameter.index) {
            known->second = parameter;
            m_shared.reset();
        }
    }
    checkWrite(now, parameter, outbox);
}

void ParameterClient::handleDeadline(TimePoint now, MessageQueue &outbox)
{
    if (now >= m_listDeadline) {
        if (++m_fruitless > kRounds) {
            m_listDeadline = kNever;
            m_results.push_back({{},
                                 false,
                                 m_received == 0 ? "the vehicle does not send its parameters"
                                                 : "only " + std::to_string(m_received) + " of " + std::to_string(m_expected)
                                         + " parameters came"});
        } else if (m_received == 0) {
            requestList(now, outbox);
        } else {
            requestGaps(now, outbox);
        }
    }
    if (!m_writes.empty() && now >= m_writes.front().deadline) {
        const Write &front = m_writes.front();
        if (front.attempts < kWriteAttempts) {
            sendWrite(now, outbox);
        } else if (front.seen) {
            finishWrite(now, {*front.seen, false, "the vehicle keeps " + shortNumber(front.seen->value, 6)}, outbox);
        } else {
            finishWrite(
                now, {{front.name, front.value}, false, "no answer to " + std::to_string(kWriteAttempts) + " attempts", true},
                outbox);
        }
    }
}

TimePoint ParameterClient::nextDeadline() const
{
    return std::min(m_listDeadline, m_writes.empty() ? kNever : m_writes.front().deadline);
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

std::optional<ParameterResult> ParameterClient::poll()
{
    if (m_results.empty())
        return std::nullopt;
    ParameterResult result = std::move(m_results.front());
    m_results.pop_front();
    return result;
}

double ParameterClient::decode(float raw, std::uint8_t type) const
{
    if (!m_bytewise || !isInteger(type))
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
    if (!m_bytewise || !isInteger(type))
        return static_cast<float>(value);
    const double whole = std::clamp(std::round(value), -2147483648.0, 4294967295.0);
    return std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
}

void ParameterClient::requestList(TimePoint now, MessageQueue &outbox)
{
    mavlink::ParamRequestList request;
    request.target_system = m_addressing.system;
    request.target_component = m_addressing.component;
    push(outbox, request, true);
    m_listDeadline = now + kListTimeout;
}

void ParameterClient::requestGaps(TimePoint now, MessageQueue &outbox)
{
    std::size_t asked = 0;
    for (std::size_t index = 0; index < m_have.size() && asked < kBatch; ++index) {
        if (m_have[index])
            continue;
        mavlink::ParamRequestRead request;
        request.target_system = m_addressing.system;
        request.target_component = m_addressing.component;
        request.param_index = static_cast<std::int16_t>(index);
        push(outbox, request, true);
        ++asked;
    }
    m_listDeadline = now + kListTimeout;
}

void ParameterClient::sendWrite(TimePoint now, MessageQueue &outbox)
{
    Write &write = m_writes.front();
    const auto known = m_values.find(write.name);
    mavlink::ParamSet message;
    message.target_system = m_addressing.system;
    message.target_component = m_addressing.component;
    message.param_type = known == m_values.end() ? std::uint8_t(mavlink::MAV_PARAM_TYPE_REAL32) : known->second.type;
    message.param_value = encode(write.value, message.param_type);
    mavlink::setText(message.param_id, write.name);
    push(outbox, message, true);
    ++write.attempts;
    write.deadline = now + kWriteTimeout;
}

void ParameterClient::checkWrite(TimePoint now, const Parameter &parameter, MessageQueue &outbox)
{
    if (m_writes.empty() || m_writes.front().name != parameter.name)
        return;
    Write &write = m_writes.front();
    if (sameValue(write.value, parameter.value))
        finishWrite(now, {parameter, true, {}}, outbox);
    else
        write.seen = parameter; // it may be an answer from before the writing: ask once more before believing it
}

void ParameterClient::finishWrite(TimePoint now, ParameterResult result, MessageQueue &outbox)
{
    m_results.push_back(std::move(result));
    m_writes.pop_front();
    if (!m_writes.empty())
        sendWrite(now, outbox);
}

} // namespace skyseal::vehicle
