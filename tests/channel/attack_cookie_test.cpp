// Floods of first messages with a valid mac1, from forged and from real addresses: the legitimate station gets its session in
// each case.
#include "attack.h"
#include "core/channel/cookie.h"
#include "core/channel/handshake_limit.h"
#include "core/crypto/init_crypto.h"
#include "first_message_flood.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackCookieTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void floodFromForgedAddresses();
    void floodFromRealAddresses();
    void floodFromRealAddressesOfAStranger();
    void replayedAnnouncementsDoNotAmplify();
    void forgedCookiesDoNotAmplify();
};

void AttackCookieTest::floodFromForgedAddresses()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link.delay = 20ms;
        options.link.loss = 0.05;
        Pair pair(options);
        Flood flood(pair, 1u << 20);
        const TimePoint start = pair.now;
        HOLDS(connectsIn(pair, flood), "a station gets its session");
        // Each computed handshake was refused as forged: at most 50 a second, 20 at once.
        const double computed = static_cast<double>(pair.air().unmatched().forged);
        QVERIFY2(computed <= 50 * seconds(pair.now - start) + 20, qPrintable(QString::number(computed)));
        QVERIFY(flood.bytesOut <= flood.bytesIn);
        QVERIFY(flood.cookies > 1000);
        const auto told = pair.air().all<HandshakeRefused>();
        QCOMPARE(std::count_if(told.begin(), told.end(), [](const auto &e) { return e.reason == RefusalReason::Flood; }), 1);
    }
}

void AttackCookieTest::floodFromRealAddresses()
{
    // A thousand hosts with real addresses. The agent announces itself to the address of the station.
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link.delay = 20ms;
        Pair pair(options);
        Flood flood(pair, 1000);
        flood.answerCookies();
        HOLDS(connectsIn(pair, flood), "a station gets its session");
    }
}

void AttackCookieTest::floodFromRealAddressesOfAStranger()
{
    // The agent has no expected address; some hosts use up their shares only.
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link.delay = 20ms;
        options.announceToAddress = false;
        Pair pair(options);
        Flood flood(pair, 15);
        flood.answerCookies();
        HOLDS(connectsIn(pair, flood), "a station gets its session");
    }
}

void AttackCookieTest::replayedAnnouncementsDoNotAmplify()
{
    // One recorded announcement, replayed from many addresses: each copy is answered once.
    Pair pair;
    std::optional<SentDatagram> announcement;
    std::uint64_t in = 0, out = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x58 && flight.from == Air)
            announcement = flight;
        if (flight.from == Ground)
            out += flight.bytes.size();
        return false;
    };
    pair.run(1ms);
    QVERIFY(announcement);
    pair.kill(Air);
    for (std::uint32_t i = 0; i < 40; ++i) {
        Bytes copy = announcement->bytes;
        in += copy.size();
        pair.ground().handleDatagram(pair.now, addressNumber(i % 3), copy);
        pair.run(200ms);
    }
    pair.run(20s);
    QVERIFY(out > 0);
    HOLDS(out <= in, "no more goes out than came in");
}

void AttackCookieTest::forgedCookiesDoNotAmplify()
{
    // An attacker with the public key receives the first message at his own address and forges cookies for it from another
    // address.
    Pair pair;
    SeededRandom random(7);
    CookieMaker imitator(pair.air().publicKey(), random);
    const Announcement announcement(pair.air().publicKey());
    pair.kill(Air);
    std::optional<Bytes> first;
    std::uint64_t in = 0, out = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == Ground) {
            out += flight.bytes.size();
            first = flight.bytes;
        }
        return false;
    };
    const Path victim = addressNumber(2);
    for (int i = 0; i < 20; ++i) {
        auto call = announcement.make(random);
        in += call.size();
        pair.ground().handleDatagram(pair.now, addressNumber(1), call);
        pair.run(60ms);
        QVERIFY(first);
        CookieMessage cookie = imitator.make(pair.now, victim, *first);
        in += cookie.size();
        pair.ground().handleDatagram(pair.now, victim, cookie);
        pair.run(200ms);
    }
    pair.run(20s);
    QVERIFY(out > 0);
    HOLDS(out <= in, "no more goes out than came in");
}

SKYSEAL_TEST(AttackCookieTest)
#include "attack_cookie_test.moc"
