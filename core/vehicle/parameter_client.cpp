#include "core/vehicle/parameter_client.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/mavlink/packed_parameters.h"
#include "core/vehicle/reasons.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kHash = "_HASH_CHECK"; // of all values: PX4 begins a list with it; it is no parameter

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
    else if (const auto *one = std::get_if<ReadParameter>(&request))
        exchange(now, id, one->name, std::nullopt);
    else if (const auto *change = std::get_if<WriteParameter>(&request))
        exchange(now, id, change->name, change->value);
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
    if (now >= m_store.publishDue())
        m_store.publish(now);
    if (m_file || now >= m_openDue)
        handleFile(now);
    if (now >= m_giveUp)
        giveUp();
    else if (now >= m_listDeadline)
        handleListDeadline(now);
    else if (isReadingList())
        requestGaps(now);
    if (now >= m_repetition.due())
        handleExchangeDeadline(now);
}

TimePoint ParameterClient::nextDeadline() const
{
    if (m_file)
        return TimePoint::min();
    const TimePoint gaps = isReadingList() ? m_window.nextDeadline() : kNever;
    return std::min({m_openDue, m_store.publishDue(), m_listDeadline, m_giveUp, gaps, m_repetition.due()});
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
    if (isReadingFile() || readFile(now))
        return;
    beginList(now);
}

