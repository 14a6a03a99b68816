#include "tests/engine/simulated_network.h"

#include "core/link/address_text.h"
#include "tests/fuzz/simulated_host.h"

#include <algorithm>
#include <cstdlib>

namespace skyseal::test {

namespace {

constexpr std::size_t kHeard = 256; ///< datagrams that an attacker remembers

std::unique_ptr<link::Link> makeEnd(const link::LinkUrl &url, LinkId id, link::LinkListener &listener,
                                    const link::LinkOptions &options);

const link::LinkType kTypes[] = {
    {"udpin", link::LinkTarget::HostPort, {.isListening = true}, "", "", makeEnd},
    {"udpout", link::LinkTarget::HostPort, {.hasOneRemote = true}, "", "", makeEnd},
};

} // namespace

class SimulatedLinkEnd final : public link::Link
{
public:
    SimulatedLinkEnd(const link::LinkUrl &url, LinkId id, link::LinkListener &listener, const link::LinkOptions &options)
        : Link(url, id, listener, options), m_host(network().m_host),
          m_named(SimulatedNetwork::address(url.host() + ':' + std::to_string(url.port())))
    {}
    ~SimulatedLinkEnd() override { leave(); }

    void open() override
    {
        m_local = traits().isListening ? m_named : newAddress();
        network().m_links[m_local] = this;
        setState(traits().isListening ? link::LinkState::Listening : link::LinkState::Connected);
    }
    void close() override
    {
        leave();
        setState(link::LinkState::Closed);
    }
    std::optional<Address> localEndpoint() const override { return m_local; }
    Address remote() const override { return traits().isListening ? Address{} : m_named; }
    void send(const Address &to, ByteView block) override
    {
        ++m_counters.txBlocks;
        m_counters.txBytes += block.size();
        const Address target = to == Address{} ? remote() : to;
        if (state() != link::LinkState::Closed && target != Address{})
            network().send(m_local, target, block);
    }
    void flush() override {}

    void arrive(const Address &from, MutableByteView bytes)
    {
        ++m_counters.rxBlocks;
        m_counters.rxBytes += bytes.size();
        const link::ReceivedBlock block{{id(), from}, bytes, SimulatedHost::instance().now()};
        listener().linkReceived(*this, {&block, 1});
    }
    /// Returns false for links that keep their address.
    bool move(const SimulatedNetwork::Ip &host)
    {
        if (traits().isListening || m_host != host || m_local.ip != host)
            return false;
        leave();
        m_local = newAddress();
        network().m_links[m_local] = this;
        return true;
    }

private:
    static SimulatedNetwork &network() { return SimulatedNetwork::instance(); }
    void leave()
    {
        if (const auto found = network().m_links.find(m_local); found != network().m_links.end() && found->second == this)
            network().m_links.erase(found);
    }
    Address newAddress()
    {
        Address out = m_named; // a cable leads to the same host
        if (m_named.ip[12] != 127)
            out.ip = m_host;
        out.port = network().m_nextPort++;
        if (network().m_nextPort > 60000)
            network().m_nextPort = 30000;
        return out;
    }

    const SimulatedNetwork::Ip m_host;
    const Address m_named; ///< by the URL
    Address m_local;
};

namespace {

std::unique_ptr<link::Link> makeEnd(const link::LinkUrl &url, LinkId id, link::LinkListener &listener,
                                    const link::LinkOptions &options)
{
    return std::make_unique<SimulatedLinkEnd>(url, id, listener, options);
}

} // namespace

SimulatedNetwork &SimulatedNetwork::instance()
{
    static SimulatedNetwork instance;
    return instance;
}

link::LinkUrl SimulatedNetwork::url(const std::string &text)
{
    const auto parsed = link::LinkUrl::parse(text, link::LinkUrl::kAnyHost, kTypes);
    if (!parsed)
        std::abort();
    return *parsed;
}

Address SimulatedNetwork::address(const std::string &text)
{
    const auto parsed = link::parseAddress(text);
    if (!parsed)
        std::abort();
    return *parsed;
}

bool SimulatedNetwork::isRadio(const Address &from, const Address &to)
{
    return from.ip[12] != 127 && to.ip[12] != 127;
}

void SimulatedNetwork::send(const Address &from, const Address &to, ByteView datagram)
{
    Datagram flying{from, to, Bytes(datagram.begin(), datagram.end())};
    if (!isRadio(from, to))
        return fly(Duration::zero(), std::move(flying));
    ++m_counters.sent;
    if (m_heard.size() < kHeard)
        m_heard.push_back(flying);
    else
        m_heard[m_nextHeard++ % kHeard] = flying;
    if (m_cut.contains(from.ip) || m_cut.contains(to.ip) || chance(radio.loss)) {
        ++m_counters.dropped;
        return;
    }
    if (chance(radio.corrupt))
        flying.bytes[m_dice() % flying.bytes.size()] ^= static_cast<std::uint8_t>(1 + m_dice() % 255);
    if (chance(radio.duplicate)) {
        ++m_counters.duplicated;
        fly(radio.delay + radio.reorderBy / 2, flying);
    }
    fly(chance(radio.reorder) ? radio.delay + radio.reorderBy : radio.delay, std::move(flying));
}

void SimulatedNetwork::fly(Duration delay, Datagram datagram)
{
    m_flying.emplace(SimulatedHost::instance().now() + delay, std::move(datagram));
}

void SimulatedNetwork::deliver()
{
    while (!m_flying.empty() && m_flying.begin()->first <= SimulatedHost::instance().now()) {
        Datagram datagram = std::move(m_flying.begin()->second);
        m_flying.erase(m_flying.begin());
        const bool isOnRadio = isRadio(datagram.from, datagram.to);
        const auto link = m_links.find(datagram.to);
        const auto socket = m_sockets.find(datagram.to);
        if (link != m_links.end())
            link->second->arrive(datagram.from, datagram.bytes);
        else if (socket != m_sockets.end())
            socket->second(datagram.from, datagram.bytes);
        m_counters.delivered += isOnRadio;
        m_counters.nobody += isOnRadio && link == m_links.end() && socket == m_sockets.end();
    }
}

std::size_t SimulatedNetwork::move(const std::string &ip)
{
    const Ip host = address(ip + ":1").ip;
    std::vector<SimulatedLinkEnd *> ends;
    for (const auto &[local, end] : m_links)
        ends.push_back(end);
    return static_cast<std::size_t>(std::ranges::count_if(ends, [&](SimulatedLinkEnd *end) { return end->move(host); }));
}

std::optional<SimulatedNetwork::Datagram> SimulatedNetwork::overheard()
{
    if (m_heard.empty())
        return {};
    return m_heard[m_dice() % m_heard.size()];
}

} // namespace skyseal::test
