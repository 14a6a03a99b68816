#include "core/engine/agent/agent_core.h"

#include "core/channel/endpoint.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/engine/common/dialect_traits.h"
#include "core/mavlink/dialect.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// Targets of the announcements: not on listening links, where stations send first.
std::vector<Path> placesOf(const AgentConfig &config)
{
    std::vector<Path> out;
    for (std::size_t i = 0; i < config.grounds.size(); ++i) {
        if (!config.grounds[i].url.traits().isDatagramServer())
            out.push_back({groundLink(i), {}, config.grounds[i].carrier});
    }
    return out;
}

channel::Endpoint makeEndpoint(const AgentConfig &config, SecretFiles &secrets)
{
    channel::Config out;
    out.role = channel::Role::Agent;
    out.identity = secrets.identity;
    out.peers = secrets.peers;
    out.policy = config.policy;
    out.freshness = config.freshness;
    out.announceTo = placesOf(config);
    out.messageTraits = std::make_shared<DialectTraits>(mavlink::Dialect::builtin());
    return {std::move(out), secrets.random, *secrets.counters, steadyNow()};
}

} // namespace

AgentCore::AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify)
    : AgentCore(std::move(config), std::move(secrets), std::move(notify), nullptr)
{}

AgentCore::AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify,
                     std::unique_ptr<VehicleSigning> signing)
    : m_config(std::move(config)), m_secrets(std::move(secrets)), m_signing(std::move(signing)), m_events(std::move(notify)),
      m_places(placesOf(m_config)), m_links(*this, [this](link::Link &link) { linkChanged(link); }),
      m_ingress(mavlink::Dialect::builtin(), m_links.carriers()), m_channel(makeEndpoint(m_config, *m_secrets), m_links),
      m_pairing(m_links, m_secrets->random,
                [this](const channel::PairingEvent &event) { m_events.publish(steadyNow(), event); }),
      m_receiver({m_config, m_links, m_ingress, m_channel, m_pairing, m_node, m_events, *this, m_signing.get()}),
      m_timer([this] { handleDeadline(); })
{
    m_receiver.setPeers(m_secrets->peers);
    m_channel.endpoint().setCostSource([this](channel::SessionId session) { return m_channel.costs().endCosts(session); });
}

AgentCore::~AgentCore() = default;

void AgentCore::start()
{
    m_receiver.addLinks();
    m_links.open(kVehicleLink, m_config.vehicle); // first, so that the vehicle is there when a station finds the agent
    for (std::size_t i = 0; i < m_config.grounds.size(); ++i)
        m_links.open(groundLink(i), m_config.grounds[i].url);
    finishWake();
}

void AgentCore::setPeers(std::vector<channel::Peer> peers)
{
    m_receiver.setPeers(peers);
    m_channel.endpoint().setPeers(steadyNow(), std::move(peers));
    finishWake();
}

void AgentCore::setPolicy(channel::Policy policy)
{
    m_config.policy = policy;
    m_receiver.updateRules();
    m_channel.endpoint().setPolicy(steadyNow(), std::move(policy));
    finishWake();
}

