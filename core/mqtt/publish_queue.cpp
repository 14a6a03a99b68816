#include "core/mqtt/publish_queue.h"

#include "core/mqtt/topics.h"

#include <utility>

namespace skyseal::mqtt {

void PublishQueue::putState(std::string topic, std::string payload)
{
    if (const auto waiting = m_states.find(topic); waiting != m_states.end()) {
        ++dropCounter(Kind::State);
        waiting->second = std::move(payload);
        return;
    }
    if (m_states.size() == kMostStates) {
        ++dropCounter(Kind::State);
        m_states.erase(m_order.front());
        m_order.pop_front();
    }
    m_order.push_back(topic);
    m_states.emplace(std::move(topic), std::move(payload));
}

void PublishQueue::putEvent(std::string topic, std::string payload)
{
    if (m_events.size() == kMostEvents) {
        ++dropCounter(Kind::Event);
        m_events.pop_front();
    }
    m_events.push_back({Kind::Event, std::move(topic), std::move(payload)});
}

void PublishQueue::putRaw(std::uint8_t systemId, ByteView frame)
{
    Raw &raw = m_raw[systemId];
    if (frame.empty() || frame.size() > kMostRawBytes)
        return;
    if (raw.bytes.empty()) {
        raw.bytes.reserve(kMostRawBytes);
        ++m_rawWaiting;
    }
    if (raw.bytes.size() + frame.size() > kMostRawBytes) {
        dropCounter(Kind::Raw) += std::exchange(raw.frames, 0);
        raw.bytes.clear();
    }
    raw.bytes.append(asText(frame));
    ++raw.frames;
}

std::optional<OutgoingMessage> PublishQueue::takeEvent()
{
    if (m_events.empty())
        return std::nullopt;
    std::optional<OutgoingMessage> out(std::move(m_events.front()));
    m_events.pop_front();
    return out;
}

std::optional<OutgoingMessage> PublishQueue::takeOther()
{
    if (!m_order.empty()) {
        auto state = m_states.extract(m_order.front());
        m_order.pop_front();
        return OutgoingMessage{Kind::State, std::move(state.key()), std::move(state.mapped())};
    }
    if (m_rawWaiting == 0)
        return std::nullopt;
    while (m_raw[m_nextRaw].bytes.empty())
        ++m_nextRaw;
    const std::uint8_t systemId = m_nextRaw++;
    Raw &raw = m_raw[systemId];
    OutgoingMessage out{Kind::Raw, vehicleMavlink(systemId), raw.bytes}; // a copy: the buffer stays
    raw.bytes.clear();
    raw.frames = 0;
    --m_rawWaiting;
    return out;
}

} // namespace skyseal::mqtt
