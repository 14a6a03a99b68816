#include "app/sim/sim_link.h"

namespace skyseal::app {

namespace {
constexpr Duration kForget = std::chrono::seconds(30);
constexpr std::size_t kMostPeers = 16;
} // namespace

SimLink::SimLink(const link::LinkUrl &url, LinkId id, Receive receive, const link::LinkOptions &options)
    : m_link(link::makeLink(url, id, *this, options)), m_receive(std::move(receive))
{}

void SimLink::send(TimePoint now, ByteView frame)
{
    if (!m_link->traits().isDatagramServer()) {
        m_link->send(Address{}, frame);
        return;
    }
    for (auto peer = m_peers.begin(); peer != m_peers.end();) {
        if (now - peer->second > kForget) {
            peer = m_peers.erase(peer);
            continue;
        }
        m_link->send(peer->first, frame);
        ++peer;
    }
}

void SimLink::remember(TimePoint now, const Address &address)
{
    const auto known = m_peers.find(address);
    if (known != m_peers.end())
        known->second = now;
    else if (m_peers.size() < kMostPeers)
        m_peers.emplace(address, now);
}

void SimLink::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    for (const link::ReceivedBlock &block : blocks) {
        const auto deliver = [&](const mavlink::ScanItem &item) {
            if (!item.frame)
                return;
            link.noteUse(block.path.remote);
            if (!link.isStream())
                remember(block.time, block.path.remote);
            m_receive(block.time, *item.frame);
        };
        if (link.isStream())
            m_intake.takeStream(block.path, block.bytes, deliver);
        else
            m_intake.takeDatagram(block.time, block.path, block.bytes, deliver);
    }
}

void SimLink::linkPeerLeft(link::Link &, const Path &path)
{
    m_intake.forget(path);
}

} // namespace skyseal::app
