// The limits of an endpoint, and impossible requests of owners, peers and keys: each refusal leaves the state unchanged.
#include "core/channel/endpoint.h"
#include "core/channel/handshake.h"
#include "core/channel/datagram_queue.h"
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

class LimitsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void refusedSealingUsesNoCounter_data();
    void refusedSealingUsesNoCounter();
    void commandsWithoutASession();
    void unconfirmedSessionsAreLimited();
    void peerWithAnUnusableKey();
    void agentThatChoosesAnUnknownSuite();
    void fullOutboxKeepsTheOldest();
};

void LimitsTest::refusedSealingUsesNoCounter_data()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (info.id != SuiteId::None)
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

void LimitsTest::refusedSealingUsesNoCounter()
{
    QFETCH(int, suite);
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.ground().switchSuite(pair.now, static_cast<SuiteId>(suite));
    pair.run(2s);
    Endpoint &endpoint = *pair.air().endpoint;
    const SessionId session = pair.air().session();
    QCOMPARE(endpoint.sessionInfo(session)->suite, static_cast<SuiteId>(suite));
    const auto sealed = [&] { return endpoint.stats(session)->tx.records; };
    const auto before = sealed();
    Bytes frames(kMaxRecordPayload + 1, 0xfd), out(kMaxRecordPayload + 1 + kMaxRecordOverhead);
    const auto refusal = [&](ByteView text, MutableByteView room, SessionId id) {
        const auto result = endpoint.seal(pair.now, id, text, room);
        return result ? std::optional<SealError>() : result.error();
    };
    QVERIFY(refusal(frames, out, session) == SealError::TooLong);
    QVERIFY(refusal({}, out, session) == SealError::NotFrames);
    QVERIFY(refusal(Bytes{0x06, 0xfd}, out, session) == SealError::NotFrames); // would be taken for a report
    QVERIFY(refusal(Bytes{0xfd}, out, SessionId{77}) == SealError::NoSession);
    QCOMPARE(sealed(), before);

    const ByteView longest = ByteView(frames).first(kMaxRecordPayload);
    const auto size = endpoint.seal(pair.now, session, longest, out);
    QVERIFY(size && *size <= 1200);
    QVERIFY(refusal(longest, MutableByteView(out).first(*size - 1), session) == SealError::NoRoom);
    QCOMPARE(sealed(), before + 1);
    // No counter is missing at the other end, either.
    QVERIFY(pair.ground().handleDatagram(pair.now, pair.pathOf(Air), MutableByteView(out).first(*size)));
    pair.run(2s);
    QCOMPARE(pair.ground().stats()->rx.lost, std::uint64_t(0));
}

void LimitsTest::commandsWithoutASession()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const SessionId nobody{0xabcd00};
    for (Pair::End &end : pair.ends) {
        Endpoint &endpoint = *end.endpoint;
        const auto events = end.events.size();
        endpoint.switchSuite(pair.now, nobody, SuiteId::Aes256Gcm);
        endpoint.rekey(pair.now, nobody);
        endpoint.close(pair.now, nobody);
        endpoint.countPlaintextDropped(nobody, 5);
        QVERIFY(!endpoint.sessionInfo(nobody) && !endpoint.stats(nobody));
        QCOMPARE(endpoint.framing(nobody), Framing::Sealed);
        QVERIFY(endpoint.recordPath(nobody) == Path{});
        Bytes frame{0xfd}, out(100);
        QCOMPARE(endpoint.sealInline(pair.now, nobody, frame, out).error(), SealError::NoSession);
        QVERIFY(!endpoint.pollTransmit());
        pair.pump();
        QCOMPARE(end.events.size(), events);
    }
    QVERIFY(pair.bothUp());
}

