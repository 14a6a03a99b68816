// The handshake: its result at both ends, and two endpoints with lost, repeated, damaged and replayed messages.
#include "core/crypto/x25519.h"
#include "core/base/hex.h"
#include "core/channel/handshake.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tap.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;
using crypto::X25519KeyPair;

class HandshakeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void bothEndsAgree();
    void fitsOneTunnel();
    void wrongAnswerIsIgnored();
    void presharedKeyMustBeTheSame();
    void weakKeysAreRefused();

    void lostMessagesAreRepeated();
    void repeatedMessagesAreAnsweredTheSame();
    void replayedFirstMessageKeepsTheSession();
    void replayAfterRestartIsRefused();
    void counterThatCannotBeStored();
    void unknownPeerIsReported();
    void firstMessageForAnotherAgentIsRefused();
    void noCommonSuite();
    void researchIsNeverChosen();
    void otherVersionIsReported();
    void refusalsDoNotFlood();
    void revokedPeerLosesItsSession();
    void newPresharedKeyEndsTheSession();
    void newPresharedKeyAppliesToPendingHandshakes_data();
    void newPresharedKeyAppliesToPendingHandshakes();

private:
    SeededRandom m_random{11};
    X25519KeyPair m_station = X25519KeyPair::generate(m_random);
    X25519KeyPair m_agent = X25519KeyPair::generate(m_random);
    const SuiteOffer m_offer = offerOf(Policy{defaultSuites(), false, false});

    /// 0 for none.
    static void setPresharedKey(Pair &pair, Side side, std::uint8_t value)
    {
        Peer other = pair.configOf(side).peers.at(0);
        if (value != 0)
            other.presharedKey = std::make_shared<const Key32>(std::span<const std::uint8_t, 32>(Bytes(32, value)));
        pair.ends[side].setPeers(pair.now, {other});
    }
    static Peer known(const X25519KeyPair &identity) { return {identity.publicKey, "known", {}, {}, {}}; }
    Initiator begin(std::uint64_t counter = 1)
    {
        return *Initiator::begin(m_station, known(m_agent), {ConnectionId{0x1234}, m_offer, counter}, m_random);
    }
    Responder::Answer answer(const Initiator &initiator)
    {
        auto responder = Responder::read(m_agent, initiator.message());
        return *std::move(*responder).answer(known(m_station), ConnectionId{0x4321}, m_offer, m_random);
    }
};

void HandshakeTest::bothEndsAgree()
{
    auto initiator = begin(77);
    auto responder = Responder::read(m_agent, initiator.message());
    QVERIFY(responder);
    QCOMPARE(responder->peer(), m_station.publicKey);
    QCOMPARE(responder->payload().counter, std::uint64_t(77));
    QCOMPARE(responder->payload().connection, ConnectionId{0x1234});
    auto answered = std::move(*responder).answer(known(m_station), ConnectionId{0x4321}, m_offer, m_random);
    QVERIFY(answered);
    const auto agreement = initiator.readAnswer(answered->message);
    QVERIFY(agreement);
    QCOMPARE(agreement->peerConnection, ConnectionId{0x4321});
    QCOMPARE(agreement->suite, SuiteId::ChaCha20Poly1305);
    const auto here = agreement->chain.begin(agreement->suite);
    const auto there = answered->agreement.chain.begin(agreement->suite);
    QVERIFY(here.fromInitiator.equals(there.fromInitiator) && here.fromResponder.equals(there.fromResponder));
    QVERIFY(!here.fromInitiator.equals(here.fromResponder));
}

void HandshakeTest::fitsOneTunnel()
{
    constexpr std::size_t kTunnelPayload = 128;
    auto initiator = begin();
    QVERIFY(initiator.message().size() <= kTunnelPayload && answer(initiator).message.size() <= kTunnelPayload);
    QVERIFY(initiator.message().size() <= Announcement::kLength);
    QVERIFY(kAnswerLength <= kFirstLength);
}

