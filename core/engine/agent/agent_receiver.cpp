#include "core/engine/agent/agent_receiver.h"

#include "core/channel/endpoint.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/mavlink/dialect.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// Targets of clear frames: not on listening links, since clear frames prove no address.
std::vector<Path> clearPaths(const AgentConfig &config)
{
    std::vector<Path> out;
    for (std::size_t i = 0; i < config.grounds.size(); ++i) {
        if (!config.grounds[i].url.traits().isDatagramServer())
            out.push_back({groundLink(i), {}});
    }
    return out;
}

bool isTunnel(const GroundLink &ground)
{
    return ground.carrier == Carrier::Tunnel;
}

} // namespace

AgentReceiver::AgentReceiver(const Parts &parts) : m_parts(parts), m_clear(parts.links, clearPaths(parts.config)) {}

void AgentReceiver::addLinks()
{
    m_parts.ingress.addLink(kVehicleLink, {.isStream = m_parts.config.vehicle.traits().isStream}, m_vehicleSink);
    for (std::size_t i = 0; i < m_parts.config.grounds.size(); ++i)
        m_parts.ingress.addLink(groundLink(i), groundRules(m_parts.config.grounds[i]), *this);
}

void AgentReceiver::updateRules()
{
    for (std::size_t i = 0; i < m_parts.config.grounds.size(); ++i)
        m_parts.ingress.setRules(groundLink(i), groundRules(m_parts.config.grounds[i]));
}

void AgentReceiver::streamChanged(const Path &path)
{
    m_parts.ingress.forget(path);
    m_routes.streamChanged(path);
}

void AgentReceiver::sessionUp(const channel::SessionUp &up)
{
    m_gate.sessionUp(up);
    m_sessions.add(up.session);
    updateRules();
}

void AgentReceiver::sessionDown(channel::SessionId session)
{
    m_gate.sessionDown(session);
    m_sessions.remove(session);
    updateRules();
}

AgentCounters AgentReceiver::counters() const
{
    AgentCounters out = m_counters;
    out.groundIdRefused = m_groundIdClaims.count();
    m_gate.addTo(out);
    return out;
}

IngressRules AgentReceiver::groundRules(const GroundLink &ground) const
{
    const bool tunnel = isTunnel(ground);
    const bool cobs = ground.carrier == Carrier::Serial;
    IngressRules out;
    out.isStream = cobs || (tunnel && ground.url.traits().isStream);
    out.takesDatagrams = ground.carrier == Carrier::Datagram;
    out.sealed = true;
    out.takesCobs = cobs;
    out.takesTunnel = tunnel;
    // Anyone can send clear bytes, so they are searched only for useful frames: those that carry messages of the channel, those
    // sealed in place, and those of a station that does not seal, if they would be forwarded.
    const bool inPlace = out.takesDatagrams && m_parts.config.policy.allowInline;
    const bool searched = tunnel || inPlace || isPlain();
    out.clear = searched ? ClearScan::Always : ClearScan::Never;
    return out;
}

void AgentReceiver::takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item)
{
    if (mavlink::isDamagedFrame(item))
        m_parts.links.countBadFrame(from.link);
    if (!mavlink::isWholeFrame(item) || !takeSignature(now, from, item.bytes))
        return;
    if (item.frame) {
        m_parts.links.noteUse(from);
        if (VehicleRoutes::isVehicleHeartbeat(*item.frame) && !takeVehicleHeartbeat(now, from, *item.frame))
            return;
        m_fromVehicle.note({from.link, item.frame->systemId(), item.frame->componentId(), from.remote}, item.frame->sequence(),
                           now);
    }
    if (isPlain()) {
        m_clear.add(item.bytes);
    } else if (m_sessions.none()) {
        ++m_counters.undelivered;
    } else {
        ++m_counters.toGround;
        for (const channel::SessionId session : m_sessions.all())
            m_parts.channel.queue(now, session, item.bytes);
    }
}

/// Returns false for frames that are not the vehicle's according to their signature.
bool AgentReceiver::takeSignature(TimePoint now, const Path &from, ByteView frame)
{
    if (!m_parts.signing || m_parts.signing->accept(frame))
        return true;
    if (const ByteView request = m_parts.signing->catchUp(now, frame); !request.empty())
        m_parts.links.send(from, request);
    return false;
}

