#include "core/engine/agent/agent_core.h"

#include "core/base/weakness.h"
#include "core/engine/common/dialect_traits.h"
#include "core/engine/agent/misreading.h"
#include "core/engine/agent/observer_rules.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

constexpr LinkId kVehicleLink{1};
constexpr LinkId kGroundLink{2};
/// The remote of a link that has only one, for clear frames.
constexpr Path kGround{kGroundLink, {}};
constexpr Duration kBeat = std::chrono::seconds(1);

/// The same for what is sealed.
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
    out.announceTo = {groundOf(config)};
    out.messageTraits = std::make_shared<DialectTraits>(mavlink::Dialect::builtin());
    return {std::move(out), secrets.random, *secrets.counters, steadyNow()};
}

/// A valid frame, or one of a message that is not known here and is carried as it is.
bool isWhole(const mavlink::ScanItem &item)
{
    return item.frame || item.fault == mavlink::FrameFault::UnknownMessage;
}

std::uint8_t systemOf(const mavlink::ScanItem &item)
{
    return item.bytes[item.bytes[0] == mavlink::kMagic2 ? 5 : 3];
}

std::uint32_t messageIdOf(const mavlink::ScanItem &item)
{
    if (item.bytes[0] != mavlink::kMagic2)
        return item.bytes[5];
    return item.bytes[7] | item.bytes[8] << 8 | static_cast<std::uint32_t>(item.bytes[9]) << 16;
}

} // namespace

AgentCore::AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Tell tell)
    : m_config(std::move(config)), m_secrets(std::move(secrets)), m_notify(std::move(tell)), m_ground(groundOf(m_config)),
      m_links(*this, [this](link::Link &link) { linkChanged(link); }), m_channel(makeEndpoint(m_config, *m_secrets), m_links),
      m_pairing(m_links, m_secrets->random, [this](const channel::PairingEvent &event) { m_notify(event); }),
      m_policy(SecureMode::Required, Speakers::MayShareASystem), m_intake(mavlink::Dialect::builtin()),
      m_clear(m_links, kGround), m_timer([this] { handleDeadline(); })
{
    m_policy.setPeers(m_secrets->peers);
    m_channel.endpoint().setCostSource([this](channel::SessionId session) { return m_channel.endCosts(session); });
}

AgentCore::~AgentCore() = default;

void AgentCore::start()
{
    // The vehicle first: a station that finds us shall find it as well.
    m_links.open(kVehicleLink, m_config.vehicle);
    m_links.open(kGroundLink, m_config.ground);
    finishWake();
}

void AgentCore::setPeers(std::vector<channel::Peer> peers)
{
    m_policy.setPeers(peers);
    m_channel.endpoint().setPeers(steadyNow(), std::move(peers));
    finishWake();
}

Result<void, PairingRefusal> AgentCore::openPairing(std::string name, std::shared_ptr<const Key32> passphraseKey)
{
    if (!m_armed.empty())
        return tl::unexpected(PairingRefusal::Armed);
    if (m_pairing.isOpen())
        return tl::unexpected(PairingRefusal::OpenAlready);
    channel::PairingConfig config;
    config.role = channel::Role::Agent;
    config.identity = m_secrets->identity;
    config.name = std::move(name);
    config.passphraseKey = std::move(passphraseKey);
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

/// Who can reach a vehicle in flight shall not be able to be paired with it.
void AgentCore::noteArmed(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Heartbeat::kId)
        return;
    const mavlink::Heartbeat beat = mavlink::Heartbeat::decode(frame.payload());
    if (beat.autopilot == mavlink::MAV_AUTOPILOT_INVALID)
        return;
    const std::pair who(frame.systemId(), frame.componentId());
    if ((beat.base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) == 0)
        m_armed.erase(who); // but not another vehicle behind the same agent
    else
        m_armed.insert(who);
    if (!m_armed.empty() && m_pairing.isOpen())
        m_pairing.cancel(now, channel::PairingEnd::Armed);
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
    for (const auto &[key, refused] : std::exchange(m_refusedPending, {}))
        m_notify(refused);
    AgentSnapshot out;
    for (LinkSnapshot &link : m_links.snapshots(now))
        (link.id == kVehicleLink ? out.vehicle : out.ground) = std::move(link);
    const metrics::SequenceCounts counts = m_sequences.total();
    out.mavlink = {counts.received, counts.lost, counts.late, counts.duplicate, m_links.badFrames(), m_sequences.evicted()};
    out.channel = m_channel.totals();
    out.channel.rx.malformed += m_garbage;
    out.channel.rx.plaintextDropped = m_counters.clearRefused;
    out.counters = m_counters;
    out.processCpuPercent = m_cpu.sample(now, metrics::processCpuTime());
    out.residentBytes = metrics::residentBytes().value_or(0);
    return out;
}

