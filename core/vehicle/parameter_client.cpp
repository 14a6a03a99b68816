#include "core/vehicle/parameter_client.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/mavlink/packed_parameters.h"
#include "core/vehicle/parameter_file.h"
#include "core/vehicle/reasons.h"
#include "core/vehicle/result_reason.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kHash = "_HASH_CHECK"; // of all values: PX4 begins a list with it; it is no parameter

/// Integers of 8, 16 and 32 bits.
constexpr bool isInteger(std::uint8_t type)
{
    return type >= mavlink::MAV_PARAM_TYPE_UINT8 && type <= mavlink::MAV_PARAM_TYPE_INT32;
}

bool fitsFloat(double value)
{
    return static_cast<double>(static_cast<float>(value)) == value;
}

// Integers travel as their bytes (PX4, and components after MAVLink's specification) or as floats (ArduPilot).

double decode(float raw, std::uint8_t type, bool bytewise)
{
    if (!bytewise || !isInteger(type))
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

/// `value` is within the range of the type.
float encode(double value, std::uint8_t type, bool bytewise)
{
    if (!bytewise || !isInteger(type))
        return static_cast<float>(value);
    return std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
}

std::string textOfValue(double value)
{
    return valueText({.value = value});
}

/// Why the parameter cannot take the value, or the wire cannot carry it; empty if both can.
Reason unfit(double value, std::uint8_t type, bool bytewise)
{
    const auto range = rangeOfType(type);
    if (!range)
        return {};
    if (value < range->least || value > range->greatest)
        return reasons::kOutOfType(textOfValue(value), textOfValue(range->least), textOfValue(range->greatest));
    if (range->isWhole && value != std::trunc(value))
        return reasons::kNotWhole(textOfValue(value));
    if (range->isWhole && !bytewise && !fitsFloat(value))
        return reasons::kNotExact(textOfValue(value), textOfValue(static_cast<float>(value)));
    return {};
}

} // namespace

bool ParameterClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (std::holds_alternative<ReadParameters>(request))
        read(now, id);
    else if (const auto *one = std::get_if<ReadParameter>(&request))
        exchange(now, {.id = id, .parameter = {.name = one->name, .componentId = one->componentId}});
    else if (const auto *change = std::get_if<WriteParameter>(&request))
        exchange(now,
                 {.id = id,
                  .parameter = {.name = change->name, .value = change->value, .componentId = change->componentId},
                  .isWrite = true});
    else
        return false;
    return true;
}

bool ParameterClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() == mavlink::ParamValue::kId)
        handleValue(now, componentOf(frame), unpack<mavlink::ParamValue>(frame));
    else if (frame.messageId() == mavlink::ParamError::kId)
        handleError(now, componentOf(frame), unpack<mavlink::ParamError>(frame));
    else
        return false;
    return true;
}

void ParameterClient::handleHeartbeat(TimePoint now)
{
    m_heardSince = std::min(m_heardSince, now);
}

void ParameterClient::handleDeadline(TimePoint now)
{
    if (now >= m_store.publishDue())
        m_store.publish(now);
    if (m_file || now >= m_openDue)
        handleFile(now);
    m_list.handleDeadline(now);
    for (auto &[component, list] : m_others)
        list.handleDeadline(now);
    sendRequests(now);
    checkRead(now);
    if (now >= m_repetition.due())
        handleExchangeDeadline(now);
}

TimePoint ParameterClient::nextDeadline() const
{
    if (m_file)
        return TimePoint::min();
    TimePoint next = std::min({m_openDue, m_store.publishDue(), m_list.nextDeadline(), m_settled, m_repetition.due()});
    for (const auto &[component, list] : m_others)
        next = std::min(next, list.nextDeadline());
    return next;
}

/// As in Parameter: 0 for the autopilot.
std::uint8_t ParameterClient::componentOf(const mavlink::Frame &frame) const
{
    return frame.componentId() == addressing().component ? std::uint8_t(0) : frame.componentId();
}

/// Other components do as the vehicle does, until one shows that it sends bytes: the bytes of a small integer are no whole
/// number as a float.
bool ParameterClient::isBytewise(std::uint8_t component) const
{
    return kind().isPx4() || (state().capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE) != 0
        || m_bytewise.test(component);
}

