// The cookie that an agent under load sends instead of computing on a first message (PROTOCOL.md, section 4.1). It is sealed
// for a receiver that knows the agent's public key and the first message. A sender that returns it has proven that it receives
// datagrams at its address. The agent keeps no state: the cookie is a function of the address and a secret that changes
// every 120 s.
//
//   0x5B | nonce 16 | sealed cookie 16 + 16 | zeros 78                                                 127 bytes
//
// A first message under a cookie has the same 127 bytes, with a MAC keyed by the cookie where mac1 stood.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/base/secret_bytes.h"
#include "core/channel/policy.h"
#include "core/channel/wire_format.h"

#include <array>
#include <optional>

namespace skyseal::channel {

inline constexpr std::size_t kCookieLength = 127;                        ///< of the first message, too
inline constexpr Duration kCookieSecretLife = std::chrono::seconds(120); ///< then valid as the previous one for as long again

using Cookie = std::array<std::uint8_t, 16>;
using CookieMessage = std::array<std::uint8_t, kCookieLength>;

/// The agent's half.
class CookieMaker
{
public:
    CookieMaker(const PublicKey &own, RandomSource &random);

    /// Makes the cookie message for `from` that answers a first message with a right mac1.
    CookieMessage make(TimePoint now, const Path &from, ByteView first);
    /// Returns true if the last 16 bytes are a MAC under a cookie sent to `from` within the last two to four minutes. Returns
    /// false without a computation if no cookie is valid.
    bool verify(TimePoint now, const Path &from, ByteView first) const;

private:
    using Secret = SecretBytes<16>;
    void renew(TimePoint now);

    RandomSource &m_random;
    std::array<std::uint8_t, 32> m_sealKey;
    Secret m_secret;
    std::optional<Secret> m_previous;
    std::optional<TimePoint> m_since;       ///< when the secret was made; none before the first cookie
    std::array<std::uint8_t, 16> m_nonce{}; ///< eight random bytes for each secret, and eight that count
    std::uint64_t m_made = 0;
};

/// Returns true if the datagram is shaped like a cookie. Costs no hash, and authenticates nothing.
bool cookieHasForm(ByteView datagram);
/// The station's half: opens the cookie that answers the first message with this `mac1`. Returns nullopt if it answers another
/// message, or was made without the agent's public key.
std::optional<Cookie> openCookie(const PublicKey &agent, ByteView mac1, ByteView datagram);
/// Replaces mac1 by a MAC under the cookie.
void signWithCookie(const Cookie &cookie, MutableByteView first);

} // namespace skyseal::channel
