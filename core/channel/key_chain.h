// The secret from which each epoch's keys and the next link of the chain come. A link is a one-way function of the one
// before and of a fresh nonce of either end, so whoever finds the keys of one epoch cannot open an earlier one.
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

    /// Secrets of one epoch, bound to its number, suite and nonces (zeros in epoch 0), and the chain after it.
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
