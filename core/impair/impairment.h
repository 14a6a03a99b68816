// A bad link in a box: loss, duplicates, reordering, corruption, delay, jitter and a line rate, all decided by a seed, so
// that a run can be repeated and every datagram accounted for. No sockets and no clock inside: test harnesses drive it on
// a simulated clock, the relay of core/link on the real one. One object is one direction.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <vector>

namespace skyseal::impair {

struct Settings
{
    // Probabilities per datagram, 0…1, independent of each other.
    double loss = 0;
    double duplicate = 0; ///< a second copy, with a jitter of its own
    double reorder = 0;   ///< held back until 1 to 3 later datagrams have gone ahead
    double corrupt = 0;   ///< one bit is flipped
    Duration delay{};
    Duration jitter{};                     ///< on top of the delay, evenly from 0 to this
    std::uint64_t baud = 0;                ///< line rate at 10 bits a byte, as on a serial line; 0 = unlimited
    std::size_t lineQueueBytes = 16 << 10; ///< what may wait for the line; more is dropped
    std::uint64_t seed = 1;

    bool operator==(const Settings &) const = default;
};

/// What was done with one datagram.
struct Verdict
{
    enum class Fate : std::uint8_t { Passed, Lost, QueueFull };

    std::uint64_t sequence = 0; ///< the first datagram is 0
    std::size_t bytes = 0;
    Fate fate = Fate::Passed;
    bool duplicated = false;
    bool pendingApproval = false;
    bool corrupted = false;

    bool dropped() const { return fate != Fate::Passed; }
    bool operator==(const Verdict &) const = default;
};

/// At any time: offered + duplicated = lost + queueFull + delivered + waiting.
struct Counters
{
    std::uint64_t offered = 0;
    std::uint64_t offeredBytes = 0;
    std::uint64_t lost = 0;
    std::uint64_t queueFull = 0; ///< dropped because the line or the memory was full
    std::uint64_t duplicated = 0;
    std::uint64_t pendingApproval = 0; ///< chosen for reordering
    std::uint64_t corrupted = 0;
    std::uint64_t delivered = 0; ///< copies that came out
    std::uint64_t deliveredBytes = 0;
    std::uint64_t outOfOrder = 0; ///< copies that came out after a datagram that went in later, whatever the reason
    std::uint64_t waiting = 0;

    std::uint64_t dropped() const { return lost + queueFull; }
    bool operator==(const Counters &) const = default;
};

/// Query: nextDeadline(), counters(). Input: push(). Output: pop(), to be called until it gives nothing whenever the
/// deadline has come, and after push() when there is no delay.
///
/// Every datagram draws the same number of random values whatever the settings are: raising one probability leaves the
/// other decisions of the same seed as they were.
class Impairment
{
public:
    /// `stream` tells the two directions of one seed apart.
    explicit Impairment(const Settings &settings, std::uint64_t stream = 0);

    Verdict push(TimePoint now, ByteView datagram);
    /// When pop() will have something, kNever when nothing waits.
    TimePoint nextDeadline() const;

    struct Delivery
    {
        std::uint64_t sequence = 0;
        ByteView bytes; ///< valid until the next call of push() or pop()
    };
    /// The next datagram that is due; false when there is none.
    bool pop(TimePoint now, Delivery &out);

    const Counters &counters() const { return m_counters; }
    const Settings &settings() const { return m_settings; }

    /// Bound of the memory, in datagrams that wait.
    static constexpr std::size_t kMostWaiting = 8192;
    /// A datagram that is held back goes at last after this, when no later ones come.
    static constexpr Duration kLongestHold = std::chrono::milliseconds(250);

private:
    struct Slot
    {
        Bytes bytes;
        std::uint64_t sequence = 0;
        std::uint64_t order = 0; ///< breaks ties of the deadline
        TimePoint deadline{};
        unsigned holdFor = 0; ///< later datagrams that still have to go ahead
    };

    double uniform();
    TimePoint takeLine(TimePoint now, std::size_t bytes);
    void enqueue(TimePoint deadline, ByteView bytes, std::uint64_t sequence, unsigned holdFor);
    void releaseHeld(TimePoint deadline, std::uint64_t newest);
    bool later(std::size_t a, std::size_t b) const;
    void intoHeap(std::size_t slot);

    Settings m_settings;
    std::uint64_t m_random;
    TimePoint m_lineFree{};
    Counters m_counters;
    std::uint64_t m_order = 0;
    std::uint64_t m_newestOut = 0;
    Bytes m_damaged;
    std::vector<Slot> m_slots;
    std::vector<std::size_t> m_free;
    std::vector<std::size_t> m_heap; ///< slots by deadline, the next one in front
    std::vector<std::size_t> m_held; ///< slots that wait for later ones
};

} // namespace skyseal::impair
