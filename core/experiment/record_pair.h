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
    /// A session under this suite; nullptr when it did not come up (the suite is not available).
    static std::unique_ptr<RecordPair> create(crypto::SuiteId suite);

    /// The agent seals; the record's size, 0 when it failed.
    std::size_t seal(ByteView frames, MutableByteView out);
    /// The station opens, in place.
    bool open(MutableByteView record);
    /// Heap bytes that both ends together took for the session; nullopt where the C library does not tell.
    std::optional<std::size_t> heapBytes() const { return m_heapBytes; }

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

    RecordPair();
    bool connect(crypto::SuiteId suite);
    void run(Duration span);
    void exchange();
    bool bothUse(crypto::SuiteId suite) const;

    crypto::SystemRandom m_random;
    std::array<Counters, 2> m_counters;
    std::array<std::unique_ptr<channel::Endpoint>, 2> m_ends; ///< station, agent
    std::array<Path, 2> m_paths;
    TimePoint m_now{std::chrono::hours(1)};
    std::optional<std::size_t> m_heapBytes;
};

/// Bytes of the heap that are in use now; nullopt where the C library does not tell.
std::optional<std::size_t> heapInUse();

} // namespace skyseal::experiment
