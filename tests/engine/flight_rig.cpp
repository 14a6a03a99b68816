#include "tests/engine/flight_rig.h"

#include "core/crypto/init_crypto.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/engine/station/snapshot.h"
#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"
#include "core/link/make_link.h"
#include "core/mavlink/stream_parser.h"

namespace skyseal::test {

namespace {

sim::SimulatedVehicleConfig vehicleConfig(std::uint8_t systemId)
{
    sim::SimulatedVehicleConfig config;
    config.systemId = systemId;
    return config;
}

keys::PeerEntry entryOf(const std::string &name, const crypto::PublicKey &key, channel::PeerRole role,
                        std::vector<std::uint8_t> systemIds)
{
    keys::PeerEntry entry;
    entry.peer.key = key;
    entry.peer.name = name;
    entry.peer.role = role;
    entry.peer.systemIds = std::move(systemIds);
    return entry;
}

/// Adds the entry to the list in the file.
void add(keys::PeersFile peers, keys::PeerEntry entry, const std::string &file)
{
    if (!peers.add(std::move(entry)) || !peers.save(file))
        qFatal("cannot write %s", file.c_str());
}

} // namespace

VehicleOnUdp::VehicleOnUdp(const std::string &target, std::uint8_t systemId)
    : vehicle(vehicleConfig(systemId), steadyNow()), m_link(link::makeLink(urlOf("udpout:" + target), LinkId{1}, *this))
{
    m_link->open();
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { advance(); });
    m_timer.start(5);
}

void VehicleOnUdp::linkReceived(link::Link &, std::span<const link::ReceivedBlock> blocks)
{
    for (const link::ReceivedBlock &block : blocks) {
        mavlink::FrameScanner scanner(block.bytes, mavlink::Dialect::builtin());
        while (const auto item = scanner.next()) {
            if (item->frame)
                vehicle.handleFrame(block.time, *item->frame);
        }
    }
    advance();
}

void VehicleOnUdp::advance()
{
    vehicle.advance(steadyNow());
    for (ByteView frame = vehicle.pollFrame(); !frame.empty(); frame = vehicle.pollFrame()) {
        m_link->send({}, frame);
        ++sent;
    }
    m_link->flush();
}

FlightRig::FlightRig(channel::PeerRole stationRole, std::vector<std::uint8_t> pinned, std::vector<std::uint8_t> stationSystems)
    : m_stationRole(stationRole), m_stationSystems(std::move(stationSystems))
{
    if (!crypto::initCrypto())
        qFatal("no randomness");
    crypto::SystemRandom random;
    const auto ground = keys::writeNewIdentity(file("ground.key"), random);
    const auto air = keys::writeNewIdentity(file("air.key"), random);
    if (!ground || !air)
        qFatal("cannot write keys");
    add({}, entryOf("air-1", *air, channel::PeerRole::Pilot, std::move(pinned)), file("ground.peers"));
    m_airKey = *air;
    m_groundKey = *ground;
    introduceStation(true);
}

FlightRig::~FlightRig() = default;

void FlightRig::introduceStation(bool known)
{
    // Otherwise the list holds another key.
    crypto::PublicKey key = m_groundKey;
    key[0] ^= known ? 0 : 1;
    add({}, entryOf("ground", key, m_stationRole, m_stationSystems), file("air.peers"));
}

std::vector<channel::Peer> FlightRig::peersOfAgent() const
{
    const auto known = keys::PeersFile::load(file("air.peers"));
    if (!known)
        qFatal("%s", known.error().text().c_str());
    std::vector<channel::Peer> out;
    for (const keys::PeerEntry &entry : known->entries())
        out.push_back(entry.peer);
    return out;
}

engine::StationConfig FlightRig::addStation(const std::string &name, channel::PeerRole role)
{
    crypto::SystemRandom random;
    const auto identity = keys::writeNewIdentity(file(name + ".key"), random);
    auto known = keys::PeersFile::load(file("air.peers"));
    if (!identity || !known)
        qFatal("cannot add a station");
    add(std::move(*known), entryOf(name, *identity, role, {}), file("air.peers"));
    add({}, entryOf("air-1", m_airKey, channel::PeerRole::Pilot, {}), file(name + ".peers"));
    return configOf(name, engine::SecureMode::Required);
}

engine::StationConfig FlightRig::stationConfig(engine::SecureMode mode) const
{
    return configOf("ground", mode);
}

engine::StationConfig FlightRig::configOf(const std::string &station, engine::SecureMode mode) const
{
    engine::StationConfig config;
    config.secure = mode;
    if (mode != engine::SecureMode::Off)
        config.keys = {file(station + ".key"), file(station + ".peers")};
    config.policy.suites = channel::defaultSuites();
    config.policy.allowResearch = true;
    config.record = false;
    return config;
}

void FlightRig::startAgentAt(const std::vector<std::string> &grounds)
{
    std::vector<link::LinkUrl> urls;
    for (const std::string &ground : grounds)
        urls.push_back(urlOf("udpout:" + ground));
    startAgentOn(urls);
}

void FlightRig::startAgentOn(const std::vector<link::LinkUrl> &grounds)
{
    auto secrets = engine::readSecretFiles({file("air.key"), file("air.peers")});
    if (!secrets)
        qFatal("%s", secrets.error().text().c_str());
    engine::AgentConfig config{
        urlOf("udpin:127.0.0.1:" + m_vehiclePort), {}, {channel::defaultSuites(), true, allowPlain}, allowPlain};
    for (const link::LinkUrl &ground : grounds)
        config.grounds.push_back({ground, carrier});
    agent = std::make_unique<engine::AgentCore>(
        std::move(config), std::move(*secrets), [this](const engine::AgentEvent &event) { agentEvents.push_back(event); },
        std::move(signing));
    agent->start();
    // While no agent runs, another program may take the port of before.
    if (const std::string problem = agent->snapshot().vehicle.problem.text(); !problem.empty())
        qFatal("%s", problem.c_str());
    m_vehiclePort = std::to_string(portOf(vehicleAddress()));
}

std::string FlightRig::vehicleAddress()
{
    return agent->snapshot().vehicle.localAddress;
}

StationEars::StationEars(engine::Station &station)
{
    QObject::connect(&station, &engine::Station::snapshotReady, &m_context,
                     [this](const std::shared_ptr<const engine::Snapshot> &taken) { snapshot = taken; });
    QObject::connect(&station, &engine::Station::eventOccurred, &m_context,
                     [this](const engine::Event &event) { events.push_back(event); });
}

std::string StationEars::listening() const
{
    for (const engine::LinkChanged &changed : all<engine::LinkChanged>()) {
        if (changed.link.phase == engine::LinkPhase::Listening)
            return changed.link.localAddress;
    }
    return {};
}

} // namespace skyseal::test
