#include "core/engine/agent/agent_core.h"

#include "core/channel/endpoint.h"
#include "core/base/weakness.h"
#include "core/engine/common/dialect_traits.h"
#include "core/mavlink/dialect.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

constexpr LinkId kVehicleLink{1};
constexpr LinkId kGroundLink{2};
/// The remote of a link that has only one, for clear frames.
constexpr Path kGround{kGroundLink, {}};

/// The same for sealed messages.
Path groundOf(const AgentConfig &config)
{
    return {kGroundLink, {}, config.carrier};
}

channel::Endpoint makeEndpoint(const AgentConfig &config, SecretFiles &secrets)
{
    channel::Config out;
    out.role = channel::Role::Agent;
    out.identity = secrets.identity;
    out.peers = secrets.peers;
    out.policy = config.policy;
    out.freshness = config.freshness;
    out.announceTo = {groundOf(config)};
    out.messageTraits = std::make_shared<DialectTraits>(mavlink::Dialect::builtin());
    return {std::move(out), secrets.random, *secrets.counters, steadyNow()};
}

} // namespace

AgentCore::AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify)
    : m_config(std::move(config)), m_secrets(std::move(secrets)), m_events(std::move(notify)), m_ground(groundOf(m_config)),
      m_links(*this, [this](link::Link &link) { linkChanged(link); }),
      m_ingress(mavlink::Dialect::builtin(), m_links.carriers()), m_vehicleSink(*this),
      m_channel(makeEndpoint(m_config, *m_secrets), m_links),
      m_pairing(m_links, m_secrets->random,
                [this](const channel::PairingEvent &event) { m_events.publish(steadyNow(), event); }),
      m_clear(m_links, kGround), m_timer([this] { handleDeadline(); })
{
    m_gate.setPeers(m_secrets->peers);
    m_channel.endpoint().setCostSource([this](channel::SessionId session) { return m_channel.endCosts(session); });
}

AgentCore::~AgentCore() = default;

IngressRules AgentCore::groundRules() const
{
    const bool tunnel = m_config.carrier == Carrier::Tunnel;
    const bool cobs = m_config.carrier == Carrier::Serial;
    IngressRules out;
    out.isStream = cobs || (tunnel && m_config.ground.traits().isStream);
    out.takesDatagrams = m_config.carrier == Carrier::Datagram;
    out.takesCobs = cobs;
    out.takesTunnel = tunnel;
    // Clear bytes are searched only for frames that are of use: those that carry messages of the channel, those sealed in
    // place, and those of a station that cannot seal, while they would be forwarded. Anyone can send clear bytes.
    const bool inPlace = out.takesDatagrams && m_config.policy.allowInline;
    const bool searched = tunnel || inPlace || isPlain() || (out.takesDatagrams && weakened(Weakness::ClearAccepted));
    out.clear = searched ? ClearScan::Always : ClearScan::Never;
    return out;
}

void AgentCore::start()
{
    m_ingress.addLink(kVehicleLink, {.isStream = m_config.vehicle.traits().isStream}, m_vehicleSink);
    m_ingress.addLink(kGroundLink, groundRules(), *this);
    m_links.open(kVehicleLink, m_config.vehicle); // first, so that a station that finds the agent finds the vehicle as well
    m_links.open(kGroundLink, m_config.ground);
    finishWake();
}

void AgentCore::setPeers(std::vector<channel::Peer> peers)
{
    m_gate.setPeers(peers);
    m_channel.endpoint().setPeers(steadyNow(), std::move(peers));
    finishWake();
}

Result<void, PairingRefusal> AgentCore::openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase)
{
    if (m_armed.any())
        return tl::unexpected(PairingRefusal::Armed);
    if (m_pairing.isOpen())
        return tl::unexpected(PairingRefusal::OpenAlready);
    channel::PairingConfig config;
    config.role = channel::Role::Agent;
    config.identity = m_secrets->identity;
    config.name = std::move(name);
    config.systemId = m_routes.onlySystem();
    config.passphrase = std::move(passphrase);
    config.callTo = {m_ground};
    m_pairing.open(steadyNow(), std::move(config));
    finishWake();
    return {};
}

void AgentCore::confirmPairing(const channel::PublicKey &key)
{
    m_pairing.confirm(steadyNow(), key);
    finishWake();
}

void AgentCore::refusePairing()
{
    m_pairing.refuse(steadyNow());
    finishWake();
}

void AgentCore::cancelPairing()
{
    m_pairing.cancel(steadyNow(), channel::PairingEnd::Cancelled);
    finishWake();
}

