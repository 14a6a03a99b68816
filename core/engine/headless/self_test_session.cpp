// Two endpoints in this process: they perform a handshake, carry a frame in each direction under every suite, and reject
// records that were modified.
#include "core/crypto/x25519.h"
#include "core/engine/headless/self_test.h"

#include "core/channel/endpoint.h"
#include "core/crypto/system_random.h"

#include <algorithm>
#include <array>

namespace skyseal::engine {

namespace {

using namespace channel;

class CountersInMemory final : public CounterStore
{
public:
    std::optional<std::uint64_t> next() override { return ++m_next; }
    std::uint64_t lastSeen(const PublicKey &) override { return m_seen; }
    bool remember(const PublicKey &, std::uint64_t counter) override
    {
        m_seen = counter;
        return true;
    }

private:
    std::uint64_t m_next = 0, m_seen = 0;
};

class TwoEnds
{
public:
    TwoEnds()
    {
        auto ground = std::make_shared<const crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
        auto air = std::make_shared<const crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
        m_ground = std::make_unique<Endpoint>(config(Role::Station, ground, air->publicKey), m_random, m_groundCounters, m_now);
        m_air = std::make_unique<Endpoint>(config(Role::Agent, air, ground->publicKey), m_random, m_airCounters, m_now);
    }

    /// Advances the clock in steps of a millisecond until `reached` returns true; returns false if it never does.
    template<typename F> bool runUntil(F &&reached)
    {
        for (int step = 0; step < 3000; ++step) {
            carry(*m_air, *m_ground, kAirPath);
            carry(*m_ground, *m_air, kGroundPath);
            drain(*m_air);
            drain(*m_ground);
            if (reached())
                return true;
            m_now += std::chrono::milliseconds(1);
            m_ground->handleDeadline(m_now);
            m_air->handleDeadline(m_now);
        }
        return false;
    }

    bool up() const { return !m_ground->sessions().empty() && !m_air->sessions().empty(); }
    crypto::SuiteId suite() const { return m_ground->sessionInfo(m_ground->sessions().front())->suite; }
    void switchTo(crypto::SuiteId suite) { m_ground->switchSuite(m_now, m_ground->sessions().front(), suite); }

    bool carriesBothWays() { return carries(*m_ground, *m_air, kGroundPath) && carries(*m_air, *m_ground, kAirPath); }
    bool refusesChanges()
    {
        Bytes record = seal(*m_air);
        record[record.size() / 2] ^= 1;
        return !m_ground->handleDatagram(m_now, kAirPath, record);
    }

private:
    static constexpr Path kAirPath{LinkId{1}, {{}, 1}};
    static constexpr Path kGroundPath{LinkId{1}, {{}, 2}};
    static constexpr std::array<std::uint8_t, 21> kFrame{0xfd, 9, 0,   0,   1,  15,  27, 0, 0,  0,  34,
                                                         30,   7, 105, 242, 55, 146, 91, 3, 82, 250};

    static Config config(Role role, std::shared_ptr<const crypto::X25519KeyPair> own, const PublicKey &other)
    {
        Config out;
        out.role = role;
        out.identity = std::move(own);
        Peer peer;
        peer.key = other;
        peer.name = "other end";
        out.peers = {peer};
        out.policy = {defaultSuites(), true, false};
        if (role == Role::Agent)
            out.announceTo = {kGroundPath};
        return out;
    }

    void carry(Endpoint &from, Endpoint &to, const Path &path)
    {
        while (const auto out = from.pollTransmit()) {
            Bytes datagram(out->bytes.begin(), out->bytes.end());
            to.handleDatagram(m_now, path, datagram);
        }
    }

    static void drain(Endpoint &endpoint)
    {
        while (endpoint.pollEvent()) {}
    }

    Bytes seal(Endpoint &from)
    {
        Bytes out(kFrame.size() + kMaxRecordOverhead);
        out.resize(from.seal(m_now, from.sessions().front(), kFrame, out).value_or(0));
        return out;
    }

    bool carries(Endpoint &from, Endpoint &to, const Path &path)
    {
        Bytes record = seal(from);
        const auto delivery = record.empty() ? std::nullopt : to.handleDatagram(m_now, path, record);
        if (!delivery || !std::equal(delivery->frames.begin(), delivery->frames.end(), kFrame.begin(), kFrame.end()))
            return false;
        Bytes again = record; // a record is not accepted twice
        return !to.handleDatagram(m_now, path, again);
    }

    TimePoint m_now{std::chrono::seconds(1)};
    crypto::SystemRandom m_random;
    CountersInMemory m_groundCounters, m_airCounters;
    std::unique_ptr<Endpoint> m_ground, m_air;
};

std::optional<std::string> checkSession()
{
    TwoEnds ends;
    if (!ends.runUntil([&] { return ends.up(); }))
        return "no session comes up";
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (!info.authenticated || !crypto::suiteAvailable(info.id)) // reported by the test of the suite
            continue;
        if (info.id != ends.suite()) {
            ends.switchTo(info.id);
            if (!ends.runUntil([&] { return ends.suite() == info.id; }))
                return "no switch to " + std::string(info.name);
        }
        if (!ends.carriesBothWays())
            return "frames do not arrive under " + std::string(info.name);
        if (!ends.refusesChanges())
            return "a changed record is taken under " + std::string(info.name);
    }
    return std::nullopt;
}

} // namespace

std::vector<SelfTest> sessionSelfTests()
{
    return {{"session and live switch", checkSession}};
}

} // namespace skyseal::engine
