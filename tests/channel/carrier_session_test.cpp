// Sessions on each carrier: they come up, and switch under loss without losing a frame of their own. Messages moved to another
// carrier are refused. A serial line needs no connection ids, whichever end restarts.
#include "core/channel/endpoint.h"
#include "core/channel/handshake_messages.h"
#include "core/channel/message_traits.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr Carrier kCarriers[] = {Carrier::Datagram, Carrier::Tunnel, Carrier::Serial};

PairOptions in(Carrier carrier)
{
    PairOptions options;
    options.carrier = carrier;
    options.link.delay = 20ms;
    return options;
}

ReceiveCounters received(Pair &pair, Side side)
{
    return pair.ends[side].stats()->rx;
}

} // namespace

class CarrierSessionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void switchesUnderLoss();
    void handshakesStayInTheirCarrier();
    void recordsStayInTheirCarrier();
    void recordOverheadIsTwentyBytesOnALine();
    void restartsOnALine();
    void lineReconnects();
    void lineReconnectsRepeatedly();
    void reportsNameTheirSessionOnLines();
    void anotherStationOnTheLine();
    void singleRecordsAreForLines();
    void noInlineFramesElsewhere();
};

void CarrierSessionTest::switchesUnderLoss()
{
    for (const Carrier carrier : kCarriers) {
        PairOptions options = in(carrier);
        options.link.loss = 0.2;
        options.seed = 5 + static_cast<unsigned>(carrier);
        Pair pair(options);
        QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
        QCOMPARE(pair.ground().sessionInfo()->path.carrier, carrier);
        pair.every(20ms, [&pair] { pair.sendFrame(Air); });
        pair.every(100ms, [&pair] { pair.sendFrame(Ground); });
        std::size_t next = 0;
        pair.every(2s, [&] {
            const auto suites = defaultSuites();
            pair.ground().switchSuite(pair.now, suites[++next % suites.size()]);
        });
        pair.run(60s);
        pair.stopTraffic();
        pair.run(3s);
        QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
        QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString());
        QVERIFY(pair.ground().all<SwitchDone>().size() > 20);
        QCOMPARE(received(pair, Ground).forged, std::uint64_t(0));
        QCOMPARE(received(pair, Air).forged, std::uint64_t(0));
    }
}

void CarrierSessionTest::handshakesStayInTheirCarrier()
{
    for (const Carrier sent : kCarriers) {
        for (const Carrier arrived : kCarriers) {
            Pair pair(in(sent));
            // The station sends no announcements; it answers in the carrier in which it received the agent.
            pair.setArrival(arrived);
            pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
                pair.setArrival(flight.from == Ground ? arrived : sent);
                return true;
            };
            pair.run(5s);
            QCOMPARE(pair.bothUp(), sent == arrived);
            if (sent != arrived)
                QVERIFY(!pair.air().all<HandshakeRefused>().empty());
        }
    }
}

void CarrierSessionTest::recordsStayInTheirCarrier()
{
    for (const Carrier sent : kCarriers) {
        for (const Carrier arrived : kCarriers) {
            Pair pair(in(sent));
            QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
            pair.run(2s);
            const std::size_t before = pair.ground().delivered.size();
            pair.setArrival(arrived);
            pair.sendFrame(Air);
            pair.run(100ms);
            QCOMPARE(pair.ground().delivered.size() - before, sent == arrived ? 1u : 0u);
            // The path of the session did not change either.
            const auto path = pair.ground().recordPath();
            QCOMPARE(path.carrier, sent);
        }
    }
}

void CarrierSessionTest::recordOverheadIsTwentyBytesOnALine()
{
    for (const Carrier carrier : kCarriers) {
        Pair pair(in(carrier));
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.run(1s);
        for (const Side side : {Ground, Air}) {
            Bytes frame(28, 0xfd), record(100);
            Endpoint &endpoint = *pair.ends[side].endpoint;
            const auto size = endpoint.seal(pair.now, pair.ends[side].session(), frame, record);
            QVERIFY(size.has_value());
            const std::size_t stamp = side == Ground ? 3 : 0;
            QCOMPARE(*size, frame.size() + stamp + (carrier == Carrier::Serial ? 20u : 22u));
        }
    }
}

void CarrierSessionTest::restartsOnALine()
{
    for (const Side restarting : {Ground, Air}) {
        Pair pair(in(Carrier::Serial));
        pair.every(5ms, [&pair] { pair.sendFrame(Air); });
        pair.every(5ms, [&pair] { pair.sendFrame(Ground); });
        for (int i = 0; i < 5; ++i) {
            QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
            pair.run(std::chrono::milliseconds(1700 + 130 * i));
            pair.kill(restarting);
            pair.run(std::chrono::milliseconds(50 + 450 * i));
            const std::size_t before = pair.ground().all<SessionUp>().size();
            pair.start(restarting);
            QVERIFY(pair.run(5s, [&] { return pair.bothUp() && pair.ground().all<SessionUp>().size() > before; }));
            pair.run(1s);
            // Records of the previous session reached the new one; they must not raise a forgery alarm.
            for (const Side side : {Ground, Air}) {
                QCOMPARE(received(pair, side).forged, std::uint64_t(0));
                QVERIFY(pair.ends[side].all<ForgeryAlarm>().empty());
            }
        }
        pair.stopTraffic();
        pair.run(1s);
        const std::size_t delivered = pair.ground().delivered.size();
        pair.sendFrame(Air);
        pair.run(1s);
        QCOMPARE(pair.ground().delivered.size(), delivered + 1);
    }
}

