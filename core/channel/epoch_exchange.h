// The Diffie-Hellman of a switch (PROTOCOL.md, sections 5 and 8). Holds the private key of this end's open proposal; that of an
// answer lives during answer() only.
#pragma once

#include "core/base/random_source.h"
#include "core/channel/key_chain.h"
#include "core/channel/token_bucket.h"
#include "core/crypto/x25519.h"

#include <optional>

namespace skyseal::channel {

class EpochExchange
{
public:
    /// Makes the key pair of a proposal, in place of an earlier one. Returns the public key.
    crypto::PublicKey propose(RandomSource &random);
    /// The proposal was answered or given up: wipes its private key.
    void drop() { m_proposal.reset(); }

    /// Limits the computations that the peer can cause.
    bool mayCompute(TimePoint now) { return m_computations.take(now, kPerSecond, kAtOnce); }
    /// Answers a proposal with a fresh key. Returns nullopt if its key is of small order.
    static std::optional<SwitchSecret> answer(const crypto::PublicKey &proposer, RandomSource &random);
    /// Result of this end's proposal, whose private key stays. Returns nullopt if the answer's key is of small order.
    /// Precondition: propose() was called, and drop() was not.
    std::optional<SwitchSecret> finish(const crypto::PublicKey &answerer) const;

private:
    static constexpr double kPerSecond = 50, kAtOnce = 20;

    std::optional<crypto::X25519KeyPair> m_proposal;
    TokenBucket m_computations;
};

} // namespace skyseal::channel
