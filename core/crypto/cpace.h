// CPace, a password-authenticated key exchange (draft-irtf-cfrg-cpace, suite CPACE-RISTR255-SHA512, initiator-responder mode)
// by libsodium. One attempt tests one passphrase, a recording tests none. Without a passphrase it is a plain Diffie-Hellman.
#pragma once

#include "core/base/random_source.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/cpace_generator.h"

#include <optional>

namespace skyseal::crypto {

/// The draft's ISK.
using CpaceKey = SecretBytes<64>;

/// A party's message in the transcript: its share, and data that both ends must agree on.
struct CpaceMessage
{
    ByteView share;
    ByteView associatedData;
};

/// One end's secret scalar, for one exchange.
class Cpace
{
public:
    enum class Role : std::uint8_t { Initiator, Responder };

    static Cpace begin(Role role, const CpaceInputs &inputs, RandomSource &random);

    const CpaceShare &share() const { return m_share; }
    /// The key of the exchange; `session` as in begin(). nullopt if the other share is invalid or the result is the identity.
    std::optional<CpaceKey> key(ByteView session, const CpaceMessage &initiator, const CpaceMessage &responder) const;

private:
    Cpace() = default;

    Role m_role = Role::Initiator;
    Key32 m_scalar;
    CpaceShare m_share{};
};

} // namespace skyseal::crypto