void LimitsTest::unconfirmedSessionsAreLimited()
{
    // An agent that knows more stations than it can have sessions: all send first messages, and none confirms its session.
    constexpr std::size_t kStations = 257, kKept = 64;
    SeededRandom random(1);
    MemoryCounterStore counters;
    Config config;
    config.role = Role::Agent;
    config.identity = std::make_shared<X25519KeyPair>(X25519KeyPair::generate(random));
    config.policy = {defaultSuites(), false, false};
    std::vector<X25519KeyPair> stations;
    for (std::size_t i = 0; i < kStations; ++i) {
        stations.push_back(X25519KeyPair::generate(random));
        config.peers.push_back({stations.back().publicKey, "station", {}, {}, {}});
    }
    const Peer agent{config.identity->publicKey, "agent", {}, {}, {}};
    const SuiteOffer offer = offerOf(config.policy);
    TimePoint now{1h};
    Endpoint endpoint(std::move(config), random, counters, now);
    const auto answerTo = [&](const Bytes &message) {
        Bytes first = message, out;
        endpoint.handleDatagram(now, Path{LinkId{1}, {}}, first);
        while (const auto transmit = endpoint.pollTransmit())
            out.assign(transmit->bytes.begin(), transmit->bytes.end());
        return out;
    };
    std::vector<Bytes> firsts, answers;
    for (const X25519KeyPair &station : stations) {
        auto initiator = Initiator::begin(station, agent, {ConnectionId{1}, offer, 1}, random);
        firsts.emplace_back(initiator->message().begin(), initiator->message().end());
        answers.push_back(answerTo(firsts.back()));
        QVERIFY(initiator->readAnswer(answers.back()));
        now += 30ms; // within the rate, and all within the time that an unconfirmed session is kept
    }
    QVERIFY(endpoint.sessions().empty());
    // The session of a message is kept if a copy of it gets the same answer.
    for (std::size_t i = kStations - kKept; i < kStations; ++i)
        QCOMPARE(answerTo(firsts[i]), answers[i]);
    QVERIFY(answerTo(firsts[kStations - kKept - 1]) != answers[kStations - kKept - 1]);
}

void LimitsTest::peerWithAnUnusableKey()
{
    // A point of small order in the list of peers, announced repeatedly: no message is sent, and no session slot is used.
    Pair pair;
    Peer bad{{}, "bad", {}, {}, {}};
    bad.key[0] = 1;
    auto peers = pair.configOf(Ground).peers;
    peers.push_back(bad);
    pair.kill(Air);
    pair.ground().setPeers(pair.now, peers);
    SeededRandom random(5);
    for (int i = 0; i < 400; ++i) {
        auto announcement = Announcement(bad.key).make(random);
        pair.ground().handleDatagram(pair.now, pair.pathOf(Air), announcement);
        pair.run(100ms);
    }
    QCOMPARE(pair.ground().datagramsOut, std::uint64_t(0));
    QVERIFY(pair.ground().endpoint->unanswered().empty());
    pair.start(Air);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
}

void LimitsTest::agentThatChoosesAnUnknownSuite()
{
    SeededRandom random(7);
    const X25519KeyPair station = X25519KeyPair::generate(random), agent = X25519KeyPair::generate(random);
    const SuiteOffer offer = offerOf(Policy{defaultSuites(), false, false});
    for (const int suite : {7, 9, 15, 255}) {
        const Peer known{agent.publicKey, "agent", {}, {}, {}};
        auto initiator = Initiator::begin(station, known, {ConnectionId{1}, offer, 1}, random);
        const std::string prologue("skyseal channel v1\x01");
        auto state = noise::HandshakeState::responder(asBytes(prologue), agent.clone());
        state.setPsk(Key32());
        std::array<std::uint8_t, FirstPayload::kLength> asked;
        QVERIFY(state.readMessage(ByteView(initiator->message()).subspan(1, kFirstNoiseLength), asked));
        auto payload = AnswerPayload{ConnectionId{2}, offer, SuiteId::ChaCha20Poly1305}.write();
        payload.back() = static_cast<std::uint8_t>(suite);
        AnswerMessage message{};
        message[0] = firstByte(HandshakeMessage::Answer);
        QVERIFY(state.writeMessage(payload, MutableByteView(message).subspan(3, kAnswerNoiseLength), random));
        Mac1(station.publicKey).sign(message);
        QCOMPARE(initiator->readAnswer(message).error(), RefusalReason::OfferTampered);
    }
}

void LimitsTest::fullOutboxKeepsTheOldest()
{
    DatagramQueue outgoing;
    QVERIFY(!outgoing.pop());
    outgoing.push({}, Bytes(DatagramQueue::kMaxLength + 1));
    QVERIFY(outgoing.empty());
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < DatagramQueue::kSlots + 50; ++i)
            outgoing.push({}, Bytes{static_cast<std::uint8_t>(i)});
        QCOMPARE(outgoing.size(), DatagramQueue::kSlots);
        for (std::size_t i = 0; i < DatagramQueue::kSlots; ++i) {
            const DatagramQueue::Item *item = outgoing.pop();
            QVERIFY(item);
            QCOMPARE(item->length, std::size_t(1));
            QCOMPARE(item->bytes[0], static_cast<std::uint8_t>(i));
        }
        QVERIFY(!outgoing.pop());
    }
}

SKYSEAL_TEST(LimitsTest)
#include "limits_test.moc"
