// Passes values from one thread to another, in order. The receiver is woken once, by a queued signal without arguments, and
// takes all values: a burst costs one wake-up. Not bounded: for commands and the results of
// requests, which are few; snapshots and events go through OutputQueue. The transfer is protected by a lock of this class that
// ThreadSanitizer sees, unlike the event queue of an uninstrumented Qt.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

namespace skyseal::engine {

template<typename T> class Mailbox
{
public:
    /// Returns true if the box was empty: the receiver has to be woken.
    bool put(T value)
    {
        const std::lock_guard lock(m_mutex);
        m_values.push_back(std::move(value));
        return m_values.size() == 1;
    }

    std::vector<T> takeAll()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_values, {});
    }

private:
    std::mutex m_mutex;
    std::vector<T> m_values;
};

} // namespace skyseal::engine
