// Pairing: two people who both confirm get each other's key; in every other case neither gets anything.
#include "core/channel/pairing_handshake.h"
#include "core/crypto/init_crypto.h"
#include "pairing_pair.h"
#include "tap.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class PairingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void bothSayYes();
    void agentThatListens();
    void noIsTold();
    void eitherOrder();
    void passphraseNeedsNoCode();
    void wrongKeyIsNotConfirmed();
    void cancelledWhenArmed();
    void windowCloses();
    void badLinks();
    void lastWordLost();
    void restartsMidway();
    void otherEndDies();
    void namesAreCleaned();
    void unansweredOpeningEndsTheWindow();
    void systemsAreBound();
    void oversizedAndShort();
};

namespace {

bool isNothing(const PairingSide &end)
{
    return end.all<Paired>().empty();
}

} // namespace

void PairingTest::bothSayYes()
{
    PairingPair pair;
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    QCOMPARE(pair.air().pairing->peer()->name, std::string("tablet"));
    QCOMPARE(pair.ground().pairing->peer()->name, std::string("scout-1"));
    const std::string code = pair.air().pairing->peer()->code;
    QCOMPARE(pair.ground().pairing->peer()->code, code);
    QVERIFY2(code.size() == 7 && code[3] == ' ', code.c_str());
    pair.run(30s); // They take their time.
    QVERIFY(pair.shown() && isNothing(pair.ground()) && isNothing(pair.air()));
    pair.confirm(Air);
    QVERIFY(pair.run(1s, [&] { return pair.ground().pairing->confirmedThere(); }));
    QCOMPARE(pair.ground().all<PairingPeerConfirmed>().size(), 1u);
    pair.run(5s);
    QVERIFY(isNothing(pair.ground()) && isNothing(pair.air()));
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    const Peer air = pair.ground().all<Paired>()[0].peer, ground = pair.air().all<Paired>()[0].peer;
    QCOMPARE(air.key, publicKeyOf(*pair.air().identity));
    QCOMPARE(ground.key, publicKeyOf(*pair.ground().identity));
    QVERIFY(air.presharedKey && ground.presharedKey && air.presharedKey->equals(*ground.presharedKey));
    QVERIFY(!air.presharedKey->isZero());
    const auto words = pair.ground().bytesOut + pair.air().bytesOut;
    QVERIFY(pair.run(10s, [&] { return pair.ground().pairing->finished() && pair.air().pairing->finished(); }));
    QVERIFY(pair.ground().bytesOut + pair.air().bytesOut - words <= 6 * kWordLength);
    for (const PairingSide &end : pair.ends) {
        QCOMPARE(end.over()->reason, channel::PairingEnd::Paired);
        QVERIFY(std::holds_alternative<PairingOver>(end.events.back()));
        QCOMPARE(end.pairing->nextDeadline(), kNever);
    }
}

/// The station calls; without its request the agent sends nothing.
void PairingTest::agentThatListens()
{
    PairingPair pair;
    pair.letAirListen();
    pair.open(Air);
    pair.run(10s);
    QCOMPARE(pair.air().bytesOut, std::uint64_t(0));
    pair.open(Ground);
    QVERIFY(pair.run(3s, [&] { return pair.shown(); }));
    QCOMPARE(pair.ground().pairing->peer()->code, pair.air().pairing->peer()->code);
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(3s, [&] { return pair.paired(); }));

    // Over a link that loses a third.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        WireModel model;
        model.loss = 0.33;
        PairingPair lossy(seed, model);
        lossy.letAirListen();
        lossy.openBoth();
        QVERIFY2(lossy.run(30s, [&] { return lossy.shown(); }), qPrintable(QString::number(seed)));
    }
}

void PairingTest::noIsTold()
{
    for (const Side side : {Ground, Air}) {
        for (const bool otherSaidYes : {false, true}) {
            PairingPair pair;
            const Side other = side == Ground ? Air : Ground;
            pair.openBoth();
            QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
            if (otherSaidYes)
                pair.confirm(other);
            pair.run(1s);
            pair.ends[side].pairing->refuse(pair.now);
            QVERIFY(pair.run(1s, [&] { return pair.ends[other].over().has_value(); }));
            QCOMPARE(pair.ends[other].over()->reason, channel::PairingEnd::RefusedThere);
            QCOMPARE(pair.ends[side].over()->reason, channel::PairingEnd::Refused);
            pair.run(200s); // Neither is asked again.
            QCOMPARE(pair.ground().all<PairingPeerSeen>().size(), 1u);
            QCOMPARE(pair.air().all<PairingPeerSeen>().size(), 1u);
            QVERIFY(isNothing(pair.ground()) && isNothing(pair.air()));
            QVERIFY(pair.ground().pairing->finished() && pair.air().pairing->finished());
        }
    }
}

