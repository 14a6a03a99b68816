// First-in, first-out queue of fixed capacity whose storage is allocated once, for messages that wait to be sent: a link that
// stalls can neither make it grow nor cause allocations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skyseal {

template<typename T> class Ring
{
public:
    explicit Ring(std::size_t capacity) : m_slots(capacity + 1) {}

    /// Appends an element and returns it, to be filled in place; it still has the content of an older one. Null when the
    /// ring is full, which is counted.
    T *append()
    {
        if (full()) {
            ++m_refused;
            return nullptr;
        }
        return &m_slots[(m_first + m_count++) % m_slots.size()];
    }
    /// Appends a copy. Returns false when the ring is full.
    bool push(const T &value)
    {
        T *slot = append();
        if (slot)
            *slot = value;
        return slot != nullptr;
    }
    /// Removes the oldest element and returns it, valid until the next call of append() or push(). Null when empty.
    const T *take()
    {
        if (empty())
            return nullptr;
        const T *oldest = &m_slots[m_first];
        m_first = (m_first + 1) % m_slots.size();
        --m_count;
        return oldest;
    }

    bool empty() const { return m_count == 0; }
    bool full() const { return room() == 0; }
    std::size_t size() const { return m_count; }
    std::size_t room() const { return m_slots.size() - 1 - m_count; }
    /// How many elements did not fit since construction.
    std::uint64_t refused() const { return m_refused; }

private:
    std::vector<T> m_slots; ///< one more than the capacity, so that the element taken last stays intact
    std::size_t m_first = 0;
    std::size_t m_count = 0;
    std::uint64_t m_refused = 0;
};

} // namespace skyseal
