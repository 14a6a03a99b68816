// Puts messages of the channel on a link as the carrier of their path wants them: a datagram is the message, a serial line
// takes COBS, MAVLink routers and radios take TUNNEL. I/O thread; no I/O itself, and nothing is allocated.
#pragma once

#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

class CarrierWriter
{
public:
    /// As whom TUNNEL messages go out: a system and component that the other end and the routers between know us by. With
    /// system 0, which is nobody's, none goes out.
    void setNode(Node node);
    Node node() const { return m_node; }

    /// Calls `send(ByteView)` for each block that carries the message. False when it cannot travel so.
    template<typename Send> bool write(const Path &to, ByteView message, Send &&send)
    {
        switch (to.carrier) {
        case Carrier::Datagram: send(message); return true;
        case Carrier::Serial: {
            const std::size_t size = channel::writeCobs(message, m_buffer);
            if (size > 0)
                send(ByteView(m_buffer).first(size));
            return size > 0;
        }
        case Carrier::Tunnel:
            if (m_node.system == 0)
                return false;
            return channel::writeParts(message, ++m_set, [&](ByteView payload) { send(tunnel(to.node, payload)); });
        }
        return false;
    }

    /// A TUNNEL without a message, to everybody: routers learn from it where we are. Empty without a node.
    ByteView hello();
    /// A clear HEARTBEAT of an onboard computer, which tells radios that MAVLink is spoken here. Empty without a node.
    ByteView heartbeat();

private:
    ByteView tunnel(Node to, ByteView payload);

    Node m_node;
    mavlink::FrameWriter m_frames{0, 0};
    std::uint16_t m_set = 0;
    std::array<std::uint8_t, channel::kMaxCobs> m_buffer;
    static_assert(channel::kMaxCobs >= mavlink::kMaxFrameLength);
};

} // namespace skyseal::engine
