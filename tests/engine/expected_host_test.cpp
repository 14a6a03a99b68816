// An agent whose configuration names a station's host, under a flood from many hosts that answer its cookies: the station at
// that host gets its session before any of them. Covers the whole path from the configuration on, over real sockets;
// channel_attack_cookie_test tests the limit itself with addresses.
#include "core/channel/cookie.h"
#include "core/channel/handshake_messages.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/agent/agent_core.h"
#include "tests/engine/bare_end.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>
#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// One of the flooding hosts, 127.1.0.x. It knows the agent's public key and returns the cookies that it receives.
class FloodingHost
{
public:
    FloodingHost(unsigned number, std::uint16_t agentPort, const channel::PublicKey &agent)
        : m_agentPort(agentPort), m_agent(agent), m_mac(agent)
    {
        if (!m_socket.bind(QHostAddress(0x7f010000u + number), 0))
            qFatal("cannot bind 127.1.0.%u", number);
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { take(); });
    }
    void sendOne()
    {
        channel::FirstMessage message;
        m_random.fill(message);
        message[0] = channel::firstByte(channel::HandshakeMessage::First);
        m_mac.sign(message);
        if (m_cookie)
            channel::signWithCookie(*m_cookie, message);
        else
            m_asked = message;
        m_socket.writeDatagram(reinterpret_cast<const char *>(message.data()), static_cast<qint64>(message.size()),
                               QHostAddress::LocalHost, m_agentPort);
    }
    bool hasCookie() const { return m_cookie.has_value(); }

private:
    void take()
    {
        while (m_socket.hasPendingDatagrams()) {
            const QByteArray data = m_socket.receiveDatagram().data();
            const ByteView bytes(reinterpret_cast<const std::uint8_t *>(data.constData()),
                                 static_cast<std::size_t>(data.size()));
            if (const auto cookie = channel::openCookie(m_agent, ByteView(m_asked).last(channel::kMacLength), bytes))
                m_cookie = cookie;
        }
    }

    QUdpSocket m_socket;
    std::uint16_t m_agentPort;
    channel::PublicKey m_agent;
    channel::Mac1 m_mac;
    channel::FirstMessage m_asked{};
    std::optional<channel::Cookie> m_cookie;
    crypto::SystemRandom m_random;
};

} // namespace

class ExpectedHostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationAtTheNamedHostComesFirst();
};

void ExpectedHostTest::stationAtTheNamedHostComesFirst()
{
    QVERIFY(crypto::initCrypto());
    Introduced keys;
    BareEnd station(keys, channel::Role::Station, {channel::defaultSuites(), false, false});
    bool agentUp = false, floodTold = false;
    engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"),
                               {{urlOf("udpout:localhost:" + std::to_string(station.port()))}},
                               {channel::defaultSuites(), false, false},
                               false};
    engine::AgentCore agent(std::move(config), keys.secrets(channel::Role::Agent), [&](const engine::AgentEvent &event) {
        const auto *happened = std::get_if<channel::Event>(&event);
        agentUp = agentUp || (happened && std::holds_alternative<channel::SessionUp>(*happened));
        const auto *refused = happened ? std::get_if<channel::HandshakeRefused>(happened) : nullptr;
        floodTold = floodTold || (refused && refused->reason == channel::RefusalReason::Flood);
    });
    agent.start();
    EVENTUALLY_EQUAL(int(agent.snapshot().grounds.at(0).phase), int(engine::LinkPhase::Connected));
    const std::uint16_t port = portOf(agent.snapshot().grounds.at(0).localAddress);

    // Each host has a share of two a second; sixty hosts exceed the total of fifty.
    std::vector<std::unique_ptr<FloodingHost>> hosts;
    for (unsigned i = 1; i <= 60; ++i)
        hosts.push_back(std::make_unique<FloodingHost>(i, port, publicKeyOf(*keys.air)));
    QTimer flood;
    std::size_t next = 0;
    connect(&flood, &QTimer::timeout, this, [&] {
        for (int i = 0; i < 5; ++i)
            hosts[next++ % hosts.size()]->sendOne();
    });
    flood.start(1);
    const auto allHaveCookies = [&] {
        return std::all_of(hosts.begin(), hosts.end(), [](const auto &host) { return host->hasCookie(); });
    };
    EVENTUALLY(allHaveCookies() && floodTold);
    const std::size_t exhausted = next + 1500; // by then the initial shares are used up
    EVENTUALLY(next >= exhausted);

    // Counted in messages of the flood, which slows down with the machine: these take 3 s at full pace. Without a share of its
    // own the station's attempts would have to find one of the few that the flood leaves.
    QVERIFY(eventually([&] { return station.pump(), station.up() && agentUp; }));
    qInfo("the station's session is up beside %zu messages of the flood", next - exhausted);
    QVERIFY(next - exhausted < 15'000);
}

SKYSEAL_TEST(ExpectedHostTest)
#include "expected_host_test.moc"
