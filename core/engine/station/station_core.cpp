#include "core/engine/station/station_core.h"

#include "core/channel/endpoint.h"
#include "core/engine/station/recording_link_events.h"
#include "core/engine/station/snapshot.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/metrics/process_usage.h"
#include "core/vehicle/reasons.h"
#include "core/vehicle/request_failure.h"

#include <algorithm>

namespace skyseal::engine {

StationCore::StationCore(StationConfig config, std::unique_ptr<SecretFiles> secrets, StationSinks sinks)
    : m_config(std::move(config)), m_sinks(std::move(sinks)),
      m_settings(m_config.secure, m_config.policy, m_config.preferredSuite), m_secrets(std::move(secrets)),
      m_links(*this, [this](link::Link &link) { linkChanged(link); }),
      m_ingress(mavlink::Dialect::builtin(), m_links.carriers()), m_fleet(m_config),
      m_sender({m_config.systemId, m_config.componentId}, m_links, m_ingress),
      m_receiver({m_config.systemId, m_config.componentId},
                 {m_links, m_ingress, m_fleet, m_sender.routes(), m_settings,
                  [this](Event event) { m_events.publish(steadyNow(), std::move(event)); }, *this}),
      m_pace(m_config.snapshotsPerSecond), m_events(m_sinks.event), m_clock{steadyNow()}, m_timer([this] { handleDeadline(); })
{
    if (m_secrets && m_config.secure != SecureMode::Off) {
        m_receiver.gate().policy().setPeers(m_secrets->peers);
        m_receiver.gate().policy().rememberSealed(m_secrets->sealedSystems);
        m_links.carriers().setNode({m_config.systemId, m_config.componentId});
        m_channel = std::make_unique<StationChannel>(m_clock.start, m_settings.policy(), *m_secrets, m_links,
                                                     [this](const channel::PairingEvent &event) {
                                                         if (m_sinks.pairing)
                                                             m_sinks.pairing(event);
                                                     });
        m_sender.setChannel(m_channel.get(), isSealing());
        m_receiver.setChannel(m_channel.get());
    }
    setRecording(m_config.record);
}

StationCore::~StationCore() = default;

void StationCore::addLink(LinkId id, const link::LinkUrl &url)
{
    m_receiver.addLink(id, url.traits());
    m_links.open(id, url);
    finishWake();
}

void StationCore::addMavsecLink(LinkId id, const link::LinkUrl &url, crypto::MavsecCipher cipher)
{
    m_receiver.addMavsecLink(id, url.traits(), std::move(cipher));
    m_links.open(id, url, LinkUse::ListenOnly);
    finishWake();
}

void StationCore::removeLink(LinkId id)
{
    m_links.remove(id);
    m_receiver.removeLink(id);
    m_sender.routes().removeLink(id);
    m_pace.markChanged();
    finishWake();
}

void StationCore::serve(std::vector<ServeConfig> served)
{
    if (m_gateway)
        m_gateway->close();
    m_gateway.reset();
    if (!served.empty())
        m_gateway = std::make_unique<Gateway>(
            std::move(served), static_cast<Gateway::Vehicles &>(*this), [this](GatewayEvent event) {
                std::visit([this](auto &&value) { m_sinks.event(std::forward<decltype(value)>(value)); }, std::move(event));
                m_pace.markChanged();
            });
    m_receiver.setGateway(m_gateway.get());
    if (m_gateway)
        m_gateway->open();
    m_pace.markChanged();
    finishWake();
}

void StationCore::setFeed(std::shared_ptr<Feed> feed)
{
    m_feed = std::move(feed);
    m_receiver.setFeed(m_feed.get());
}

void StationCore::forward(TimePoint now, std::uint8_t systemId, ByteView frame)
{
    m_sender.forward(now, systemId, frame, m_receiver.gate().policy());
}

void StationCore::switchSuite(channel::SessionId session, crypto::SuiteId suite)
{
    if (m_channel)
        m_channel->endpoint().switchSuite(steadyNow(), session, suite);
    finishWake();
}

void StationCore::setAllowResearch(bool allow)
{
    m_settings.setAllowResearch(allow);
    applyPolicy();
    finishWake();
}

void StationCore::setWeakestSuite(crypto::SuiteId weakest)
{
    m_settings.setWeakestSuite(weakest);
    applyPolicy();
    finishWake();
}

void StationCore::followLinks()
{
    m_links.forEach([this](link::Link &link) { m_sender.followLink(link, isClearAllowed()); });
}

void StationCore::applyPolicy()
{
    if (m_channel)
        m_channel->endpoint().setPolicy(steadyNow(), m_settings.policy());
}

void StationCore::setPeers(std::vector<channel::Peer> peers)
{
    m_receiver.gate().policy().setPeers(peers);
    m_sender.routes().forgetClear(); // routes that are still accepted are learned again soon
    followLinks();
    if (m_channel)
        m_channel->endpoint().setPeers(steadyNow(), std::move(peers));
    finishWake();
}

void StationCore::allowPlaintext(std::uint8_t systemId)
{
    m_receiver.gate().allowPlaintext(systemId);
    m_pace.markChanged();
    finishWake();
}

bool StationCore::openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase)
{
    if (!m_channel)
        return false;
    const TimePoint now = steadyNow();
    channel::PairingConfig config;
    config.role = channel::Role::Station;
    config.identity = m_secrets->identity;
    config.name = std::move(name);
    config.systemId = m_config.systemId;
    config.passphrase = std::move(passphrase);
    m_channel->pairing.open(now, std::move(config));
    callAgents(now); // a listening agent may be waiting for this station
    finishWake();
    return true;
}

