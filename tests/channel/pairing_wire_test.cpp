// Datagrams of attackers during a pairing: recordings, reflections, changed bits and floods.
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/channel/pairing_handshake.h"
#include "core/crypto/init_crypto.h"
#include "pairing_pair.h"
#include "tap.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <map>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class PairingWireTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void replayOfAWholePairing();
    void reflection();
    void everyBitFlipped();
    void wordsOfElsewhere();
    void lateAnswerOfAnother();
    void shownOnlyWithThePrivateKey();
    void floodWithoutTheToken();
    void floodWithTheToken();
    void floodOfFalseOpenings();
    void floodOfFalseAnswers();
    void forgedCalls();
    void noMoreOutThanIn();
    void requestsAreAnsweredWhereTheAgentListens();
    void onlyTheLastAnswersAreKept();
    void moreCallersThanPlaces();
};

void PairingWireTest::replayOfAWholePairing()
{
    PairingPair pair;
    Tap recorded(pair);
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(20s, [&] { return pair.ground().pairing->finished() && pair.air().pairing->finished(); }));
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
    for (PairingSide &side : pair.ends)
        side.events.clear();
    pair.openBoth(); // Later, new windows; nobody answers but the recording.
    for (int round = 0; round < 5; ++round) {
        for (const SentDatagram &flight : recorded.flights) {
            pair.link.inject(pair.now, flight);
            pair.run(30ms);
        }
    }
    for (const PairingSide &side : pair.ends)
        QVERIFY(side.all<PairingPeerSeen>().empty() && side.all<Paired>().empty());
}

void PairingWireTest::reflection()
{
    // Reflection: an end's messages come back to it from the other end's address. Two roles of one key do not pair.
    PairingPair pair;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        SentDatagram back = flight;
        back.from = flight.from == Ground ? Air : Ground;
        pair.link.inject(pair.now + 1ms, back);
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(3s, [&] { return pair.shown(); }));
    pair.confirm(Air);
    pair.run(5s);
    QVERIFY(!pair.air().pairing->confirmedThere());
    QVERIFY(pair.air().all<Paired>().empty());

    PairingPair same;
    same.air().config.identity = same.ground().config.identity;
    same.openBoth();
    same.run(30s);
    QVERIFY(same.ground().all<PairingPeerSeen>().empty() && same.air().all<PairingPeerSeen>().empty());
}

void PairingWireTest::everyBitFlipped()
{
    SeededRandom random(9);
    const auto station = newIdentity(random), agent = newIdentity(random);
    const PairingToken token{1, 2, 3};
    const auto sameStation = [&] {
        SeededRandom same(10);
        return handshakeAs(Ground, station, PairingId{0x01020304}, token, same);
    };
    auto here = sameStation();
    const auto flipped = [](auto bytes, std::size_t bit) {
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
        return bytes;
    };
    // A changed hello is refused, or its reader cannot read the opening: shares and commitments are part of the keys.
    const auto first = here.first();
    for (std::size_t bit = 8; bit < first.size() * 8; ++bit) {
        const auto changed = flipped(first, bit);
        const auto head = readFirst(changed);
        auto reader = handshakeAs(Air, agent, head ? head->id : PairingId{}, head ? head->token : token, random);
        auto sender = sameStation();
        if (reader.takeFirst(changed) && sender.takeAnswer(reader.answer()))
            QVERIFY(!reader.takeOpening(sender.opening()));
    }
    auto there = handshakeAs(Air, agent, PairingId{0x01020304}, token, random);
    QVERIFY(there.takeFirst(first));
    const auto answer = there.answer();
    QVERIFY(here.takeAnswer(answer));
    const auto opening = here.opening();
    for (std::size_t bit = 0; bit < opening.size() * 8; ++bit)
        QVERIFY(!there.takeOpening(flipped(opening, bit)));
    const auto seenThere = there.takeOpening(opening);
    QVERIFY(seenThere);
    for (std::size_t bit = 0; bit < opening.size() * 8; ++bit)
        QVERIFY(!here.takeOpening(flipped(there.opening(), bit)));
    QVERIFY(!here.takeOpening(opening)); // The directions have keys of their own.
    const auto seenHere = here.takeOpening(there.opening());
    QVERIFY(seenHere);
    QCOMPARE(seenHere->key, agent->publicKey);
    QCOMPARE(seenThere->key, station->publicKey);
    QCOMPARE(here.code(), there.code());
    auto sender = *here.finish(), receiver = *there.finish();
    for (const Decision mine : {Decision::None, Decision::Yes, Decision::No}) {
        for (const Heard heard : {Heard::Nothing, Heard::Yes, Heard::No, Heard::AllIsSaid}) {
            const auto word = sender.seal({mine, heard});
            for (std::size_t bit = 0; bit < word.size() * 8; ++bit)
                QVERIFY(!receiver.open(flipped(word, bit)));
            const auto opened = receiver.open(word);
            QVERIFY(opened && opened->mine == mine && opened->heard == heard);
            QVERIFY(!sender.open(word)); // The directions have keys of their own.
            QCOMPARE(sender.seal({mine, heard}), word);
        }
    }
    QVERIFY(sender.presharedKey()->equals(*receiver.presharedKey()));
}

