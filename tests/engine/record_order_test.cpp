// Sealed messages leave in the order of their counters, whatever is sealed in one wake-up: frames in records and in place, and
// reports between them, for several sessions. Otherwise the other end counts records as late, and an agent refuses a command
// that was sealed in place once two reports have overtaken it. The clock is simulated; the sockets are real.
#include "core/channel/endpoint.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/common/channel_driver.h"
#include "core/engine/common/dialect_traits.h"
#include "core/engine/common/totals.h"
#include "core/mavlink/frame_reader.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/bare_end.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;
using engine::ChannelDriver;

namespace {

struct HubListener final : link::LinkListener
{
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
};

/// The driver of an agent with a session to each of several stations. Each of these prefers frames sealed in place and allows
/// one suite only.
class Hub
{
public:
    explicit Hub(std::span<const SuiteId> suites) : m_links(m_nobody, [](link::Link &) {})
    {
        m_link = &m_links.open(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
        channel::Config agent = configOf(channel::Role::Agent, {channel::defaultSuites(), false, false, true});
        for (const SuiteId suite : suites) {
            auto &station = *m_stations.emplace_back(std::make_unique<Station>());
            channel::Config config = configOf(channel::Role::Station, {{suite}, false, false, true, true});
            config.peers.push_back({publicKeyOf(*agent.identity), "agent", {}, {}, {}});
            agent.peers.push_back({publicKeyOf(*config.identity), "station", {}, {}, {}});
            agent.announceTo.push_back(pathTo(station));
            station.endpoint.emplace(std::move(config), m_random, station.counters, now);
        }
        m_driver.emplace(channel::Endpoint(std::move(agent), m_random, m_counters, now), m_links);
    }

    bool connect()
    {
        const bool listens = eventually([this] { return m_link->state() == link::LinkState::Listening; });
        const auto settled = [this] {
            return sessions.size() == m_stations.size() && std::ranges::all_of(m_stations, [](const auto &station) {
                       return station->endpoint->sessions().size() == 1;
                   });
        };
        for (const TimePoint end = now + 5s; listens && now < end; now += 10ms)
            turn();
        return settled();
    }
    ChannelDriver &driver() { return *m_driver; }
    bool isInPlace(std::size_t session) const
    {
        return m_driver->endpoint().framing(sessions[session]) == channel::Framing::Inline;
    }
    /// Everything that is due now, in both directions.
    void turn()
    {
        handleDeadlines();
        send();
    }
    void handleDeadlines()
    {
        if (m_driver->endpoint().nextDeadline() <= now)
            m_driver->endpoint().handleDeadline(now);
    }
    /// The end of a wake-up, and what the stations answer.
    void send()
    {
        m_driver->flush(now);
        m_links.flush();
        isComplete = isComplete && eventually([this] { return hear() == m_link->counters().txBlocks; });
        for (const auto &station : m_stations)
            answer(*station);
        while (const auto event = m_driver->pollEvent()) {
            if (const auto *up = std::get_if<channel::SessionUp>(&*event))
                sessions.push_back(up->session);
        }
    }
    /// Of the records and frames of all sessions.
    channel::ReceiveCounters received() const
    {
        using engine::operator+=;
        channel::ReceiveCounters out;
        for (const auto &station : m_stations)
            out += station->endpoint->stats(station->endpoint->sessions().at(0))->rx;
        return out;
    }

    TimePoint now{1h};
    std::vector<channel::SessionId> sessions; ///< of the driver
    std::uint64_t frames = 0;                 ///< that arrived
    bool isComplete = true;                   ///< every datagram that was sent has arrived

private:
    struct Station
    {
        BareSocket socket;
        VolatileCounters counters;
        std::optional<channel::Endpoint> endpoint;
    };

    channel::Config configOf(channel::Role role, channel::Policy policy)
    {
        channel::Config out;
        out.role = role;
        out.identity = newIdentity(m_random);
        out.policy = std::move(policy);
        out.messageTraits = std::make_shared<engine::DialectTraits>(mavlink::Dialect::builtin());
        return out;
    }
    static Path pathTo(const Station &station)
    {
        Path path{LinkId{1}, {}};
        path.remote.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 127, 0, 0, 1};
        path.remote.port = station.socket.port();
        return path;
    }

