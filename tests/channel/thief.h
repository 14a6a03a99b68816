// An attacker who stole the agent's private key and knows the public keys forges a first message of the station: Noise's "ss"
// can be computed from either end's private key. To continue from the answer he also needs "se", for which the test supplies
// guesses.
#pragma once

#include "reconstruction.h"

namespace skyseal::test {

class Thief
{
public:
    Thief(crypto::X25519KeyPair agent, const crypto::PublicKey &station, const channel::FirstPayload &payload,
          RandomSource &random)
        : m_agent(std::move(agent)), m_station(station), m_ephemeral(crypto::X25519KeyPair::generate(random))
    {
        m_state.mixHash(asBytes(kPrologueText));
        m_state.mixHash(m_agent.publicKey);
        const MutableByteView out(m_message);
        out[0] = channel::firstByte(channel::HandshakeMessage::First);
        std::copy(m_ephemeral.publicKey.begin(), m_ephemeral.publicKey.end(), out.begin() + 1);
        m_state.mixHash(m_ephemeral.publicKey);
        m_state.mixKey(m_ephemeral.publicKey);
        m_state.mixKey(crypto::x25519(m_ephemeral.secret, m_agent.publicKey)->view());
        const auto named = m_state.encryptAndHash(m_station, out.subspan(33, 48));
        m_state.mixKey(crypto::x25519(m_agent.secret, m_station)->view());
        const auto said = m_state.encryptAndHash(payload.write(), out.subspan(81, 30));
        if (named && said)
            channel::Mac1(m_agent.publicKey).sign(out);
    }

    const channel::FirstMessage &message() const { return m_message; }

    /// All guesses: the shared secrets of the stolen keys with the public keys of this handshake, none, and zeros.
    std::vector<std::optional<Key32>> guesses(ByteView answer) const
    {
        std::vector<std::optional<Key32>> out;
        out.emplace_back(std::nullopt);
        out.emplace_back(Key32());
        for (const crypto::X25519KeyPair *own : {&m_agent, &m_ephemeral}) {
            for (const crypto::PublicKey &other : {ephemeralOf(answer), m_station, m_agent.publicKey, m_ephemeral.publicKey})
                out.emplace_back(crypto::x25519(own->secret, other));
        }
        return out;
    }
    static crypto::PublicKey ephemeralOf(ByteView answer) { return Reconstruction::asKey(answer.subspan(3, 32)); }

    struct Guessed
    {
        std::optional<channel::AnswerPayload> read; ///< nullopt if the answer does not open
        RevealedSession session;
    };
    Guessed withGuess(ByteView answer, const std::optional<Key32> &se) const
    {
        noise::SymmetricState state = m_state.clone();
        const auto re = ephemeralOf(answer);
        state.mixHash(re);
        state.mixKey(re);
        state.mixKey(crypto::x25519(m_ephemeral.secret, re)->view());
        if (se)
            state.mixKey(se->view());
        state.mixKeyAndHash(Key32().view());
        constexpr std::size_t kSealed = channel::AnswerPayload::kLength + 16;
        std::array<std::uint8_t, channel::AnswerPayload::kLength> plain;
        const bool opened = state.decryptAndHash(answer.subspan(35, kSealed), plain).has_value();
        if (!opened)
            state.mixHash(answer.subspan(35, kSealed)); // as the agent does
        auto [initiators, responders] = state.split();
        return {opened ? channel::AnswerPayload::read(plain) : std::nullopt,
                {std::move(initiators), std::move(responders), state.handshakeHash()}};
    }

private:
    crypto::X25519KeyPair m_agent;
    crypto::PublicKey m_station;
    crypto::X25519KeyPair m_ephemeral;
    noise::SymmetricState m_state;
    channel::FirstMessage m_message{};
};

} // namespace skyseal::test