void PairingWireTest::wordsOfElsewhere()
{
    // Words of one pairing, repeated in the next between the same devices.
    PairingPair pair;
    std::vector<SentDatagram> words;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (isWord(flight.bytes))
            words.push_back(flight);
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    const std::vector<SentDatagram> old = words;
    pair.openBoth();
    QVERIFY(pair.run(3s, [&] { return pair.shown(); }));
    for (const SentDatagram &flight : old) {
        pair.link.inject(pair.now, flight);
        SentDatagram sameId = flight; // And with the id of the present one.
        std::copy_n(words.back().bytes.begin() + 1, 4, sameId.bytes.begin() + 1);
        pair.link.inject(pair.now, sameId);
    }
    pair.run(2s);
    QVERIFY(!pair.ground().pairing->confirmedThere() && !pair.air().pairing->confirmedThere());
    QCOMPARE(pair.ground().all<Paired>().size(), 1u);
}

void PairingWireTest::lateAnswerOfAnother()
{
    // Another device reads the station's first message and answers before the agent. It receives the only opening of this
    // window, and cannot continue with the agent.
    PairingPair pair;
    SeededRandom random(15);
    const auto other = newIdentity(random);
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        const auto head = readFirst(flight.bytes);
        if (!head)
            return true;
        auto quick = handshakeAs(Air, other, head->id, head->token, random);
        if (quick.takeFirst(flight.bytes)) {
            const auto answer = quick.answer();
            pair.link.inject(pair.now, {Air, 0, 0, Bytes(answer.begin(), answer.end())});
        }
        return true;
    };
    pair.openBoth();
    pair.run(20s);
    QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::Interrupted);
    for (const PairingSide &side : pair.ends)
        QVERIFY(side.all<PairingPeerSeen>().empty() && side.all<Paired>().empty());
    pair.link.attacker = {};
    pair.openBoth();
    QVERIFY(pair.run(30s, [&] { return pair.shown(); }));
}

void PairingWireTest::shownOnlyWithThePrivateKey()
{
    // A station shows the public key of another device, without its private key.
    PairingPair pair;
    SeededRandom random(16);
    const auto victim = newIdentity(random);
    auto claimed = crypto::X25519KeyPair::generate(random);
    claimed.publicKey = victim->publicKey;
    Stranger stranger(pair);
    pair.open(Air);
    QVERIFY(pair.run(1s, [&] { return stranger.token.has_value(); }));
    Path from{LinkId{1}, {}};
    from.remote.ip[15] = 77;
    for (const bool holdsKey : {false, true}) {
        if (holdsKey)
            pair.open(Air);
        pair.run(1s);
        pair.elsewhere = [&](Side, const Transmit &out) { stranger.received.assign(out.bytes.begin(), out.bytes.end()); };
        auto handshake = handshakeAs(Ground,
                                     holdsKey ? victim : std::make_shared<const crypto::X25519KeyPair>(std::move(claimed)),
                                     PairingId{1}, *stranger.token, random);
        pair.air().pairing->handleDatagram(pair.now, from, handshake.first());
        pair.pump();
        QVERIFY(handshake.takeAnswer(stranger.received));
        pair.elsewhere = [&](Side, const Transmit &out) {
            if (isOpening(out.bytes))
                stranger.received.assign(out.bytes.begin(), out.bytes.end());
        };
        pair.air().pairing->handleDatagram(pair.now, from, handshake.opening());
        pair.pump();
        QVERIFY(handshake.takeOpening(stranger.received));
        auto words = handshake.finish();
        QVERIFY(words);
        pair.air().pairing->handleDatagram(pair.now, from, words->seal({}));
        pair.pump();
        QCOMPARE(pair.air().sees(victim->publicKey), holdsKey);
    }
}

