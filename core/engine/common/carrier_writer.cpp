#include "core/engine/common/carrier_writer.h"

#include "core/mavlink/enums.h"

#include <algorithm>

namespace skyseal::engine {

void CarrierWriter::setNode(Node node)
{
    if (node == m_node)
        return;
    m_node = node;
    m_frames = mavlink::FrameWriter(node.system, node.component);
}

ByteView CarrierWriter::tunnel(Node to, ByteView payload)
{
    mavlink::Tunnel message;
    message.target_system = to.system;
    message.target_component = to.component;
    message.payload_type = channel::kTunnelPayloadType;
    message.payload_length = static_cast<std::uint8_t>(payload.size());
    std::copy(payload.begin(), payload.end(), message.payload.begin());
    if (channel::isPadded(payload))
        message.payload.back() = channel::kTunnelPadding;
    return m_frames.write(message, m_buffer);
}

ByteView CarrierWriter::hello()
{
    return m_node.system == 0 ? ByteView() : tunnel({}, {});
}

ByteView CarrierWriter::heartbeat()
{
    if (m_node.system == 0)
        return {};
    mavlink::Heartbeat message;
    message.type = mavlink::MAV_TYPE_ONBOARD_CONTROLLER;
    message.autopilot = mavlink::MAV_AUTOPILOT_INVALID;
    message.system_status = mavlink::MAV_STATE_ACTIVE;
    return m_frames.write(message, m_buffer);
}

} // namespace skyseal::engine
