// Limits the first messages on which an agent computes (PROTOCOL.md, section 4.1): a Diffie-Hellman computation is the most
// expensive reaction to an unauthenticated datagram. All sources share 50 a second. Addresses proven by a cookie have priority
// over claimed ones, each source has its own share, and expected stations have the highest priority. Memory is fixed.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/channel/token_bucket.h"

#include <array>

namespace skyseal::channel {

/// Trust in the source address of a first message.
enum class Standing : std::uint8_t {
    Claimed,  ///< may be forged
    Proven,   ///< a cookie was received there
    Expected, ///< proven, and the agent announces itself or has a session there
};

class HandshakeLimit
{
public:
    /// The default of 50 a second costs about a percent of one core of a small companion computer.
    HandshakeLimit(RandomSource &random, TimePoint now, double perSecond = 50);

    /// Returns true if messages from claimed addresses must be answered by a cookie.
    bool underLoad(TimePoint now);
    /// Returns true, and counts, if one more may be computed on.
    bool admit(TimePoint now, const Path &from, Standing standing);

private:
    TokenBucket &shareOf(TimePoint now, const Path &from);

    // Addresses are hashed into a fixed number of shares, since a flood could fill a list. The key of the hash changes, so that
    // two addresses do not share one for long.
    static constexpr std::size_t kShares = 1024;

    RandomSource &m_random;
    double m_perSecond;
    TokenBucket m_all;
    std::array<TokenBucket, kShares> m_shares{};
    std::array<std::uint8_t, 16> m_key{};
    TimePoint m_keySince;
};

} // namespace skyseal::channel