void PairingWireTest::floodWithoutTheToken()
{
    PairingPair pair;
    SeededRandom random(21);
    std::uint64_t answers = 0;
    pair.elsewhere = [&](Side, const Transmit &) { ++answers; };
    pair.open(Air);
    PairingDatagram datagram;
    const auto flood = [&](int count) {
        for (int i = 0; i < count; ++i) {
            random.fill(datagram);
            datagram[0] = firstByte(PairingMessage::First);
            Path from{LinkId{1}, {}};
            from.remote.ip[15] = static_cast<std::uint8_t>(50 + i % 100);
            pair.air().pairing->handleDatagram(pair.now, from, datagram);
        }
        pair.pump();
    };
    for (int ms = 0; ms < 500; ++ms) {
        flood(20);
        pair.run(1ms);
    }
    QCOMPARE(answers, std::uint64_t(0));
    pair.open(Ground);
    bool shown = false;
    for (int ms = 0; ms < 3000 && !shown; ++ms) {
        flood(20);
        pair.run(1ms);
        shown = pair.shown();
    }
    QVERIFY(shown);
}

void PairingWireTest::floodWithTheToken()
{
    // Somebody hears the calls and has a thousand addresses. The agent computes little, and first for those it calls.
    PairingPair pair;
    SeededRandom random(22);
    PairingToken token{};
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (const auto called = calledToken(flight.bytes))
            token = *called;
        return true;
    };
    std::uint64_t in = 0, out = 0, answers = 0;
    pair.elsewhere = [&](Side, const Transmit &transmit) {
        ++answers;
        out += transmit.bytes.size();
    };
    pair.open(Air);
    const TimePoint start = pair.now;
    const PairingDatagram sample = handshakeAs(Ground, newIdentity(random), PairingId{1}, token, random).first();
    std::uint32_t count = 0;
    const auto flood = [&] {
        for (int i = 0; i < 20; ++i) {
            ++count;
            PairingDatagram datagram = sample;
            std::copy_n(reinterpret_cast<const std::uint8_t *>(&count), 4, datagram.begin() + 1);
            std::copy(token.begin(), token.end(), datagram.begin() + 5);
            Path from{LinkId{1}, {}};
            from.remote.ip[10] = from.remote.ip[11] = 0xff; // IPv4
            from.remote.ip[14] = static_cast<std::uint8_t>(1 + count % 5);
            from.remote.ip[15] = static_cast<std::uint8_t>(count / 5 % 200);
            in += datagram.size();
            pair.air().pairing->handleDatagram(pair.now, from, datagram);
        }
        pair.pump();
    };
    for (int ms = 0; ms < 500; ++ms) {
        flood();
        pair.run(1ms);
    }
    pair.open(Ground);
    bool shown = false;
    for (int ms = 0; ms < 3000 && !shown; ++ms) {
        flood();
        pair.run(1ms);
        shown = pair.shown();
    }
    QVERIFY(shown);
    QVERIFY(static_cast<double>(answers) <= 15 * seconds(pair.now - start) + 20);
    QVERIFY(out <= in);
}