void HandshakeTest::wrongAnswerIsIgnored()
{
    auto first = begin(1);
    auto second = begin(2);
    const auto answerToFirst = answer(first).message;
    const auto answerToSecond = answer(second).message;
    QVERIFY(!second.readAnswer(answerToFirst));
    QVERIFY(!second.readAnswer(ByteView(answerToSecond).first(kAnswerLength - 1)));
    QVERIFY(!second.readAnswer({}));
    QVERIFY(second.readAnswer(answerToSecond));
    QVERIFY(!second.readAnswer(answerToSecond)); // accepted only once
}

void HandshakeTest::presharedKeyMustBeTheSame()
{
    const auto secret = [](std::uint8_t first) {
        Key32 key;
        key.mutableView()[0] = first;
        return std::make_shared<const Key32>(std::move(key));
    };
    const std::shared_ptr<const Key32> here[] = {nullptr, secret(0), secret(1), secret(2)};
    for (const auto &ours : here) {
        for (const auto &theirs : here) {
            Peer agent = known(m_agent), station = known(m_station);
            agent.presharedKey = ours;
            station.presharedKey = theirs;
            auto initiator = Initiator::begin(m_station, agent, {ConnectionId{1}, m_offer, 1}, m_random);
            auto responder = Responder::read(m_agent, initiator->message());
            const auto answer = std::move(*responder).answer(station, ConnectionId{2}, m_offer, m_random);
            QVERIFY(answer);
            const bool same = (ours ? ours->view()[0] : 0) == (theirs ? theirs->view()[0] : 0);
            QCOMPARE(initiator->readAnswer(answer->message).has_value(), same);
        }
    }
}

void HandshakeTest::weakKeysAreRefused()
{
    QVERIFY(!Initiator::begin(m_station, Peer{}, {ConnectionId{1}, m_offer, 1}, m_random));
    Peer one;
    one.key[0] = 1;
    QVERIFY(!Initiator::begin(m_station, one, {ConnectionId{1}, m_offer, 1}, m_random));
}

// ---- endpoints

void HandshakeTest::lostMessagesAreRepeated()
{
    for (const std::uint8_t lost : {0x59, 0x5a, 0x58}) {
        for (int copies = 1; copies <= 3; ++copies) {
            Pair pair;
            int left = copies;
            pair.link.attacker = [&, lost](TimePoint, SentDatagram &flight) { return flight.bytes[0] != lost || --left < 0; };
            QVERIFY(pair.run(4s, [&] { return pair.bothUp(); }));
            QVERIFY(left < 0 || lost == 0x5a);
        }
    }
}

void HandshakeTest::repeatedMessagesAreAnsweredTheSame()
{
    PairOptions options;
    options.link.duplicate = 1;
    options.link.delay = 200ms;
    options.link.jitter = 100ms;
    Pair pair(options);
    Tap tap(pair);
    pair.run(5s);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    const auto answers = tap.ofKind(0x5a);
    QVERIFY(answers.size() > 1);
    for (const SentDatagram &flight : answers)
        QCOMPARE(toHex(flight.bytes), toHex(answers[0].bytes));
    // The station used the first of them; the others count as repeated, not as malformed or forged.
    const ReceiveCounters &unmatched = pair.ground().unmatched();
    QVERIFY(unmatched.replayed > 0);
    QCOMPARE(unmatched.malformed, std::uint64_t(0));
    QCOMPARE(unmatched.forged, std::uint64_t(0));
}

