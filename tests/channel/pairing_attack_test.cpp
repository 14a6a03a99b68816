// Somebody on the wire while two people pair: in between, beside, with a recording, or with a flood.
#include "core/channel/pairing_handshake.h"
#include "core/crypto/init_crypto.h"
#include "pairing_pair.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class PairingAttackTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void inBetween();
    void inBetweenWithoutThePassphrase();
    void passphraseMustBeTheSame();
    void anotherWhileComparing();
    void replayOfAWholePairing();
    void reflection();
    void everyBitFlipped();
    void wordsOfElsewhere();
    void lateAnswerOfAnother();
    void floodWithoutTheToken();
    void floodWithTheToken();
    void forgedCalls();
    void noMoreOutThanIn();
};

namespace {

std::shared_ptr<const Key32> secret(std::uint8_t first)
{
    Key32 key;
    key.mutableView()[0] = first;
    return std::make_shared<const Key32>(std::move(key));
}

std::shared_ptr<const crypto::X25519KeyPair> newKey(RandomSource &random)
{
    return std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(random));
}

/// Who is in between: an agent of its own towards the station, and a station of its own towards the agent, at the true
/// ends' addresses. Everything that either end sends goes to it alone.
struct InBetween
{
    explicit InBetween(PairingPair &victims, std::shared_ptr<const Key32> passphraseKey = {}) : pair(victims)
    {
        for (const Side as : {Ground, Air}) {
            auto config = PairingPair::configOf(as, newKey(random));
            config.passphraseKey = passphraseKey;
            faces[as].emplace(config, random, pair.now);
            keys[as] = config.identity->publicKey;
        }
        pair.link.attacker = [this](TimePoint, Flight &flight) {
            const Side as = flight.from == Ground ? Air : Ground;
            faces[as]->handleDatagram(pair.now, PairingPair::pathOf(flight.from), flight.bytes);
            pump();
            return false;
        };
    }
    void pump()
    {
        for (const Side as : {Ground, Air}) {
            faces[as]->handleDeadline(pair.now);
            while (const auto out = faces[as]->pollTransmit())
                pair.link.inject(pair.now + 1ms, {as, 0, 0, Bytes(out->bytes.begin(), out->bytes.end())});
            if (faces[as]->peer())
                faces[as]->confirm(pair.now, faces[as]->peer()->key);
            while (const auto event = faces[as]->pollEvent())
                hints += std::holds_alternative<PairingPassphraseDiffers>(*event);
        }
    }

    PairingPair &pair;
    SeededRandom random{666};
    std::array<std::optional<Pairing>, 2> faces;
    std::array<channel::PublicKey, 2> keys;
    int hints = 0;
};

} // namespace

void PairingAttackTest::inBetween()
{
    PairingPair pair;
    InBetween attacker(pair);
    pair.openBoth();
    pair.run(5s);
    // It gets through, and what the two people see are two keys, neither of them the other one's.
    QVERIFY(pair.ground().pairing->peer() && pair.air().pairing->peer());
    QCOMPARE(pair.ground().pairing->peer()->key, attacker.keys[Air]);
    QCOMPARE(pair.air().pairing->peer()->key, attacker.keys[Ground]);
    QVERIFY(!pair.shown());
    pair.confirm(Ground); // "Yes, if it is the key of the drone": it is not.
    pair.confirm(Air);
    QVERIFY(!pair.ground().pairing->confirmedHere() && !pair.air().pairing->confirmedHere());
    pair.ground().pairing->refuse(pair.now);
    pair.air().pairing->refuse(pair.now);
    pair.run(30s);
    QVERIFY(pair.ground().all<Paired>().empty() && pair.air().all<Paired>().empty());
    QVERIFY(!pair.ground().pairing->peer() && !pair.air().pairing->peer()); // Not shown again.
}

void PairingAttackTest::inBetweenWithoutThePassphrase()
{
    for (const bool guesses : {false, true}) {
        PairingPair pair;
        pair.ground().config.passphraseKey = pair.air().config.passphraseKey = secret(7);
        InBetween attacker(pair, guesses ? secret(8) : nullptr);
        pair.openBoth();
        pair.run(100s);
        QVERIFY(pair.ground().all<PairingPeerSeen>().empty());
        QVERIFY(pair.air().all<PairingPeerSeen>().empty());
        QVERIFY(!pair.ground().all<PairingPassphraseDiffers>().empty());
        QVERIFY(!pair.air().all<PairingPassphraseDiffers>().empty());
    }
}