void PairingWireTest::floodOfFalseOpenings()
{
    // Another device hears a call, has its first message answered, and sends twenty wrong openings a millisecond. Without a
    // passphrase the window stays open, and a station beside it is shown.
    PairingPair pair;
    SeededRandom random(25);
    Path from{LinkId{1}, {}};
    from.remote.ip[15] = 77;
    Stranger stranger(pair);
    pair.open(Air);
    QVERIFY(pair.run(1s, [&] { return stranger.token.has_value(); }));
    auto handshake = handshakeAs(Ground, newIdentity(random), PairingId{1}, *stranger.token, random);
    pair.air().pairing->handleDatagram(pair.now, from, handshake.first());
    pair.pump();
    QVERIFY(handshake.takeAnswer(stranger.received));
    OpeningDatagram wrong = handshake.opening();
    wrong.back() ^= 1;
    for (int ms = 0; ms < 3000 && (ms <= 100 || !pair.shown()); ++ms) {
        for (int i = 0; i < 20; ++i)
            pair.air().pairing->handleDatagram(pair.now, from, wrong);
        if (ms == 100)
            pair.open(Ground);
        pair.run(1ms);
    }
    QVERIFY(pair.shown());
    QVERIFY(!pair.air().over());
}

void PairingWireTest::floodOfFalseAnswers()
{
    // An eavesdropper reads the pairing id in the station's first messages, and sends twenty answers with invalid shares a
    // millisecond. Each id is given up after one of them.
    PairingPair pair;
    SeededRandom random(24);
    std::set<PairingId> ids;
    std::optional<PairingId> known, heard;
    TimePoint knownFrom = kNever;
    bool jammed = true;
    pair.link.attacker = [&](TimePoint at, SentDatagram &flight) {
        if (const auto head = readFirst(flight.bytes); head && heard != head->id) {
            heard = head->id;
            knownFrom = at + 3ms; // it is no nearer than the agent
            ids.insert(head->id);
        }
        return !jammed || flight.bytes[0] != firstByte(PairingMessage::Answer);
    };
    const auto flood = [&] {
        if (pair.now >= knownFrom)
            known = heard;
        for (int i = 0; i < 20 && known; ++i) {
            PairingHello hello{*known};
            random.fill(hello.commitment);
            hello.share.fill(0xff);
            const PairingAnswer datagram = pairingAnswer(hello);
            pair.ground().pairing->handleDatagram(pair.now, PairingPair::pathOf(Air), datagram);
        }
        pair.pump();
    };
    pair.openBoth();
    bool shown = false;
    for (int ms = 0; ms < 5000 && !shown; ++ms) {
        jammed = ms < 2000;
        flood();
        pair.run(1ms);
        shown = pair.shown();
    }
    QVERIFY(shown);
    QVERIFY2(ids.size() >= 3, qPrintable(QString::number(ids.size()))); // none was kept for its whole turn of three seconds
}

void PairingWireTest::forgedCalls()
{
    // Calls from ten addresses where nobody is: each has its turn, and so has the true one.
    PairingPair pair;
    SeededRandom random(23);
    std::vector<PairingDatagram> calls;
    for (int i = 0; i < 10; ++i) {
        PairingToken token;
        random.fill(token);
        calls.push_back(pairingCall(token));
    }
    std::uint64_t in = 0, out = 0;
    pair.elsewhere = [&](Side, const Transmit &transmit) { out += transmit.bytes.size(); };
    pair.openBoth();
    bool shown = false;
    for (int tick = 0; tick < 300 && !shown; ++tick) {
        for (std::size_t i = 0; i < calls.size(); ++i) {
            Path from{LinkId{1}, {}};
            from.remote.ip[15] = static_cast<std::uint8_t>(100 + i);
            in += calls[i].size();
            pair.ground().pairing->handleDatagram(pair.now, from, calls[i]);
        }
        pair.pump();
        pair.run(200ms);
        shown = pair.shown();
    }
    QVERIFY(shown);
    QVERIFY(out <= in);
}

void PairingWireTest::noMoreOutThanIn()
{
    // Recorded messages are replayed to either end alone, repeatedly, in a new window.
    PairingPair pair;
    Tap recorded(pair);
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.run(2s);
    for (const Side victim : {Ground, Air}) {
        PairingPair fresh;
        std::uint64_t in = 0, out = 0;
        fresh.link.attacker = [&](TimePoint, SentDatagram &flight) {
            out += calledToken(flight.bytes) ? 0 : flight.bytes.size(); // A call is no answer to anything.
            return false;
        };
        fresh.open(victim);
        for (int round = 0; round < 30; ++round) {
            for (const SentDatagram &flight : recorded.flights) {
                if (flight.from == victim)
                    continue;
                fresh.link.inject(fresh.now, flight);
                in += flight.bytes.size();
                fresh.run(20ms);
            }
        }
        fresh.run(30s);
        QVERIFY2(out <= in, qPrintable(QStringLiteral("%1 out, %2 in").arg(out).arg(in)));
    }
}

