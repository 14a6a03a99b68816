#include "tests/engine/bare_end.h"

#include "core/channel/endpoint.h"
#include "core/link/steady_now.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_scanner.h"

namespace skyseal::test {

namespace {

Path loopback(std::uint16_t port)
{
    Path path{LinkId{1}, {}};
    path.remote.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 127, 0, 0, 1};
    path.remote.port = port;
    return path;
}

} // namespace

Introduced::Introduced()
{
    crypto::SystemRandom random;
    ground = newIdentity(random);
    air = newIdentity(random);
}

std::unique_ptr<engine::SecretFiles> Introduced::secrets(channel::Role role) const
{
    const bool station = role == channel::Role::Station;
    auto out = std::make_unique<engine::SecretFiles>();
    out->identity = station ? ground : air;
    const channel::PublicKey &other = publicKeyOf(station ? *air : *ground);
    out->peers.push_back({other, station ? "air" : "ground", channel::PeerRole::Pilot, {}, {}});
    out->counters = std::make_unique<VolatileCounters>();
    return out;
}

BareEnd::BareEnd(const Introduced &keys, channel::Role role, channel::Policy policy, std::uint16_t groundPort)
    : BareEnd(keys.secrets(role), role, std::move(policy), groundPort)
{}

BareEnd::BareEnd(std::unique_ptr<engine::SecretFiles> secrets, channel::Role role, channel::Policy policy,
                 std::uint16_t groundPort)
    : m_secrets(std::move(secrets)), m_peerPort(groundPort)
{
    channel::Config config;
    config.role = role;
    config.identity = m_secrets->identity;
    config.peers = m_secrets->peers;
    config.policy = std::move(policy);
    if (role == channel::Role::Agent)
        config.announceTo.push_back(loopback(groundPort));
    m_endpoint = std::make_unique<channel::Endpoint>(std::move(config), m_secrets->random, *m_secrets->counters, steadyNow());
}

BareEnd::~BareEnd() = default;

channel::SessionInfo BareEnd::sessionInfo() const
{
    return *m_endpoint->sessionInfo(session());
}

void BareEnd::switchSuite(crypto::SuiteId suite)
{
    m_endpoint->switchSuite(steadyNow(), session(), suite);
}

void BareEnd::close()
{
    m_endpoint->close(steadyNow(), session());
}

std::size_t BareEnd::pump()
{
    std::size_t frames = 0;
    while (const std::size_t count = m_socket.receive()) {
        for (std::size_t i = 0; i < count; ++i) {
            // The peer has one address only; records say by their connection who sent them.
            m_peerPort = m_peerPort == 0 ? m_socket.senderPort(i) : m_peerPort;
            const auto delivery = m_endpoint->handleDatagram(steadyNow(), loopback(m_peerPort), m_socket.received(i));
            if (!delivery)
                continue;
            mavlink::FrameScanner scanner(delivery->frames, mavlink::Dialect::builtin());
            while (const auto item = scanner.next()) {
                frames += item->frame.has_value();
                if (frameReceived)
                    frameReceived(item->bytes);
            }
        }
        say();
    }
    if (steadyNow() >= m_endpoint->nextDeadline())
        m_endpoint->handleDeadline(steadyNow());
    say();
    return frames;
}

void BareEnd::say()
{
    while (const auto out = m_endpoint->pollTransmit()) {
        const std::array<ByteView, 1> one{out->bytes};
        m_socket.send(out->to.remote.port, one);
    }
    while (const auto event = m_endpoint->pollEvent()) {
        if (const auto *up = std::get_if<channel::SessionUp>(&*event))
            m_session = up->session;
    }
}

Bytes BareEnd::seal(ByteView frame)
{
    Bytes record(frame.size() + channel::kMaxRecordOverhead);
    record.resize(m_endpoint->seal(steadyNow(), session(), frame, record).value_or(0));
    return record;
}

ByteView BareEnd::open(TimePoint now, MutableByteView record)
{
    const auto delivery = m_endpoint->handleDatagram(now, loopback(m_peerPort), record);
    return delivery ? ByteView(delivery->frames) : ByteView();
}

void BareEnd::sendEach(std::span<const ByteView> frames)
{
    m_records.resize(std::max(m_records.size(), frames.size()));
    m_views.clear();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        m_records[i].resize(mavlink::kMaxFrameLength + channel::kMaxRecordOverhead);
        const auto size = m_endpoint->seal(steadyNow(), session(), frames[i], m_records[i]);
        m_views.push_back(ByteView(m_records[i]).first(size.value_or(0)));
    }
    m_socket.send(m_peerPort, m_views);
}

} // namespace skyseal::test