void PairingAttackTest::passphraseMustBeTheSame()
{
    const std::shared_ptr<const Key32> keys[] = {nullptr, secret(1), secret(2)};
    for (const auto &here : keys) {
        for (const auto &there : keys) {
            PairingPair pair;
            pair.ground().config.passphraseKey = here;
            pair.air().config.passphraseKey = there;
            pair.openBoth();
            QCOMPARE(pair.run(20s, [&] { return pair.shown(); }), here == there);
            QCOMPARE(pair.ground().all<PairingPeerSeen>().size(), here == there ? 1u : 0u);
            QCOMPARE(pair.air().all<PairingPeerSeen>().size(), here == there ? 1u : 0u);
            QCOMPARE(pair.ground().all<PairingPassphraseDiffers>().empty(), here == there);
            QCOMPARE(pair.air().all<PairingPassphraseDiffers>().empty(), here == there);
        }
    }
}

void PairingAttackTest::anotherWhileComparing()
{
    // A second device that hears the calls does the whole handshake while the first is on the screen.
    PairingPair pair;
    PairingToken token{};
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        if (const auto called = calledToken(flight.bytes))
            token = *called;
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    Path elsewhere = PairingPair::pathOf(Ground);
    elsewhere.remote.ip[15] = 99;
    SeededRandom random(5);
    const auto other = newKey(random);
    std::optional<PairingVoice> voice;
    Bytes answer;
    pair.elsewhere = [&](Side, const Transmit &out) { answer.assign(out.bytes.begin(), out.bytes.end()); };
    for (std::uint32_t id = 1; id <= 30; ++id) {
        auto handshake = PairingHandshake::begin(noise::Role::Initiator, *other, nullptr, PairingId{id}, token);
        pair.air().pairing->handleDatagram(pair.now, elsewhere, *handshake->first(random));
        pair.pump();
        QVERIFY(handshake->takeAnswer(answer));
        pair.air().pairing->handleDatagram(pair.now, elsewhere, *handshake->third({}, random));
        pair.pump();
        QVERIFY(pair.shown()); // Who came first stays.
        pair.run(500ms);
    }
    const auto told = pair.air().all<PairingOtherTried>();
    QVERIFY(!told.empty() && told.size() <= 16);
    QCOMPARE(told[0].peer.key, other->publicKey);
    pair.air().pairing->confirm(pair.now, other->publicKey);
    QVERIFY(!pair.air().pairing->confirmedHere());
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    QCOMPARE(pair.air().all<Paired>()[0].peer.key, pair.ground().identity->publicKey);
}

void PairingAttackTest::replayOfAWholePairing()
{
    PairingPair pair;
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(20s, [&] { return pair.ground().pairing->finished() && pair.air().pairing->finished(); }));
    pair.link.attacker = [](TimePoint, Flight &) { return false; };
    for (PairingSide &side : pair.ends)
        side.events.clear();
    pair.openBoth(); // Later, new windows; nobody answers but the recording.
    for (int round = 0; round < 5; ++round) {
        for (const Flight &flight : recorded) {
            pair.link.inject(pair.now, flight);
            pair.run(30ms);
        }
    }
    for (const PairingSide &side : pair.ends)
        QVERIFY(side.all<PairingPeerSeen>().empty() && side.all<Paired>().empty());
}