/// By one call each, which has the length of the request; not elsewhere, not by a station, not after an opening.
void PairingWireTest::requestsAreAnsweredWhereTheAgentListens()
{
    const auto request = pairingRequest();
    Path stranger{LinkId{1}, {}}, elsewhere{LinkId{2}, {}};
    stranger.remote.port = elsewhere.remote.port = 9;
    for (const bool listens : {false, true}) {
        PairingPair pair;
        if (listens)
            pair.letAirListen();
        std::map<std::pair<Side, LinkId>, std::uint64_t> bytesOut;
        pair.elsewhere = [&](Side side, const Transmit &out) { bytesOut[{side, out.to.link}] += out.bytes.size(); };
        pair.openBoth();
        constexpr std::size_t kRequests = 50;
        const auto ask = [&] {
            for (std::size_t i = 0; i < kRequests; ++i) {
                for (const Path &from : {stranger, elsewhere}) {
                    for (PairingSide &end : pair.ends)
                        end.pairing->handleDatagram(pair.now, from, request);
                    pair.pump();
                }
            }
        };
        ask();
        QCOMPARE((bytesOut[{Air, stranger.link}]), listens ? std::uint64_t(kRequests * request.size()) : std::uint64_t(0));
        QCOMPARE((bytesOut[{Air, elsewhere.link}]), std::uint64_t(0));
        QCOMPARE((bytesOut[{Ground, stranger.link}]), std::uint64_t(0));
        QVERIFY(pair.run(3s, [&] { return pair.shown(); }));
        bytesOut.clear();
        ask();
        QVERIFY(bytesOut.empty());
        // Bytes behind the first make it a call, which an agent ignores.
        Bytes call(request.begin(), request.end());
        call.back() = 1;
        QVERIFY(!isPairingRequest(call) && calledToken(call) && !calledToken(request));
    }
}

void PairingWireTest::onlyTheLastAnswersAreKept()
{
    PairingPair pair;
    SeededRandom random(31);
    Stranger stranger(pair);
    pair.open(Air);
    pair.run(100ms);
    QVERIFY(stranger.token);
    struct Caller
    {
        Path from;
        OpeningDatagram opening;
    };
    std::vector<Caller> callers;
    for (unsigned i = 0; i < 9; ++i) {
        Path from = PairingPair::pathOf(Ground);
        from.remote.ip[0] = static_cast<std::uint8_t>(50 + i); // another host each: one has a share of five
        auto handshake = handshakeAs(Ground, newIdentity(random), PairingId{i + 1}, *stranger.token, random);
        pair.air().pairing->handleDatagram(pair.now, from, handshake.first());
        pair.pump();
        QVERIFY(handshake.takeAnswer(stranger.received));
        callers.push_back({from, handshake.opening()});
    }
    const auto isAnswered = [&](const Caller &caller) {
        stranger.received.clear();
        pair.air().pairing->handleDatagram(pair.now, caller.from, caller.opening);
        pair.pump();
        return !stranger.received.empty();
    };
    QVERIFY(!isAnswered(callers.front()));
    QVERIFY(isAnswered(callers.back()));
}

void PairingWireTest::moreCallersThanPlaces()
{
    PairingPair pair;
    SeededRandom random(32);
    std::uint64_t out = 0;
    pair.elsewhere = [&](Side, const Transmit &) { ++out; };
    pair.open(Ground);
    for (unsigned i = 0; i < 200; ++i) {
        Path from = PairingPair::pathOf(Air);
        from.remote.ip[14] = 7;
        from.remote.ip[15] = static_cast<std::uint8_t>(i);
        PairingToken token;
        random.fill(token);
        pair.ground().pairing->handleDatagram(pair.now, from, pairingCall(token));
        pair.run(1ms);
    }
    QVERIFY(out <= 1); // One at a time.
    pair.open(Air);
    QVERIFY(pair.run(30s, [&] { return pair.shown(); }));
}

SKYSEAL_TEST(PairingWireTest)
#include "pairing_wire_test.moc"
