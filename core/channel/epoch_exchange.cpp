#include "core/channel/epoch_exchange.h"

namespace skyseal::channel {

crypto::PublicKey EpochExchange::propose(RandomSource &random)
{
    return m_proposal.emplace(crypto::X25519KeyPair::generate(random)).publicKey;
}

std::optional<SwitchSecret> EpochExchange::answer(const crypto::PublicKey &proposer, RandomSource &random)
{
    const auto own = crypto::X25519KeyPair::generate(random);
    auto shared = crypto::x25519(own.secret, proposer);
    if (!shared)
        return std::nullopt;
    return SwitchSecret{proposer, own.publicKey, std::move(*shared)};
}

std::optional<SwitchSecret> EpochExchange::finish(const crypto::PublicKey &answerer) const
{
    auto shared = crypto::x25519(m_proposal->secret, answerer);
    if (!shared)
        return std::nullopt;
    return SwitchSecret{m_proposal->publicKey, answerer, std::move(*shared)};
}

} // namespace skyseal::channel
