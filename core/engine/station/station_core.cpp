#include "core/engine/station/station_core.h"

#include "core/channel/suite_strength.h"
#include "core/engine/common/dialect_traits.h"
#include "core/keys/public_key_text.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

constexpr Duration kSlowestSnapshots = std::chrono::milliseconds(500);

vehicle::VehicleConfig vehicleConfig(const StationConfig &config)
{
    vehicle::VehicleConfig out;
    out.ownSystemId = config.systemId;
    out.ownComponentId = config.componentId;
    out.streams = config.lowBandwidth ? vehicle::StreamProfile::LowBandwidth : vehicle::StreamProfile::Standard;
    out.streamRate = config.streamRate;
    out.timeSyncEvery = config.timeSyncEvery;
    return out;
}

channel::Config channelConfig(const StationConfig &config, const SecretFiles &secrets)
{
    channel::Config out;
    out.role = channel::Role::Station;
    out.identity = secrets.identity;
    out.peers = secrets.peers;
    out.policy = config.policy;
    out.messageTraits = std::make_shared<DialectTraits>(mavlink::Dialect::builtin());
    return out;
}

} // namespace

StationCore::StationCore(StationConfig config, std::unique_ptr<SecretFiles> secrets, StationSinks sinks)
    : m_config(std::move(config)), m_suites(m_config.policy.suites), m_sinks(std::move(sinks)), m_secrets(std::move(secrets)),
      m_links(*this, [this](link::Link &link) { linkChanged(link); }), m_policy(m_config.secure),
      m_intake(mavlink::Dialect::builtin()), m_vehicles(vehicleConfig(m_config)), m_start(steadyNow()),
      m_lastSnapshot(TimePoint::min()), m_nextQuarter(m_start), m_timer([this] { handleDeadline(); })
{
    if (m_secrets && m_config.secure != SecureMode::Off) {
        m_unanswering = UnansweringAgents(keys::fingerprint(m_secrets->identity->publicKey));
        m_policy.setPeers(m_secrets->peers);
        m_policy.rememberSealed(m_secrets->sealedSystems);
        channel::Endpoint endpoint(channelConfig(m_config, *m_secrets), m_secrets->random, *m_secrets->counters, m_start);
        m_channel = std::make_unique<ChannelDriver>(std::move(endpoint), m_links);
        m_links.carriers().setNode({m_config.systemId, m_config.componentId});
        m_pairing = std::make_unique<PairingDriver>(m_links, m_secrets->random, [this](const channel::PairingEvent &event) {
            if (m_sinks.pairing)
                m_sinks.pairing(event);
        });
    }
    setRecording(m_config.record);
}

StationCore::~StationCore() = default;

void StationCore::addLink(LinkId id, const link::LinkUrl &url)
{
    m_links.open(id, url);
    finishWake();
}

void StationCore::addMavsecLink(LinkId id, const link::LinkUrl &url, crypto::MavsecCipher cipher)
{
    m_mavsec.emplace(id, MavsecStream(std::move(cipher), mavlink::Dialect::builtin()));
    m_links.open(id, url, LinkUse::ListenOnly);
    finishWake();
}

void StationCore::removeLink(LinkId id)
{
    m_mavsec.erase(id);
    m_links.remove(id);
    m_routes.removeLink(id);
    m_changed = true;
    finishWake();
}

void StationCore::switchSuite(channel::SessionId session, crypto::SuiteId suite)
{
    if (m_channel)
        m_channel->endpoint().switchSuite(steadyNow(), session, suite);
    finishWake();
}

void StationCore::setAllowResearch(bool allow)
{
    m_config.policy.allowResearch = allow;
    if (m_channel)
        m_channel->endpoint().setPolicy(steadyNow(), policy());
    finishWake();
}

void StationCore::setWeakestSuite(crypto::SuiteId weakest)
{
    m_config.policy.suites = channel::notWeakerThan(weakest, m_suites);
    if (m_channel)
        m_channel->endpoint().setPolicy(steadyNow(), policy());
    finishWake();
}

