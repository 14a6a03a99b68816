#include "core/vehicle/message_queue.h"

namespace skyseal::vehicle {

bool MessageQueue::push(const OutMessage &message)
{
    if (full()) {
        ++m_refused;
        return false;
    }
    m_ring[(m_first + m_count) % m_ring.size()] = message;
    ++m_count;
    return true;
}

std::optional<OutMessage> MessageQueue::poll()
{
    if (empty())
        return std::nullopt;
    const OutMessage &front = m_ring[m_first];
    m_first = (m_first + 1) % m_ring.size();
    --m_count;
    return front;
}

} // namespace skyseal::vehicle
