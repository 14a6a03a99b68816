// Model of a bad link in one direction: loss, duplicates, reordering, corruption, delay, jitter and a line rate. A seed
// determines all decisions, so that a run can be repeated and every datagram accounted for. No sockets and no clock inside:
// tests drive it on a simulated clock, the relay in core/link on the real one.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <vector>

namespace skyseal::impair {

struct ImpairmentSettings
{
    // Probabilities per datagram, 0…1, independent of each other.
    double loss = 0;
    double duplicate = 0; ///< a second copy follows, with its own jitter
    double reorder = 0;   ///< the datagram is held until 1 to 3 later ones were delivered
    double corrupt = 0;   ///< one bit is flipped
    Duration delay{};
    Duration jitter{};                     ///< added to the delay, uniform from 0 to this value
    std::uint64_t baud = 0;                ///< line rate in bit/s at 10 bits per byte, as on a serial line; 0 = unlimited
    std::size_t lineQueueBytes = 16 << 10; ///< queue in front of the line; datagrams that do not fit are dropped
    std::uint64_t seed = 1;

    bool operator==(const ImpairmentSettings &) const = default;
};

/// Decision about one datagram.
struct Treatment
{
    enum class Fate : std::uint8_t { Passed, Lost, QueueFull };

    std::uint64_t sequence = 0; ///< the first datagram is 0
    std::size_t bytes = 0;
    Fate fate = Fate::Passed;
    bool duplicated = false;
    bool heldBack = false; ///< chosen for reordering
    bool corrupted = false;

    bool dropped() const { return fate != Fate::Passed; }
    bool operator==(const Treatment &) const = default;
};

/// At any time: offered + duplicated = lost + queueFull + delivered + waiting.
struct Counters
{
    std::uint64_t offered = 0;
    std::uint64_t offeredBytes = 0;
    std::uint64_t lost = 0;
    std::uint64_t queueFull = 0; ///< dropped because the line queue or kMostWaiting was full
    std::uint64_t duplicated = 0;
    std::uint64_t heldBack = 0; ///< chosen for reordering
    std::uint64_t corrupted = 0;
    std::uint64_t delivered = 0; ///< copies returned by pop()
    std::uint64_t deliveredBytes = 0;
    std::uint64_t outOfOrder = 0; ///< copies delivered after a datagram that was pushed later
    std::uint64_t waiting = 0;

    std::uint64_t dropped() const { return lost + queueFull; }
    bool operator==(const Counters &) const = default;
};

/// Query: nextDeadline(), counters(). Input: push(). Output: pop(); call it until it returns false, after each push() and at
/// nextDeadline().
///
/// Each datagram draws the same number of random values whatever the settings are, so that a change of one probability
/// leaves the other decisions of the same seed unchanged.
class Impairment
{
public:
    /// `stream` makes the two directions of one seed differ.
    explicit Impairment(const ImpairmentSettings &settings, std::uint64_t stream = 0);

    Treatment push(TimePoint now, ByteView datagram);
    /// Time of the next delivery; kNever when nothing waits.
    TimePoint nextDeadline() const;

    struct Delivery
    {
        std::uint64_t sequence = 0;
        ByteView bytes; ///< valid until the next call of push() or pop()
    };
    /// Takes the next datagram that is due. Returns false when there is none.
    bool pop(TimePoint now, Delivery &out);

    const Counters &counters() const { return m_counters; }
    const ImpairmentSettings &settings() const { return m_settings; }

    /// Limit of waiting datagrams, which bounds the memory.
    static constexpr std::size_t kMostWaiting = 8192;
    /// A held datagram is delivered after this time even when no later ones follow.
    static constexpr Duration kLongestHold = std::chrono::milliseconds(250);

private:
    struct Slot
    {
        Bytes bytes;
        std::uint64_t sequence = 0;
        std::uint64_t order = 0; ///< breaks ties of the deadline
        TimePoint deadline{};
        unsigned holdFor = 0; ///< number of later datagrams to let pass first
    };

    double uniform();
    TimePoint takeLine(TimePoint now, std::size_t bytes);
    void enqueue(TimePoint deadline, ByteView bytes, std::uint64_t sequence, unsigned holdFor);
    void releaseHeld(TimePoint deadline, std::uint64_t newest);
    bool later(std::size_t a, std::size_t b) const;
    void intoHeap(std::size_t slot);

    ImpairmentSettings m_settings;
    std::uint64_t m_random;
    TimePoint m_lineFree{};
    Counters m_counters;
    std::uint64_t m_order = 0;
    std::uint64_t m_newestOut = 0;
    Bytes m_damaged;
    std::vector<Slot> m_slots;
    std::vector<std::size_t> m_free;
    std::vector<std::size_t> m_heap; ///< slots as a heap by deadline
    std::vector<std::size_t> m_held; ///< slots that are held for reordering
};

} // namespace skyseal::impair
