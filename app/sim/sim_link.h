// One link of the simulator and the stations that spoke on it: parses what arrives, and sends to whoever is to hear it.
// Lives on the main thread, as everything in this program.
#pragma once

#include "core/link/make_link.h"
#include "core/mavlink/stream_parser.h"

#include <functional>
#include <map>

namespace skyseal::app {

class SimLink : private link::LinkListener
{
public:
    using Receive = std::function<void(TimePoint, const mavlink::Frame &)>;

    /// `receive` is called for every valid frame, from inside the event loop.
    SimLink(const link::LinkUrl &url, LinkId id, Receive receive);

    link::Link &link() { return *m_link; }
    void open() { m_link->open(); }
    /// To everybody who is to hear it: the fixed peer, every client, or whoever spoke within the last half minute.
    void send(TimePoint now, ByteView frame);
    void flush() { m_link->flush(); }

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void remember(TimePoint now, const Address &address);

    std::unique_ptr<link::Link> m_link;
    Receive m_receive;
    std::map<Path, mavlink::StreamParser> m_streams;
    std::map<Address, TimePoint> m_peers; ///< of udpin: when each last sent a valid frame
};

} // namespace skyseal::app
