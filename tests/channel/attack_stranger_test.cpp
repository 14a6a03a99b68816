// The cost of messages from unknown senders, counted in keyed hashes: none for malformed messages, few for well-formed ones,
// regardless of the number of listed peers.
#include "attack.h"
#include "core/channel/cookie.h"
#include "core/channel/handshake.h"
#include "core/channel/mac1.h"
#include "core/crypto/init_crypto.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <map>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr std::size_t kListed = 256;

/// A station that lists many agents; the one of the pair is the last.
struct ManyListed
{
    ManyListed()
    {
        const Peer listed = pair.configOf(Ground).peers.front();
        std::vector<Peer> peers;
        for (std::size_t i = 0; i + 1 < kListed; ++i) {
            PublicKey key;
            random.fill(key);
            peers.push_back({key, "agent-" + std::to_string(i), {}, {}, {}});
        }
        peers.push_back(listed);
        keys = peers;
        pair.ground().setPeers(pair.now, std::move(peers));
    }

    Path stranger()
    {
        Path path = pair.pathOf(Air);
        random.fill(MutableByteView(path.remote.ip).last(3));
        return path;
    }
    std::uint64_t hashes() { return pair.ground().strangerHashes(); }

    Pair pair{attackOptions()};
    SeededRandom random{kAttackSeed};
    std::vector<Peer> keys;
};

} // namespace

class AttackStrangerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void malformedMessagesCostNoHash_data();
    void malformedMessagesCostNoHash();
    void announcementsForManyPeers();
    void cookiesForManyAttempts();
    void floodRaisesOneEventASecond();
    void unknownAgentsHideNoRefusal();
};

void AttackStrangerTest::malformedMessagesCostNoHash_data()
{
    QTest::addColumn<int>("firstByte");
    QTest::newRow("announcements") << 0x58;
    QTest::newRow("cookies") << 0x5b;
}

void AttackStrangerTest::malformedMessagesCostNoHash()
{
    QFETCH(int, firstByte);
    ManyListed many;
    many.pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from == Ground; };
    auto announcement = Announcement(many.keys.back().key).make(many.random); // so that a first message waits for a cookie
    many.pair.ground().handleDatagram(many.pair.now, many.pair.pathOf(Air), announcement);
    many.pair.pump();
    const std::uint64_t before = many.hashes();
    const std::uint64_t refused = refusedInAll(many.pair.ground());
    for (int i = 0; i < 1000; ++i) {
        Bytes datagram(Announcement::kLength);
        many.random.fill(datagram);
        datagram[0] = static_cast<std::uint8_t>(firstByte);
        QVERIFY(!offer(many.pair, Ground, datagram, many.stranger()));
    }
    HOLDS(many.hashes() == before, "a datagram without the form costs no hash");
    QCOMPARE(refusedInAll(many.pair.ground()) - refused, std::uint64_t(1000));
}