void AgentCore::linkChanged(link::Link &link)
{
    const link::LinkScheme scheme = link.url().scheme();
    const bool hasOneRemote = scheme == link::LinkScheme::UdpOut || scheme == link::LinkScheme::Tcp
        || scheme == link::LinkScheme::Serial;
    if (link.id() == kVehicleLink && hasOneRemote)
        m_routes.setFixed({kVehicleLink, {}});
    // Whoever is at the address that we were given comes before strangers when many call at once.
    if (link.id() == kGroundLink && scheme == link::LinkScheme::UdpOut && link.remote() != Address{}) {
        m_ground.remote = link.remote();
        m_channel.endpoint().setAnnounceTo(steadyNow(), {m_ground});
    }
    m_notify(AgentLinkChanged{link.id() == kGroundLink, m_links.snapshot(link)});
}

void AgentCore::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    if (m_stopped)
        return;
    for (const link::ReceivedBlock &block : blocks) {
        if (link.id() == kVehicleLink) {
            const auto take = [&](const mavlink::ScanItem &item) { takeFromVehicle(block.time, block.path, item); };
            if (link.isStream())
                m_intake.takeStream(block.path, block.bytes, take);
            else
                m_intake.takeDatagram(block.bytes, take);
        } else {
            takeGround(link, block);
        }
    }
    finishWake();
}

void AgentCore::linkPeerJoined(link::Link &link, const Path &path)
{
    m_intake.forget(path);
    m_carriers.forget(path);
    m_routes.streamChanged(link.id(), path);
    if (link.id() == kGroundLink) {
        m_channel.endpoint().handleStreamBegan(steadyNow(), kGroundLink);
        finishWake();
    }
}

void AgentCore::linkPeerLeft(link::Link &link, const Path &path)
{
    m_intake.forget(path);
    m_carriers.forget(path);
    m_routes.streamChanged(link.id(), path);
}

void AgentCore::takeGround(const link::Link &link, const link::ReceivedBlock &block)
{
    const auto takeFrame = [&](const mavlink::ScanItem &item) {
        if (m_config.carrier != Carrier::Tunnel || !CarrierReader::isTunnel(item))
            return takeClearFromGround(block.path, item);
        if (const auto message = m_carriers.takeTunnel(block.time, block.path, *item.frame, m_links.carriers().node()))
            takeMessage(*message);
    };
    switch (m_config.carrier) {
    case Carrier::Datagram: return takeMessage(block);
    case Carrier::Serial:
        m_carriers.takeCobs(block, [this](const link::ReceivedBlock &message) { takeMessage(message); });
        // A station that knows no sealing may be there.
        if (m_config.allowPlain && m_sessions.empty())
            m_intake.takeStream(block.path, block.bytes, takeFrame);
        return;
    case Carrier::Tunnel:
        if (link.isStream())
            m_intake.takeStream(block.path, block.bytes, takeFrame);
        else
            m_intake.takeDatagram(block.bytes, takeFrame);
    }
}

