// A station's and an agent's endpoint with a session between them, in memory and on a simulated clock, for benchmarks of
// sealing and opening complete records. Also the heap measurement of such objects.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/counter_store.h"
#include "core/crypto/suite.h"
#include "core/crypto/system_random.h"

#include <array>
#include <memory>
#include <optional>

namespace skyseal::channel {
class Endpoint;
}

namespace skyseal::experiment {

class RecordPair
{
public:
    /// Two endpoints without a session.
    RecordPair();
    ~RecordPair();
    /// A pair with a session under this suite; nullptr if the suite is not available.
    static std::unique_ptr<RecordPair> create(crypto::SuiteId suite);

    /// Establishes the session and runs until both ends use only this suite; false on failure.
    bool connect(crypto::SuiteId suite);

    /// Seals at the agent. Returns the size of the record, 0 on failure.
    std::size_t seal(ByteView frames, MutableByteView out);
    /// Opens at the station, in place.
    bool open(MutableByteView record);

private:
    class Counters final : public channel::CounterStore
    {
    public:
        std::optional<std::uint64_t> next() override { return ++m_next; }
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

/// Heap bytes in use; nullopt if the C library has no heap statistics. glibc also counts the freed blocks in the thread caches,
/// up to seven of each size.
std::optional<std::size_t> heapInUse();

/// Mean heap bytes of one of `count` objects; make() creates the next one and keeps it. Some objects are created first and not
/// counted: they use up the freed blocks in the thread cache, so that the counted ones are taken from the heap.
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
