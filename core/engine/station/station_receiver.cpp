#include "core/engine/station/station_receiver.h"

#include "core/channel/endpoint.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/gateway/late_answers.h"
#include "core/engine/station/recording_link_events.h"
#include "core/link/address_text.h"
#include "core/link/steady_now.h"
#include "core/mavlink/autopilot_heartbeat.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

IngressRules StationReceiver::rulesFor(const link::LinkTraits &traits) const
{
    const bool sealing = isSealing() && !traits.isRecording;
    IngressRules out;
    out.isStream = traits.isStream;
    out.takesDatagrams = !traits.isStream;
    out.sealed = sealing;
    out.takesCobs = traits.isStream && sealing;
    out.takesTunnel = sealing;
    out.dropsNodeHeartbeats = true;
    out.clear = ClearScan::UnlessCobs;
    return out;
}

IngressSink &StationReceiver::sinkFor(const link::LinkTraits &traits)
{
    if (traits.isRecording)
        return m_recordings;
    return m_bare ? static_cast<IngressSink &>(*m_bare) : *this;
}

void StationReceiver::addLink(LinkId id, const link::LinkTraits &traits)
{
    m_parts.ingress.addLink(id, rulesFor(traits), sinkFor(traits));
}

void StationReceiver::setBareCipher(std::optional<crypto::MavsecCipher> &&cipher)
{
    m_bare.reset();
    if (cipher)
        m_bare.emplace(MavsecStream(std::move(*cipher), mavlink::Dialect::builtin()), static_cast<IngressSink &>(*this),
                       m_datagrams.unreadable);
    m_parts.links.forEach([this](const link::Link &link) {
        if (!m_mavsec.contains(link.id()))
            m_parts.ingress.setSink(link.id(), sinkFor(link.traits()));
    });
}

void StationReceiver::addMavsecLink(LinkId id, const link::LinkTraits &traits, crypto::MavsecCipher cipher)
{
    const auto deliver = [this](const link::ReceivedBlock &block, const mavlink::Frame &frame) {
        takeClearFrame(block.time, block.path, frame, FrameOrigin::ListenOnly);
    };
    MavsecStream stream(std::move(cipher), mavlink::Dialect::builtin());
    MavsecSink &sink = m_mavsec.try_emplace(id, std::move(stream), static_cast<IngressSink &>(*this), deliver).first->second;
    m_parts.ingress.addLink(id, {.isStream = traits.isStream}, sink);
}

void StationReceiver::removeLink(LinkId id)
{
    m_parts.ingress.removeLink(id);
    m_mavsec.erase(id);
}

void StationReceiver::updateRules()
{
    m_parts.links.forEach([this](const link::Link &link) {
        if (!m_mavsec.contains(link.id()))
            m_parts.ingress.setRules(link.id(), rulesFor(link.traits()));
    });
}

bool StationReceiver::takePairing(const link::Link &, const link::ReceivedBlock &message)
{
    return m_channel && m_channel->pairing.take(message.time, message.path, message.bytes);
}

bool StationReceiver::namesSession(ByteView message) const
{
    return isSealing() && m_channel->driver.endpoint().namesSerialSession(message);
}

bool StationReceiver::takeRecord(const link::Link &link, const link::ReceivedBlock &message)
{
    if (message.path.carrier == Carrier::Tunnel)
        m_callPlaces.noteMavlink(link, message.path, message.time);
    if (!isSealing()) {
        m_datagrams.waitingBytes += message.bytes.size();
        ++m_datagrams.waitingCount;
        m_datagrams.garbage += !channel::Endpoint::isAnnouncement(message.bytes); // every agent announces itself
        if (m_channel)
            m_channel->goodbyes.recordArrived(message.time, message.path,
                                              [this](const Path &to, ByteView bytes) { m_parts.links.send(to, bytes); });
        return false;
    }
    const auto delivery = m_channel->driver.receive(message.time, message.path, message.bytes);
    if (delivery) {
        m_callPlaces.noteSession(link, message.path);
        takeDelivery(message, *delivery);
    }
    return delivery.has_value();
}

void StationReceiver::takeSealedInPlace(const link::Link &, const link::ReceivedBlock &frame)
{
    if (!isSealing())
        return;
    if (const auto delivery = m_channel->driver.receiveInline(frame.time, frame.path, frame.bytes))
        takeDelivery(frame, *delivery);
}

void StationReceiver::takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery)
{
    // The rights of a session must be known from its first frame until its last one was judged, which a goodbye may have
    // overtaken.
    m_parts.events.handleEvents(block.time, delivery.session);
    std::uint64_t frames = 0;
    mavlink::scanFrames(delivery.frames, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
        if (!item.frame) {
            if (mavlink::isDamagedFrame(item))
                m_parts.links.countBadFrame(block.path.link);
            else if (mavlink::isWholeFrame(item))
                takeUnknownMessage(delivery, item.bytes);
            return;
        }
        ++frames;
        if (!m_gate.acceptSealed(delivery.session, item.frame->systemId()))
            refuseFrame(block, *item.frame, delivery.session);
        else if (m_gate.isPresent(*item.frame, delivery))
            acceptFrame(block.time, block.path, *item.frame, FrameOrigin::Live, delivery.session);
        else
            acceptLateFrame(block.time, block.path, *item.frame, delivery.freshness);
    });
    m_channel->driver.costs().countFrames(delivery.session, frames);
    m_parts.links.noteRemote(block.path.link, block.path.remote);
}