/// One message of the channel, or a datagram that is none.
void AgentCore::takeMessage(const link::ReceivedBlock &block)
{
    if (m_pairing.take(block.time, block.path, block.bytes))
        m_links.noteRemote(kGroundLink, block.path.remote);
    else if (!block.bytes.empty() && channel::Endpoint::owns(block.bytes[0]))
        takeRecord(block);
    else
        takeUnowned(block);
}

/// Routers and radios know us as a component of our vehicle; until that one is known we cannot speak through them.
void AgentCore::becomeNode(TimePoint now, std::uint8_t systemId)
{
    if (m_config.carrier != Carrier::Tunnel || m_links.carriers().node().system != 0)
        return;
    m_links.carriers().setNode({systemId, mavlink::MAV_COMP_ID_ONBOARD_COMPUTER});
    m_beatDue = now + kBeat;
}

/// Nothing that a vehicle or a station would say: no autopilot acts on it.
void AgentCore::beat(TimePoint now)
{
    if (now < m_beatDue)
        return;
    m_links.send(kGround, m_links.carriers().heartbeat());
    m_beatDue = std::max(m_beatDue + kBeat, now);
}

void AgentCore::takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item)
{
    if (mavlink::isDamagedFrame(item))
        m_links.countBadFrame(from.link);
    if (!isWhole(item))
        return;
    if (item.frame) {
        m_links.noteUse(from);
        m_routes.heard(now, from, *item.frame);
        noteArmed(now, *item.frame);
        if (m_routes.isVehicle(item.frame->systemId()))
            becomeNode(now, item.frame->systemId());
        m_sequences.note({from.link, item.frame->systemId(), item.frame->componentId()}, item.frame->sequence(), now);
    }
    if (m_sessions.empty()) {
        if (m_config.allowPlain)
            m_clear.add(item.bytes);
        else
            ++m_counters.undelivered;
        return;
    }
    ++m_counters.toGround;
    for (const channel::SessionId session : m_sessions)
        m_channel.queue(now, session, item.bytes);
}

void AgentCore::takeRecord(const link::ReceivedBlock &block)
{
    if (const auto delivery = m_channel.receive(block.time, block.path, block.bytes))
        takeDelivery(block, *delivery);
}

/// Clear frames, and frames that are sealed in place.
void AgentCore::takeUnowned(const link::ReceivedBlock &block)
{
    bool anyFrame = false;
    m_intake.takeDatagram(block.bytes, [&](const mavlink::ScanItem &item) {
        anyFrame = anyFrame || isWhole(item) || isSealedInPlace(item);
        if (!isSealedInPlace(item))
            return takeClearFromGround(block.path, item);
        const MutableByteView frame = block.bytes.subspan(item.offset, item.bytes.size());
        if (const auto delivery = m_channel.receiveInline(block.time, block.path, frame))
            takeDelivery(block, *delivery);
    });
    m_garbage += !anyFrame;
}

void AgentCore::takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery)
{
    // Who it is comes before what it says; that it ended, as with a record that its goodbye overtook, after.
    handleEvents(delivery.session);
    std::uint64_t frames = 0;
    m_intake.takeDatagram(delivery.frames, [&](const mavlink::ScanItem &item) {
        frames += isWhole(item);
        countFromGround(block.time, delivery.session, item);
        takeFromGround(delivery.session, item);
    });
    m_channel.countFrames(delivery.session, frames);
    m_links.noteRemote(kGroundLink, block.path.remote);
    m_links.noteUse(block.path);
}

/// The station cannot know what of its frames was lost before or behind the channel; it is told with the next report.
void AgentCore::countFromGround(TimePoint now, channel::SessionId session, const mavlink::ScanItem &item)
{
    if (!item.frame)
        return;
    metrics::SequenceTable &table = m_fromGround[session];
    table.note({kGroundLink, item.frame->systemId(), item.frame->componentId()}, item.frame->sequence(), now);
    const metrics::SequenceCounts counts = table.total();
    m_channel.endpoint().noteFrames(session, {counts.received - counts.duplicate, counts.lost});
}