void CarrierSessionTest::lineReconnects()
{
    Pair pair(in(Carrier::Serial));
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(2s);
    // A TCP connection of its own port takes the place of the old one.
    pair.air().port = 40001;
    pair.air().endpoint->handleStreamBegan(pair.now, LinkId{1});
    pair.pump();
    const std::size_t delivered = pair.ground().delivered.size();
    for (int i = 0; i < 20; ++i)
        pair.sendFrame(Air);
    pair.run(100ms);
    QCOMPARE(pair.ground().delivered.size(), delivered + 20);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QCOMPARE(pair.ground().recordPath().remote.port, std::uint16_t(40001));
    // Without such an event, within a second by the next report.
    pair.air().port = 40002;
    pair.run(1100ms);
    pair.sendFrame(Air);
    pair.run(100ms);
    QCOMPARE(pair.ground().delivered.size(), delivered + 21);
    QCOMPARE(received(pair, Ground).forged, std::uint64_t(0));
}

void CarrierSessionTest::lineReconnectsRepeatedly()
{
    // A hundred connections a second cause at most two reports a second: the reply, and the regular one.
    for (const Carrier carrier : kCarriers) {
        Pair pair(in(carrier));
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.run(2s);
        const std::uint64_t before = pair.air().datagramsOut;
        pair.every(10ms, [&] { pair.air().endpoint->handleStreamBegan(pair.now, LinkId{1}); });
        pair.run(20s);
        const std::uint64_t said = pair.air().datagramsOut - before;
        QVERIFY2(said >= 38 && said <= 42, qPrintable(QString::number(said)));
    }
}

void CarrierSessionTest::reportsNameTheirSessionOnLines()
{
    for (const Carrier carrier : kCarriers) {
        Pair pair(in(carrier));
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.run(2s);
        pair.air().endpoint->handleStreamBegan(pair.now, LinkId{1});
        pair.air().endpoint->handleDeadline(pair.now);
        const auto report = pair.air().pollTransmit();
        QVERIFY(report);
        Bytes message(report->bytes.begin(), report->bytes.end());
        QCOMPARE(pair.ground().endpoint->namesSerialSession(message), carrier == Carrier::Serial);
        message[2] ^= 1; // of another session
        QVERIFY(!pair.ground().endpoint->namesSerialSession(message));
        QVERIFY(!pair.ground().endpoint->namesSerialSession(ByteView(message).first(5)));
    }
}

void CarrierSessionTest::anotherStationOnTheLine()
{
    Pair pair(in(Carrier::Serial));
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const auto first = pair.air().session();
    SeededRandom random(77);
    const auto other = newIdentity(random);
    std::vector<channel::Peer> peers = pair.configOf(Air).peers;
    peers.push_back({publicKeyOf(*other), "second", PeerRole::Pilot, {}, {}});
    pair.air().setPeers(pair.now, peers);
    pair.kill(Ground);
    pair.ground().identity = other;
    pair.start(Ground);
    QVERIFY(pair.run(10s, [&] { return pair.ground().up() && pair.air().up() && pair.air().session() != first; }));
    pair.run(1s);
    // A line has one session.
    QCOMPARE(pair.air().sessions().size(), std::size_t(1));
    pair.sendFrame(Air);
    pair.sendFrame(Ground);
    pair.run(1s);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString());
    QCOMPARE(received(pair, Air).forged, std::uint64_t(0));
}

void CarrierSessionTest::singleRecordsAreForLines()
{
    for (const Carrier carrier : {Carrier::Datagram, Carrier::Tunnel}) {
        Pair pair(in(carrier));
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        Bytes single(40, 0x54);
        const auto before = pair.ground().unmatched().malformed;
        Path path = pair.pathOf(Air);
        QVERIFY(!pair.ground().handleDatagram(pair.now, path, single));
        QCOMPARE(pair.ground().unmatched().malformed, before + 1);
        QCOMPARE(received(pair, Ground).forged, std::uint64_t(0));
    }
}

void CarrierSessionTest::noInlineFramesElsewhere()
{
    for (const Carrier carrier : kCarriers) {
        PairOptions options = in(carrier);
        options.ground.allowInline = options.ground.preferInline = options.air.allowInline = true;
        options.ground.suites = options.air.suites = {crypto::SuiteId::Aes256Ctr};
        struct Traits final : MessageTraits
        {
            std::optional<Message> message(std::uint32_t) const override { return std::nullopt; }
            std::uint16_t checksum(ByteView, std::uint8_t) const override { return 0; }
        };
        options.messageTraits = std::make_shared<Traits>();
        Pair pair(options);
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.run(1s);
        QCOMPARE(pair.air().framing(), carrier == Carrier::Datagram ? Framing::Inline : Framing::Sealed);
    }
}

SKYSEAL_TEST(CarrierSessionTest)
#include "carrier_session_test.moc"