void ParameterClient::handleValue(TimePoint now, std::uint8_t component, const mavlink::ParamValue &value)
{
    const std::string name(mavlink::textOf(value.param_id));
    if (name.empty() || !isPrintable(name) || (kind().isPx4() && name == kHash))
        return;
    if (component != 0 && isInteger(value.param_type) && std::trunc(value.param_value) != value.param_value)
        m_bytewise.set(component);
    const bool wasReading = m_list.isReading();
    if (value.param_count > 0 && value.param_index < value.param_count) {
        m_store.expect(component, value.param_count);
        if (component == 0) {
            m_list.arrived(now, value.param_index, value.param_count);
        } else if (m_read) {
            const auto [list, isNew] = m_others.try_emplace(component);
            if (isNew) // it answers the request to all of them
                list->second.begin(now, kOthersGiveUp, now + ParameterList::kListTimeout);
            list->second.arrived(now, value.param_index, value.param_count);
        }
    }
    const bool listEnded = wasReading && !m_list.isReading();
    const Parameter parameter{name, decode(value.param_value, value.param_type, isBytewise(component)), value.param_type,
                              value.param_index, component};
    const bool changed = m_store.store(parameter);
    const bool answersWrite = checkExchange(now, parameter);
    if (listEnded || changed)
        m_store.publishChange(now, listEnded || answersWrite);
    sendRequests(now);
    checkRead(now);
}

/// An error names the request that it answers, as the request named the parameter: by its index, or by its name. One that
/// answers no request in progress changes nothing.
void ParameterClient::handleError(TimePoint now, std::uint8_t component, const mavlink::ParamError &error)
{
    if (!addressing().isForUs(error.target_system, error.target_component) || error.error == mavlink::MAV_PARAM_ERROR_NO_ERROR)
        return;
    const Reason reason = parameterErrorReason(error.error);
    if (error.param_index >= 0) {
        const auto index = static_cast<std::uint16_t>(error.param_index);
        const auto other = m_others.find(component);
        if (component == 0)
            m_list.refused(now, index, reason);
        else if (other != m_others.end())
            other->second.refused(now, index, reason);
        sendRequests(now);
        return checkRead(now);
    }
    if (m_exchanges.empty())
        return;
    const Exchange &front = m_exchanges.front();
    const bool speaksForIt = component == front.parameter.componentId
        || (component == 0 && error.error == mavlink::MAV_PARAM_ERROR_COMPONENT_NOT_FOUND); // that component cannot
    if (!speaksForIt || front.parameter.name != mavlink::textOf(error.param_id))
        return;
    m_repetition.measure(now, m_list.rtt());
    finishExchange(now, resultOf(front, reason));
}

void ParameterClient::read(TimePoint now, RequestId id)
{
    m_read = id;
    m_settled = kNever;
    if (isReadingFile())
        return;
    m_others.clear();
    m_isFileTaken = m_askedAll = false;
    if (!readFile(now))
        beginLists(now);
}

/// By one request to all components, of which the heartbeats show some.
void ParameterClient::beginLists(TimePoint now)
{
    suppose(m_list.rtt());
    m_askedAll = mayAsk();
    m_list.begin(now, kGiveUp, m_askedAll ? now + ParameterList::kListTimeout : now);
    if (m_askedAll) {
        m_context.sendTo(mavlink::MAV_COMP_ID_ALL, mavlink::ParamRequestList{});
        beginOthers(now, now + kOthersAgain);
    }
    sendRequests(now);
}

/// Begins the lists of the components that are known by their heartbeats. Returns false if there are no others by now.
bool ParameterClient::beginOthers(TimePoint now, TimePoint request)
{
    bool any = false;
    for (const Component &component : state().components) {
        const auto [list, isNew] = m_others.try_emplace(component.id);
        if (!isNew || !mayAsk())
            continue;
        suppose(list->second.rtt());
        list->second.begin(now, kOthersGiveUp, request);
        any = true;
    }
    return any;
}

/// Returns false, and does nothing, if the vehicle does not have the file, or is busy with another one.
bool ParameterClient::readFile(TimePoint now)
{
    const auto capabilities = state().capabilities;
    const bool mayHave = kind().isArduPilot()
        && (capabilities == 0 || (capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_FTP) != 0); // 0: not known yet
    if (!mayHave || m_hasNoFile || m_list.isReading()
        || !m_files.read(now, kFile, [this](FileResult file) { m_file = std::move(file); }))
        return false;
    m_openDue = now + kOpenTimeout;
    return true;
}