void AttackStrangerTest::announcementsForManyPeers()
{
    // 50,000 well-formed announcements of unknown keys a second, from many addresses.
    ManyListed many;
    Pair &pair = many.pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    std::uint64_t datagrams = 0;
    const std::uint64_t before = many.hashes();
    pair.every(1ms, [&] {
        for (int i = 0; i < 50; ++i, ++datagrams) {
            Bytes forged(Announcement::kLength);
            many.random.fill(MutableByteView(forged).first(33));
            forged[0] = 0x58;
            offer(pair, Ground, forged, many.stranger());
        }
    });
    pair.run(300ms);
    HOLDS(many.hashes() - before <= 2 * datagrams + 12'000, "a message of a stranger costs two hashes");
    // The agent restarts meanwhile. It is recognised at its former address during the flood.
    pair.kill(Air);
    pair.run(100ms);
    pair.start(Air);
    QVERIFY(pair.run(5s, [&] { return pair.ground().all<SessionUp>().size() == 2 && pair.bothUp(); }));
    QVERIFY(many.hashes() - before <= 2 * datagrams + 12'000);
    QVERIFY(pair.ground().unmatched().forged >= datagrams);
}

void AttackStrangerTest::cookiesForManyAttempts()
{
    // Replayed announcements make the station wait for many agents at once; then forged cookies arrive.
    ManyListed many;
    Pair &pair = many.pair;
    pair.kill(Air);
    for (const Peer &peer : many.keys) {
        auto announcement = Announcement(peer.key).make(many.random);
        pair.ground().handleDatagram(pair.now, many.stranger(), announcement);
        pair.pump();
    }
    const std::uint64_t before = many.hashes();
    std::uint64_t datagrams = 0;
    pair.every(1ms, [&] {
        for (int i = 0; i < 50; ++i, ++datagrams) {
            Bytes forged(kCookieLength);
            many.random.fill(MutableByteView(forged).first(49));
            forged[0] = 0x5b;
            offer(pair, Ground, forged, many.stranger());
        }
    });
    pair.run(200ms);
    HOLDS(many.hashes() - before <= 2 * datagrams + 12'000, "a message of a stranger costs two hashes");
    QVERIFY(datagrams >= 9000);
}

void AttackStrangerTest::floodRaisesOneEventASecond()
{
    // Every kind of message that an agent refuses, from many addresses: for another key, of an unknown peer, of another
    // version, replayed ones, and one of the listed station that asked for a suite the agent does not have.
    Pair pair(attackOptions());
    std::vector<Bytes> firsts;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x59)
            firsts.push_back(flight.bytes);
        return true;
    };
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(11s); // its answer has expired
    pair.kill(Ground);
    pair.air().events.clear();
    const Mac1 mac(pair.air().publicKey());
    Path source = pair.pathOf(Ground);
    SeededRandom random(kAttackSeed);
    const SuiteOffer otherSuites{{crypto::SuiteId::Rc4}, true};
    const auto withoutSuite = Initiator::begin(*pair.ground().identity, pair.configOf(Ground).peers.front(),
                                               {ConnectionId{1}, otherSuites, kGreatestCounter}, random);
    std::uint16_t port = 1000;
    int turn = 0;
    pair.every(4ms, [&] {
        ++turn;
        for (int i = 0; i < 5; ++i) {
            const int kind = (turn / 100 + i) % 5; // Each is the first for a while, and computed on.
            Bytes message(127);
            random.fill(message);
            message[0] = kind == 0 ? 0x69 : 0x59;
            if (kind == 1)
                mac.sign(message);
            if (kind == 2)
                message = firsts.front();
            if (kind == 3)
                message.assign(withoutSuite->message().begin(), withoutSuite->message().end());
            source.remote.port = ++port;
            offer(pair, Air, message, source);
        }
    });
    pair.run(20s);
    const auto told = pair.air().all<HandshakeRefused>();
    std::map<RefusalReason, int> count;
    for (const HandshakeRefused &refused : told)
        ++count[refused.reason];
    QVERIFY(count[RefusalReason::Flood] <= 3); // one in ten seconds
    for (const auto &[reason, times] : count)
        HOLDS(times <= 21, "strangers cause one event a second of each reason");
    for (const RefusalReason reason : // none hides another
         {RefusalReason::WrongKey, RefusalReason::Version, RefusalReason::ReplayedHandshake, RefusalReason::NoCommonSuite})
        QVERIFY2(count[reason] >= 8, qPrintable(QStringLiteral("%1 of %2").arg(count[reason]).arg(int(reason))));
}

void AttackStrangerTest::unknownAgentsHideNoRefusal()
{
    // A station that cannot start a session says why each second, whoever forges announcements of agents that it does not know.
    Pair pair(attackOptions());
    QVERIFY(pair.ground().counters.skipTo(kGreatestCounter + 1));
    SeededRandom random(kAttackSeed);
    Path source = pair.pathOf(Air);
    source.remote.port = 1000;
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
    pair.run(300ms); // so that the flood begins first, and between two announcements of the agent
    pair.every(1ms, [&] {
        Bytes forged(127);
        random.fill(forged);
        forged[0] = 0x58;
        std::fill(forged.begin() + 33, forged.end(), std::uint8_t(0));
        ++source.remote.port;
        offer(pair, Ground, forged, source);
    });
    pair.run(100ms);
    pair.link.attacker = nullptr;
    pair.run(20s);
    int unknown = 0, usedUp = 0;
    for (const HandshakeRefused &refused : pair.ground().all<HandshakeRefused>()) {
        unknown += refused.reason == RefusalReason::UnknownPeer;
        usedUp += refused.reason == RefusalReason::CountersUsedUp;
    }
    QVERIFY2(unknown >= 100 && unknown <= 8 * 21, qPrintable(QString::number(unknown)));
    HOLDS(usedUp >= 8, "a station reports its own refusals");
}

SKYSEAL_TEST(AttackStrangerTest)
#include "attack_stranger_test.moc"