void StationCore::confirmPairing(const channel::PublicKey &key)
{
    if (m_channel)
        m_channel->pairing.confirm(steadyNow(), key);
    finishWake();
}

void StationCore::refusePairing()
{
    if (m_channel)
        m_channel->pairing.refuse(steadyNow());
    finishWake();
}

void StationCore::cancelPairing()
{
    if (m_channel)
        m_channel->pairing.cancel(steadyNow(), channel::PairingEnd::Cancelled);
    finishWake();
}

void StationCore::perform(vehicle::RequestId id, std::uint8_t systemId, const vehicle::Request &request)
{
    if (vehicle::Vehicle *vehicle = m_fleet.find(systemId)) {
        vehicle->perform(steadyNow(), id, request);
        finishWake();
    } else {
        std::visit([this](auto &&failure) { m_sinks.event(std::forward<decltype(failure)>(failure)); },
                   vehicle::failureOf(id, systemId, request, vehicle::reasons::kNoVehicle(systemId)));
    }
}

void StationCore::resumeSuite(crypto::SuiteId suite)
{
    // A silent session may be replaced by a new one, which must then begin with the suite.
    const bool anyHeard = m_channel && m_channel->switchAll(steadyNow(), suite);
    m_settings.setNextSuite(anyHeard ? std::nullopt : std::optional(suite));
    finishWake();
}

void StationCore::setProtection(std::optional<Protection> protection)
{
    if (m_settings.setProtection(protection) && m_channel) {
        m_channel->goodbyes.set(steadyNow(), m_channel->driver.closeAll(steadyNow())); // under the policy still in force
        handleEvents(steadyNow(), {});
    }
    applyPolicy();
    m_receiver.gate().policy().setMode(m_settings.mode());
    m_sender.setSealing(isSealing());
    m_sender.routes().forgetClear();
    m_receiver.updateRules();
    followLinks();
    m_pace.markChanged();
    finishWake();
}

void StationCore::setMeasuring(bool measuring)
{
    m_measuring = measuring;
    if (m_channel)
        m_channel->driver.setMeasuring(measuring);
}

void StationCore::requestCosts(bool request)
{
    if (m_channel)
        m_channel->driver.endpoint().askCosts(request);
    finishWake();
}

void StationCore::requestProbe()
{
    if (!m_stopped)
        publishSnapshot(steadyNow(), true);
}

void StationCore::setRecording(bool recording)
{
    if (!recording)
        m_recorder.reset();
    else if (!m_recorder && !m_config.recordFolder.empty())
        m_recorder = startRecording(m_config.recordFolder, m_channel.get());
    m_sender.setRecorder(m_recorder.get());
    m_receiver.setRecorder(m_recorder.get());
    m_pace.markChanged();
}

