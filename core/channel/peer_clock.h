// A bound on the age of what the peer sends, without a shared clock (PROTOCOL.md, section 6.1).
//
// A report of the peer echoes the stamp of one of our reports: the peer's clock showed `peerStamp` after our clock showed the
// echoed stamp, plus the time for which the peer held it. Every later message of the peer was therefore sent later than that on
// our clock as well, by the difference of its stamps. The bound exceeds the true age by the transit time of our report;
// delaying messages can only increase it.
#pragma once

#include "core/base/clock.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace skyseal::channel {

class PeerClock
{
public:
    /// `start`: a time on our clock before the peer's clock showed 0.
    explicit PeerClock(TimePoint start) : m_best{start, start, 0} {}

    /// The peer's clock showed `peerStamp` (microseconds modulo 2^32) at `since` on our clock, or later.
    void add(TimePoint now, TimePoint since, std::uint32_t peerStamp)
    {
        const Mark mark{now, since, peerStamp};
        const Duration before = m_best.age(now, peerStamp);
        const bool stepped = before < Duration::zero();
        if (stepped || mark.age(now, peerStamp) < before || now >= m_best.at + kKeepBest)
            m_best = mark;
    }

    /// Greatest possible age at `now` of what the peer sent when its clock showed `peerStamp`. Returns nullopt where the stamp
    /// gives no bound: one of the clocks has stepped, or none of our reports was answered for long.
    std::optional<Duration> age(TimePoint now, std::uint32_t peerStamp) const
    {
        const Duration age = m_best.age(now, peerStamp);
        const bool known = age >= Duration::zero() && now < m_best.at + kForget;
        return known ? std::optional(age) : std::nullopt;
    }

    /// Two clocks of 200 ppm each differ by less.
    static constexpr int kDrift = 2048;

private:
    /// The tightest mark is kept, so that a queue on the way back to the peer does not loosen the bound; not for ever, so that
    /// a suspended machine, whose clock stood still, is forgotten.
    static constexpr Duration kKeepBest = std::chrono::seconds(60);
    static constexpr Duration kForget = std::chrono::minutes(20); ///< below half of the range of a stamp

    struct Mark
    {
        TimePoint at;
        TimePoint since;
        std::uint32_t peerStamp;

        Duration age(TimePoint now, std::uint32_t stamp) const
        {
            const Duration passed = std::chrono::microseconds(static_cast<std::int32_t>(stamp - peerStamp));
            return now - since - passed + std::max(passed, -passed) / kDrift;
        }
    };

    Mark m_best;
};

} // namespace skyseal::channel