void StationCore::setPeers(std::vector<channel::Peer> peers)
{
    m_policy.setPeers(peers);
    m_routes.forgetClear(); // those that are still taken are heard again soon
    m_links.forEach([this](link::Link &link) { noteRemoteOf(link); });
    if (m_channel)
        m_channel->endpoint().setPeers(steadyNow(), std::move(peers));
    finishWake();
}

void StationCore::allowPlaintext(std::uint8_t systemId)
{
    m_policy.allowPlaintext(systemId);
    m_pendingVehicles.release(systemId);
    m_changed = true;
    finishWake();
}

bool StationCore::openPairing(std::string name, channel::PeerRole roleAsked, std::shared_ptr<const Key32> passphraseKey)
{
    if (!m_pairing)
        return false;
    channel::PairingConfig config;
    config.role = channel::Role::Station;
    config.identity = m_secrets->identity;
    config.name = std::move(name);
    config.roleAsked = roleAsked;
    config.passphraseKey = std::move(passphraseKey);
    m_pairing->open(steadyNow(), std::move(config));
    finishWake();
    return true;
}

void StationCore::confirmPairing(const channel::PublicKey &key)
{
    if (m_pairing)
        m_pairing->confirm(steadyNow(), key);
    finishWake();
}

void StationCore::refusePairing()
{
    if (m_pairing)
        m_pairing->refuse(steadyNow());
    finishWake();
}

void StationCore::cancelPairing()
{
    if (m_pairing)
        m_pairing->cancel(steadyNow(), channel::PairingEnd::Cancelled);
    finishWake();
}

void StationCore::command(vehicle::CommandId id, std::uint8_t systemId, const vehicle::VehicleCommand &command)
{
    if (!withVehicle(systemId, [&](vehicle::Vehicle &vehicle, TimePoint now) { vehicle.command(now, id, command); }))
        notify(vehicle::CommandResult{id, systemId, vehicle::CommandOutcome::Refused, 0, "no such vehicle"});
}

bool StationCore::withVehicle(std::uint8_t systemId, const std::function<void(vehicle::Vehicle &, TimePoint)> &act)
{
    vehicle::Vehicle *vehicle = m_vehicles.find(systemId);
    if (!vehicle)
        return false;
    act(*vehicle, steadyNow());
    finishWake();
    return true;
}

void StationCore::setInspecting(bool inspecting)
{
    m_inspector.setWatching(inspecting);
}

void StationCore::setRecording(bool recording)
{
    if (!recording)
        m_recorder.reset();
    else if (!m_recorder && !m_config.recordFolder.empty())
        m_recorder = std::make_unique<Recorder>(m_config.recordFolder);
    m_changed = true;
}

void StationCore::setMeasuring(bool measuring)
{
    m_measuring = measuring;
    if (m_channel)
        m_channel->setMeasuring(measuring);
}

std::shared_ptr<const Snapshot> StationCore::stop()
{
    keepSealedSystems();
    const std::shared_ptr<Snapshot> last = takeSnapshot(steadyNow());
    if (m_channel) {
        m_channel->flushAll(steadyNow());
        for (const channel::SessionId session : m_channel->endpoint().sessions())
            m_channel->endpoint().close(steadyNow(), session);
        finishWake();
        const ChannelTotals totals = channelTotals();
        last->channel.rx = totals.rx;
        last->channel.tx = totals.tx;
        last->channel.peerRx = totals.peerRx;
    }
    m_stopped = true;
    m_timer.set(kNever);
    m_links.forEach([](link::Link &link) {
        link.disconnect();
        link.close();
    });
    m_recorder.reset();
    return last;
}

void StationCore::noteRemoteOf(link::Link &link)
{
    const link::LinkState state = link.state();
    const link::LinkScheme scheme = link.url().scheme();
    const bool hasOneRemote = scheme == link::LinkScheme::UdpOut || scheme == link::LinkScheme::Tcp
        || scheme == link::LinkScheme::Serial;
    const bool listensOnly = m_mavsec.contains(link.id());
    if (state == link::LinkState::Connected && hasOneRemote && !listensOnly && secureMode() != SecureMode::Required)
        m_routes.addFixed({link.id(), link.remote()});
    else if (state == link::LinkState::Waiting || state == link::LinkState::Closed)
        m_routes.removeLink(link.id());
}