void HandshakeTest::replayedFirstMessageKeepsTheSession()
{
    Pair pair;
    Tap tap(pair);
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const auto firsts = tap.ofKind(0x59);
    QCOMPARE(firsts.size(), 1u);
    for (int i = 0; i < 50; ++i) {
        pair.link.inject(pair.now, firsts[0]);
        pair.run(100ms);
    }
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QCOMPARE(pair.air().all<SessionDown>().size(), 0u);
    QCOMPARE(pair.air().unmatched().replayed, std::uint64_t(50));
    QCOMPARE(pair.air().all<HandshakeRefused>().at(0).reason, RefusalReason::ReplayedHandshake);
    QCOMPARE(pair.air().all<HandshakeRefused>().at(0).peer, pair.ground().publicKey());
    QVERIFY(pair.air().all<HandshakeRefused>().size() <= 6);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
}

void HandshakeTest::replayAfterRestartIsRefused()
{
    Pair pair;
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const auto first = tap.ofKind(0x59).at(0);
    pair.kill(Ground);
    pair.kill(Air);
    pair.start(Air);
    pair.link.inject(pair.now, first);
    pair.run(1s);
    QCOMPARE(pair.air().unmatched().replayed, std::uint64_t(1));
    QVERIFY(!pair.air().up());
    QCOMPARE(tap.ofKind(0x5a).size(), 1u);
}

void HandshakeTest::counterThatCannotBeStored()
{
    Pair pair;
    pair.air().counters.fails = true;
    pair.run(5s);
    QVERIFY(!pair.air().up());
    pair.air().counters.fails = false;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
}

void HandshakeTest::unknownPeerIsReported()
{
    Pair pair;
    const auto peersOf = [&](Side side) { return pair.configOf(side).peers; };
    pair.air().setPeers(pair.now, {});
    pair.run(2s);
    QVERIFY(!pair.air().up());
    const auto refused = pair.air().all<HandshakeRefused>();
    QVERIFY(!refused.empty());
    QCOMPARE(refused[0].reason, RefusalReason::UnknownPeer);
    QCOMPARE(refused[0].peer, pair.ground().publicKey());
    pair.air().setPeers(pair.now, peersOf(Air));
    QVERIFY(pair.run(3s, [&] { return pair.bothUp(); }));

    Pair other;
    other.ground().setPeers(other.now, {});
    other.run(2s);
    QCOMPARE(other.ground().all<HandshakeRefused>().at(0).reason, RefusalReason::UnknownPeer);
    QCOMPARE(other.ground().datagramsOut, std::uint64_t(0));
}

void HandshakeTest::firstMessageForAnotherAgentIsRefused()
{
    PairOptions options;
    Pair one(options);
    options.seed = 2;
    Pair two(options);
    Tap tap(one);
    one.run(1s);
    // The second agent even knows the station, but the message is not for it.
    auto peers = two.configOf(Air).peers;
    peers.push_back(one.configOf(Air).peers[0]);
    two.air().setPeers(two.now, peers);
    two.link.inject(two.now, tap.ofKind(0x59).at(0));
    two.run(1s);
    QCOMPARE(two.air().unmatched().forged, std::uint64_t(1));
    QCOMPARE(two.air().all<HandshakeRefused>().at(0).reason, RefusalReason::WrongKey);
    QCOMPARE(two.air().sessions().size(), 1u);
}

void HandshakeTest::noCommonSuite()
{
    PairOptions options;
    options.ground.suites = {SuiteId::ChaCha20Poly1305};
    options.air.suites = {SuiteId::Aes256Gcm, SuiteId::Aes256Ctr};
    Pair pair(options);
    pair.run(3s);
    QVERIFY(!pair.ground().up() && !pair.air().up());
    QCOMPARE(pair.air().all<HandshakeRefused>().at(0).reason, RefusalReason::NoCommonSuite);
}

void HandshakeTest::researchIsNeverChosen()
{
    PairOptions options;
    options.ground = {{SuiteId::Rc4, SuiteId::Aes256Ctr}, true, true};
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    QCOMPARE(pair.ground().sessionInfo()->suite, SuiteId::Aes256Ctr);
    options.ground = options.air = {{SuiteId::Rc4}, true, true};
    Pair only(options);
    only.run(3s);
    QVERIFY(!only.ground().up());
}

