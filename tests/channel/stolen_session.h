// A session in epoch 0 whose secrets are known to a thief: computed from the handshake's bytes, both static keys and the seed
// of the random source that made the ephemeral ones. The same secrets are in the memory of each end.
#pragma once

#include "pair.h"
#include "reconstruction.h"
#include "tap.h"

#include "core/channel/control.h"
#include "core/channel/record.h"
#include "core/crypto/record_cipher.h"

#include <cstdlib>

namespace skyseal::test {

/// The key pair of a public key, whose secret is among all runs of 32 bytes of a stream.
inline crypto::X25519KeyPair keyPairIn(ByteView stream, const crypto::PublicKey &wanted)
{
    for (std::size_t at = 0; at + 32 <= stream.size(); ++at) {
        auto pair = crypto::X25519KeyPair::fromSecret(Key32(stream.subspan(at).first<32>()));
        if (pair.publicKey == wanted)
            return pair;
    }
    std::abort();
}

class StolenSession
{
public:
    /// `tap` has seen the handshake of `pair`, whose seed is `seed` and which uses datagrams.
    StolenSession(const Pair &pair, const Tap &tap, std::uint64_t seed, crypto::SuiteId suite)
        : m_suite(suite), m_stream(4096), m_session(reveal(pair, tap, seed, m_stream)), m_epoch(m_session.epochZero(suite))
    {
        for (const SentDatagram &flight : tap.ofKind(0x50)) {
            if (flight.from == Ground)
                m_agents = static_cast<ConnectionId>(flight.bytes[1] | flight.bytes[2] << 8);
            else
                m_stations = static_cast<ConnectionId>(flight.bytes[1] | flight.bytes[2] << 8);
        }
    }

    const RevealedSession &revealed() const { return m_session; }
    const EpochSecrets &epoch() const { return m_epoch; }
    /// The secret of a public key that the random source of the pair made.
    crypto::X25519KeyPair keyPairOf(const crypto::PublicKey &key) const { return keyPairIn(m_stream, key); }

    /// The plaintext of a record under these secrets; nullopt if it does not open.
    std::optional<Bytes> open(const SentDatagram &flight, const EpochSecrets &secrets) const
    {
        Bytes bytes = flight.bytes;
        const auto header = RecordHeader::read(bytes);
        if (!header)
            return std::nullopt;
        const bool station = flight.from == Ground;
        const auto cipher = crypto::makeRecordCipher(m_suite,
                                                     (station ? secrets.fromInitiator : secrets.fromResponder).clone());
        const AssociatedData associated(*header, m_suite, direction(flight.from), Carrier::Datagram);
        const auto plain = cipher->open(header->counter, associated.view(), MutableByteView(bytes).subspan(header->length()));
        return plain ? std::optional(Bytes(plain->begin(), plain->end())) : std::nullopt;
    }
    /// The newest control message of a type among records of epoch 0.
    template<typename Message> std::optional<Message> newest(const std::vector<SentDatagram> &flights) const
    {
        std::optional<Message> out;
        for (const SentDatagram &flight : flights) {
            const auto plain = open(flight, m_epoch);
            const auto message = plain && isControl(*plain) ? readControl(*plain) : std::nullopt;
            if (message && std::holds_alternative<Message>(*message))
                out = std::get<Message>(*message);
        }
        return out;
    }
    /// A control message in a record of epoch 0, as `from` would seal it.
    Bytes seal(Side from, std::uint32_t counter, const ControlMessage &message) const
    {
        Bytes plain(kMaxControl);
        plain.resize(writeControl(message, plain));
        const auto cipher = crypto::makeRecordCipher(m_suite,
                                                     (from == Ground ? m_epoch.fromInitiator : m_epoch.fromResponder).clone());
        const RecordHeader header{DatagramKind::Record, 0, from == Ground ? m_agents : m_stations, counter};
        Bytes out(header.length() + cipher->sealedSize(plain.size()));
        header.write(out);
        const AssociatedData associated(header, m_suite, direction(from), Carrier::Datagram);
        out.resize(header.length()
                   + cipher->seal(counter, associated.view(), plain, MutableByteView(out).subspan(header.length())));
        return out;
    }

private:
    static Direction direction(Side from) { return from == Ground ? Direction::FromInitiator : Direction::FromResponder; }

    static RevealedSession reveal(const Pair &pair, const Tap &tap, std::uint64_t seed, Bytes &stream)
    {
        SeededRandom(seed).fill(stream);
        const Bytes first = tap.ofKind(0x59).at(0).bytes, answer = tap.ofKind(0x5a).at(0).bytes;
        const auto stations = keyPairIn(stream, Reconstruction::asKey(ByteView(first).subspan(1, 32)));
        const auto shared = crypto::x25519(stations.secret, Reconstruction::asKey(ByteView(answer).subspan(3, 32)));
        auto session =
            Reconstruction(*pair.ends[Ground].identity, *pair.ends[Air].identity, first, answer).withGuess(shared->clone());
        if (!session)
            std::abort();
        return std::move(*session);
    }

    crypto::SuiteId m_suite;
    Bytes m_stream;
    RevealedSession m_session;
    EpochSecrets m_epoch;
    ConnectionId m_agents{}, m_stations{};
};

} // namespace skyseal::test
