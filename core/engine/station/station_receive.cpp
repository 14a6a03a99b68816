// The part of StationCore that takes in what the links received: records to the channel, clear MAVLink past the policy, and
// what is believed to the vehicles.
#include "core/engine/station/station_core.h"

#include "core/link/address_text.h"

namespace skyseal::engine {

void StationCore::linkPeerJoined(link::Link &link, const Path &path)
{
    m_intake.forget(path);
    m_carriers.forget(path);
    if (!m_channel || m_stopped)
        return;
    m_channel->endpoint().handleStreamBegan(steadyNow(), link.id());
    finishWake();
}

void StationCore::linkPeerLeft(link::Link &, const Path &path)
{
    m_intake.forget(path);
    m_carriers.forget(path);
}

void StationCore::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    if (m_stopped)
        return;
    for (const link::ReceivedBlock &block : blocks) {
        if (link.isStream())
            takeStream(link, block);
        else
            takeDatagram(link, block);
    }
    m_changed = true;
    finishWake();
}

/// Whether what comes there may be sealed: there are keys, and it is neither a recording nor only listened to.
bool StationCore::maySeal(const link::Link &link) const
{
    return isSealing() && link.url().scheme() != link::LinkScheme::Tlog && !m_mavsec.contains(link.id());
}

void StationCore::takeStream(const link::Link &link, const link::ReceivedBlock &block)
{
    const bool sealing = maySeal(link);
    if (sealing)
        m_carriers.takeCobs(block, [this](const link::ReceivedBlock &message) { takeMessage(message); });
    if (sealing && m_carriers.isCobs(block.path, block.time))
        return;
    m_intake.takeStream(block.path, block.bytes, [&](const mavlink::ScanItem &item) {
        if (!sealing)
            return takeClear(block.time, block.path, item);
        if (item.frame)
            m_carriers.noteMavlink(block.path);
        else if (!m_carriers.speaksMavlink(block.path))
            return; // half an announcement in COBS is no damaged frame
        if (!takeTunnel(block, item))
            takeClear(block.time, block.path, item);
    });
}

void StationCore::takeDatagram(const link::Link &link, const link::ReceivedBlock &block)
{
    const bool sealing = maySeal(link);
    if (m_pairing && !m_mavsec.contains(link.id()) && m_pairing->take(block.time, block.path, block.bytes))
        return; // an agent that is open for pairing
    if (!block.bytes.empty() && channel::Endpoint::owns(block.bytes[0]) && !m_mavsec.contains(link.id()))
        return takeRecord(block.time, block);
    bool anyFrame = false;
    m_intake.takeDatagram(block.bytes, [&](const mavlink::ScanItem &item) {
        anyFrame = anyFrame || item.fault != mavlink::FrameFault::Garbage || item.frame;
        if (isSealedInPlace(item))
            takeInline(block, item);
        else if (!sealing || !takeTunnel(block, item))
            takeClear(block.time, block.path, item);
    });
    m_garbage += !anyFrame;
}

/// False for a frame that has nothing to do with the channel.
bool StationCore::takeTunnel(const link::ReceivedBlock &block, const mavlink::ScanItem &item)
{
    if (!CarrierReader::isTunnel(item))
        return item.frame && m_carriers.isAgentsHeartbeat(block.path, *item.frame);
    const Node ours{m_config.systemId, m_config.componentId};
    if (const auto message = m_carriers.takeTunnel(block.time, block.path, *item.frame, ours))
        takeMessage(*message);
    return true;
}

/// One that came in another carrier than a datagram.
void StationCore::takeMessage(const link::ReceivedBlock &message)
{
    if (!m_pairing->take(message.time, message.path, message.bytes) && channel::Endpoint::owns(message.bytes[0]))
        takeRecord(message.time, message);
}

void StationCore::takeRecord(TimePoint now, const link::ReceivedBlock &block)
{
    if (!isSealing()) {
        m_waitingBytes += block.bytes.size();
        ++m_waitingDatagrams;
        repeatGoodbye(now, block.path);
        m_garbage += !channel::Endpoint::isAnnouncement(block.bytes); // of an agent that waits for whoever wants a session
        return;
    }
    if (const auto delivery = m_channel->receive(now, block.path, block.bytes)) {
        // The session is told of by its event; what it may speak as must be known before its first frame is judged, and
        // until its last one was, which its goodbye may have overtaken.
        handleEvents(now, delivery->session);
        takeSealed(now, block.path, *delivery);
    }
}

/// A frame that is sealed in place; without keys it is nobody's telemetry.
void StationCore::takeInline(const link::ReceivedBlock &block, const mavlink::ScanItem &item)
{
    if (!isSealing() || m_mavsec.contains(block.path.link))
        return;
    const MutableByteView frame = block.bytes.subspan(item.offset, item.bytes.size());
    if (const auto delivery = m_channel->receiveInline(block.time, block.path, frame)) {
        handleEvents(block.time, delivery->session);
        takeSealed(block.time, block.path, *delivery);
    }
}

void StationCore::takeSealed(TimePoint now, const Path &from, const channel::Delivery &delivery)
{
    std::uint64_t frames = 0;
    m_intake.takeDatagram(delivery.frames, [&](const mavlink::ScanItem &item) {
        if (!item.frame) {
            if (mavlink::isDamagedFrame(item))
                m_links.countBadFrame(from.link);
            return;
        }
        ++frames;
        if (m_policy.acceptSealed(delivery.session, item.frame->systemId()))
            takeFrame(now, from, *item.frame, delivery.session);
        else
            refuseSystem(now, delivery.session, item.frame->systemId());
    });
    m_channel->countFrames(delivery.session, frames);
    m_links.noteRemote(from.link, from.remote);
}

