// Queue of the datagrams that an endpoint sends by itself: handshake messages, announcements, control records. They are few
// and short and their senders repeat them, so the queue has a fixed size and drops new datagrams when it is full.
#pragma once

#include "core/base/bytes.h"
#include "core/base/path.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace skyseal::channel {

class DatagramQueue
{
public:
    static constexpr std::size_t kSlots = 384; ///< a report of each session, announcements, and some more
    static constexpr std::size_t kMaxLength = 256;

    struct Item
    {
        Path to;
        std::size_t length = 0;
        std::array<std::uint8_t, kMaxLength> bytes{};
        ByteView view() const { return ByteView(bytes).first(length); }
    };

    bool empty() const { return m_count == 0; }
    std::size_t size() const { return m_count; }

    /// The slot to fill in place before commit(). Its content is undefined.
    Item &draft() { return m_items[(m_first + m_count) % (kSlots + 1)]; }
    /// Appends the draft; drops it if the queue is full or the length is 0.
    void commit(const Path &to, std::size_t length)
    {
        if (m_count == kSlots || length == 0)
            return;
        Item &item = draft();
        item.to = to;
        item.length = length;
        ++m_count;
    }
    /// Appends a copy. Drops a datagram longer than kMaxLength.
    void push(const Path &to, ByteView bytes)
    {
        if (bytes.size() > kMaxLength)
            return;
        std::copy(bytes.begin(), bytes.end(), draft().bytes.begin());
        commit(to, bytes.size());
    }

    /// Removes the oldest datagram; nullptr if the queue is empty. Valid until the next draft is committed.
    const Item *pop()
    {
        if (m_count == 0)
            return nullptr;
        const Item *item = &m_items[m_first];
        m_first = (m_first + 1) % (kSlots + 1);
        --m_count;
        return item;
    }

private:
    // One slot more than the queue holds: the popped datagram stays intact while the next one is drafted.
    std::array<Item, kSlots + 1> m_items{};
    std::size_t m_first = 0;
    std::size_t m_count = 0;
};

} // namespace skyseal::channel
