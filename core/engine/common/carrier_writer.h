// Encodes messages of the channel for the carrier of their path: the message itself in a datagram, COBS on a serial line,
// TUNNEL for MAVLink routers and radios (core/channel/PROTOCOL.md). I/O thread; no I/O itself, and nothing is allocated.
#pragma once

#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

class CarrierWriter
{
public:
    /// Sets the system and component from which TUNNEL messages are sent, by which routers and the other end identify this
    /// node. With system 0, which no node has, none is sent.
    void setNode(Node node);
    Node node() const { return m_node; }

    /// Calls `send(ByteView)` for each block that carries the message. Returns false if it does not fit the carrier.
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

    /// A broadcast TUNNEL without a message, from which routers learn the address of this node. Empty without a node.
    ByteView hello();
    /// A clear HEARTBEAT of an onboard computer, by which radios detect that the line carries MAVLink. Empty without a node.
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