void StationCore::linkChanged(link::Link &link)
{
    noteRemoteOf(link);
    m_changed = true;
    notify(LinkChanged{m_links.snapshot(link)});
}

void StationCore::finishWake()
{
    if (m_stopped)
        return;
    const TimePoint now = steadyNow();
    serveVehicles(now);
    if (m_channel) {
        m_channel->flush(now);
        handleEvents(now);
        m_channel->flush(now); // what an event asked for
        m_pairing->flush();
    }
    m_links.flush();
    publish(now);
    m_timer.set(nextDeadline());
}

void StationCore::handleDeadline()
{
    const TimePoint now = steadyNow();
    if (isSealing() && now >= m_channel->endpoint().nextDeadline())
        m_channel->endpoint().handleDeadline(now);
    if (m_pairing)
        m_pairing->handleDeadline(now);
    if (now >= m_vehicles.nextDeadline())
        m_vehicles.handleDeadline(now);
    if (now >= m_nextQuarter)
        everyQuarterSecond(now);
    sendHeartbeats(now);
    finishWake();
}

TimePoint StationCore::nextDeadline() const
{
    TimePoint next = std::min({m_nextQuarter, m_vehicles.nextDeadline(), m_heartbeat.nextDeadline()});
    if (isSealing())
        next = std::min({next, m_channel->endpoint().nextDeadline(), m_channel->flushDue()});
    if (m_pairing)
        next = std::min(next, m_pairing->nextDeadline());
    if (m_changed)
        next = std::min(next, m_lastSnapshot + std::chrono::seconds(1) / std::clamp(m_config.snapshotsPerSecond, 1, 30));
    return next;
}

void StationCore::handleEvents(TimePoint now, std::optional<channel::SessionId> speaking)
{
    while (const auto event = m_channel->pollEvent(speaking))
        handleEvent(now, *event);
}

void StationCore::handleEvent(TimePoint now, const channel::Event &event)
{
    m_changed = true;
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_policy.sessionUp(up->session, up->peer, up->path);
        m_routes.ofSession(up->session);
        noteUp(*up);
        noteUnanswering(now);
        beginWithSuite(now, *up);
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        nameSpoofer(); // before nothing knows that session any more
        m_policy.sessionDown(down->session);
        m_routes.sessionDown(down->session);
        noteDown(now, *down);
    } else if (const auto *moved = std::get_if<channel::PeerMoved>(&event)) {
        m_policy.sessionMoved(moved->session, moved->to);
    } else if (const auto *refused = std::get_if<channel::HandshakeRefused>(&event)) {
        if (refused->reason == channel::RefusalReason::UnknownPeer && !m_unknownAgents.note(now, refused->path))
            return; // it was told
    }
    std::visit([this](const auto &value) { notify(value); }, event);
}

void StationCore::noteUp(const channel::SessionUp &up)
{
    SessionWatch &watch = m_sessionWatches[up.session];
    watch.peer = up.peer;
    watch.peerName = up.peerName;
    for (auto &[systemId, vehicle] : m_vehicleWatches) {
        if (!vehicle.ended || vehicle.ended->peer != up.peer)
            continue;
        vehicle.session = up.session; // its agent is back
        vehicle.ended.reset();
    }
}

void StationCore::noteDown(TimePoint now, const channel::SessionDown &down)
{
    const auto found = m_sessionWatches.find(down.session);
    if (found == m_sessionWatches.end())
        return;
    const SessionWatch gone = std::move(found->second);
    m_sessionWatches.erase(found);
    const auto next = std::ranges::find_if(m_sessionWatches, [&](const auto &watch) { return watch.second.peer == gone.peer; });
    for (auto &[systemId, vehicle] : m_vehicleWatches) {
        if (vehicle.session != down.session)
            continue;
        if (next != m_sessionWatches.end())
            vehicle.session = next->first; // its agent began anew
        else
            vehicle.ended = Ended{gone.peer, gone.peerName, down.reason, now};
    }
}