void AgentCore::takeFromGround(channel::SessionId session, const mavlink::ScanItem &item)
{
    if (!isWhole(item))
        return;
    const std::uint8_t systemId = systemOf(item);
    if (!m_policy.mayCommand(session)) {
        if (!item.frame || !observerMaySend(*item.frame, m_policy.pilotThere()))
            return refuse(session, item, FramesRefused::Reason::Observer);
        if (mayBeMisread(*item.frame) && !weakened(Weakness::Misreadable)) {
            ++m_counters.observerUnclear; // as if the link had lost it: no alarm
            return;
        }
    }
    if ((m_routes.isVehicle(systemId) && !weakened(Weakness::NoSenderCheck)) || !m_policy.acceptSealed(session, systemId))
        refuse(session, item, FramesRefused::Reason::System); // nobody on the ground speaks as the vehicle
    else
        deliver(item);
}

void AgentCore::refuse(channel::SessionId session, const mavlink::ScanItem &item, FramesRefused::Reason reason)
{
    ++(reason == FramesRefused::Reason::Observer ? m_counters.observerRefused : m_counters.spoofRefused);
    // Every station sends them once a second, an observer's too: nothing to tell of each.
    if (reason == FramesRefused::Reason::Observer && item.frame && item.frame->messageId() == mavlink::Heartbeat::kId)
        return;
    FramesRefused &refused = m_refusedPending[{session, reason}];
    if (refused.frames++ == 0) {
        refused.reason = reason;
        if (const auto info = m_channel.endpoint().sessionInfo(session))
            refused.peer = info->peerName;
    }
    refused.messageId = messageIdOf(item);
    refused.messageName = item.frame ? std::string(item.frame->info().name) : std::string();
    refused.command = 0;
    if (item.frame && refused.messageId == mavlink::CommandLong::kId)
        refused.command = mavlink::CommandLong::decode(item.frame->payload()).command;
    else if (item.frame && refused.messageId == mavlink::CommandInt::kId)
        refused.command = mavlink::CommandInt::decode(item.frame->payload()).command;
}

void AgentCore::takeClearFromGround(const Path &from, const mavlink::ScanItem &item)
{
    if (!isWhole(item))
        return;
    if ((m_config.allowPlain && m_sessions.empty()) || weakened(Weakness::ClearAccepted)) {
        m_links.noteUse(from);
        deliver(item);
    } else {
        ++m_counters.clearRefused;
    }
}

void AgentCore::deliver(const mavlink::ScanItem &item)
{
    const std::uint8_t target = item.frame ? item.frame->targetSystem() : std::uint8_t(0);
    if (m_routes.forEachWayTo(target, [&](const Path &way) { m_links.send(way, item.bytes); }))
        ++m_counters.toVehicle;
    else
        ++m_counters.undelivered;
}

void AgentCore::handleEvents(std::optional<channel::SessionId> speaking)
{
    while (const auto event = m_channel.pollEvent(speaking)) {
        if (const auto *up = std::get_if<channel::SessionUp>(&*event)) {
            m_policy.sessionUp(up->session, up->peer, up->path);
            m_sessions.push_back(up->session);
        } else if (const auto *down = std::get_if<channel::SessionDown>(&*event)) {
            m_policy.sessionDown(down->session);
            std::erase(m_sessions, down->session);
            m_fromGround.erase(down->session);
        }
        m_notify(*event);
    }
}

void AgentCore::handleDeadline()
{
    m_channel.endpoint().handleDeadline(steadyNow());
    beat(steadyNow());
    m_pairing.handleDeadline(steadyNow());
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
    m_channel.flush(now);
    m_pairing.flush();
    m_links.flush();
    m_timer.set(std::min({m_channel.endpoint().nextDeadline(), m_channel.flushDue(), m_pairing.nextDeadline(), m_beatDue}));
}

} // namespace skyseal::engine