/// Returns false if the heartbeat must not reach the ground, where it would be shown as a vehicle.
bool AgentReceiver::takeVehicleHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &heartbeat)
{
    const std::uint8_t systemId = heartbeat.systemId();
    if (m_gate.isGroundSystem(systemId)) {
        m_routes.forget(systemId);
        if (m_groundIdClaims.note(now, systemId))
            m_parts.events.publish(now, GroundIdClaimed{systemId});
        return false;
    }
    m_routes.heard(now, from, systemId);
    m_parts.links.noteRemote(from.link, from.remote);
    if (m_armed.note(heartbeat) && m_parts.pairing.isOpen()) // a pairing must not be possible in flight
        m_parts.pairing.cancel(now, channel::PairingEnd::Armed);
    if (std::ranges::any_of(m_parts.config.grounds, isTunnel))
        m_parts.node.setSystem(now, systemId, m_parts.links.carriers());
    return true;
}

bool AgentReceiver::takePairing(const link::Link &, const link::ReceivedBlock &message)
{
    if (!m_parts.pairing.take(message.time, message.path, message.bytes))
        return false;
    m_parts.links.noteRemote(message.path.link, message.path.remote);
    return true;
}

bool AgentReceiver::namesSession(ByteView message) const
{
    return m_parts.channel.endpoint().namesSerialSession(message);
}

bool AgentReceiver::takeRecord(const link::Link &, const link::ReceivedBlock &message)
{
    const auto delivery = m_parts.channel.receive(message.time, message.path, message.bytes);
    if (delivery)
        takeDelivery(message, *delivery);
    return delivery.has_value();
}

void AgentReceiver::takeSealedInPlace(const link::Link &, const link::ReceivedBlock &frame)
{
    if (const auto delivery = m_parts.channel.receiveInline(frame.time, frame.path, frame.bytes))
        takeDelivery(frame, *delivery);
}

void AgentReceiver::takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery)
{
    // The start of a session is handled before its first frame; its end, when a goodbye overtook a record, after the record.
    m_parts.handler.handleEvents(delivery.session);
    std::uint64_t frames = 0;
    mavlink::scanFrames(delivery.frames, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
        if (!mavlink::isWholeFrame(item))
            return;
        ++frames;
        if (item.frame) {
            const auto counts = m_sessions.note(block.time, delivery.session, *item.frame);
            m_parts.channel.endpoint().noteFrames(delivery.session, counts);
        }
        if (m_gate.accept(block.time, delivery, item, [this](std::uint8_t systemId) { return m_routes.isVehicle(systemId); }))
            signToVehicle(item, m_gate.mayCommand(delivery.session));
    });
    m_parts.channel.costs().countFrames(delivery.session, frames);
    m_parts.links.noteRemote(block.path.link, block.path.remote);
    m_parts.links.noteUse(block.path);
}

void AgentReceiver::takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item)
{
    if (!mavlink::isWholeFrame(item))
        return;
    // Never with a signing key: the agent would sign for everybody on the ground side.
    if (isPlain() && !m_parts.signing) {
        m_parts.links.noteUse(block.path);
        signToVehicle(item, true);
    } else {
        ++m_counters.clearRefused;
    }
}

void AgentReceiver::takeUnusable(const link::Link &link, Unusable what)
{
    if (what == Unusable::Clear) {
        ++m_counters.clearRefused;
        return;
    }
    // Behind a router, the datagrams are those of the router, not of the station.
    const GroundLink &ground = m_parts.config.grounds[groundIndex(link.id())];
    m_counters.unusable += what == Unusable::Message || ground.carrier == Carrier::Datagram;
}

void AgentReceiver::signToVehicle(const mavlink::ScanItem &item, bool mayCommand)
{
    if (!m_parts.signing)
        sendToVehicle(item, item.bytes);
    else if (const ByteView frame = m_parts.signing->sign(item.bytes, mayCommand); !frame.empty())
        sendToVehicle(item, frame);
}

void AgentReceiver::sendToVehicle(const mavlink::ScanItem &item, ByteView bytes)
{
    const std::uint8_t target = item.frame ? item.frame->targetSystem() : std::uint8_t(0);
    if (m_routes.forEachPathTo(target, [&](const Path &path) { m_parts.links.send(path, bytes); }))
        ++m_counters.toVehicle;
    else
        ++m_counters.undelivered;
}

} // namespace skyseal::engine