const channel::PublicKey &AgentCore::publicKey() const
{
    return m_secrets->publicKey();
}

void AgentCore::stop()
{
    m_pairing.cancel(steadyNow(), channel::PairingEnd::Cancelled);
    m_channel.flushAll(steadyNow());
    for (const channel::SessionId session : m_channel.endpoint().sessions())
        m_channel.endpoint().close(steadyNow(), session);
    finishWake();
    m_stopped = true;
    m_timer.set(kNever);
    m_links.forEach([](link::Link &link) {
        link.disconnect();
        link.close();
    });
}

AgentSnapshot AgentCore::snapshot()
{
    const TimePoint now = steadyNow();
    m_channel.roll(now);
    m_routes.forgetSilent(now);
    for (const FramesRefused &refused : m_gate.takeRefused())
        m_events.publish(now, refused);
    if (const auto storage = m_storage.note(now, m_secrets->counters->problem()))
        m_events.publish(now, *storage);
    AgentSnapshot out;
    out.storageProblem = m_storage.problem();
    for (LinkSnapshot &link : m_links.snapshots(now))
        (link.id == kVehicleLink ? out.vehicle : out.ground) = std::move(link);
    const metrics::SequenceCounts counts = m_measured.fromVehicle.total();
    out.mavlink = {counts.received,  counts.lost,         counts.late,
                   counts.duplicate, m_links.badFrames(), m_measured.fromVehicle.evicted()};
    out.channel = m_channel.totals();
    out.channel.rx.malformed += m_measured.counters.unusable;
    out.channel.rx.plaintextDropped = m_measured.counters.clearRefused;
    out.counters = m_measured.counters;
    out.counters.groundIdRefused = m_groundIdClaims.count();
    m_gate.addTo(out.counters);
    out.processCpuPercent = m_measured.cpu.sample(now, metrics::processCpuTime());
    out.residentBytes = metrics::residentBytes().value_or(0);
    return out;
}

void AgentCore::linkChanged(link::Link &link)
{
    if (link.id() == kVehicleLink && link.traits().hasOneRemote)
        m_routes.setFixed({kVehicleLink, {}});
    // When many call at once, the handshakes of the address that the operator named come first.
    if (link.id() == kGroundLink && link.traits().isDatagramClient() && link.remote() != Address{}) {
        m_ground.remote = link.remote();
        m_channel.endpoint().setAnnounceTo(steadyNow(), {m_ground});
    }
    m_events.publish(steadyNow(), AgentLinkChanged{link.id() == kGroundLink, m_links.snapshot(link)});
}

void AgentCore::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    if (m_stopped)
        return;
    for (const link::ReceivedBlock &block : blocks)
        m_ingress.take(link, block);
    finishWake();
}

void AgentCore::linkPeerJoined(link::Link &link, const Path &path)
{
    m_ingress.forget(path);
    m_routes.streamChanged(path);
    if (link.id() == kGroundLink) {
        m_channel.endpoint().handleStreamBegan(steadyNow(), kGroundLink);
        finishWake();
    }
}

void AgentCore::linkPeerLeft(link::Link &, const Path &path)
{
    m_ingress.forget(path);
    m_routes.streamChanged(path);
}

void AgentCore::takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item)
{
    if (mavlink::isDamagedFrame(item))
        m_links.countBadFrame(from.link);
    if (!mavlink::isWholeFrame(item))
        return;
    if (item.frame) {
        m_links.noteUse(from);
        if (VehicleRoutes::isVehicleHeartbeat(*item.frame) && !takeVehicleHeartbeat(now, from, *item.frame))
            return;
        m_measured.fromVehicle.note({from.link, item.frame->systemId(), item.frame->componentId()}, item.frame->sequence(),
                                    now);
    }
    if (isPlain()) {
        m_clear.add(item.bytes);
    } else if (m_sessions.none()) {
        ++m_measured.counters.undelivered;
    } else {
        ++m_measured.counters.toGround;
        for (const channel::SessionId session : m_sessions.all())
            m_channel.queue(now, session, item.bytes);
    }
}

/// Returns false if the heartbeat must not reach the ground, where it would be shown as a vehicle.
bool AgentCore::takeVehicleHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &heartbeat)
{
    const std::uint8_t systemId = heartbeat.systemId();
    if (m_gate.isGroundSystem(systemId) && !weakened(Weakness::VehicleTakesAnyId)) {
        m_routes.forget(systemId);
        if (m_groundIdClaims.note(now, systemId))
            m_events.publish(now, GroundIdClaimed{systemId});
        return false;
    }
    m_routes.heard(now, from, systemId);
    if (m_armed.note(heartbeat) && m_pairing.isOpen()) // a pairing must not be possible in flight
        m_pairing.cancel(now, channel::PairingEnd::Armed);
    if (m_config.carrier == Carrier::Tunnel)
        m_node.setSystem(now, systemId, m_links.carriers());
    return true;
}

