// The key chain (PROTOCOL.md, section 5): the secrets of an epoch follow from the chain and, except in epoch 0, from a fresh
// Diffie-Hellman of both ends. The chain is one-way, so the keys of one epoch do not open an earlier one; the Diffie-Hellman is
// fresh, so they do not open a later one either, unless the thief took part in the switch.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/channel/control.h"

#include <memory>

namespace skyseal::channel {

struct EpochSecrets;

/// Result of the Diffie-Hellman of a switch.
struct SwitchSecret
{
    crypto::PublicKey proposer{};
    crypto::PublicKey answerer{};
    Key32 shared;
};

class KeyChain
{
public:
    /// The chain before epoch 0, from the two transport keys and the final hash of the handshake.
    KeyChain(const Key32 &fromInitiator, const Key32 &fromResponder, ByteView handshakeHash);

    /// Derives the secrets of epoch 0.
    EpochSecrets begin(crypto::SuiteId suite) const;
    /// Derives the secrets of a later epoch, bound to its number, its suite and the public keys of the switch.
    EpochSecrets advance(Epoch epoch, crypto::SuiteId suite, const SwitchSecret &exchanged) const;

private:
    explicit KeyChain(Key32 secret) : m_secret(std::move(secret)) {}

    static EpochSecrets derive(const Key32 &chain, Epoch epoch, crypto::SuiteId suite, const crypto::PublicKey &proposer,
                               const crypto::PublicKey &answerer);

    Key32 m_secret; ///< chain(0), or next(n) while epoch n is the current one
};

struct EpochSecrets
{
    Key32 fromInitiator;
    Key32 fromResponder;
    KeyChain next;
};

} // namespace skyseal::channel