std::shared_ptr<const Snapshot> StationCore::stop()
{
    saveSealedSystems(kNever);
    const std::shared_ptr<Snapshot> last = takeSnapshot(steadyNow());
    if (m_channel) {
        m_channel->driver.flushAll(steadyNow());
        for (const channel::SessionId session : m_channel->endpoint().sessions())
            m_channel->endpoint().close(steadyNow(), session);
        finishWake();
        const ChannelTotals totals = channelTotals(sources());
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
    if (m_gateway)
        m_gateway->close();
    setRecording(false);
    return last;
}

void StationCore::linkPeerJoined(link::Link &link, const Path &path)
{
    m_ingress.forget(path);
    if (!m_channel || m_stopped)
        return;
    m_channel->endpoint().handleStreamBegan(steadyNow(), link.id());
    finishWake();
}

void StationCore::linkPeerLeft(link::Link &, const Path &path)
{
    m_ingress.forget(path);
}

void StationCore::linkChanged(link::Link &link)
{
    m_sender.followLink(link, isClearAllowed());
    m_pace.markChanged();
    m_sinks.event(LinkChanged{m_links.snapshot(link)});
}

void StationCore::callAgents(TimePoint now)
{
    const bool mayCall = isSealing()
        && (m_settings.mode() == SecureMode::Required || m_receiver.gate().policy().knowsAnybody());
    const bool pairs = m_channel->pairing.isOpen();
    const auto isFlown = [this](const Path &path) { return m_sender.routes().hasVehicleInClear(path); };
    const auto lastCall = [this](const Path &path) { return m_channel->endpoint().lastCall(path); };
    CallPlaces::Update places = m_receiver.callPlaces().update(now, m_links, isFlown, lastCall);
    m_channel->endpoint().setCallAt(now, mayCall ? std::move(places.calls) : std::vector<Path>());
    m_channel->pairing.setCallTo(std::move(places.requests));
    if (mayCall || pairs)
        m_sender.greetRouters();
}

void StationCore::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    if (m_stopped)
        return;
    for (const link::ReceivedBlock &block : blocks)
        m_ingress.take(link, block);
    if (m_receiver.callPlaces().takeChanged() && m_channel)
        callAgents(steadyNow());
    m_pace.markChanged();
    finishWake();
}

void StationCore::finishWake()
{
    if (m_stopped)
        return;
    const TimePoint now = steadyNow();
    for (auto &[systemId, vehicle] : m_fleet.vehicles().all()) {
        const bool sealed = m_sender.sendOutgoing(now, systemId, vehicle) && !vehicle.isLost(now);
        Fleet::publishEvents(vehicle, sealed, m_sinks.event);
    }
    if (m_channel) {
        m_channel->driver.flush(now);
        handleEvents(now, {});
        m_channel->driver.flush(now); // datagrams caused by an event
        m_channel->pairing.flush();
    }
    m_links.flush();
    if (m_gateway)
        m_gateway->flush();
    if (m_pace.takeIfDue(now))
        publishSnapshot(now, false);
    m_timer.set(nextDeadline());
}

void StationCore::handleDeadline()
{
    const TimePoint now = steadyNow();
    if (isSealing() && now >= m_channel->endpoint().nextDeadline())
        m_channel->endpoint().handleDeadline(now);
    if (m_channel)
        m_channel->pairing.handleDeadline(now);
    if (now >= m_fleet.vehicles().nextDeadline())
        m_fleet.vehicles().handleDeadline(now);
    if (now >= m_clock.nextQuarter)
        everyQuarterSecond(now);
    m_events.publishDue(now);
    if (m_config.ownHeartbeat)
        m_sender.sendHeartbeats(now, m_receiver.gate().policy());
    finishWake();
}

TimePoint StationCore::nextDeadline() const
{
    TimePoint next = std::min({m_clock.nextQuarter, m_fleet.vehicles().nextDeadline(),
                               m_config.ownHeartbeat ? m_sender.nextHeartbeat() : kNever, m_pace.nextDeadline(),
                               m_events.nextDeadline()});
    if (isSealing())
        next = std::min({next, m_channel->endpoint().nextDeadline(), m_channel->driver.flushDue()});
    if (m_channel)
        next = std::min(next, m_channel->pairing.nextDeadline());
    return next;
}

void StationCore::handleEvents(TimePoint now, std::optional<channel::SessionId> speaking)
{
    while (const auto event = m_channel->driver.pollEvent(speaking))
        handleEvent(now, *event);
}

void StationCore::handleEvent(TimePoint now, const channel::Event &event)
{
    m_pace.markChanged();
    noteLinkEvent(m_recorder.get(), *m_channel, event);
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        handleSessionUp(now, *up);
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        handleSessionDown(now, *down);
    } else if (const auto *moved = std::get_if<channel::PeerMoved>(&event)) {
        m_receiver.gate().policy().sessionMoved(moved->session, moved->to);
    } else if (const auto *refused = std::get_if<channel::HandshakeRefused>(&event)) {
        if (refused->reason == channel::RefusalReason::UnknownPeer && !m_channel->unknownAgents.note(now, refused->path))
            return; // published a short while ago
    }
    std::visit([&](const auto &value) { m_events.publish(now, value); }, event);
}