void PairingTest::eitherOrder()
{
    for (const Side first : {Ground, Air}) {
        for (const Duration between : {0ms, 1ms, 3ms, 500ms}) {
            for (const bool groundOpensFirst : {false, true}) {
                PairingPair pair;
                pair.open(groundOpensFirst ? Ground : Air);
                pair.run(7s);
                pair.open(groundOpensFirst ? Air : Ground);
                QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
                pair.confirm(first);
                pair.run(between);
                pair.confirm(first == Ground ? Air : Ground);
                QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
                pair.run(12s);
                QVERIFY(pair.ground().pairing->finished() && pair.air().pairing->finished());
                QCOMPARE(pair.ground().all<Paired>().size(), 1u);
                QCOMPARE(pair.air().all<Paired>().size(), 1u);
            }
        }
    }
}

void PairingTest::passphraseNeedsNoCode()
{
    PairingPair pair;
    pair.ground().config.passphrase = pair.air().config.passphrase = passphraseOf("blue heron at noon");
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Ground);
    pair.confirm(Air);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    QVERIFY(pair.ground().all<PairingPassphraseDiffers>().empty() && pair.air().all<PairingPassphraseDiffers>().empty());
}

void PairingTest::wrongKeyIsNotConfirmed()
{
    PairingPair pair;
    pair.openBoth();
    pair.confirm(Ground); // Nobody is shown yet.
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    channel::PublicKey near = publicKeyOf(*pair.air().identity);
    near[31] ^= 1;
    pair.ground().pairing->confirm(pair.now, near);
    pair.confirm(Air);
    pair.run(5s);
    QVERIFY(!pair.ground().pairing->confirmedHere());
    QVERIFY(isNothing(pair.ground()) && isNothing(pair.air()));
}

void PairingTest::cancelledWhenArmed()
{
    PairingPair pair;
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    pair.confirm(Ground);
    pair.run(1s);
    pair.air().pairing->cancel(pair.now, channel::PairingEnd::Armed);
    pair.confirm(Air); // Too late.
    pair.run(3s);
    QCOMPARE(pair.air().over()->reason, channel::PairingEnd::Armed);
    QVERIFY(pair.air().pairing->finished());
    QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::RefusedThere);
    QVERIFY(isNothing(pair.ground()) && isNothing(pair.air()));
    // And with nobody there.
    PairingPair alone;
    alone.open(Air);
    alone.air().pairing->cancel(alone.now);
    alone.pump();
    QVERIFY(alone.air().pairing->finished());
    QCOMPARE(alone.air().over()->reason, channel::PairingEnd::Cancelled);
}

void PairingTest::windowCloses()
{
    PairingPair pair;
    pair.open(Air);
    pair.run(119s);
    QVERIFY(!pair.air().over());
    pair.run(2s);
    QCOMPARE(pair.air().over()->reason, channel::PairingEnd::TimedOut);
    pair.open(Ground);
    pair.run(150s);
    QVERIFY(pair.ground().all<PairingPeerSeen>().empty());
    QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::TimedOut);
}

void PairingTest::badLinks()
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        WireModel model;
        model.loss = 0.3;
        model.duplicate = 0.2;
        model.corrupt = 0.05;
        model.delay = 50ms;
        model.jitter = 200ms;
        PairingPair pair(seed, model);
        pair.openBoth();
        const auto words = QStringLiteral("seed %1").arg(seed);
        // A changed byte in a share or a commitment interrupts a pairing: people start again.
        const auto isOver = [&] { return pair.ground().pairing->finished() || pair.air().pairing->finished(); };
        for (int attempt = 0; attempt < 5 && !pair.shown(); ++attempt) {
            if (attempt > 0)
                pair.openBoth();
            pair.run(60s, [&] { return pair.shown() || isOver(); });
        }
        QVERIFY2(pair.shown(), qPrintable(words));
        pair.confirm(seed & 1 ? Ground : Air);
        pair.run(2s);
        pair.confirm(seed & 1 ? Air : Ground);
        QVERIFY2(pair.run(10s, [&] { return pair.paired(); }), qPrintable(words));
        pair.run(20s);
        QVERIFY(pair.ground().pairing->finished() && pair.air().pairing->finished());
        QVERIFY(pair.ground().all<Paired>()[0].peer.presharedKey->equals(*pair.air().all<Paired>()[0].peer.presharedKey));
        QCOMPARE(pair.ground().all<Paired>().size(), 1u);
        QCOMPARE(pair.air().all<Paired>().size(), 1u);
    }
}

void PairingTest::lastWordLost()
{
    // The end that pairs first repeats its message until the other end has received it.
    for (const Side deaf : {Ground, Air}) {
        PairingPair pair;
        pair.openBoth();
        QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
        pair.confirm(deaf);
        pair.run(1s);
        pair.link.attacker = [&](TimePoint, SentDatagram &flight) { return flight.from == deaf; };
        pair.confirm(deaf == Ground ? Air : Ground);
        pair.run(4s);
        QVERIFY(isNothing(pair.ends[deaf]) && !isNothing(pair.ends[deaf == Ground ? Air : Ground]));
        pair.link.attacker = {};
        QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
        pair.run(12s);
        QVERIFY(pair.ground().pairing->finished() && pair.air().pairing->finished());
    }
}

