// The other end of an engine that is fuzzed, and the attacker on its paths. An endpoint, and a pairing if one is open, whose
// blocks wait in a queue: steps of the input hold, reorder, withhold, repeat, change or cut them before they reach the engine.
#pragma once

#include "core/base/byte_reader.h"
#include "core/channel/pairing.h"
#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/carrier_writer.h"
#include "tests/channel/pair.h"
#include "tests/fuzz/oracle.h"

#include <deque>
#include <optional>
#include <vector>

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::test {

/// 10.0.0.1 and so on.
Address addressOf(std::size_t number);
/// One of three passphrases, or none, as the two low bits of `choice` say.
std::shared_ptr<const crypto::Passphrase> passphraseOf(std::uint8_t choice);

/// The policy of one end, from the low bits of a byte of the input: bit 0 prefers frames
/// sealed in place, and the suites that have them; bit 1 forbids them; bit 2 forbids research suites.
Policy policyOf(std::uint8_t choice);

class RemoteEnd
{
public:
    struct Block
    {
        Bytes bytes;
        std::optional<std::size_t> closes; ///< it carries a Close: the mark passed to close()
        LinkId link{};                     ///< of the engine, at which it arrives
    };
    /// A link of the engine that this end can reach.
    struct Way
    {
        Path engine;        ///< where this end finds the engine, and in which carrier
        bool calls = false; ///< an agent announces itself there, a station calls; otherwise this end listens
    };

    /// `node`: its ids in TUNNEL.
    RemoteEnd(Config config, std::vector<Way> ways, Node node, std::uint64_t seed, TimePoint now);
    ~RemoteEnd();

    Endpoint &endpoint() { return *m_endpoint; }
    const std::vector<Way> &ways() const { return m_ways; }
    bool hasSession() const;

    /// Seals frames and queues them, a single one in place if the session's framing says so and `inRecord` is false. Returns
    /// false without a session.
    bool send(TimePoint now, const Bytes &frames, bool inRecord);
    void switchSuite(TimePoint now, std::uint8_t choice);
    /// Ends its session; the Close is queued as a block of its own, with this mark.
    void close(TimePoint now, std::size_t mark);
    /// Opens a window, with passphraseOf(passphrase).
    void openPairing(TimePoint now, std::string name, std::uint8_t systemId, std::uint8_t passphrase);
    /// The person at this end confirms the engine, if it is shown. Returns true if so.
    bool confirmPairing(TimePoint now);
    void cancelPairing(TimePoint now);
    /// The stream to this link of the engine began anew.
    void reconnect(TimePoint now, LinkId link);
    /// A station calls where it may, or not at all.
    void setCalling(TimePoint now, bool calling);

    void handleDeadline(TimePoint now);
    /// A block from this link of the engine; ignored where this end cannot reach it.
    void receive(TimePoint now, LinkId link, ByteView block);
    /// Moves the output of the endpoint and the pairing to the queue. The session follows the key of a pairing that succeeded.
    void poll(TimePoint now);

    // the attacker
    /// `how`, bit 0: hold all blocks from now on; bit 1: reverse those that are held; bit 2: drop them.
    void hold(std::uint8_t how);
    /// Takes the newest block that is held off the path.
    void withholdNewest();
    /// The next block on its way to the engine; nullopt if there is none, or all are held.
    std::optional<Block> next();
    /// A block that arrived or was withheld: `choice` 0 is the newest.
    std::optional<Block> repeat(std::uint8_t choice) const;
    /// The newest one, with a byte changed, or cut to a length.
    std::optional<Block> changed(std::uint8_t at, std::uint8_t by) const;
    std::optional<Block> cut(std::uint8_t length) const;

private:
    std::vector<Path> called() const;
    void transmit(const Path &to, ByteView message, std::optional<std::size_t> closes = {});
    void handleMessage(TimePoint now, const link::ReceivedBlock &message);
    void keep(Block block);

    SeededRandom m_random;
    MemoryCounterStore m_counters;
    Config m_config;
    std::vector<Way> m_ways;
    std::unique_ptr<Endpoint> m_endpoint;
    std::optional<Pairing> m_pairing;
    std::optional<channel::PublicKey> m_shown; ///< by the pairing
    engine::CarrierReader m_reader;
    engine::CarrierWriter m_writer;
    bool m_isHeld = false;
    std::deque<Block> m_queue;   ///< on their way
    std::deque<Block> m_history; ///< the newest ones that arrived or were withheld
};

} // namespace skyseal::test