void HandshakeTest::otherVersionIsReported()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    for (const std::uint8_t first : {0x49, 0x69, 0x79}) {
        Bytes datagram(127, first);
        QVERIFY(!pair.air().handleDatagram(pair.now, pair.pathOf(Ground), datagram));
        pair.run(2s);
    }
    QCOMPARE(pair.air().all<HandshakeRefused>().size(), 3u);
    QCOMPARE(pair.air().all<HandshakeRefused>()[0].reason, RefusalReason::Version);
    QCOMPARE(pair.air().unmatched().malformed, std::uint64_t(3));
}

void HandshakeTest::refusalsDoNotFlood()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    std::uint64_t count = 0;
    for (int i = 0; i < 20000; ++i) {
        Bytes datagram(127);
        m_random.fill(datagram);
        datagram[0] = 0x59;
        Path from = pair.pathOf(Ground);
        from.remote.port = static_cast<std::uint16_t>(i);
        from.remote.ip[0] = static_cast<std::uint8_t>(i >> 16);
        QVERIFY(!pair.air().handleDatagram(pair.now, from, datagram));
        ++count;
        if (i % 200 == 0)
            pair.run(10ms);
    }
    QCOMPARE(pair.air().unmatched().forged, count);
    const auto told = pair.air().all<HandshakeRefused>().size();
    QVERIFY2(told <= 24, qPrintable(QString::number(told)));
    QVERIFY(pair.bothUp());
}

void HandshakeTest::revokedPeerLosesItsSession()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.air().setPeers(pair.now, {});
    pair.run(100ms);
    QCOMPARE(pair.air().all<SessionDown>().at(0).reason, DownReason::Revoked);
    QCOMPARE(pair.ground().all<SessionDown>().at(0).reason, DownReason::PeerClosed);
    pair.run(5s);
    QVERIFY(!pair.air().up());
}

void HandshakeTest::newPresharedKeyEndsTheSession()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    setPresharedKey(pair, Air, 1);
    pair.run(5s);
    QCOMPARE(pair.air().all<SessionDown>().at(0).reason, DownReason::Closed);
    QCOMPARE(pair.ground().all<SessionDown>().at(0).reason, DownReason::PeerClosed);
    QVERIFY(!pair.air().up() && !pair.ground().up()); // until the other end has it as well
    setPresharedKey(pair, Ground, 1);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);

    setPresharedKey(pair, Ground, 1); // read again
    pair.run(5s);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.ground().all<SessionUp>().size(), 2u);
    setPresharedKey(pair, Ground, 2);
    pair.run(5s);
    QCOMPARE(pair.ground().all<SessionDown>().back().reason, DownReason::Closed);
    QVERIFY(!pair.air().up() && !pair.ground().up());
    setPresharedKey(pair, Air, 2);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    setPresharedKey(pair, Air, 0);
    pair.run(5s);
    QVERIFY(!pair.air().up() && !pair.ground().up());
}

void HandshakeTest::newPresharedKeyAppliesToPendingHandshakes_data()
{
    QTest::addColumn<int>("after");
    QTest::newRow("first message") << 150;
    QTest::newRow("answer") << 250;
    QTest::newRow("first record") << 350;
}

void HandshakeTest::newPresharedKeyAppliesToPendingHandshakes()
{
    QFETCH(int, after);
    PairOptions options;
    options.link.delay = 100ms;
    Pair pair(options);
    pair.run(std::chrono::milliseconds(after));
    for (const Side side : {Ground, Air})
        setPresharedKey(pair, side, 1);
    pair.run(std::chrono::milliseconds(420 - after)); // when the session without it would be there
    QVERIFY(!pair.air().up() && !pair.ground().up());
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
}

SKYSEAL_TEST(HandshakeTest)
#include "handshake_test.moc"
