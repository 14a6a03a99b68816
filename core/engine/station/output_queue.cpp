#include "core/engine/station/output_queue.h"

#include <algorithm>

namespace skyseal::engine {

template<typename Kind> void OutputQueue::dropOldest()
{
    const auto found = std::ranges::find_if(m_items, [](const Item &item) { return std::holds_alternative<Kind>(item); });
    if (found != m_items.end())
        m_items.erase(found);
}

bool OutputQueue::put(Item item)
{
    const std::lock_guard lock(m_mutex);
    const bool wasEmpty = m_items.empty();
    if (std::holds_alternative<SnapshotPtr>(item)) {
        dropOldest<SnapshotPtr>();
    } else if (std::holds_alternative<Event>(item) && ++m_events > kMostEvents) {
        dropOldest<Event>();
        --m_events;
        ++m_eventsDropped;
    }
    m_items.push_back(std::move(item));
    return wasEmpty;
}

std::deque<OutputQueue::Item> OutputQueue::takeAll()
{
    const std::lock_guard lock(m_mutex);
    m_events = 0;
    std::deque<Item> items = std::exchange(m_items, {});
    const std::uint64_t reported = std::exchange(m_eventsDroppedReported, m_eventsDropped);
    if (m_eventsDropped > reported)
        items.emplace_front(Event(EventsDropped{m_eventsDropped - reported}));
    return items;
}

std::uint64_t OutputQueue::eventsDropped() const
{
    const std::lock_guard lock(m_mutex);
    return m_eventsDropped;
}

} // namespace skyseal::engine