/// The sender is authentic, but may not use this system id.
void StationReceiver::refuseFrame(const link::ReceivedBlock &block, const mavlink::Frame &frame, channel::SessionId session)
{
    const bool announces = m_parts.fleet.vehicles().announcesVehicle(frame);
    const bool others = m_gate.refuseSealed(block.time, session, frame.systemId(), announces);
    if (!others && frame.messageId() == mavlink::RadioStatus::kId)
        m_parts.fleet.takeRadioStatus(block.path, frame, session);
    m_gate.publishRefusals(block.time, m_parts.notify);
}

/// A message that may be known to clients only. Without its definition it can neither be shown nor be compared with newer ones,
/// so that clients receive it only if its record is fresh.
void StationReceiver::takeUnknownMessage(const channel::Delivery &delivery, ByteView frame)
{
    if ((m_gateway || m_feed) && delivery.freshness == channel::Freshness::Fresh
        && m_gate.acceptSealed(delivery.session, mavlink::systemIdOf(frame)))
        serve(frame);
}

void StationReceiver::takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item)
{
    if (item.frame)
        m_callPlaces.noteMavlink(link, block.path, block.time);
    takeClearItem(block, item, FrameOrigin::Live);
}

void StationReceiver::takeClearItem(const link::ReceivedBlock &block, const mavlink::ScanItem &item, FrameOrigin origin)
{
    if (item.frame)
        takeClearFrame(block.time, block.path, *item.frame, origin);
    else if (mavlink::isDamagedFrame(item))
        m_parts.links.countBadFrame(block.path.link);
    else if (mavlink::isWholeFrame(item) && origin == FrameOrigin::Live
             && m_gate.judgeClear(block.path, mavlink::systemIdOf(item.bytes), origin, false) == FrameGate::Verdict::Accept)
        serve(item.bytes);
}

void StationReceiver::takeUnusable(const link::Link &, Unusable what)
{
    m_datagrams.garbage += what == Unusable::Garbage;
}

void StationReceiver::takeClearFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, FrameOrigin origin)
{
    const std::uint8_t systemId = frame.systemId();
    if (systemId == m_self.system && frame.componentId() == m_self.component)
        return; // our own, looped back
    const bool wasSealed = origin == FrameOrigin::Recording && m_parts.fleet.watches().isOrWasSealed(systemId);
    switch (m_gate.judgeClear(from, systemId, origin, wasSealed)) {
    case FrameGate::Verdict::Accept: return acceptFrame(now, from, frame, origin, std::nullopt);
    case FrameGate::Verdict::AwaitApproval:
        if (auto event = m_gate.awaitApproval(now, from, systemId, m_parts.fleet.vehicles().announcesVehicle(frame)))
            m_parts.notify(std::move(*event));
        return;
    case FrameGate::Verdict::Refuse: break;
    }
    const auto session = m_gate.refuseClear(from, systemId);
    if (session && m_channel)
        m_channel->endpoint().countPlaintextDropped(*session, 1);
    m_gate.publishRefusals(now, m_parts.notify);
}

void StationReceiver::acceptFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, FrameOrigin origin,
                                  std::optional<channel::SessionId> session)
{
    m_parts.links.noteUse(from);
    const bool live = origin == FrameOrigin::Live;
    const std::uint8_t systemId = frame.systemId();
    if (live)
        m_gate.heardLive(systemId);
    const WallTime wall = wallNow();
    if (origin != FrameOrigin::Recording)
        record(frame, wall);
    if (live)
        serve(frame.bytes());
    if (session) {
        m_parts.routes.heardSealed(systemId, *session);
        m_notedPlain.reset(systemId);
    }
    if (!session && live)
        notePlain(frame, wall);
    if (auto found = m_parts.fleet.take(now, wall, from, frame, session)) {
        found->recorded = origin == FrameOrigin::Recording;
        m_parts.notify(*found);
    }
    const bool highLatency = mavlink::isHighLatency(frame.messageId());
    if (live && (highLatency || frame.messageId() == mavlink::Heartbeat::kId)) {
        const vehicle::Vehicle *vehicle = m_parts.fleet.find(systemId);
        const bool isAutopilot = vehicle && vehicle->componentId() == frame.componentId();
        if (!session) {
            m_parts.routes.heardClear(now, systemId, from, isAutopilot, highLatency);
            m_parts.links.noteRemote(from.link, from.remote);
        }
        if (isAutopilot)
            m_parts.routes.heardVersion(systemId, from, session, vehicle->current().mavlinkVersion);
    }
    if (live && m_parts.fleet.vehicles().claimsOwnId(frame) && m_ownIdLimit.take(now))
        m_parts.notify(OwnIdClaimed{systemId, frame.componentId(), link::toText(from.remote)});
}

/// The frames of a recording do not say whether they were sealed.
void StationReceiver::notePlain(const mavlink::Frame &frame, WallTime wall)
{
    const std::uint8_t systemId = frame.systemId();
    if (!m_recorder || m_notedPlain.test(systemId) || !m_parts.fleet.vehicles().announcesVehicle(frame))
        return;
    m_notedPlain.set(systemId);
    m_recorder->note(plainVehicle(wall, systemId));
}

/// Does not change the routes: the vehicle may have another address by now.
void StationReceiver::acceptLateFrame(TimePoint now, const Path &from, const mavlink::Frame &frame,
                                      channel::Freshness freshness)
{
    record(frame, wallNow());
    if (freshness == channel::Freshness::Fresh && isLateAnswer(frame.messageId()))
        serve(frame.bytes());
    m_parts.fleet.takeLate(now, from, frame);
}

void StationReceiver::record(const mavlink::Frame &frame, WallTime wall)
{
    if (m_recorder)
        m_recorder->record(wall, frame.bytes());
}

} // namespace skyseal::engine