/// The file has arrived, failed, or should have been opened by now.
void ParameterClient::handleFile(TimePoint now)
{
    m_openDue = kNever;
    if (!m_file && !m_files.isOpening()) {
        m_isFileOpen = true; // m_file will come
        return;
    }
    m_files.cancelRead(now);
    const auto file = std::exchange(m_file, std::nullopt);
    const bool wasOpen = std::exchange(m_isFileOpen, false);
    m_isFileTaken = file && take(now, *file);
    if (!m_isFileTaken) {
        m_hasNoFile = !wasOpen || (file && file->ok); // not open, or damaged; a link that was down says nothing
        beginLists(now);
    } else {
        beginOthers(now, now);
    }
}

/// Returns false if the file is none, or not of all parameters.
bool ParameterClient::take(TimePoint now, const FileResult &file)
{
    if (!file.ok || !file.content)
        return false;
    const auto packed = mavlink::parsePackedParameters(*file.content);
    if (!packed || packed->parameters.size() != packed->total || packed->total > ParameterStore::kMostNames)
        return false;
    m_store.expect(0, packed->total);
    for (std::uint16_t index = 0; index < packed->total; ++index) {
        const mavlink::PackedParameter &parameter = packed->parameters[index];
        if (isPrintable(parameter.name))
            m_store.store({parameter.name, parameter.value, parameter.type, index});
    }
    m_store.publish(now);
    return true;
}

/// Sends what the lists need now.
void ParameterClient::sendRequests(TimePoint now)
{
    const auto sendFor = [&](std::uint8_t component, ParameterList &list) {
        while (const auto index = list.poll(now)) {
            if (*index == ParameterList::kWhole) {
                m_context.sendTo(component, mavlink::ParamRequestList{});
                continue;
            }
            mavlink::ParamRequestRead request;
            request.param_index = static_cast<std::int16_t>(*index);
            m_context.sendTo(component, request);
        }
    };
    sendFor(addressing().component, m_list);
    for (auto &[component, list] : m_others)
        sendFor(component, list);
}

/// Ends the read when its lists have ended.
void ParameterClient::checkRead(TimePoint now)
{
    if (!m_read || isReadingFile() || m_list.isReading())
        return;
    if (!m_isFileTaken && !m_list.isComplete())
        return endRead(now, failureOfList());
    if (std::ranges::any_of(m_others, [](const auto &other) { return other.second.isReading(); })) {
        m_settled = kNever;
        return;
    }
    if (m_settled == kNever)
        m_settled = m_askedAll ? now + kSettle : std::max(now, m_heardSince + kHeartbeats);
    if (now < m_settled)
        return;
    if (!m_askedAll && beginOthers(now, now))
        return sendRequests(now);
    endRead(now, {});
}

Reason ParameterClient::failureOfList() const
{
    if (m_list.count() == 0)
        return reasons::kParametersMissing;
    if (m_list.refusal().empty())
        return reasons::kParametersIncomplete(m_list.received(), m_list.count());
    return reasons::kParametersRefused(m_list.received(), m_list.count(), m_list.refusal());
}

/// Of the first one of which a part is missing; empty if there is none.
Reason ParameterClient::failureOfOthers() const
{
    for (const auto &[component, list] : m_others) {
        if (list.count() != 0 && !list.isComplete())
            return reasons::kComponentIncomplete(component, list.received(), list.count());
    }
    return {};
}

void ParameterClient::endRead(TimePoint now, Reason failure)
{
    m_settled = kNever;
    const bool ok = failure.empty();
    ParameterResult result{.id = *std::exchange(m_read, std::nullopt),
                           .systemId = addressing().system,
                           .ok = ok,
                           .reason = std::move(failure),
                           .action = ParameterAction::ReadList};
    if (result.ok) {
        m_store.publish(now);
        result.reason = failureOfOthers();
        result.all = m_store.list();
    }
    m_others.clear();
    report(std::move(result));
}

std::optional<TransferProgress> ParameterClient::progress() const
{
    if (!m_read)
        return std::nullopt;
    if (isReadingFile())
        return TransferProgress{*m_read, m_files.transferred().done, m_files.transferred().total};
    TransferProgress out{*m_read, m_list.received(), m_list.count()};
    for (const auto &[component, list] : m_others) {
        out.done += list.received();
        out.total += list.count();
    }
    return out;
}

