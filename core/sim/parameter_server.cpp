#include "core/sim/parameter_server.h"

#include "core/mavlink/messages.h"

namespace skyseal::sim {

namespace {
constexpr Duration kPace = std::chrono::milliseconds(4); // 250 a second
constexpr std::size_t kKeepFree = 32;                    // frames of the outbox that a list may not take from telemetry
} // namespace

void ParameterServer::requestList(TimePoint now)
{
    m_next = 0;
    m_due = now;
}

void ParameterServer::requestRead(int index, std::string_view name)
{
    if (index >= 0) {
        if (static_cast<std::size_t>(index) < m_parameters.count())
            sendValue(static_cast<std::size_t>(index));
    } else if (const auto found = m_parameters.find(name)) {
        sendValue(*found);
    }
}

void ParameterServer::set(std::string_view name, float value)
{
    const auto index = m_parameters.find(name);
    if (!index)
        return;
    if (m_parameters.set(*index, value) != Parameters::SetResult::Stored)
        m_texts.say(Severity::Warning, std::string(name) + ": value refused");
    sendValue(*index);
}

void ParameterServer::handleDeadline(TimePoint now)
{
    while (m_due <= now) {
        m_due += kPace;
        if (m_outbox.room() < kKeepFree)
            continue;
        sendValue(m_next++);
        if (m_next >= m_parameters.count())
            m_due = kNever;
    }
}

void ParameterServer::sendValue(std::size_t index)
{
    const ParameterInfo &info = m_parameters.info(index);
    mavlink::ParamValue out;
    std::copy(info.name.begin(), info.name.end(), out.param_id.begin());
    out.param_value = m_parameters.value(index);
    out.param_type = static_cast<std::uint8_t>(info.type);
    out.param_count = static_cast<std::uint16_t>(m_parameters.count());
    out.param_index = static_cast<std::uint16_t>(index);
    m_outbox.send(out);
}

} // namespace skyseal::sim
