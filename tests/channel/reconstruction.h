// Computes the keys of a recorded handshake from both static keys and the pre-shared key. The shared secret of the two
// ephemeral keys is missing; the test supplies guesses.
#pragma once

#include "core/crypto/x25519.h"
#include "core/channel/key_chain.h"
#include "core/channel/handshake_messages.h"
#include "core/crypto/kdf.h"
#include "core/noise/symmetric_state.h"

#include <optional>
#include <string_view>

namespace skyseal::test {

inline constexpr std::string_view kPrologueText("skyseal channel v1\x01");

/// The end of a handshake, as the initiator has it.
struct RevealedSession
{
    Key32 initiators, responders; ///< the transport keys of Noise
    crypto::Hash64 hash{};

    /// First key of the chain; private to the channel.
    Key32 chain() const
    {
        SecretBytes<64> both;
        std::copy(initiators.view().begin(), initiators.view().end(), both.mutableView().begin());
        std::copy(responders.view().begin(), responders.view().end(), both.mutableView().begin() + 32);
        return crypto::hkdfExtractSha256(hash, both.view());
    }
    /// The part of the key chain that is kept while epoch 0 is the current one.
    Key32 next(crypto::SuiteId suite) const
    {
        Bytes info;
        for (const char c : std::string_view("skyseal v1 epoch next"))
            info.push_back(static_cast<std::uint8_t>(c));
        info.resize(info.size() + 4 + 1 + 64);
        info[info.size() - 65] = static_cast<std::uint8_t>(suite);
        return crypto::hkdfExpandKey(chain(), info);
    }
    channel::EpochSecrets epochZero(crypto::SuiteId suite) const
    {
        return channel::KeyChain(initiators, responders, hash).begin(suite);
    }
};

class Reconstruction
{
public:
    Reconstruction(const crypto::X25519KeyPair &station, const crypto::X25519KeyPair &agent, ByteView first, ByteView answer)
        : m_station(station), m_agent(agent), m_first(first), m_answer(answer)
    {}

    /// `guess`: shared secret of the ephemeral keys; nullopt omits it. `psk`: zeros if there was none. Returns nullopt if the
    /// answer does not open.
    std::optional<RevealedSession> withGuess(const std::optional<Key32> &guess, const Key32 &psk = Key32())
    {
        noise::SymmetricState state;
        state.mixHash(asBytes(kPrologueText));
        state.mixHash(m_agent.publicKey);
        const ByteView e = m_first.subspan(1, 32), s = m_first.subspan(33, 48), payload = m_first.subspan(81, 30);
        std::array<std::uint8_t, 64> plain;
        mixEphemeral(state, e);
        mix(state, m_agent, e);
        if (!state.decryptAndHash(s, plain))
            return std::nullopt;
        mix(state, m_agent, m_station.publicKey);
        firstPayloadRead = state.decryptAndHash(payload, plain).has_value();
        const ByteView re = m_answer.subspan(3, 32), answered = m_answer.subspan(35, channel::AnswerPayload::kLength + 16);
        mixEphemeral(state, re);
        if (guess)
            state.mixKey(guess->view());
        mix(state, m_station, re);
        state.mixKeyAndHash(psk.view());
        if (!state.decryptAndHash(answered, plain))
            return std::nullopt;
        auto [initiators, responders] = state.split();
        return RevealedSession{std::move(initiators), std::move(responders), state.handshakeHash()};
    }

    /// True if the payload of the first message was read with the agent's key alone: Noise IK gives it no forward secrecy.
    bool firstPayloadRead = false;

    static crypto::PublicKey asKey(ByteView bytes)
    {
        crypto::PublicKey key{};
        std::copy(bytes.begin(), bytes.end(), key.begin());
        return key;
    }

private:
    static void mixEphemeral(noise::SymmetricState &state, ByteView key)
    {
        state.mixHash(key);
        state.mixKey(key);
    }
    static void mix(noise::SymmetricState &state, const crypto::X25519KeyPair &own, ByteView key)
    {
        if (const auto shared = crypto::x25519(own.secret, asKey(key)))
            state.mixKey(shared->view());
    }

    const crypto::X25519KeyPair &m_station, &m_agent;
    ByteView m_first, m_answer;
};

} // namespace skyseal::test