void ParameterClient::exchange(TimePoint now, Exchange exchange)
{
    Parameter &parameter = exchange.parameter;
    if (parameter.componentId == addressing().component)
        parameter.componentId = 0;
    if (parameter.name.empty() || parameter.name.size() > 16 || !std::isfinite(parameter.value))
        return report(resultOf(exchange, nothingSent(reasons::kNoParameter)));
    m_exchanges.push_back(std::move(exchange));
    if (m_exchanges.size() == 1)
        beginExchange(now);
}

/// The failed result of an exchange, with the value that the vehicle has reported, if it has.
ParameterResult ParameterClient::resultOf(const Exchange &exchange, Reason failure) const
{
    return {.id = exchange.id,
            .systemId = addressing().system,
            .parameter = exchange.reported.value_or(exchange.parameter),
            .reason = std::move(failure),
            .action = exchange.isWrite ? ParameterAction::Write : ParameterAction::Read};
}

/// Begins the first one in the queue that can be sent. Writes that cannot end here.
void ParameterClient::beginExchange(TimePoint now)
{
    m_repetition.stop();
    for (; !m_exchanges.empty(); m_exchanges.pop_front()) {
        const Exchange &front = m_exchanges.front();
        const Parameter &wanted = front.parameter;
        const Parameter *known = front.isWrite ? m_store.find(wanted.componentId, wanted.name) : nullptr;
        Reason problem = known ? unfit(wanted.value, known->type, isBytewise(wanted.componentId)) : Reason();
        if (problem.empty())
            break;
        report(resultOf(front, std::move(problem)));
    }
    if (m_exchanges.empty())
        return;
    suppose(m_list.rtt());
    m_repetition.begin();
    m_exchangeGiveUp = now + kExchangeGiveUp;
    sendExchange(now);
}

/// The bytes of a float, written to an integer, would be a huge number, and a float cannot hold every integer: the type must be
/// known first, unless the vehicle takes any number as a float.
bool ParameterClient::needsType(const Parameter &wanted) const
{
    return wanted.componentId != 0 || isBytewise(0) || (wanted.value == std::trunc(wanted.value) && !fitsFloat(wanted.value));
}

void ParameterClient::sendExchange(TimePoint now)
{
    Exchange &front = m_exchanges.front();
    const Parameter &wanted = front.parameter;
    const std::uint8_t target = wanted.componentId == 0 ? addressing().component : wanted.componentId;
    const Parameter *known = m_store.find(wanted.componentId, wanted.name);
    if (front.isWrite && (known || !needsType(wanted))) {
        front.written = true;
        mavlink::ParamSet message;
        message.param_type = known ? known->type : std::uint8_t(mavlink::MAV_PARAM_TYPE_REAL32);
        message.param_value = encode(wanted.value, message.param_type, isBytewise(wanted.componentId));
        mavlink::setText(message.param_id, wanted.name);
        m_context.sendTo(target, message);
    } else {
        mavlink::ParamRequestRead message;
        message.param_index = -1;
        mavlink::setText(message.param_id, wanted.name);
        m_context.sendTo(target, message);
    }
    m_repetition.sent(now, m_list.rtt());
}

void ParameterClient::handleExchangeDeadline(TimePoint now)
{
    const Exchange &front = m_exchanges.front();
    const bool answers = front.reports >= kReports;
    if (m_repetition.attempts() < kExchangeAttempts || (now < m_exchangeGiveUp && !answers))
        return sendExchange(now);
    ParameterResult result = resultOf(
        front, front.reported ? reasons::kValueKept(valueText(*front.reported)) : reasons::kNoAnswer(m_repetition.attempts()));
    result.changeUnanswered = front.isWrite && !front.reported;
    finishExchange(now, std::move(result));
}

/// Returns true if the value answers the exchange in progress.
bool ParameterClient::checkExchange(TimePoint now, const Parameter &parameter)
{
    if (m_exchanges.empty() || !m_exchanges.front().isOf(parameter))
        return false;
    Exchange &front = m_exchanges.front();
    m_repetition.measure(now, m_list.rtt());
    if (!front.isWrite || hasValue(parameter, front.parameter.value)) {
        ParameterResult result = resultOf(front, {});
        result.parameter = parameter;
        result.ok = true;
        finishExchange(now, std::move(result));
    } else if (!front.written) {
        beginExchange(now); // now its type is known
    } else {
        front.reported = parameter; // perhaps sent before the write took effect, so the write is repeated
        ++front.reports;
    }
    return true;
}

void ParameterClient::finishExchange(TimePoint now, ParameterResult result)
{
    report(std::move(result));
    m_exchanges.pop_front();
    beginExchange(now);
}

} // namespace skyseal::vehicle
