#include "core/metrics/rate_meter.h"

#include <algorithm>

namespace skyseal::metrics {

static constexpr std::int64_t kRing = RateMeter::kSlots + 1;

static std::size_t at(std::int64_t slice)
{
    return static_cast<std::size_t>(((slice % kRing) + kRing) % kRing);
}

void RateMeter::add(TimePoint now, std::uint64_t amount)
{
    const std::int64_t slice = sliceOf(now);
    if (m_last == INT64_MIN) {
        m_start = now;
        m_last = slice;
    }
    // Slices without an event still hold the amounts of the previous round.
    for (std::int64_t passed = std::max(m_last + 1, slice - kSlots); passed <= slice; ++passed)
        m_amounts[at(passed)] = 0;
    m_last = std::max(m_last, slice);
    m_amounts[at(m_last)] += amount;
    m_total += amount;
}

std::uint64_t RateMeter::amountSince(std::int64_t firstSlice, std::int64_t lastSlice) const
{
    std::uint64_t out = 0;
    for (std::int64_t slice = std::max(firstSlice, m_last - kSlots); slice <= std::min(lastSlice, m_last); ++slice)
        out += m_amounts[at(slice)];
    return out;
}

double RateMeter::perSecond(TimePoint now) const
{
    if (m_last == INT64_MIN)
        return 0;
    const std::int64_t slice = sliceOf(now);
    const Duration window = m_slice * kSlots;
    // The current slice is incomplete, so the window ends where it begins. Before the first full window all slices count.
    if (now - m_start < window)
        return static_cast<double>(amountSince(m_last - kSlots, slice)) / std::max(seconds(now - m_start), seconds(m_slice));
    return static_cast<double>(amountSince(slice - kSlots, slice - 1)) / seconds(window);
}

} // namespace skyseal::metrics
