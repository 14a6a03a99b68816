// Histogram of durations in nanoseconds. The number of buckets is fixed, so that recording never allocates and the
// difference of two copies is exact. Buckets are log-linear (as in HdrHistogram), 32 per power of two: a percentile is at
// most 1/32 above the true value, from 1 ns to 18 minutes.
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::metrics {

class Histogram
{
public:
    void record(Duration value) { record(value.count() < 0 ? 0 : static_cast<std::uint64_t>(value.count())); }
    void record(std::uint64_t nanoseconds, std::uint64_t times = 1);
    void reset() { *this = {}; }
    /// Returns the values recorded since `earlier`, a previous copy of this histogram. min() and max() of the result are
    /// accurate to one bucket.
    Histogram since(const Histogram &earlier) const;

    std::uint64_t count() const { return m_count; }
    /// Exact, 0 when empty.
    std::uint64_t sum() const { return m_sum; }
    std::uint64_t min() const { return m_count ? m_min : 0; }
    std::uint64_t max() const { return m_max; }
    double mean() const { return m_count ? static_cast<double>(m_sum) / static_cast<double>(m_count) : 0; }

    /// The smallest value that is not exceeded by `share` (0…1) of the recorded values, rounded up to the end of its bucket,
    /// at most max(); 0 when empty.
    std::uint64_t percentile(double share) const;

    /// Figures for reports, in nanoseconds.
    struct Summary
    {
        std::uint64_t count = 0;
        std::uint64_t min = 0;
        std::uint64_t max = 0;
        double mean = 0;
        std::uint64_t p50 = 0;
        std::uint64_t p90 = 0;
        std::uint64_t p99 = 0;
        std::uint64_t p999 = 0;
    };
    Summary summary() const;

    static constexpr unsigned kStepBits = 5;
    static constexpr unsigned kHighestBit = 40;
    static constexpr std::size_t kBuckets = (std::size_t(1) << kStepBits) * (kHighestBit - kStepBits + 1);

    /// Index of the bucket of a value; the last bucket takes all larger values.
    static std::size_t bucketOf(std::uint64_t nanoseconds);
    /// The largest value of a bucket.
    static std::uint64_t lastOf(std::size_t bucket);

private:
    std::array<std::uint64_t, kBuckets> m_buckets{};
    std::uint64_t m_count = 0;
    std::uint64_t m_sum = 0;
    std::uint64_t m_min = UINT64_MAX;
    std::uint64_t m_max = 0;
};

} // namespace skyseal::metrics