/// Returns false, and does nothing, if the vehicle does not have the file, or is busy with another one.
bool ParameterClient::readFile(TimePoint now)
{
    const auto capabilities = state().capabilities;
    const bool mayHave = kind().isArduPilot()
        && (capabilities == 0 || (capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_FTP) != 0); // 0: not known yet
    if (!mayHave || m_hasNoFile || isReadingList()
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
    if (file && take(now, *file))
        return reportList();
    m_hasNoFile = !wasOpen || (file && file->ok); // not open, or damaged; a link that was down says nothing
    beginList(now);
}

/// Returns false if the file is none, or not of all parameters.
bool ParameterClient::take(TimePoint now, const FileResult &file)
{
    if (!file.ok || !file.content)
        return false;
    const auto packed = mavlink::parsePackedParameters(*file.content);
    if (!packed || packed->parameters.size() != packed->total || packed->total > ParameterStore::kMostNames)
        return false;
    m_store.expect(packed->total);
    for (std::uint16_t index = 0; index < packed->total; ++index) {
        const mavlink::PackedParameter &parameter = packed->parameters[index];
        if (isPrintable(parameter.name))
            m_store.store({parameter.name, parameter.value, parameter.type, index});
    }
    m_store.publish(now);
    return true;
}

void ParameterClient::beginList(TimePoint now)
{
    suppose(m_window.rtt());
    m_window.begin();
    m_reached = 0;
    m_interval = m_variation = Duration::zero();
    m_giveUp = now + kGiveUp;
    requestList(now);
}

void ParameterClient::exchange(TimePoint now, RequestId id, const std::string &name, std::optional<double> value)
{
    if (name.empty() || name.size() > 16 || (value && !std::isfinite(*value))) {
        report(ParameterResult{.id = id,
                               .systemId = addressing().system,
                               .parameter = {name, value.value_or(0)},
                               .reason = nothingSent(reasons::kNoParameter),
                               .action = value ? ParameterAction::Write : ParameterAction::Read});
        return;
    }
    m_exchanges.push_back({id, name, value});
    if (m_exchanges.size() == 1)
        beginExchange(now);
}

void ParameterClient::handleValue(TimePoint now, const mavlink::ParamValue &value)
{
    const std::string name(mavlink::textOf(value.param_id));
    if (name.empty() || !isPrintable(name) || (kind().isPx4() && name == kHash))
        return;
    const bool wasReading = isReadingList();
    if (value.param_count > 0 && value.param_index < value.param_count)
        noteIndex(now, value.param_index, value.param_count);
    const Parameter parameter{name, decode(value.param_value, value.param_type), value.param_type, value.param_index};
    const bool changed = m_store.store(parameter);
    const bool answersWrite = checkExchange(now, parameter);
    const bool readIsComplete = wasReading && !isReadingList();
    if (readIsComplete || changed)
        m_store.publishChange(now, readIsComplete || answersWrite);
    if (readIsComplete)
        reportList();
}

void ParameterClient::reportList()
{
    report(ParameterResult{
        .id = m_read, .systemId = addressing().system, .ok = true, .action = ParameterAction::ReadList, .all = m_store.list()});
}

void ParameterClient::noteIndex(TimePoint now, std::uint16_t index, std::uint16_t count)
{
    if (m_store.expected() != count || m_window.count() != count) {
        // The number changes when a write makes further parameters visible; those received before still count.
        m_store.expect(count);
        m_window.setCount(count);
    }
    const bool isNew = m_window.arrived(now, index);
    if (!isReadingList())
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
    Reason reason = m_window.received() == 0 ? Reason(reasons::kParametersMissing)
                                             : reasons::kParametersIncomplete(m_window.received(), m_store.expected());
    report(ParameterResult{
        .id = m_read, .systemId = addressing().system, .reason = std::move(reason), .action = ParameterAction::ReadList});
}

std::optional<TransferProgress> ParameterClient::progress() const
{
    if (isReadingFile())
        return TransferProgress{m_read, m_files.transferred().done, m_files.transferred().total};
    if (!isReadingList())
        return std::nullopt;
    return TransferProgress{m_read, m_window.received(), m_window.count()};
}

void ParameterClient::handleExchangeDeadline(TimePoint now)
{
    const Exchange &front = m_exchanges.front();
    const bool answers = front.reports >= kReports;
    if (m_repetition.attempts() < kExchangeAttempts || (now < m_exchangeGiveUp && !answers))
        return sendExchange(now);
    ParameterResult result{.id = front.id, .systemId = addressing().system};
    if (front.reported) {
        result.parameter = *front.reported;
        result.reason = reasons::kValueKept(shortNumber(front.reported->value, 6));
    } else {
        result.parameter = {front.name, front.value.value_or(0)};
        result.reason = reasons::kNoAnswer(m_repetition.attempts());
        result.changeUnanswered = front.value.has_value();
    }
    finishExchange(now, std::move(result));
}

void ParameterClient::beginExchange(TimePoint now)
{
    suppose(m_window.rtt());
    m_repetition.begin();
    m_exchangeGiveUp = now + kExchangeGiveUp;
    sendExchange(now);
}

void ParameterClient::sendExchange(TimePoint now)
{
    Exchange &front = m_exchanges.front();
    const Parameter *known = m_store.find(front.name);
    // The bytes of a float, written to an integer of PX4, would be a huge number: its type must be known first.
    if (front.value && (known || !isBytewise())) {
        front.written = true;
        mavlink::ParamSet message;
        message.param_type = known ? known->type : std::uint8_t(mavlink::MAV_PARAM_TYPE_REAL32);
        message.param_value = encode(*front.value, message.param_type);
        mavlink::setText(message.param_id, front.name);
        send(message);
    } else {
        mavlink::ParamRequestRead message;
        message.param_index = -1;
        mavlink::setText(message.param_id, front.name);
        send(message);
    }
    m_repetition.sent(now, m_window.rtt());
}

/// Returns true if the value answers the exchange in progress.
bool ParameterClient::checkExchange(TimePoint now, const Parameter &parameter)
{
    if (m_exchanges.empty() || m_exchanges.front().name != parameter.name)
        return false;
    Exchange &front = m_exchanges.front();
    m_repetition.measure(now, m_window.rtt());
    if (!front.value || sameValue(*front.value, parameter.value)) {
        finishExchange(now, {front.id, addressing().system, parameter, true});
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
    result.action = m_exchanges.front().value ? ParameterAction::Write : ParameterAction::Read;
    report(std::move(result));
    m_exchanges.pop_front();
    m_repetition.stop();
    if (!m_exchanges.empty())
        beginExchange(now);
}

} // namespace skyseal::vehicle
