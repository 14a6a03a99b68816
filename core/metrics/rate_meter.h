// Events per second over a sliding window, for rate displays. Fixed memory; the caller passes the time.
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>

namespace skyseal::metrics {

class RateMeter
{
public:
    /// `window` is the averaging time; it is divided into kSlots slices.
    explicit RateMeter(Duration window = std::chrono::seconds(1)) : m_slice(window / kSlots) {}

    void add(TimePoint now, std::uint64_t amount = 1);
    /// Amount per second over the last window, or over the time since the first add() if that is shorter.
    double perSecond(TimePoint now) const;
    std::uint64_t total() const { return m_total; }

    static constexpr std::int64_t kSlots = 20;

private:
    std::int64_t sliceOf(TimePoint time) const { return time.time_since_epoch() / m_slice; }
    std::uint64_t amountSince(std::int64_t firstSlice, std::int64_t lastSlice) const;

    Duration m_slice;
    std::array<std::uint64_t, kSlots + 1> m_amounts{}; ///< the current slice and the completed ones before it
    std::int64_t m_last = INT64_MIN;                   ///< newest slice in m_amounts
    TimePoint m_start{};
    std::uint64_t m_total = 0;
};

} // namespace skyseal::metrics