void PairingTest::restartsMidway()
{
    for (const Side side : {Ground, Air}) {
        PairingPair pair;
        const Side other = side == Ground ? Air : Ground;
        pair.openBoth();
        QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
        pair.confirm(other);
        pair.ends[side].pairing.reset(); // Killed: it sends nothing.
        pair.open(side);
        QVERIFY(pair.run(12s, [&] { return pair.ends[other].over().has_value(); }));
        QCOMPARE(pair.ends[other].over()->reason, channel::PairingEnd::Interrupted);
        pair.openBoth();
        QVERIFY(pair.run(30s, [&] { return pair.shown(); }));
        QVERIFY(!pair.ends[other].pairing->confirmedHere()); // A new question.
        pair.confirm(Ground);
        pair.confirm(Air);
        QVERIFY(pair.run(2s, [&] { return pair.paired(); }));
    }
}

void PairingTest::otherEndDies()
{
    for (const Side side : {Ground, Air}) {
        PairingPair pair;
        const Side other = side == Ground ? Air : Ground;
        pair.openBoth();
        QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
        pair.ends[side].pairing.reset();
        pair.run(9s);
        QVERIFY(!pair.ends[other].over());
        pair.run(2s);
        QCOMPARE(pair.ends[other].over()->reason, channel::PairingEnd::Interrupted);
        QVERIFY(!pair.ends[other].pairing->peer());
        pair.confirm(other);
        QVERIFY(!pair.ends[other].pairing->confirmedHere());
    }
}

void PairingTest::namesAreCleaned()
{
    const auto sent = [](std::string name) {
        PairingOpening opening;
        opening.name = std::move(name);
        return PairingOpening::read(opening.write()).name;
    };
    QCOMPARE(sent("scout-1"), std::string("scout-1"));
    QCOMPARE(sent(""), std::string());
    QCOMPARE(sent("a b\n\x1b[2Jc"), std::string("a-b---2Jc"));
    QCOMPARE(sent(std::string(40, 'x')), std::string(24, 'x'));
    QCOMPARE(sent(std::string(23, 'x').append("\xc3\xbc")), std::string(23, 'x')); // Not half of an umlaut.
    QCOMPARE(sent("K\xc3\xb6ln"), std::string("K\xc3\xb6ln"));
}

void PairingTest::unansweredOpeningEndsTheWindow()
{
    for (const Side deaf : {Ground, Air}) { // It does not receive the other end's opening, or the words after it.
        PairingPair pair;
        Tap recorded(pair);
        const auto drop = [&](TimePoint, SentDatagram &flight) {
            recorded.flights.push_back(flight);
            return flight.from == deaf || flight.bytes[0] != firstByte(PairingMessage::Sealed);
        };
        pair.link.attacker = drop;
        pair.openBoth();
        const PairingSide &other = pair.ends[deaf == Ground ? Air : Ground];
        QVERIFY(pair.run(15s, [&] { return pair.ground().over().has_value(); }));
        QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::Interrupted);
        pair.run(200s);
        QVERIFY(pair.ground().all<PairingPeerSeen>().empty() && other.all<PairingPeerSeen>().empty());
        std::set<Bytes> openings;
        std::size_t copies = 0;
        for (const SentDatagram &flight : recorded.flights) {
            if (flight.from == Ground && isOpening(flight.bytes)) {
                openings.insert(flight.bytes);
                ++copies;
            }
        }
        QCOMPARE(openings.size(), std::size_t(1));
        QVERIFY(copies >= 8);
    }
}

void PairingTest::systemsAreBound()
{
    for (const std::uint8_t vehicle : {0, 7}) {
        PairingPair pair;
        pair.air().config.systemId = vehicle;
        pair.openBoth();
        QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
        QCOMPARE(pair.ground().pairing->peer()->systemId, vehicle);
        pair.confirm(Ground);
        pair.confirm(Air);
        QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
        const auto bound = pair.ground().all<Paired>()[0].peer.systemIds;
        QCOMPARE(bound, vehicle == 0 ? std::vector<std::uint8_t>() : std::vector<std::uint8_t>{vehicle});
        QCOMPARE(pair.air().all<Paired>()[0].peer.systemIds, std::vector<std::uint8_t>{255});
    }
}

void PairingTest::oversizedAndShort()
{
    PairingPair pair;
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    for (unsigned first = 0; first < 256; ++first) {
        QCOMPARE(Pairing::owns(static_cast<std::uint8_t>(first)), first >= 0x5c && first <= 0x5f);
        for (const std::size_t size :
             {0u, 1u, 4u, 5u, 6u, 21u, 22u, 23u, 68u, 69u, 70u, 94u, 95u, 96u, 126u, 127u, 128u, 1200u, 65507u}) {
            Bytes datagram(size, static_cast<std::uint8_t>(first));
            pair.ground().pairing->handleDatagram(pair.now, PairingPair::pathOf(Air), datagram);
            pair.air().pairing->handleDatagram(pair.now, PairingPair::pathOf(Ground), datagram);
        }
    }
    pair.confirm(Ground);
    pair.confirm(Air);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
}

SKYSEAL_TEST(PairingTest)
#include "pairing_test.moc"