Result<void, PairingRefusal> AgentCore::openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase)
{
    if (m_receiver.isAnyArmed())
        return tl::unexpected(PairingRefusal::Armed);
    if (m_pairing.isOpen())
        return tl::unexpected(PairingRefusal::OpenAlready);
    channel::PairingConfig config;
    config.role = channel::Role::Agent;
    config.identity = m_secrets->identity;
    config.name = std::move(name);
    config.systemId = m_receiver.onlySystem();
    config.passphrase = std::move(passphrase);
    config.callTo = m_places;
    for (std::size_t i = 0; i < m_config.grounds.size(); ++i) {
        if (m_config.grounds[i].url.traits().isDatagramServer())
            config.listensOn.push_back(groundLink(i));
    }
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

/// Of the pilot's session whose commands may be the oldest.
std::optional<channel::FreshnessReport> AgentCore::latestCommands()
{
    std::optional<channel::FreshnessReport> out;
    for (const channel::SessionId session : m_channel.endpoint().sessions()) {
        if (!m_receiver.mayCommand(session))
            continue;
        const auto stats = m_channel.endpoint().stats(session);
        if (stats && stats->freshness && (!out || stats->freshness->ageMicroseconds > out->ageMicroseconds))
            out = stats->freshness;
    }
    return out;
}

AgentSnapshot AgentCore::snapshot()
{
    const TimePoint now = steadyNow();
    m_channel.roll(now);
    m_receiver.forgetSilent(now);
    for (const FramesRefused &refused : m_receiver.takeRefused())
        m_events.publish(now, refused);
    if (const auto storage = m_storage.note(now, m_secrets->counters->problem()))
        m_events.publish(now, *storage);
    AgentSnapshot out;
    if (m_signing) {
        for (VehicleSignatures &report : m_signing->takeReports(now))
            m_events.publish(now, std::move(report));
        out.signing = m_signing->counters();
    }
    out.storageProblem = m_storage.problem();
    for (LinkSnapshot &link : m_links.snapshots(now)) { // in the order in which they were opened
        if (link.id == kVehicleLink)
            out.vehicle = std::move(link);
        else
            out.grounds.push_back(std::move(link));
    }
    const metrics::SequenceCounts counts = m_receiver.fromVehicle().total();
    out.mavlink = {counts.received,  counts.lost,         counts.late,
                   counts.duplicate, m_links.badFrames(), m_receiver.fromVehicle().evicted()};
    out.counters = m_receiver.counters();
    out.channel = m_channel.totals();
    out.channel.rx.malformed += out.counters.unusable;
    out.channel.rx.plaintextDropped = out.counters.clearRefused;
    out.freshness = latestCommands();
    out.processCpuPercent = m_cpu.sample(now, metrics::processCpuTime());
    out.residentBytes = metrics::residentBytes().value_or(0);
    return out;
}

void AgentCore::linkChanged(link::Link &link)
{
    const bool toGround = link.id() != kVehicleLink;
    if (!toGround && link.traits().hasOneRemote)
        m_receiver.fixVehicle({kVehicleLink, {}});
    // Under load, the handshakes of the addresses that the operator named have priority.
    if (toGround && link.traits().isDatagramClient() && link.remote() != Address{}) {
        std::ranges::find(m_places, link.id(), &Path::link)->remote = link.remote();
        m_channel.endpoint().setAnnounceTo(steadyNow(), m_places);
    }
    m_events.publish(steadyNow(), AgentLinkChanged{toGround, m_links.snapshot(link)});
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
    m_receiver.streamChanged(path);
    if (link.id() != kVehicleLink) {
        m_channel.endpoint().handleStreamBegan(steadyNow(), link.id());
        finishWake();
    }
}

void AgentCore::linkPeerLeft(link::Link &, const Path &path)
{
    m_receiver.streamChanged(path);
}

void AgentCore::handleEvents(std::optional<channel::SessionId> speaking)
{
    while (const auto event = m_channel.pollEvent(speaking)) {
        if (const auto *up = std::get_if<channel::SessionUp>(&*event)) {
            m_receiver.sessionUp(*up);
        } else if (const auto *down = std::get_if<channel::SessionDown>(&*event)) {
            m_receiver.sessionDown(down->session);
        }
        m_events.publish(steadyNow(), *event);
    }
}

void AgentCore::handleDeadline()
{
    const TimePoint now = steadyNow();
    m_channel.endpoint().handleDeadline(now);
    m_node.handleDeadline(now, m_links, m_places);
    m_pairing.handleDeadline(now);
    m_events.publishDue(now);
    finishWake();
}

void AgentCore::finishWake()
{
    if (m_stopped)
        return;
    const TimePoint now = steadyNow();
    m_receiver.flush();
    m_channel.flush(now);
    handleEvents({});
    m_channel.flush(now); // datagrams caused by an event
    m_pairing.flush();
    m_links.flush();
    m_timer.set(std::min({m_channel.endpoint().nextDeadline(), m_channel.flushDue(), m_pairing.nextDeadline(),
                          m_node.nextDeadline(), m_events.nextDeadline()}));
}

} // namespace skyseal::engine
