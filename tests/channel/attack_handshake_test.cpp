// Attacks on the handshake: a man in the middle, messages for other devices, stolen keys, old and changed messages, weaker
// choices.
#include "attack.h"
#include "core/channel/handshake.h"
#include "core/channel/record.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "reconstruction.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"
#include "thief.h"

using namespace skyseal;
using namespace skyseal::test;
using crypto::X25519KeyPair;

class AttackHandshakeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qInfo("seed %llu", static_cast<unsigned long long>(kAttackSeed));
    }
    void interception();
    void unknownKeyShare();
    void keyCompromiseImpersonation();
    void revealedKeysOpenNothing_data();
    void revealedKeysOpenNothing();
    void replayedFirstMessage();
    void everyBitOfTheFirstMessage();
    void everyBitOfTheAnswer();
    void suiteOutsideTheOffers();
    void otherVersionOrCarrier();

private:
    SeededRandom m_random{kAttackSeed};
    X25519KeyPair m_station = X25519KeyPair::generate(m_random);
    X25519KeyPair m_agent = X25519KeyPair::generate(m_random);
    const SuiteOffer m_offer = offerOf(channel::Policy{defaultSuites(), false, false});

    static Peer known(const X25519KeyPair &identity) { return {identity.publicKey, "known", {}, {}, {}}; }
    Initiator begin(std::uint64_t counter = 1)
    {
        return *Initiator::begin(m_station, known(m_agent), {ConnectionId{0x1234}, m_offer, counter}, m_random);
    }
};

namespace {

template<std::size_t N> std::array<std::uint8_t, N> flipped(std::array<std::uint8_t, N> bytes, std::size_t bit)
{
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    return bytes;
}

/// A station's first record of a session with these keys: one frame.
Bytes recordUnder(const RevealedSession &session, ConnectionId connection)
{
    constexpr SuiteId kSuite = SuiteId::ChaCha20Poly1305;
    const auto writer = crypto::makeRecordCipher(kSuite, session.epochZero(kSuite).fromInitiator.clone());
    const RecordHeader header{DatagramKind::Record, 0, connection, 0};
    const Bytes frame(28, 0xfd);
    Bytes record(frame.size() + kMaxRecordOverhead);
    header.write(record);
    const AssociatedData said(header, kSuite, Direction::FromInitiator, Carrier::Datagram);
    record.resize(header.length() + writer->seal(0, said.view(), frame, MutableByteView(record).subspan(header.length())));
    return record;
}

} // namespace

void AttackHandshakeTest::interception()
{
    // A man in the middle with a key of his own answers both sides in place of the other.
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const X25519KeyPair middle = X25519KeyPair::generate(m_random);

    // To the agent he acts as a station.
    const auto called = Initiator::begin(middle, known(*pair.air().identity), {ConnectionId{7}, m_offer, 99}, m_random);
    QVERIFY(called);
    const std::size_t answers = tap.ofKind(0x5a).size();
    offer(pair, Air, Bytes(called->message().begin(), called->message().end()));
    pair.run(1s);
    HOLDS(tap.ofKind(0x5a).size() == answers, "an unknown key gets no answer");
    const auto refused = pair.air().all<HandshakeRefused>();
    QCOMPARE(refused.size(), 1u);
    QCOMPARE(refused[0].reason, RefusalReason::UnknownPeer);
    QCOMPARE(refused[0].peer, middle.publicKey); // reported for comparison

    // To the station he announces himself; he intercepts its first message to the agent and cannot read it.
    const auto announced = Announcement(middle.publicKey).make(m_random);
    const std::size_t firsts = tap.ofKind(0x59).size();
    offer(pair, Ground, Bytes(announced.begin(), announced.end()));
    pair.run(3s);
    QCOMPARE(tap.ofKind(0x59).size(), firsts);
    QCOMPARE(pair.ground().all<HandshakeRefused>().at(0).reason, RefusalReason::UnknownPeer);
    QVERIFY(!Responder::read(middle, tap.ofKind(0x59).at(0).bytes));
    QVERIFY(aliveAndExact(pair));
}

void AttackHandshakeTest::unknownKeyShare()
{
    // A first message for one agent is delivered to another agent that knows the station as well, with a recomputed mac1, which
    // needs no secret.
    Pair one(attackOptions());
    PairOptions options = attackOptions();
    ++options.seed;
    Pair two(options);
    Tap tap(one);
    one.run(1s);
    QVERIFY(two.run(2s, [&] { return two.bothUp(); }));
    Tap answers(two);
    auto peers = two.configOf(Air).peers;
    peers.push_back(one.configOf(Air).peers[0]);
    two.air().setPeers(two.now, peers);
    Bytes carried = tap.ofKind(0x59).at(0).bytes;
    offer(two, Air, carried);
    Mac1(two.air().publicKey()).sign(carried);
    offer(two, Air, carried);
    two.run(1s);
    HOLDS(answers.ofKind(0x5a).empty(), "a message for another agent gets no answer");
    QCOMPARE(two.air().unmatched().forged, std::uint64_t(2));
    QVERIFY(aliveAndExact(two));
}

