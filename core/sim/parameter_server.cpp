#include "core/sim/parameter_server.h"

#include "core/mavlink/messages.h"

#include <bit>
#include <utility>

namespace skyseal::sim {

namespace {
constexpr std::string_view kHashName = "_HASH_CHECK";
constexpr std::uint16_t kNoIndex = 65535;
constexpr Duration kParameterPace = std::chrono::milliseconds(4); // 250 a second
} // namespace

std::uint16_t ParameterServer::answerIndex(std::size_t index) const
{
    return isPx4() ? static_cast<std::uint16_t>(index) : kNoIndex;
}

void ParameterServer::requestList(TimePoint now)
{
    m_next = 0;
    m_hashDue = isPx4();
    m_due = now;
}

void ParameterServer::requestRead(int index, std::string_view name)
{
    if (index >= 0) {
        if (static_cast<std::size_t>(index) < m_parameters.count())
            sendValue(static_cast<std::size_t>(index), static_cast<std::uint16_t>(index));
    } else if (const auto found = m_parameters.find(name)) {
        sendValue(*found, answerIndex(*found));
    } else if (isPx4() && name == kHashName) {
        sendHash();
    }
}

void ParameterServer::announce(std::string_view name)
{
    if (const auto index = m_parameters.find(name))
        sendValue(*index, answerIndex(*index));
}

void ParameterServer::set(std::string_view name, float value)
{
    if (isPx4() && name == kHashName) { // the station has a copy of all values already
        m_due = kNever;
        return;
    }
    const auto index = m_parameters.find(name);
    if (!index) {
        if (isPx4())
            m_texts.say(Severity::Info, "[pm] unknown param: " + std::string(name));
        return;
    }
    if (isPx4() && m_parameters.info(*index).type != ParameterType::Real32)
        value = static_cast<float>(std::bit_cast<std::int32_t>(value)); // its integers travel as their bytes
    if (m_parameters.set(*index, value) != Parameters::SetResult::Stored)
        m_texts.say(Severity::Warning, std::string(name) + ": value refused");
    sendValue(*index, answerIndex(*index));
}

void ParameterServer::handleDeadline(TimePoint now)
{
    while (m_due <= now) {
        m_due += kParameterPace;
        if (m_outbox.room() < FrameQueue::kKeptForTelemetry)
            continue;
        if (std::exchange(m_hashDue, false)) {
            sendHash();
            continue;
        }
        sendValue(m_next, static_cast<std::uint16_t>(m_next));
        if (++m_next >= m_parameters.count())
            m_due = kNever;
    }
}

void ParameterServer::sendHash()
{
    std::uint32_t hash = 2166136261u; // any hash is acceptable, since stations only compare it
    for (std::size_t i = 0; i < m_parameters.count(); ++i)
        hash = (hash ^ std::bit_cast<std::uint32_t>(m_parameters.value(i))) * 16777619u;
    mavlink::ParamValue out;
    std::copy(kHashName.begin(), kHashName.end(), out.param_id.begin());
    out.param_value = std::bit_cast<float>(hash);
    out.param_type = mavlink::MAV_PARAM_TYPE_UINT32;
    out.param_count = static_cast<std::uint16_t>(m_parameters.count());
    out.param_index = kNoIndex;
    m_outbox.send(out);
}

void ParameterServer::sendValue(std::size_t index, std::uint16_t listIndex)
{
    const ParameterInfo &info = m_parameters.info(index);
    mavlink::ParamValue out;
    std::copy(info.name.begin(), info.name.end(), out.param_id.begin());
    out.param_value = m_parameters.value(index);
    out.param_type = static_cast<std::uint8_t>(info.type);
    if (isPx4() && info.type != ParameterType::Real32) {
        out.param_value = std::bit_cast<float>(static_cast<std::int32_t>(m_parameters.value(index)));
        out.param_type = mavlink::MAV_PARAM_TYPE_INT32;
    }
    out.param_count = static_cast<std::uint16_t>(m_parameters.count());
    out.param_index = listIndex;
    m_outbox.send(out);
}

} // namespace skyseal::sim