void StationCore::handleSessionUp(TimePoint now, const channel::SessionUp &up)
{
    m_receiver.gate().sessionUp(up);
    m_sender.routes().ofSession(up.session);
    m_channel->sessions.sessionUp(up);
    m_fleet.watches().sessionUp(up);
    publishUnanswering(now);
    const auto suite = m_settings.takeFirstSuite();
    if (suite && *suite != up.suite)
        m_channel->endpoint().switchSuite(now, up.session, *suite);
}

void StationCore::handleSessionDown(TimePoint now, const channel::SessionDown &down)
{
    m_receiver.gate().sessionDown(down.session);
    m_sender.routes().sessionDown(down.session);
    if (const auto end = m_channel->sessions.sessionDown(now, down))
        m_fleet.watches().sessionDown(down.session, *end);
}

void StationCore::everyQuarterSecond(TimePoint now)
{
    m_clock.nextQuarter = std::max(m_clock.nextQuarter + MetricsSampler::kEvery, now);
    if (m_clock.quarters++ % 4 == 0)
        everySecond(now);
    const bool anyHeard = m_fleet.sample(now, m_sinks.event);
    if (m_channel)
        m_channel->sampleQuarter();
    m_pace.markChanged();
    if (!m_config.diagnostics)
        return;
    const Duration before = metrics::threadCpuTime();
    m_sampler.sample(now, seconds(now - m_clock.start), metricsReading(sources(), now, anyHeard));
    m_watchingCpu += metrics::threadCpuTime() - before;
}

void StationCore::everySecond(TimePoint now)
{
    m_sender.routes().forgetSilent(now);
    m_receiver.gate().forgetSilent(now);
    if (m_gateway)
        m_gateway->everySecond(now);
    m_receiver.gate().publishRefusals(now, [&](Event event) { m_events.publish(now, std::move(event)); });
    saveSealedSystems(now);
    if (m_secrets) {
        if (auto storage = m_storage.noteCounters(now, *m_secrets))
            m_sinks.event(std::move(*storage));
    }
    if (m_channel) {
        m_channel->driver.roll(now);
        if (isSealing())
            publishUnanswering(now);
        callAgents(now);
        m_channel->sampleSecond();
    }
    if (m_recorder) {
        if (const auto problem = m_recorder->takeProblem())
            m_sinks.event(RecordingProblem{problem->file, problem->problem});
    }
}

void StationCore::publishUnanswering(TimePoint now)
{
    for (AgentUnanswering &event : m_channel->updateUnanswering(now))
        m_events.publish(now, std::move(event));
}

void StationCore::saveSealedSystems(TimePoint now)
{
    const auto problem = m_secrets ? m_storage.saveSystems(now, *m_secrets, m_receiver.gate().policy().sealedSystems())
                                   : std::nullopt;
    if (problem)
        m_sinks.event(*problem);
}

SnapshotSources StationCore::sources()
{
    return {m_links,         m_channel.get(), m_receiver.datagrams(),     m_receiver.gate(),
            m_fleet,         m_sampler,       m_recorder.get(),           m_watchingCpu,
            m_gateway.get(), m_feed.get(),    m_storage.countersProblem()};
}

/// Measures its own cost, which measurements and diagnostics state. Two readings of the clock are some hundred nanoseconds.
void StationCore::publishSnapshot(TimePoint now, bool withProbe)
{
    const Duration before = metrics::threadCpuTime();
    if (!withProbe)
        m_sinks.snapshot(takeSnapshot(now));
    else if (m_sinks.probed)
        m_sinks.probed(takeSnapshot(now, true));
    m_watchingCpu += metrics::threadCpuTime() - before;
}

std::shared_ptr<Snapshot> StationCore::takeSnapshot(TimePoint now, bool withProbe)
{
    auto out = buildSnapshot(sources(), now, withProbe);
    out->number = m_pace.takeNumber();
    out->time = seconds(now - m_clock.start);
    if (m_sinks.eventsDropped)
        out->eventsDropped = m_sinks.eventsDropped();
    return out;
}

} // namespace skyseal::engine