    /// Returns the number of datagrams so far.
    std::uint64_t hear()
    {
        for (const auto &station : m_stations) {
            for (std::size_t count = station->socket.receive(), i = 0; i < count; ++i, ++m_heard)
                take(*station, station->socket.received(i));
        }
        return m_heard;
    }
    void take(Station &station, MutableByteView datagram)
    {
        const Path from{LinkId{1}, {}};
        if (channel::Endpoint::owns(datagram[0])) {
            if (const auto delivery = station.endpoint->handleDatagram(now, from, datagram))
                frames += countFrames(delivery->frames);
            return;
        }
        while (const std::size_t length = std::min(mavlink::frameLength(datagram), datagram.size())) {
            frames += station.endpoint->handleInlineFrame(now, from, datagram.first(length)).has_value();
            datagram = datagram.subspan(length);
        }
    }
    static std::uint64_t countFrames(ByteView bytes)
    {
        std::uint64_t out = 0;
        for (; !bytes.empty(); bytes = bytes.subspan(mavlink::frameLength(bytes)))
            ++out;
        return out;
    }
    void answer(Station &station)
    {
        if (station.endpoint->nextDeadline() <= now)
            station.endpoint->handleDeadline(now);
        while (const auto out = station.endpoint->pollTransmit()) {
            Bytes bytes(out->bytes.begin(), out->bytes.end());
            m_driver->receive(now, pathTo(station), bytes);
        }
        while (station.endpoint->pollEvent()) {}
    }

    crypto::SystemRandom m_random;
    HubListener m_nobody;
    engine::LinkPool m_links;
    link::Link *m_link = nullptr;
    std::vector<std::unique_ptr<Station>> m_stations;
    VolatileCounters m_counters;
    std::optional<ChannelDriver> m_driver;
    std::uint64_t m_heard = 0;
};

} // namespace

class RecordOrderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void reportBetweenFrames_data();
    void reportBetweenFrames();
};

void RecordOrderTest::reportBetweenFrames_data()
{
    QTest::addColumn<std::vector<SuiteId>>("suites");
    QTest::addColumn<std::vector<std::size_t>>("after");
    using Suites = std::vector<SuiteId>;
    using Order = std::vector<std::size_t>;
    const Suites inRecords{SuiteId::ChaCha20Poly1305}, inPlace{SuiteId::Aes256Ctr};
    const Suites bothInPlace{SuiteId::Aes256Ctr, SuiteId::ChaCha20};
    const Suites mixed{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Ctr}, mixedToo{SuiteId::Aes256Ctr, SuiteId::ChaCha20Poly1305};
    QTest::newRow("in records") << inRecords << Order{0};
    QTest::newRow("in place") << inPlace << Order{0};
    QTest::newRow("in place, nothing after the report") << inPlace << Order{};
    QTest::newRow("two sessions in place") << bothInPlace << Order{0, 1};
    QTest::newRow("two sessions in place, the second first") << bothInPlace << Order{1, 0};
    QTest::newRow("two sessions in place, only the first") << bothInPlace << Order{0};
    QTest::newRow("two sessions in place, nothing after the reports") << bothInPlace << Order{};
    QTest::newRow("records, in place") << mixed << Order{0, 1};
    QTest::newRow("records, in place, nothing after the reports") << mixed << Order{};
    QTest::newRow("in place, records") << mixedToo << Order{1, 0};
    QTest::newRow("in place, records, nothing after the reports") << mixedToo << Order{};
}

/// A frame for each session, then the reports that are due, then a frame for the sessions of `after`, in one wake-up.
void RecordOrderTest::reportBetweenFrames()
{
    QFETCH(std::vector<SuiteId>, suites);
    QFETCH(std::vector<std::size_t>, after);
    Hub hub(suites);
    QVERIFY(hub.connect());
    for (std::size_t i = 0; i < suites.size(); ++i)
        QCOMPARE(hub.isInPlace(i), suites[i] != SuiteId::ChaCha20Poly1305);
    mavlink::FrameWriter vehicle(1, 1);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const auto queue = [&](std::size_t session) {
        QVERIFY(hub.driver().queue(hub.now, hub.sessions[session], vehicle.write(mavlink::Attitude{.roll = 1}, buffer)));
    };
    constexpr std::uint64_t kRounds = 10;
    std::uint64_t reported = 0;
    hub.frames = 0;
    const channel::ReceiveCounters before = hub.received();
    while (reported < kRounds) {
        hub.now = std::max(hub.now, hub.driver().endpoint().nextDeadline());
        for (std::size_t i = 0; i < suites.size(); ++i)
            queue(i);
        hub.handleDeadlines();
        reported += hub.driver().endpoint().hasTransmit();
        for (const std::size_t i : after)
            queue(i);
        hub.send();
        QVERIFY(hub.isComplete);
    }
    const channel::ReceiveCounters counters = hub.received();
    QVERIFY(hub.frames >= kRounds * (suites.size() + after.size()));
    QVERIFY(counters.good - before.good >= kRounds + kRounds * suites.size());
    QCOMPARE(counters.late, std::uint64_t(0));
    QCOMPARE(counters.lost, std::uint64_t(0));
}

SKYSEAL_TEST(RecordOrderTest)
#include "record_order_test.moc"