void PairingAttackTest::reflection()
{
    // What an end sends comes back to it, from the other end's address; and two roles of one key do not pair.
    PairingPair pair;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        Flight back = flight;
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

void PairingAttackTest::everyBitFlipped()
{
    SeededRandom random(9);
    const auto station = newKey(random), agent = newKey(random);
    const PairingToken token{1, 2, 3};
    const auto make = [&](noise::Role role, const auto &key) {
        return *PairingHandshake::begin(role, *key, nullptr, PairingId{0x01020304}, token);
    };
    auto here = make(noise::Role::Initiator, station), there = make(noise::Role::Responder, agent);
    const auto flipped = [](auto bytes, std::size_t bit) {
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
        return bytes;
    };
    const auto first = *here.first(random);
    for (std::size_t bit = 8; bit < first.size() * 8; ++bit) {
        const auto changed = flipped(first, bit);
        const auto head = firstHead(changed);
        auto reader = *PairingHandshake::begin(noise::Role::Responder, *agent, nullptr, head->id, head->token);
        QVERIFY(!reader.takeFirst(changed));
    }
    QVERIFY(there.takeFirst(first));
    const auto answer = *there.answer({}, random);
    for (std::size_t bit = 0; bit < answer.size() * 8; ++bit)
        QVERIFY(!here.takeAnswer(flipped(answer, bit)));
    QVERIFY(here.takeAnswer(answer));
    const auto third = *here.third({}, random);
    for (std::size_t bit = 0; bit < third.size() * 8; ++bit)
        QVERIFY(!there.takeThird(flipped(third, bit)));
    QVERIFY(there.takeThird(third));
    QCOMPARE(here.peer(), agent->publicKey);
    QCOMPARE(there.peer(), station->publicKey);
    auto mouth = *std::move(here).finish(), ear = *std::move(there).finish();
    for (const Decision mine : {Decision::None, Decision::Yes, Decision::No}) {
        for (const Heard heard : {Heard::Nothing, Heard::Yes, Heard::No, Heard::AllIsSaid}) {
            const auto word = mouth.say({mine, heard});
            for (std::size_t bit = 0; bit < word.size() * 8; ++bit)
                QVERIFY(!ear.hear(flipped(word, bit)));
            const auto said = ear.hear(word);
            QVERIFY(said && said->mine == mine && said->heard == heard);
            QVERIFY(!mouth.hear(word)); // The directions have keys of their own.
            QCOMPARE(mouth.say({mine, heard}), word);
        }
    }
    QVERIFY(mouth.presharedKey()->equals(*ear.presharedKey()));
}

void PairingAttackTest::wordsOfElsewhere()
{
    // Words of one pairing, repeated in the next between the same devices.
    PairingPair pair;
    std::vector<Flight> words;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        if (isWord(flight.bytes))
            words.push_back(flight);
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    const std::vector<Flight> old = words;
    pair.openBoth();
    QVERIFY(pair.run(3s, [&] { return pair.shown(); }));
    for (const Flight &flight : old) {
        pair.link.inject(pair.now, flight);
        Flight sameId = flight; // And with the id of the present one.
        std::copy_n(words.back().bytes.begin() + 1, 4, sameId.bytes.begin() + 1);
        pair.link.inject(pair.now, sameId);
    }
    pair.run(2s);
    QVERIFY(!pair.ground().pairing->confirmedThere() && !pair.air().pairing->confirmedThere());
    QCOMPARE(pair.ground().all<Paired>().size(), 1u);
}

void PairingAttackTest::lateAnswerOfAnother()
{
    // Somebody reads the station's first message and is quicker than the agent: its own key is all that it can show.
    PairingPair pair;
    SeededRandom random(15);
    const auto other = newKey(random);
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        const auto head = firstHead(flight.bytes);
        if (!head)
            return true;
        auto quick = *PairingHandshake::begin(noise::Role::Responder, *other, nullptr, head->id, head->token);
        if (quick.takeFirst(flight.bytes)) {
            const auto answer = *quick.answer({}, random);
            pair.link.inject(pair.now, {Air, 0, 0, Bytes(answer.begin(), answer.end())});
        }
        return true;
    };
    pair.openBoth();
    pair.run(20s);
    for (const PairingSide &side : pair.ends) {
        for (const auto &seen : side.all<PairingPeerSeen>())
            QVERIFY(seen.peer.key == other->publicKey || seen.peer.key == pair.air().identity->publicKey
                    || seen.peer.key == pair.ground().identity->publicKey);
        QVERIFY(side.all<Paired>().empty());
    }
    pair.link.attacker = {}; // It stops, and all is well.
    QVERIFY(pair.run(30s, [&] { return pair.shown(); }));
}

void PairingAttackTest::floodWithoutTheToken()
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

void PairingAttackTest::floodWithTheToken()
{
    // Somebody hears the calls and has a thousand addresses. The agent computes little, and first for those it calls.
    PairingPair pair;
    SeededRandom random(22);
    PairingToken token{};
    pair.link.attacker = [&](TimePoint, Flight &flight) {
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
    PairingHandshake handshake =
        *PairingHandshake::begin(noise::Role::Initiator, *newKey(random), nullptr, PairingId{1}, token);
    PairingDatagram sample = *handshake.first(random);
    std::uint32_t count = 0;
    const auto flood = [&] {
        for (int i = 0; i < 20; ++i) {
            ++count;
            PairingDatagram datagram = sample; // A right head; what is behind it fails after a Diffie-Hellman.
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

void PairingAttackTest::forgedCalls()
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

void PairingAttackTest::noMoreOutThanIn()
{
    // What was recorded, given to either end alone in a new window, again and again.
    PairingPair pair;
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.run(2s);
    for (const Side victim : {Ground, Air}) {
        PairingPair fresh;
        std::uint64_t in = 0, out = 0;
        fresh.link.attacker = [&](TimePoint, Flight &flight) {
            out += calledToken(flight.bytes) ? 0 : flight.bytes.size(); // A call is no answer to anything.
            return false;
        };
        fresh.open(victim);
        for (int round = 0; round < 30; ++round) {
            for (const Flight &flight : recorded) {
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

QTEST_GUILESS_MAIN(PairingAttackTest)
#include "pairing_attack_test.moc"
