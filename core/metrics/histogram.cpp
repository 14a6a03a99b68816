#include "core/metrics/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace skyseal::metrics {

static constexpr std::uint64_t kSteps = std::uint64_t(1) << Histogram::kStepBits;

std::size_t Histogram::bucketOf(std::uint64_t nanoseconds)
{
    if (nanoseconds < kSteps)
        return static_cast<std::size_t>(nanoseconds);
    const unsigned highest = static_cast<unsigned>(std::bit_width(nanoseconds)) - 1;
    if (highest >= kHighestBit)
        return kBuckets - 1;
    // The leading bit selects the group of buckets, the next kStepBits bits the bucket within it.
    const unsigned shift = highest - kStepBits;
    return static_cast<std::size_t>((shift + 1) * kSteps + ((nanoseconds >> shift) - kSteps));
}

std::uint64_t Histogram::lastOf(std::size_t bucket)
{
    if (bucket < kSteps)
        return bucket;
    const std::uint64_t shift = bucket / kSteps - 1;
    return ((kSteps + bucket % kSteps + 1) << shift) - 1;
}

void Histogram::record(std::uint64_t nanoseconds, std::uint64_t times)
{
    if (times == 0)
        return;
    m_buckets[bucketOf(nanoseconds)] += times;
    m_count += times;
    m_sum += nanoseconds * times;
    m_min = std::min(m_min, nanoseconds);
    m_max = std::max(m_max, nanoseconds);
}

Histogram Histogram::since(const Histogram &earlier) const
{
    Histogram out;
    for (std::size_t i = 0; i < kBuckets; ++i) {
        out.m_buckets[i] = m_buckets[i] - earlier.m_buckets[i];
        if (out.m_buckets[i] == 0)
            continue;
        out.m_min = std::min(out.m_min, std::max(m_min, i == 0 ? 0 : lastOf(i - 1) + 1));
        out.m_max = i == kBuckets - 1 ? m_max : std::min(m_max, lastOf(i));
    }
    out.m_count = m_count - earlier.m_count;
    out.m_sum = m_sum - earlier.m_sum;
    return out;
}

std::uint64_t Histogram::percentile(double share) const
{
    if (m_count == 0)
        return 0;
    const double wanted = std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(m_count));
    const auto rank = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(wanted));
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
        below += m_buckets[i];
        if (below >= rank)
            return i == kBuckets - 1 ? m_max : std::clamp(lastOf(i), m_min, m_max);
    }
    return m_max;
}

Histogram::Summary Histogram::summary() const
{
    return {m_count, min(), m_max, mean(), percentile(0.5), percentile(0.9), percentile(0.99), percentile(0.999)};
}

} // namespace skyseal::metrics
