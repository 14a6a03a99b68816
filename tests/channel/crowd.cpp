#include "crowd.h"

#include "core/channel/endpoint.h"
#include "core/channel/record.h"

#include <cstring>

namespace skyseal::test {

namespace {

constexpr std::uint8_t kAnnouncement = 0x58;
constexpr Duration kStep = std::chrono::milliseconds(10);

Path pathOfAir()
{
    Path path{LinkId{1}, {}};
    path.remote.ip[15] = 100;
    path.remote.port = 40000;
    return path;
}

} // namespace

struct Crowd::End
{
    Config config(Role role) const
    {
        Config out;
        out.role = role;
        out.identity = identity;
        out.policy = {defaultSuites(), false, false};
        return out;
    }

    std::shared_ptr<const crypto::X25519KeyPair> identity;
    std::unique_ptr<Endpoint> endpoint;
    MemoryCounterStore counters;
    std::vector<Event> events;
    std::uint16_t port = 14550;
    std::optional<std::vector<Bytes>> held;
};

Crowd::Crowd(std::size_t stations) : m_air(std::make_unique<End>()), m_stations(stations)
{
    m_air->identity = newIdentity(m_random);
    for (End &station : m_stations)
        station.identity = newIdentity(m_random);
    Config config = m_air->config(Role::Agent);
    for (const End &station : m_stations)
        config.peers.push_back({publicKeyOf(*station.identity), "station", PeerRole::Observer, {}, {}});
    config.announceTo.push_back(Path{LinkId{1}, {}});
    m_air->endpoint = std::make_unique<Endpoint>(std::move(config), m_random, m_air->counters, m_now);
}

Crowd::~Crowd() = default;

void Crowd::start(std::size_t station)
{
    End &end = m_stations[station];
    Config config = end.config(Role::Station);
    config.peers.push_back({publicKeyOf(*m_air->identity), "air", PeerRole::Pilot, {}, {}});
    end.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, end.counters, m_now);
}

void Crowd::move(std::size_t station)
{
    ++m_stations[station].port;
}

void Crowd::kill(std::size_t station)
{
    m_stations[station].endpoint.reset();
}

bool Crowd::up(std::size_t station) const
{
    return m_stations[station].endpoint && !m_stations[station].endpoint->sessions().empty();
}

std::vector<Event> &Crowd::events(std::size_t station)
{
    return m_stations[station].events;
}

void Crowd::hold(std::size_t station)
{
    m_stations[station].held.emplace();
}

void Crowd::release(std::size_t station)
{
    const std::vector<Bytes> held = std::move(*m_stations[station].held);
    m_stations[station].held.reset();
    for (const Bytes &bytes : held)
        arrive(station, bytes);
}

bool Crowd::run(Duration span, const std::function<bool()> &until)
{
    for (const TimePoint end = m_now + span; m_now < end; m_now += kStep) {
        if (until && until())
            return true;
        sendFrames();
        step();
    }
    return until && until();
}

int Crowd::announcementsIn(Duration span)
{
    m_announcements = 0;
    run(span);
    return m_announcements;
}

Path Crowd::pathOf(std::size_t station) const
{
    Path path{LinkId{1}, {}};
    path.remote.ip[15] = static_cast<std::uint8_t>(station + 1);
    path.remote.port = m_stations[station].port;
    return path;
}

void Crowd::step()
{
    std::vector<std::pair<Path, Bytes>> down;
    std::vector<std::pair<std::size_t, Bytes>> up;
    m_air->endpoint->handleDeadline(m_now);
    while (const auto transmit = m_air->endpoint->pollTransmit()) {
        down.emplace_back(transmit->to, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
        m_announcements += transmit->bytes[0] == kAnnouncement;
    }
    while (auto event = m_air->endpoint->pollEvent())
        m_air->events.push_back(std::move(*event));
    for (std::size_t i = 0; i < m_stations.size(); ++i) {
        End &station = m_stations[i];
        if (!station.endpoint)
            continue;
        station.endpoint->handleDeadline(m_now);
        for (auto &[to, bytes] : down) {
            Bytes copy = bytes;
            if (to.remote == Address{} || to == pathOf(i))
                station.endpoint->handleDatagram(m_now, pathOfAir(), copy);
        }
        while (const auto transmit = station.endpoint->pollTransmit())
            up.emplace_back(i, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
        while (auto event = station.endpoint->pollEvent())
            station.events.push_back(std::move(*event));
    }
    for (const auto &[from, bytes] : up) {
        if (auto &held = m_stations[from].held)
            held->push_back(bytes);
        else
            arrive(from, bytes);
    }
}

void Crowd::sendFrames()
{
    if (m_interval == Duration::zero() || m_now < m_nextFrames)
        return;
    m_nextFrames = m_now + m_interval;
    for (std::size_t i = 0; i < m_stations.size(); ++i) {
        if (!up(i))
            continue;
        Bytes frame(28, 0xfd);
        std::memcpy(frame.data() + 1, &m_now, sizeof m_now);
        Bytes record(frame.size() + kMaxRecordOverhead + kRecordHeaderLength);
        Endpoint &endpoint = *m_stations[i].endpoint;
        const auto size = endpoint.seal(m_now, endpoint.sessions().back(), frame, record);
        record.resize(size.value_or(0));
        if (auto &held = m_stations[i].held)
            held->push_back(record);
        else
            arrive(i, record);
    }
}

void Crowd::arrive(std::size_t station, Bytes bytes)
{
    const auto delivery = m_air->endpoint->handleDatagram(m_now, pathOf(station), bytes);
    if (!delivery)
        return;
    TimePoint sent;
    std::memcpy(&sent, delivery->frames.data() + 1, sizeof sent);
    heard.push_back({station, m_now - sent, delivery->freshness});
}

} // namespace skyseal::test
