// One link of the simulator and the stations on it: parses received frames, and sends frames to every station. Lives on the
// main thread.
#pragma once

#include "core/link/make_link.h"
#include "core/mavlink/frame_intake.h"

#include <functional>
#include <map>

namespace skyseal::app {

class SimLink : private link::LinkListener
{
public:
    using Receive = std::function<void(TimePoint, const mavlink::Frame &)>;

    /// `receive` is called for every valid frame, from inside the event loop.
    SimLink(const link::LinkUrl &url, LinkId id, Receive receive, const link::LinkOptions &options = {});

    link::Link &link() { return *m_link; }
    void open() { m_link->open(); }
    /// Sends to the fixed peer, to every client, or (udpin) to every address heard within the last 30 s.
    void send(TimePoint now, ByteView frame);
    void flush() { m_link->flush(); }

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void remember(TimePoint now, const Address &address);

    std::unique_ptr<link::Link> m_link;
    Receive m_receive;
    mavlink::FrameIntake m_intake{mavlink::Dialect::builtin()};
    std::map<Address, TimePoint> m_peers; ///< of udpin: the time of the last valid frame of each
};

} // namespace skyseal::app
