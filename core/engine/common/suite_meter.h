// Measures the cost of sealing and opening: nanoseconds per record and the share of a core. One meter per session; the
// caller reads the clock directly around each call.
#pragma once

#include "core/engine/common/totals.h"
#include "core/metrics/histogram.h"

namespace skyseal::engine {

class SuiteMeter
{
public:
    /// `bytes`: opened plaintext. `afterSleep`: the first record of a wake-up.
    void opened(crypto::SuiteId suite, std::uint64_t nanoseconds, std::size_t bytes, bool afterSleep = true);
    void openedFrames(std::uint64_t count) { m_frames += count; }
    void sealed(crypto::SuiteId suite, std::uint64_t nanoseconds);

    /// Closes the period that began with the last call; call it about once a second.
    void roll(TimePoint now);
    /// The cost in the last closed period.
    const SuiteCost &cost() const { return m_cost; }
    /// Records and time since the session began; the cost of the whole process stays 0.
    const channel::EndCosts &sums() const { return m_sums; }

private:
    void follow(crypto::SuiteId suite);

    crypto::SuiteId m_suite{};
    metrics::Histogram m_open, m_openNext, m_seal;
    std::uint64_t m_nanoseconds = 0; ///< of all suites in the period
    std::uint64_t m_records = 0, m_frames = 0, m_bytes = 0;
    TimePoint m_since{};
    bool m_started = false;
    SuiteCost m_cost;
    channel::EndCosts m_sums;
};

} // namespace skyseal::engine