void StationCore::takeClear(TimePoint now, const Path &from, const mavlink::ScanItem &item)
{
    if (!item.frame) {
        if (mavlink::isDamagedFrame(item))
            m_links.countBadFrame(from.link);
        return;
    }
    const auto mavsec = m_mavsec.find(from.link);
    const mavlink::Frame frame = mavsec == m_mavsec.end() ? *item.frame : mavsec->second.open(*item.frame);
    if (frame.systemId() == m_config.systemId && frame.componentId() == m_config.componentId)
        return; // our own, looped back
    if (!m_policy.acceptClear(from, frame.systemId())) {
        // A recording, and a stream that is only listened to, were opened as what they are. What was recorded of a sealed
        // vehicle may be looked at again, but not in the place of what that vehicle itself said.
        const link::Link *link = m_links.find(from.link);
        const bool recorded = link && link->url().scheme() == link::LinkScheme::Tlog;
        const bool pendingApproval = m_policy.needsApproval(from, frame.systemId());
        if (recorded ? isOrWasSealed(from, frame.systemId()) : !pendingApproval)
            return refuseClear(now, from, frame.systemId());
        if (pendingApproval && (!link || maySeal(*link)))
            return awaitApproval(now, from, frame);
    }
    takeFrame(now, from, frame, std::nullopt);
}

/// In this run: the vehicle has a session, or had one when it was last heard.
bool StationCore::isOrWasSealed(const Path &from, std::uint8_t systemId) const
{
    const auto watch = m_vehicleWatches.find(systemId);
    const bool flown = watch != m_vehicleWatches.end() && (watch->second.session || watch->second.ended);
    return flown || m_policy.sessionConcerned(from, systemId).has_value();
}

void StationCore::awaitApproval(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    m_pendingVehicles.count(); // apart from what is refused: a vehicle that waits for a person is no sign of an attack
    if (!m_vehicles.announcesVehicle(frame))
        return;
    const std::string address = link::toText(from.remote);
    if (m_pendingVehicles.note(now, frame.systemId(), address))
        notify(PlaintextRefused{frame.systemId(), address, 1, m_policy.neverHeard()});
}

void StationCore::refuseClear(TimePoint now, const Path &from, std::uint8_t systemId)
{
    m_refusals.count(systemId);
    m_refusedFrom = from.remote;
    if (m_channel) {
        if (const auto session = m_policy.sessionConcerned(from, systemId))
            m_channel->endpoint().countPlaintextDropped(*session, 1);
    }
    tellRefusals(now);
}

void StationCore::refuseSystem(TimePoint now, channel::SessionId session, std::uint8_t systemId)
{
    m_spoofed.count(systemId);
    m_spoofer = session;
    tellRefusals(now);
}

/// Whose frames were refused, in words: for those that are told, while its session can be asked.
void StationCore::nameSpoofer()
{
    const auto watch = m_sessionWatches.find(m_spoofer);
    if (m_spoofed.pending.frames == 0 || watch == m_sessionWatches.end())
        return;
    m_spoofed.pending.peer = watch->second.peerName;
    m_spoofed.pending.owner = m_policy.ownerOf(m_spoofed.pending.systemId, m_spoofer);
}

void StationCore::tellRefusals(TimePoint now)
{
    if (m_refusals.isDue(now)) {
        m_refusals.pending.remoteAddress = link::toText(m_refusedFrom);
        notify(m_refusals.takePending(now));
    }
    if (m_spoofed.isDue(now)) {
        nameSpoofer();
        notify(m_spoofed.takePending(now));
    }
}

void StationCore::takeFrame(TimePoint now, const Path &from, const mavlink::Frame &frame,
                            std::optional<channel::SessionId> session)
{
    m_links.noteUse(from);
    const link::Link *link = m_links.find(from.link);
    const bool replayed = link && link->url().scheme() == link::LinkScheme::Tlog;
    const bool live = !replayed && !m_mavsec.contains(from.link);
    const std::uint8_t systemId = frame.systemId();
    if (live)
        m_pendingVehicles.release(systemId);
    const WallTime wall = wallNow();
    m_frameBytes += frame.bytes().size();
    m_sequences.note({from.link, systemId, frame.componentId()}, frame.sequence(), now);
    m_inspector.note(now, frame);
    if (m_recorder && !replayed)
        m_recorder->record(wall, frame.bytes());
    if (session) {
        m_routes.heardSealed(systemId, *session);
    } else if (frame.messageId() == 0 && live) {
        m_routes.heardClear(now, systemId, from);
        m_links.noteRemote(from.link, from.remote);
    }
    const bool found = m_vehicles.handleFrame(now, wall, frame);
    if (vehicle::Vehicle *vehicle = m_vehicles.find(systemId)) {
        VehicleWatch &watch = m_vehicleWatches[systemId];
        watch.link = from.link;
        watch.session = session;
        watch.ended.reset();
        if (found)
            notify(VehicleFound{systemId, vehicle->current().type, vehicle->current().autopilot, session.has_value()});
    }
}

} // namespace skyseal::engine
