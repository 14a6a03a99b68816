// How long things take: a histogram of nanoseconds with a fixed number of buckets, so that recording never allocates and
// two of them merge exactly. Buckets are log-linear (as in HdrHistogram): 32 per power of two, so a percentile is at most
// 1/32 above the true value, from 1 ns to 18 minutes.
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
    void merge(const Histogram &other);
    void reset() { *this = {}; }
    /// What was recorded since `earlier`, a copy of this one; min() and max() to the width of a bucket.
    Histogram since(const Histogram &earlier) const;

    std::uint64_t count() const { return m_count; }
    /// Exact, 0 when empty.
    std::uint64_t sum() const { return m_sum; }
    std::uint64_t min() const { return m_count ? m_min : 0; }
    std::uint64_t max() const { return m_max; }
    double mean() const { return m_count ? static_cast<double>(m_sum) / static_cast<double>(m_count) : 0; }

    /// The smallest value such that `share` (0…1) of what was recorded is not above it, rounded up to the end of its
    /// bucket but never above max(); 0 when empty.
    std::uint64_t percentile(double share) const;

    /// What is shown and written, in nanoseconds.
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

    /// Where a value is counted; the highest bucket takes all that is larger.
    static std::size_t bucketOf(std::uint64_t nanoseconds);
    /// The largest value that the bucket counts.
    static std::uint64_t lastOf(std::size_t bucket);

private:
    std::array<std::uint64_t, kBuckets> m_buckets{};
    std::uint64_t m_count = 0;
    std::uint64_t m_sum = 0;
    std::uint64_t m_min = UINT64_MAX;
    std::uint64_t m_max = 0;
};

} // namespace skyseal::metrics
