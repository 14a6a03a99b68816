#include "core/channel/handshake_limit.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr double kAtOnce = 20;
/// Tokens that each standing leaves to the better ones.
constexpr double kLeft[] = {10, 5, 0};
/// A station sends a fresh first message every two seconds at the most; the rest is for several stations behind one address.
constexpr double kShareBySecond = 2;
constexpr double kShareAtOnce = 5;
constexpr Duration kKeyLife = std::chrono::seconds(60);

} // namespace

HandshakeLimit::HandshakeLimit(RandomSource &random, TimePoint now, double perSecond)
    : m_random(random), m_perSecond(perSecond), m_all{kAtOnce, now}, m_keySince(now)
{
    m_random.fill(m_key);
}

TokenBucket &HandshakeLimit::shareOf(TimePoint now, const Path &from)
{
    if (now >= m_keySince + kKeyLife) {
        m_random.fill(m_key);
        m_keySince = now;
    }
    // An IPv6 host can choose the lower half of its address, and every host its ports.
    static constexpr std::array<std::uint8_t, 12> kMappedIpv4{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
    const auto &ip = from.remote.ip;
    const bool ipv4 = std::equal(kMappedIpv4.begin(), kMappedIpv4.end(), ip.begin());
    std::array<std::uint8_t, 20> said{};
    std::copy_n(ip.begin(), ipv4 ? 16 : 8, said.begin());
    for (unsigned i = 0; i < 4; ++i)
        said[16 + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(from.link) >> 8 * i);
    std::array<std::uint8_t, crypto_shorthash_BYTES> hash;
    crypto_shorthash(hash.data(), said.data(), said.size(), m_key.data());
    return m_shares[(hash[0] | hash[1] << 8) % kShares];
}

bool HandshakeLimit::underLoad(TimePoint now)
{
    m_all.fill(now, m_perSecond, kAtOnce);
    return m_all.credit < kLeft[static_cast<std::size_t>(Standing::Claimed)] + 1;
}

bool HandshakeLimit::admit(TimePoint now, const Path &from, Standing standing)
{
    m_all.fill(now, m_perSecond, kAtOnce);
    if (m_all.credit < kLeft[static_cast<std::size_t>(standing)] + 1)
        return false;
    if (standing != Standing::Claimed && !shareOf(now, from).take(now, kShareBySecond, kShareAtOnce))
        return false;
    m_all.credit -= 1;
    return true;
}

} // namespace skyseal::channel
