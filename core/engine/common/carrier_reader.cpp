#include "core/engine/common/carrier_reader.h"

#include "core/channel/handshake_messages.h"
#include "core/channel/pairing_messages.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

namespace {

Path tunnelPath(const Path &from, const mavlink::Frame &frame)
{
    return {from.link, from.remote, Carrier::Tunnel, {frame.systemId(), frame.componentId()}};
}

} // namespace

bool CarrierReader::isCobs(const Path &stream, TimePoint now) const
{
    const auto found = m_lines.find(stream);
    return found != m_lines.end() && isRecent(found->second->proven, now);
}

void CarrierReader::noteMavlink(const Path &stream)
{
    if (const auto found = m_lines.find(stream); found != m_lines.end())
        found->second->speaksMavlink = true;
}

bool CarrierReader::speaksMavlink(const Path &stream) const
{
    const auto found = m_lines.find(stream);
    return found != m_lines.end() && found->second->speaksMavlink;
}

bool CarrierReader::opensConversation(ByteView message)
{
    using namespace channel;
    switch (kindOf(message[0])) {
    case DatagramKind::Handshake:
    case DatagramKind::Pairing: break;
    default: return false;
    }
    for (const std::size_t length : {kFirstLength, kAnswerLength, kNumberLength, kPairingAnswerLength, kOpeningLength}) {
        if (message.size() == length && versionOf(message[0]) == kProtocolVersion)
            return true;
    }
    return false;
}

bool CarrierReader::isTunnel(const mavlink::ScanItem &item)
{
    constexpr std::size_t kTypeEnd = 2;
    if (!item.frame || item.frame->messageId() != mavlink::Tunnel::kId)
        return false;
    const ByteView payload = item.frame->payload();
    return payload.size() >= kTypeEnd && (payload[0] | payload[1] << 8) == channel::kTunnelPayloadType;
}

std::optional<link::ReceivedBlock> CarrierReader::takeTunnel(TimePoint now, const Path &from, const mavlink::Frame &frame,
                                                             Node ours)
{
    const mavlink::Tunnel message = mavlink::Tunnel::decode(frame.payload());
    const bool forUs = (message.target_system == 0 || message.target_system == ours.system)
        && (message.target_component == 0 || message.target_component == ours.component);
    if (!forUs || message.payload_length > message.payload.size())
        return std::nullopt;
    const ByteView payload = ByteView(message.payload).first(message.payload_length);
    if (channel::isPadded(payload) && message.payload.back() == 0)
        return std::nullopt; // shorter on the wire than its answer
    const Path path = tunnelPath(from, frame);
    const auto bytes = m_tunnels.take(now, path, payload);
    if (!bytes)
        return std::nullopt;
    if (m_nodes.size() >= kMostNodes && !m_nodes.contains(path))
        m_nodes.erase(m_nodes.begin());
    m_nodes.insert(path);
    return link::ReceivedBlock{path, *bytes, now};
}

bool CarrierReader::isAgentsHeartbeat(const Path &from, const mavlink::Frame &frame) const
{
    if (frame.messageId() != mavlink::Heartbeat::kId || !m_nodes.contains(tunnelPath(from, frame)))
        return false;
    return mavlink::Heartbeat::decode(frame.payload()).autopilot == mavlink::MAV_AUTOPILOT_INVALID;
}

} // namespace skyseal::engine