bool AgentCore::takePairing(const link::Link &, const link::ReceivedBlock &message)
{
    if (!m_pairing.take(message.time, message.path, message.bytes))
        return false;
    m_links.noteRemote(kGroundLink, message.path.remote);
    return true;
}

bool AgentCore::namesSession(ByteView message) const
{
    return m_channel.endpoint().namesSerialSession(message);
}

void AgentCore::takeRecord(const link::Link &, const link::ReceivedBlock &message)
{
    if (const auto delivery = m_channel.receive(message.time, message.path, message.bytes))
        takeDelivery(message, *delivery);
}

void AgentCore::takeSealedInPlace(const link::Link &, const link::ReceivedBlock &frame)
{
    if (const auto delivery = m_channel.receiveInline(frame.time, frame.path, frame.bytes))
        takeDelivery(frame, *delivery);
}

void AgentCore::takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery)
{
    // The start of a session is handled before its first frame; its end, when a goodbye overtook a record, after the record.
    handleEvents(delivery.session);
    std::uint64_t frames = 0;
    mavlink::scanFrames(delivery.frames, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
        if (!mavlink::isWholeFrame(item))
            return;
        ++frames;
        if (item.frame) {
            const auto counts = m_sessions.note(block.time, delivery.session, kGroundLink, *item.frame);
            m_channel.endpoint().noteFrames(delivery.session, counts);
        }
        if (m_gate.accept(block.time, delivery, item, [this](std::uint8_t systemId) { return m_routes.isVehicle(systemId); }))
            sendToVehicle(item);
    });
    m_channel.countFrames(delivery.session, frames);
    m_links.noteRemote(kGroundLink, block.path.remote);
    m_links.noteUse(block.path);
}

void AgentCore::takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item)
{
    if (!mavlink::isWholeFrame(item))
        return;
    if (isPlain() || weakened(Weakness::ClearAccepted)) {
        m_links.noteUse(block.path);
        sendToVehicle(item);
    } else {
        ++m_measured.counters.clearRefused;
    }
}

void AgentCore::takeUnusable(const link::Link &, Unusable what)
{
    if (what == Unusable::Clear) {
        ++m_measured.counters.clearRefused;
        return;
    }
    // Behind a router the datagrams themselves are not the station's.
    m_measured.counters.unusable += what == Unusable::Message || m_config.carrier == Carrier::Datagram;
}

void AgentCore::sendToVehicle(const mavlink::ScanItem &item)
{
    const std::uint8_t target = item.frame ? item.frame->targetSystem() : std::uint8_t(0);
    if (m_routes.forEachPathTo(target, [&](const Path &path) { m_links.send(path, item.bytes); }))
        ++m_measured.counters.toVehicle;
    else
        ++m_measured.counters.undelivered;
}

void AgentCore::handleEvents(std::optional<channel::SessionId> speaking)
{
    while (const auto event = m_channel.pollEvent(speaking)) {
        if (const auto *up = std::get_if<channel::SessionUp>(&*event)) {
            m_gate.sessionUp(*up);
            m_sessions.add(up->session);
            m_ingress.setRules(kGroundLink, groundRules());
        } else if (const auto *down = std::get_if<channel::SessionDown>(&*event)) {
            m_gate.sessionDown(down->session);
            m_sessions.remove(down->session);
            m_ingress.setRules(kGroundLink, groundRules());
        }
        m_events.publish(steadyNow(), *event);
    }
}

void AgentCore::handleDeadline()
{
    const TimePoint now = steadyNow();
    m_channel.endpoint().handleDeadline(now);
    m_node.handleDeadline(now, m_links, kGround);
    m_pairing.handleDeadline(now);
    m_events.publishDue(now);
    finishWake();
}

void AgentCore::finishWake()
{
    if (m_stopped)
        return;
    const TimePoint now = steadyNow();
    m_clear.flush();
    m_channel.flush(now);
    handleEvents();
    m_channel.flush(now); // what an event caused
    m_pairing.flush();
    m_links.flush();
    m_timer.set(std::min({m_channel.endpoint().nextDeadline(), m_channel.flushDue(), m_pairing.nextDeadline(),
                          m_node.nextDeadline(), m_events.nextDeadline()}));
}

} // namespace skyseal::engine
