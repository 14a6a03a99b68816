// Publishes the events of a program. Those that senders without a key can cause are limited to one a second in total: they
// wait in queues, one for each kind, which take turns, so that a flood of one kind hides no other. No clock, no I/O; I/O
// thread.
#pragma once

#include "core/channel/events.h"
#include "core/channel/interval_limit.h"

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

namespace skyseal::engine {

/// The key by which events take turns and are merged: their kind and subject.
struct StrangerCause
{
    enum class Kind : std::uint8_t {
        Handshake,
        UnknownAgent,
        UnansweringAgent,
        Forgery,
        Diversion,
        Plaintext,
        Approval,
        Count
    };
    Kind kind{};
    std::uint64_t subject = 0;
};

/// The events of a channel that a stranger can cause; nullopt for all others. merge() adds a newer event to the waiting one.
struct ChannelCauses
{
    std::optional<StrangerCause> operator()(const channel::HandshakeRefused &refused) const;
    std::optional<StrangerCause> operator()(const channel::ForgeryAlarm &alarm) const;
    std::optional<StrangerCause> operator()(const channel::PeerMoved &moved) const;
    template<typename Other> std::optional<StrangerCause> operator()(const Other &) const { return std::nullopt; }

    static void merge(channel::ForgeryAlarm &waiting, const channel::ForgeryAlarm &newer);
    static void merge(channel::PeerMoved &waiting, const channel::PeerMoved &newer) { waiting.to = newer.to; }
    template<typename Other> static void merge(Other &waiting, const Other &newer) { waiting = newer; }
};

/// Adds the newer event to the one that waits, if both variants hold the same alternative.
template<typename Causes, typename Event> void mergeEvents(Event &waiting, const Event &newer)
{
    std::visit(
        [&newer](auto &pending) {
            if (const auto *same = std::get_if<std::remove_reference_t<decltype(pending)>>(&newer))
                Causes::merge(pending, *same);
        },
        waiting);
}

/// `Event`: a variant. `Causes`: a callable that returns the StrangerCause of each alternative, with a static merge() of two
/// events of one alternative.
template<typename Event, typename Causes> class EventPublisher
{
public:
    using Sink = std::function<void(Event)>;

    static constexpr Duration kEvery = std::chrono::seconds(1);
    /// Waiting events of one kind; further ones are dropped, their counts stay in the statistics. Few enough that none is
    /// published more than a minute after its cause, even if all kinds take turns.
    static constexpr std::size_t kMostWaiting = 8;

    explicit EventPublisher(Sink sink) : m_sink(std::move(sink)) {}

    /// Publishes the event at once, or queues it if a stranger can cause it.
    void publish(TimePoint now, Event event)
    {
        const auto cause = std::visit(Causes(), event);
        if (!cause)
            return m_sink(std::move(event));
        auto &waiting = m_queues[static_cast<std::size_t>(cause->kind)].waiting;
        const auto same = std::find_if(waiting.begin(), waiting.end(),
                                       [&](const auto &entry) { return entry.first == cause->subject; });
        if (same != waiting.end())
            mergeEvents<Causes>(same->second, event);
        else if (waiting.size() < kMostWaiting)
            waiting.emplace_back(cause->subject, std::move(event));
        publishDue(now);
    }

    /// Publishes the event that is due, if any: the oldest of the kind whose last turn was the longest ago.
    void publishDue(TimePoint now)
    {
        Queue *next = nullptr;
        for (Queue &queue : m_queues) {
            if (!queue.waiting.empty() && (!next || queue.turn < next->turn))
                next = &queue;
        }
        if (!next || !m_limit.take(now))
            return;
        next->turn = ++m_turns;
        Event event = std::move(next->waiting.front().second);
        next->waiting.pop_front();
        m_sink(std::move(event));
    }

    /// Time of the next waiting event; kNever if there is none.
    TimePoint nextDeadline() const
    {
        const bool waits = std::any_of(m_queues.begin(), m_queues.end(),
                                       [](const Queue &queue) { return !queue.waiting.empty(); });
        return waits ? m_limit.next() : kNever;
    }

private:
    struct Queue
    {
        std::deque<std::pair<std::uint64_t, Event>> waiting; ///< by subject
        std::uint64_t turn = 0;                              ///< number of its last turn
    };

    Sink m_sink;
    std::array<Queue, static_cast<std::size_t>(StrangerCause::Kind::Count)> m_queues;
    std::uint64_t m_turns = 0;
    channel::IntervalLimit m_limit{kEvery, TimePoint::min()};
};

} // namespace skyseal::engine
