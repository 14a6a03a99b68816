// One agent and several stations on one link, with a simulated clock.
#pragma once

#include "core/crypto/x25519.h"
#include "core/channel/record.h"
#include "pair.h"

#include <cstring>

namespace skyseal::test {

inline constexpr std::uint8_t kAnnouncement = 0x58;
inline constexpr Duration kStep = std::chrono::milliseconds(10);

/// One agent and several stations. Each station receives what is sent to no address; nothing is lost, and every datagram takes
/// one step, unless it is held back.
class Crowd
{
public:
    explicit Crowd(std::size_t stations)
    {
        m_air.identity = newIdentity();
        for (std::size_t i = 0; i < stations; ++i)
            m_stations.emplace_back().identity = newIdentity();
        Config config = configOf(Role::Agent, m_air);
        for (const End &station : m_stations)
            config.peers.push_back({station.identity->publicKey, "station", PeerRole::Observer, {}, {}});
        config.announceTo.push_back(Path{LinkId{1}, {}});
        m_air.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, m_air.counters, m_now);
    }
    void start(std::size_t station)
    {
        End &end = m_stations[station];
        Config config = configOf(Role::Station, end);
        config.peers.push_back({m_air.identity->publicKey, "air", PeerRole::Pilot, {}, {}});
        end.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, end.counters, m_now);
    }
    /// The station uses another port from its next start on.
    void move(std::size_t station) { ++m_stations[station].port; }
    void kill(std::size_t station) { m_stations[station].endpoint.reset(); }
    bool up(std::size_t station) const
    {
        return m_stations[station].endpoint && !m_stations[station].endpoint->sessions().empty();
    }
    std::vector<Event> &events(std::size_t station) { return m_stations[station].events; }

    /// Each station sends a frame at this interval from now on.
    void sendEvery(Duration interval) { m_interval = interval; }
    /// Holds back what this station sends, until release().
    void hold(std::size_t station) { m_stations[station].held.emplace(); }
    /// Delivers what was held back at once.
    void release(std::size_t station)
    {
        const std::vector<Bytes> held = std::move(*m_stations[station].held);
        m_stations[station].held.reset();
        for (const Bytes &bytes : held)
            arrive(station, bytes);
    }
    /// A frame that came out at the agent.
    struct Heard
    {
        std::size_t station = 0;
        Duration age{};
        Freshness freshness{};
    };
    std::vector<Heard> heard;

    bool run(Duration span, const std::function<bool()> &until = {})
    {
        for (const TimePoint end = m_now + span; m_now < end; m_now += kStep) {
            if (until && until())
                return true;
            sendFrames();
            step();
        }
        return until && until();
    }
    /// Counts the announcements during `span`.
    int announcementsIn(Duration span)
    {
        m_announcements = 0;
        run(span);
        return m_announcements;
    }

private:
    struct End
    {
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        std::unique_ptr<Endpoint> endpoint;
        MemoryCounterStore counters;
        std::vector<Event> events;
        std::uint16_t port = 14550;
        std::optional<std::vector<Bytes>> held;
    };

    std::shared_ptr<const crypto::X25519KeyPair> newIdentity()
    {
        return std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
    }
    static Config configOf(Role role, const End &end)
    {
        Config config;
        config.role = role;
        config.identity = end.identity;
        config.policy = {defaultSuites(), false, false};
        return config;
    }
    Path pathOf(std::size_t station) const
    {
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = static_cast<std::uint8_t>(station + 1);
        path.remote.port = m_stations[station].port;
        return path;
    }
    static Path pathOfAir()
    {
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = 100;
        path.remote.port = 40000;
        return path;
    }
    void step()
    {
        std::vector<std::pair<Path, Bytes>> down;
        std::vector<std::pair<std::size_t, Bytes>> up;
        m_air.endpoint->handleDeadline(m_now);
        while (const auto transmit = m_air.endpoint->pollTransmit()) {
            down.emplace_back(transmit->to, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
            m_announcements += transmit->bytes[0] == kAnnouncement;
        }
        while (auto event = m_air.endpoint->pollEvent())
            m_air.events.push_back(std::move(*event));
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
    void sendFrames()
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
    void arrive(std::size_t station, Bytes bytes)
    {
        const auto delivery = m_air.endpoint->handleDatagram(m_now, pathOf(station), bytes);
        if (!delivery)
            return;
        TimePoint sent;
        std::memcpy(&sent, delivery->frames.data() + 1, sizeof sent);
        heard.push_back({station, m_now - sent, delivery->freshness});
    }

    SeededRandom m_random{20261121};
    TimePoint m_now{std::chrono::hours(1)};
    End m_air;
    std::vector<End> m_stations;
    Duration m_interval{};
    TimePoint m_nextFrames{};
    int m_announcements = 0;
};

} // namespace skyseal::test
