// Two devices that pair, on one virtual clock and a simulated link, with scripted people.
#pragma once

#include "core/channel/pairing.h"
#include "core/channel/pairing_handshake.h"
#include "core/crypto/passphrase.h"
#include "pair.h"

namespace skyseal::test {

struct PairingSide
{
    std::shared_ptr<const crypto::X25519KeyPair> identity;
    PairingConfig config;
    std::optional<Pairing> pairing;
    std::vector<PairingEvent> events;
    std::uint64_t bytesOut = 0;

    template<typename E> std::vector<E> all() const
    {
        std::vector<E> out;
        for (const PairingEvent &event : events) {
            if (const E *e = std::get_if<E>(&event))
                out.push_back(*e);
        }
        return out;
    }
    bool sees(const channel::PublicKey &key) const { return pairing->peer() && pairing->peer()->key == key; }
    std::optional<PairingOver> over() const
    {
        const auto ends = all<PairingOver>();
        return ends.empty() ? std::nullopt : std::optional(ends.back());
    }
};

class PairingPair
{
public:
    explicit PairingPair(std::uint64_t seed = 1, WireModel model = {}) : link(model, seed ^ 0x5eed), m_random(seed)
    {
        for (const Side side : {Ground, Air}) {
            ends[side].identity = newIdentity(m_random);
            ends[side].config = configOf(side, ends[side].identity);
        }
    }

    static Path pathOf(Side side)
    {
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = static_cast<std::uint8_t>(side + 1);
        path.remote.port = static_cast<std::uint16_t>(side == Ground ? 14550 : 40000);
        return path;
    }
    static PairingConfig configOf(Side side, std::shared_ptr<const crypto::X25519KeyPair> identity)
    {
        PairingConfig config;
        config.role = side == Ground ? Role::Station : Role::Agent;
        config.identity = std::move(identity);
        config.name = side == Ground ? "tablet" : "scout-1";
        config.systemId = side == Ground ? 255 : 7;
        if (side == Air)
            config.callTo = {pathOf(Ground)};
        return config;
    }

    /// The agent only listens, and the station calls it.
    void letAirListen()
    {
        air().config.callTo.clear();
        air().config.listensOn = {pathOf(Ground).link};
        ground().config.callTo = {pathOf(Air)};
    }

    PairingSide &ground() { return ends[Ground]; }
    PairingSide &air() { return ends[Air]; }
    void open(Side side)
    {
        ends[side].pairing.emplace(ends[side].config, m_random, now);
        pump();
    }
    void openBoth()
    {
        open(Ground);
        open(Air);
    }
    bool shown() { return ground().sees(publicKeyOf(*air().identity)) && air().sees(publicKeyOf(*ground().identity)); }
    bool paired() { return !ground().all<Paired>().empty() && !air().all<Paired>().empty(); }
    void confirm(Side side)
    {
        ends[side].pairing->confirm(now, publicKeyOf(*ends[side == Ground ? Air : Ground].identity));
        pump();
    }

    void pump()
    {
        for (const Side side : {Ground, Air}) {
            PairingSide &end = ends[side];
            if (!end.pairing)
                continue;
            while (const auto out = end.pairing->pollTransmit()) {
                end.bytesOut += out->bytes.size();
                if (out->to == pathOf(side == Ground ? Air : Ground))
                    link.send(now, {side, out->to.remote.port, 0, Bytes(out->bytes.begin(), out->bytes.end())});
                else if (elsewhere)
                    elsewhere(side, *out);
            }
            while (auto event = end.pairing->pollEvent())
                end.events.push_back(std::move(*event));
        }
    }

    bool run(Duration span, const std::function<bool()> &until = {})
    {
        const TimePoint stop = now + span;
        pump();
        while (!(until && until())) {
            TimePoint due = link.next();
            for (const PairingSide &end : ends)
                due = end.pairing ? std::min(due, end.pairing->nextDeadline()) : due;
            if (due > stop) {
                now = stop;
                return false;
            }
            now = std::max(now, due);
            if (link.next() <= now) {
                const SentDatagram flight = link.take();
                if (auto &to = ends[flight.from == Ground ? Air : Ground].pairing)
                    to->handleDatagram(now, pathOf(flight.from), flight.bytes);
            }
            for (PairingSide &end : ends) {
                if (end.pairing && end.pairing->nextDeadline() <= now)
                    end.pairing->handleDeadline(now);
            }
            pump();
        }
        return true;
    }

    TimePoint now{std::chrono::hours(1)};
    SimulatedLink link;
    std::array<PairingSide, 2> ends;
    std::function<void(Side, const Transmit &)> elsewhere; ///< what goes to another address than the other end's

private:
    SeededRandom m_random;
};

/// Another device that hears the agent's calls, and the agent's newest message to it.
struct Stranger
{
    explicit Stranger(PairingPair &pair)
    {
        pair.link.attacker = [this](TimePoint, SentDatagram &flight) {
            if (const auto called = calledToken(flight.bytes))
                token = called;
            return true;
        };
        pair.elsewhere = [this](Side, const Transmit &out) { received.assign(out.bytes.begin(), out.bytes.end()); };
    }

    std::optional<PairingToken> token;
    Bytes received;
};

inline std::shared_ptr<const crypto::Passphrase> passphraseOf(std::string_view text)
{
    return std::make_shared<const crypto::Passphrase>(*crypto::Passphrase::fromBytes(asBytes(text)));
}

/// One end's handshake outside a Pairing.
inline PairingHandshake handshakeAs(Side side, std::shared_ptr<const crypto::X25519KeyPair> identity, PairingId id,
                                    const PairingToken &token, RandomSource &random,
                                    std::shared_ptr<const crypto::Passphrase> passphrase = {})
{
    auto config = PairingPair::configOf(side, std::move(identity));
    config.passphrase = std::move(passphrase);
    return PairingHandshake::begin(config, id, token, Carrier::Datagram, random);
}

} // namespace skyseal::test