void AttackHandshakeTest::keyCompromiseImpersonation()
{
    // An attacker with the agent's private key forges a first message of the station with the greatest counter. The agent
    // answers it; to continue, the private key of the station or the ephemeral one of the agent is needed.
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const crypto::PublicKey &station = pair.ground().publicKey();
    const auto before = pair.air().counters.lastSeen(station);
    const auto call = [&](std::uint64_t counter) {
        Thief thief(pair.air().identity->clone(), station, {ConnectionId{1}, m_offer, counter}, m_random);
        offer(pair, Air, Bytes(thief.message().begin(), thief.message().end()));
        pair.pump();
        return thief;
    };
    const Thief thief = call(kGreatestCounter);
    const Bytes answer = tap.ofKind(0x5a).back().bytes;
    QCOMPARE(tap.ofKind(0x5a).size(), 2u);
    QCOMPARE(pair.air().unmatched().forged, std::uint64_t(0));
    // The answer contains the connection id for his records.
    const auto se = crypto::x25519(pair.ground().identity->secret, Thief::ephemeralOf(answer));
    const auto truth = thief.withGuess(answer, se->clone());
    QVERIFY(truth.read);
    std::size_t taken = 0;
    for (const auto &guess : thief.guesses(answer)) {
        const auto guessed = thief.withGuess(answer, guess);
        taken += guessed.read.has_value();
        taken += offer(pair, Air, recordUnder(guessed.session, truth.read->connection));
    }
    pair.run(15s);
    HOLDS(taken == 0 && pair.air().all<SessionUp>().size() == 1 && pair.air().all<SessionDown>().empty(),
          "no session comes of it, and none ends");
    QCOMPARE(pair.air().counters.lastSeen(station), before); // nor used up
    QVERIFY(aliveAndExact(pair));
    pair.kill(Ground);
    pair.start(Ground); // with a counter far below that of the forged one
    QVERIFY(pair.run(3s, [&] { return pair.bothUp() && pair.air().all<SessionUp>().size() == 2; }));
    // Control: the same record made with the station's private key is accepted.
    const Thief both = call(kGreatestCounter);
    const Bytes last = tap.ofKind(0x5a).back().bytes;
    const auto session = both.withGuess(last, crypto::x25519(pair.ground().identity->secret, Thief::ephemeralOf(last)));
    QVERIFY(session.read && offer(pair, Air, recordUnder(session.session, session.read->connection)));
    pair.pump();
    QCOMPARE(pair.air().all<SessionUp>().size(), 3u);
}

void AttackHandshakeTest::revealedKeysOpenNothing_data()
{
    QTest::addColumn<bool>("presharedKey");
    QTest::newRow("both static keys") << false;
    QTest::newRow("both static keys and the pre-shared one") << true;
}

void AttackHandshakeTest::revealedKeysOpenNothing()
{
    QFETCH(bool, presharedKey);
    PairOptions options = attackOptions();
    Key32 psk;
    if (presharedKey) {
        m_random.fill(psk.mutableView());
        options.presharedKey = std::make_shared<const Key32>(psk.clone());
    }
    Pair pair(options);
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.sendFrame(Air);
    pair.sendFrame(Ground);
    pair.run(100ms);
    const Bytes first = tap.ofKind(0x59).at(0).bytes, answer = tap.ofKind(0x5a).at(0).bytes;
    const X25519KeyPair &station = *pair.ground().identity, &agent = *pair.air().identity;

    std::vector<std::optional<Key32>> guesses;
    guesses.emplace_back(std::nullopt);
    guesses.emplace_back(Key32());
    for (const X25519KeyPair *own : {&station, &agent}) {
        for (const ByteView key : {ByteView(first).subspan(1, 32), ByteView(answer).subspan(3, 32), ByteView(station.publicKey),
                                   ByteView(agent.publicKey)}) {
            crypto::PublicKey other{};
            std::copy(key.begin(), key.end(), other.begin());
            guesses.emplace_back(crypto::x25519(own->secret, other));
        }
    }
    Reconstruction reconstruction(station, agent, first, answer);
    std::size_t opened = 0;
    for (const auto &guess : guesses) {
        auto session = reconstruction.withGuess(guess, psk);
        if (!session)
            continue;
        auto secrets = session->epochZero(SuiteId::ChaCha20Poly1305);
        const auto reader = crypto::makeRecordCipher(SuiteId::ChaCha20Poly1305, std::move(secrets.fromResponder));
        for (const SentDatagram &flight : tap.flights) {
            const auto header = RecordHeader::read(flight.bytes);
            if (flight.from != Air || !header)
                continue;
            Bytes copy = flight.bytes;
            const AssociatedData said(ByteView(copy).first(6), SuiteId::ChaCha20Poly1305, Direction::FromResponder,
                                      Carrier::Datagram);
            opened += reader->open(header->counter, said.view(), MutableByteView(copy).subspan(6)).has_value();
        }
    }
    HOLDS(opened == 0, "the static keys open no record");
    // The payload of the first message can be read with the agent's key: Noise IK gives it no forward secrecy, and it contains
    // only suites and a counter. This also verifies the reconstruction up to that point.
    QVERIFY(reconstruction.firstPayloadRead);
}