void StationCore::everyQuarterSecond(TimePoint now)
{
    m_nextQuarter = std::max(m_nextQuarter + MetricsSampler::kEvery, now);
    if (m_quarters++ % 4 == 0)
        everySecond(now);
    bool anyUp = false;
    for (auto &[systemId, watch] : m_vehicleWatches) {
        const metrics::SequenceCounts counts = m_sequences.countsOfSystem(systemId);
        watch.loss.note(counts.received - counts.duplicate, counts.lost);
        watch.frames.note(counts.received);
        const bool lost = m_vehicles.find(systemId)->isLost(now);
        anyUp = anyUp || (!lost && !watch.ended);
        if (lost != watch.lost) {
            watch.lost = lost;
            notify(lost ? Event(VehicleLost{systemId}) : Event(VehicleBack{systemId}));
        }
    }
    for (auto &[session, watch] : m_sessionWatches) {
        if (const auto stats = m_channel->endpoint().stats(session)) {
            watch.loss.note(stats->rx.good, stats->rx.lost);
            watch.peerLoss.note(stats->peerRx.good, stats->peerRx.lost);
        }
    }
    MetricsSampler::Reading reading{channelTotals(), mavlinkTotals(), anyUp};
    TimePoint heard = TimePoint::min();
    for (const auto &[systemId, vehicle] : m_vehicles.all()) {
        const vehicle::VehicleState &state = vehicle.current();
        if (state.lastMessage >= heard && !vehicle.isLost(now)) {
            heard = state.lastMessage;
            reading.latency = state.latency;
        }
    }
    m_links.forEach([&](const link::Link &link) {
        reading.rxBytes += link.counters().rxBytes;
        reading.txBytes += link.counters().txBytes;
    });
    m_sampler.sample(now, seconds(now - m_start), reading);
    m_changed = true;
}

void StationCore::everySecond(TimePoint now)
{
    m_routes.forgetSilent(now);
    m_pendingVehicles.forgetSilent(now);
    tellRefusals(now);
    keepSealedSystems();
    if (m_channel) {
        m_channel->roll(now);
        if (isSealing())
            noteUnanswering(now);
        if (isSealing() && (secureMode() == SecureMode::Required || m_policy.knowsAnybody()))
            greetRouters();
    }
    for (auto &[session, watch] : m_sessionWatches) {
        if (const auto stats = m_channel->endpoint().stats(session)) {
            watch.forged.note(stats->rx.forged);
            watch.replayed.note(stats->rx.replayed);
            watch.good.note(stats->rx.good);
        }
    }
    if (m_recorder) {
        if (const auto problem = m_recorder->takeProblem())
            notify(RecordingProblem{problem->file, problem->problem});
    }
}

void StationCore::noteUnanswering(TimePoint now)
{
    for (AgentUnanswering &news : m_unanswering.update(now, m_channel->endpoint().unanswered()))
        notify(std::move(news));
}

void StationCore::keepSealedSystems()
{
    if (!m_secrets || m_secrets->paths.peers.empty() || m_policy.sealedSystems() == m_secrets->sealedSystems)
        return;
    m_secrets->sealedSystems = m_policy.sealedSystems();
    const std::string file = sealedSystemsFile(m_secrets->paths);
    if (const auto written = writeSealedSystems(file, m_secrets->sealedSystems); !written)
        notify(RecordingProblem{file, written.error().message}); // in force for this run all the same
}

void StationCore::publish(TimePoint now)
{
    const Duration least = std::chrono::seconds(1) / std::clamp(m_config.snapshotsPerSecond, 1, 30);
    const bool first = m_lastSnapshot == TimePoint::min();
    if (!first && (now - m_lastSnapshot < least || (!m_changed && now - m_lastSnapshot < kSlowestSnapshots)))
        return;
    m_lastSnapshot = now;
    m_changed = false;
    m_sinks.snapshot(takeSnapshot(now));
}

} // namespace skyseal::engine
