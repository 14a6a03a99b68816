// The key chain (PROTOCOL.md, section 5): each link gives the secrets of an epoch and the next link. A link is a one-way function
// of the one before and of a fresh nonce of each end, so that the keys of one epoch do not open an earlier one.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/channel/control.h"

#include <memory>

namespace skyseal::channel {

struct EpochSecrets;

class KeyChain
{
public:
    /// The first link, from the two transport keys and the final hash of the handshake.
    KeyChain(const Key32 &fromInitiator, const Key32 &fromResponder, ByteView handshakeHash);

    /// Derives the secrets of an epoch, bound to its number, suite and nonces (zero in epoch 0), and the next link.
    EpochSecrets derive(Epoch epoch, crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer) const;

private:
    explicit KeyChain(Key32 secret) : m_secret(std::move(secret)) {}

    Key32 m_secret;
};

struct EpochSecrets
{
    Key32 fromInitiator;
    Key32 fromResponder;
    KeyChain next;
};

} // namespace skyseal::channel
