// What an agent under load gives instead of a computation: a cookie, sealed so that only who knows the agent's public key
// and saw the first message can open it. Whoever sends it back has shown that datagrams to its address reach it. The agent
// keeps nothing for it: the cookie is a function of the address and a secret that changes every 120 s.
//
//   0x5B | nonce 16 | sealed cookie 16 + 16 | zeros 78                                                 127 bytes
//
// A first message under a cookie has the same 127 bytes, with a MAC keyed by the cookie where mac1 stood.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/channel/policy.h"
#include "core/channel/wire_format.h"

#include <array>
#include <optional>

namespace skyseal::channel {

inline constexpr std::size_t kCookieLength = 127;                        ///< as long as the first message that it asks for
inline constexpr Duration kCookieSecretLife = std::chrono::seconds(120); ///< and as long again as the previous one

using Cookie = std::array<std::uint8_t, 16>;
using CookieMessage = std::array<std::uint8_t, kCookieLength>;

/// The agent's half.
class CookieMaker
{
public:
    CookieMaker(const PublicKey &own, RandomSource &random);

    /// What to send to `from` for a first message whose mac1 is right.
    CookieMessage make(TimePoint now, const Path &from, ByteView first);
    /// Whether the last 16 bytes are a MAC under a cookie that `from` was given in the last two to four minutes. False at
    /// once when none was given to anybody.
    bool verify(TimePoint now, const Path &from, ByteView first) const;

private:
    using Secret = SecretBytes<16>;
    void renew(TimePoint now);

    RandomSource &m_random;
    std::array<std::uint8_t, 32> m_sealKey;
    Secret m_secret;
    std::optional<Secret> m_previous;
    std::optional<TimePoint> m_since;       ///< when the secret was made; none while no cookie was ever asked for
    std::array<std::uint8_t, 16> m_nonce{}; ///< eight random bytes for each secret, and eight that count
    std::uint64_t m_made = 0;
};

/// The station's half: the cookie in an answer to the first message whose mac1 is `mac1`. nullopt when it is not for that
/// message, or was not made by someone who knows the agent's public key.
std::optional<Cookie> openCookie(const PublicKey &agent, ByteView mac1, ByteView datagram);
/// Puts a MAC under the cookie in place of mac1.
void signWithCookie(const Cookie &cookie, MutableByteView first);

} // namespace skyseal::channel
