// The wire between an agent and a station of 127.0.0.1, with a stranger on it: forwards both ways, keeps the newest record in
// each direction, and sends a flood of the stranger's messages to one end. A thread of its own; no event loop. Linux.
#pragma once

#include "core/base/bytes.h"
#include "core/base/path.h"
#include "core/channel/pairing_messages.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace skyseal::test {

/// A message of the channel as it is on the wire in this carrier. In Carrier::Tunnel it is cut to 128 bytes.
Bytes onTheWire(Carrier carrier, ByteView message);

class StrangerWire
{
public:
    enum class Target { Agent, Station };

    /// UDP for datagrams and TUNNEL, TCP for the serial carrier. `stationPort`: where the station listens.
    StrangerWire(Carrier carrier, Target target, std::uint16_t stationPort);
    ~StrangerWire();

    /// The port that the agent takes for the station.
    std::uint16_t port() const;
    /// The newest record on its way to the target; empty before.
    Bytes record() const;
    /// Of the newest call of the agent, whose pairing window is open; nullopt before.
    std::optional<channel::PairingToken> token() const;

    /// Sends all of `messages`, which are as on the wire, each second, again and again; empty = none.
    void flood(std::shared_ptr<const std::vector<Bytes>> messages);
    /// Messages of floods sent so far.
    std::uint64_t sent() const { return m_sent; }

private:
    class Ends;
    void run();
    void note(bool isFromAgent, ByteView message);
    bool inject();

    const Target m_target;
    std::unique_ptr<Ends> m_ends;
    mutable std::mutex m_mutex; ///< of the next three
    std::shared_ptr<const std::vector<Bytes>> m_messages;
    Bytes m_record;
    std::optional<channel::PairingToken> m_token;
    std::size_t m_next = 0;
    std::atomic<std::uint64_t> m_sent{0};
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

} // namespace skyseal::test
