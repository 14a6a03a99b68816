// A station's and an agent's endpoint with a session between them, in memory and on a simulated clock: what a benchmark needs
// to time the sealing and opening of complete records.
#pragma once

#include "core/channel/endpoint.h"
#include "core/crypto/system_random.h"

#include <array>
#include <memory>
#include <optional>

namespace skyseal::experiment {

class RecordPair
{
public:
    /// Two ends with no session yet.
    RecordPair();
    /// A session under this suite; nullptr when it did not come up (the suite is not available).
    static std::unique_ptr<RecordPair> create(crypto::SuiteId suite);

    /// Begins the session and waits until both ends have nothing but this suite; false when that was not reached.
    bool connect(crypto::SuiteId suite);

    /// The agent seals; the record's size, 0 when it failed.
    std::size_t seal(ByteView frames, MutableByteView out);
    /// The station opens, in place.
    bool open(MutableByteView record);

private:
    class Counters final : public channel::CounterStore
    {
    public:
        std::uint64_t next() override { return ++m_next; }
        std::uint64_t lastSeen(const channel::PublicKey &) override { return m_seen; }
        bool remember(const channel::PublicKey &, std::uint64_t counter) override { return m_seen = counter, true; }

    private:
        std::uint64_t m_next = 0, m_seen = 0;
    };

    void run(Duration span);
    void exchange();
    bool bothUse(crypto::SuiteId suite) const;

    crypto::SystemRandom m_random;
    std::array<Counters, 2> m_counters;
    std::array<std::unique_ptr<channel::Endpoint>, 2> m_ends; ///< station, agent
    std::array<Path, 2> m_paths;
    TimePoint m_now{std::chrono::hours(1)};
};

/// Bytes of the heap that are in use now; nullopt where the C library does not tell. glibc counts as in use what it keeps in
/// each thread's cache for the next who asks, too: up to seven freed blocks of each size.
std::optional<std::size_t> heapInUse();

/// What each of `count` things takes of the heap, by make() that makes the next one and keeps it. As many as the cache may hold
/// blocks of a size are made before and not counted: they empty it, so that all that is counted comes out of the heap.
template<typename Make> std::optional<double> heapOfEach(std::size_t count, Make make)
{
    constexpr std::size_t kCached = 8;
    for (std::size_t i = 0; i < kCached; ++i)
        make();
    const auto before = heapInUse();
    for (std::size_t i = 0; i < count; ++i)
        make();
    const auto after = heapInUse();
    if (!before || !after || *after < *before)
        return std::nullopt;
    return static_cast<double>(*after - *before) / static_cast<double>(count);
}

} // namespace skyseal::experiment
