// How many first messages an agent computes on, and whose: a Diffie-Hellman for a stranger is the dearest thing that it does
// unasked. All of them share 50 a second. Sources that proved their address by a cookie come before those that only claim
// one, and each source has a share of its own; an address where a station is expected comes before all. Memory is fixed.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/channel/token_bucket.h"

#include <array>

namespace skyseal::channel {

/// What is known of the address that a first message comes from.
enum class Standing : std::uint8_t {
    Claimed,  ///< anybody can write it
    Proven,   ///< it received a cookie
    Expected, ///< and it is one where the agent announces itself or has a session
};

class HandshakeLimit
{
public:
    /// 50 a second cost about a percent of one core of a small companion computer.
    HandshakeLimit(RandomSource &random, TimePoint now, double perSecond = 50);

    /// Too many came of late: claimed addresses are to be given a cookie, not a computation.
    bool underLoad(TimePoint now);
    /// Whether to compute on one more. It counts when it is true.
    bool admit(TimePoint now, const Path &from, Standing standing);

private:
    TokenBucket &shareOf(TimePoint now, const Path &from);

    // Not a list of addresses, which a flood could fill: each falls into one of these, by a secret that changes, so that
    // two which meet in one do not meet for long.
    static constexpr std::size_t kShares = 1024;

    RandomSource &m_random;
    double m_perSecond;
    TokenBucket m_all;
    std::array<TokenBucket, kShares> m_shares{};
    std::array<std::uint8_t, 16> m_key{};
    TimePoint m_keySince;
};

} // namespace skyseal::channel
