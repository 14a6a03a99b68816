// The station's output on its way from the I/O thread to the reader's thread: bounded, so that a hung reader costs a
// fixed amount of memory. Only the newest snapshot is kept, and a limited number of events; pairing events, snapshots with a
// probe, each of which the reader requested, and the final snapshot are always delivered. Items keep their order. Thread-safe.
#pragma once

#include "core/channel/pairing.h"
#include "core/engine/station/event.h"
#include "core/engine/station/snapshot_ptr.h"

#include <deque>
#include <mutex>
#include <utility>
#include <variant>

namespace skyseal::engine {

/// A snapshot with a probe.
struct Probed
{
    SnapshotPtr snapshot;
};

/// The last snapshot of a station that was stopped.
struct Stopped
{
    SnapshotPtr last;
};

class OutputQueue
{
public:
    using Item = std::variant<SnapshotPtr, Event, channel::PairingEvent, Probed, Stopped>;

    /// Greatest number of waiting events; beyond it the oldest one is dropped.
    static constexpr std::size_t kMostEvents = 1000;

    /// Returns true if the queue was empty: the reader has to be woken.
    bool put(Item item);
    /// Takes all waiting items, oldest first, preceded by EventsDropped if events were dropped since the last call.
    std::deque<Item> takeAll();
    /// Events that were dropped since the start.
    std::uint64_t eventsDropped() const;

private:
    template<typename Kind> void dropOldest();

    mutable std::mutex m_mutex;
    std::deque<Item> m_items;
    std::size_t m_events = 0;                  ///< in m_items
    std::uint64_t m_eventsDropped = 0;         ///< since the start
    std::uint64_t m_eventsDroppedReported = 0; ///< of these, reported by takeAll()
};

} // namespace skyseal::engine
