// Datagrams between whole engines on the clock of SimulatedHost. Each link has an address of its own; a radio loses, repeats,
// reorders, damages and delays, a cable (127.0.0.1) does not. Tests have sockets as well, and are the attacker.
#pragma once

#include "core/link/link.h"

#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace skyseal::test {

class SimulatedLinkEnd;

class SimulatedNetwork
{
public:
    using Handler = std::function<void(const Address &from, ByteView datagram)>;

    /// Of the datagrams between hosts.
    struct Radio
    {
        double loss = 0, duplicate = 0, corrupt = 0, reorder = 0; ///< shares of all datagrams
        Duration delay = std::chrono::milliseconds(1);
        Duration reorderBy = std::chrono::milliseconds(60);
    };
    struct Counters
    {
        std::uint64_t sent = 0, dropped = 0, duplicated = 0, delivered = 0,
                      nobody = 0; ///< on the radio; nobody: no such address
    };

    static SimulatedNetwork &instance();

    Radio radio;

    /// "udpin:10.0.0.1:14550" or "udpout:10.0.0.1:14550", with a simulated link.
    static link::LinkUrl url(const std::string &text);
    static Address address(const std::string &text);

    /// The host of links that are opened from now on: the address of a udpout link that leads to another host.
    void setHost(const std::string &ip) { m_host = address(ip + ":1").ip; }
    /// A socket of the test.
    void bind(const Address &address, Handler handler) { m_sockets[address] = std::move(handler); }
    void send(const Address &from, const Address &to, ByteView datagram);
    /// Delivers all that is due.
    void deliver();
    bool isQuiet() const { return m_flying.empty(); }

    /// The radio of a host fails, or works again.
    void cut(const std::string &ip) { m_cut.insert(address(ip + ":1").ip); }
    void restore() { m_cut.clear(); }
    /// The udpout links of a host get new ports, as behind a router that has forgotten them. Returns their number.
    std::size_t move(const std::string &ip);
    /// A datagram that was sent on the radio a while ago, for an attacker; nullopt before the first one.
    struct Datagram
    {
        Address from, to;
        Bytes bytes;
    };
    std::optional<Datagram> overheard();
    std::uint32_t dice() { return m_dice(); }
    bool chance(double share) { return std::uniform_real_distribution<>()(m_dice) < share; }
    const Counters &counters() const { return m_counters; }

private:
    friend class SimulatedLinkEnd;

    using Ip = std::array<std::uint8_t, 16>;
    static bool isRadio(const Address &from, const Address &to);
    void fly(Duration delay, Datagram datagram);

    Ip m_host{};
    std::uint16_t m_nextPort = 30000;
    std::map<Address, Handler> m_sockets;
    std::map<Address, SimulatedLinkEnd *> m_links;
    std::multimap<TimePoint, Datagram> m_flying;
    std::set<Ip> m_cut;
    std::vector<Datagram> m_heard;
    std::size_t m_nextHeard = 0;
    Counters m_counters;
    std::mt19937 m_dice{24};
};

} // namespace skyseal::test