void AttackHandshakeTest::replayedFirstMessage()
{
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const SentDatagram first = tap.ofKind(0x59).at(0);
    QCOMPARE(tap.ofKind(0x5a).size(), 1u);
    for (int i = 0; i < 20; ++i) {
        pair.link.inject(pair.now, first);
        pair.run(100ms);
    }
    HOLDS(tap.ofKind(0x5a).size() == 1, "an old first message gets no answer");
    QCOMPARE(pair.air().unmatched().replayed, std::uint64_t(20));
    QVERIFY(aliveAndExact(pair));
    // The same for an agent that was restarted after its station ended.
    pair.kill(Ground);
    pair.kill(Air);
    pair.start(Air);
    pair.link.inject(pair.now, first);
    pair.run(1s);
    HOLDS(tap.ofKind(0x5a).size() == 1, "an old first message gets no answer");
}

void AttackHandshakeTest::everyBitOfTheFirstMessage()
{
    // This covers offers, connection id and counter: none can be removed or weakened in transit.
    const FirstMessage message = begin().message();
    const Mac1 mac(m_agent.publicKey);
    QVERIFY(Responder::read(m_agent, message));
    for (std::size_t bit = 0; bit < kFirstLength * 8; ++bit) {
        auto changed = flipped(message, bit);
        QVERIFY(!mac.verify(changed));
        if (bit < 8 || bit >= (kFirstLength - kMacLength) * 8)
            continue;
        // An attacker with the public key can recompute mac1; the message is still refused.
        mac.sign(changed);
        HOLDS(!Responder::read(m_agent, changed), "no changed first message is read");
    }
}

void AttackHandshakeTest::everyBitOfTheAnswer()
{
    auto initiator = begin();
    auto responder = Responder::read(m_agent, initiator.message());
    QVERIFY(responder);
    const auto answer = std::move(*responder).answer(known(m_station), ConnectionId{0x4321}, m_offer, m_random);
    QVERIFY(answer);
    const Mac1 mac(m_station.publicKey);
    for (std::size_t bit = kAnswerLength * 8; bit-- > 0;) {
        auto changed = flipped(answer->message, bit);
        QVERIFY(!initiator.readAnswer(changed));
        if (bit < 24 || bit >= (kAnswerLength - kMacLength) * 8)
            continue;
        mac.sign(changed);
        HOLDS(!initiator.readAnswer(changed), "no changed answer is taken");
    }
    QVERIFY(initiator.readAnswer(answer->message)); // unaffected by the refused ones
}

void AttackHandshakeTest::suiteOutsideTheOffers()
{
    // An agent, or an attacker in its place, chooses a suite that does not follow from the two offers.
    for (const auto &suite : crypto::suites()) {
        auto initiator = begin();
        auto state = noise::HandshakeState::responder(asBytes(kPrologueText), m_agent.clone());
        state.setPsk(Key32());
        std::array<std::uint8_t, FirstPayload::kLength> payload;
        QVERIFY(state.readMessage(ByteView(initiator.message()).subspan(1, kFirstNoiseLength), payload));
        AnswerMessage message{};
        message[0] = firstByte(HandshakeMessage::Answer);
        message[1] = 0x34;
        message[2] = 0x12;
        const auto said = AnswerPayload{ConnectionId{2}, m_offer, suite.id}.write();
        QVERIFY(state.writeMessage(said, MutableByteView(message).subspan(3, kAnswerNoiseLength), m_random));
        Mac1(m_station.publicKey).sign(message);
        const auto agreement = initiator.readAnswer(message);
        HOLDS(agreement.has_value() == (suite.id == SuiteId::ChaCha20Poly1305), "no other choice is taken");
        if (!agreement)
            QCOMPARE(agreement.error(), RefusalReason::OfferTampered);
    }
}

void AttackHandshakeTest::otherVersionOrCarrier()
{
    for (const char *text :
         {"skyseal channel v2\x01", "skyseal channel v1\x02", "skyseal channel v1\x03", "skyseal channel v1\x01"}) {
        const std::string prologue(text);
        auto state = noise::HandshakeState::initiator(asBytes(prologue), m_station.clone(), m_agent.publicKey);
        FirstMessage message{};
        message[0] = firstByte(HandshakeMessage::First);
        const auto payload = FirstPayload{ConnectionId{1}, m_offer, 1}.write();
        QVERIFY(state.writeMessage(payload, MutableByteView(message).subspan(1, kFirstNoiseLength), m_random));
        Mac1(m_agent.publicKey).sign(message);
        HOLDS(Responder::read(m_agent, message).has_value() == (prologue == kPrologueText),
              "no message of another version or carrier is read");
    }
}

SKYSEAL_TEST(AttackHandshakeTest)
#include "attack_handshake_test.moc"
