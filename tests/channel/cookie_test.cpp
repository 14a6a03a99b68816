// The cookie under load: its binding, its lifetime, and the effect of false cookies.
#include "core/crypto/x25519.h"
#include "core/channel/cookie.h"
#include "core/channel/handshake_limit.h"
#include "core/crypto/init_crypto.h"
#include "first_message_flood.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class CookieTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void opensOnlyForItsMessage();
    void isBoundToAddressAndMessage();
    void livesTwoToFourMinutes();
    void limitIsShared();
    void floodForMinutes();
    void activeSessionIsUnaffected();
    void unrelatedCookiesHaveNoEffect();
    void forgedCookieDelaysOneAttempt();
};

void CookieTest::opensOnlyForItsMessage()
{
    SeededRandom random(1);
    const auto agent = crypto::X25519KeyPair::generate(random), other = crypto::X25519KeyPair::generate(random);
    CookieMaker maker(agent.publicKey, random);
    FirstMessage first;
    random.fill(first);
    const ByteView mac = ByteView(first).last(16);
    const CookieMessage message = maker.make(TimePoint{}, addressNumber(1), first);
    static_assert(kCookieLength <= kFirstLength);
    QVERIFY(openCookie(agent.publicKey, mac, message));
    QVERIFY(!openCookie(other.publicKey, mac, message));
    QVERIFY(!openCookie(agent.publicKey, ByteView(first).first(16), message));
    for (std::size_t bit = 0; bit < message.size() * 8; ++bit) {
        CookieMessage changed = message;
        changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1u << bit % 8);
        QVERIFY(!openCookie(agent.publicKey, mac, changed));
    }
    for (std::size_t size = 0; size < message.size(); ++size)
        QVERIFY(!openCookie(agent.publicKey, mac, ByteView(message).first(size)));
    // Two replies to the same message contain the same cookie and have no other bytes in common.
    const CookieMessage again = maker.make(TimePoint{}, addressNumber(1), first);
    QCOMPARE(*openCookie(agent.publicKey, mac, again), *openCookie(agent.publicKey, mac, message));
    QVERIFY(!std::equal(message.begin() + 17, message.end(), again.begin() + 17));
}

void CookieTest::isBoundToAddressAndMessage()
{
    SeededRandom random(2);
    const auto agent = crypto::X25519KeyPair::generate(random);
    CookieMaker maker(agent.publicKey, random);
    FirstMessage first;
    random.fill(first);
    QVERIFY(!maker.verify(TimePoint{}, addressNumber(1), first));
    const auto sealed = maker.make(TimePoint{}, addressNumber(1), first);
    const auto cookie = openCookie(agent.publicKey, ByteView(first).last(16), sealed);
    signWithCookie(*cookie, first);
    QVERIFY(maker.verify(TimePoint{}, addressNumber(1), first));
    QVERIFY(!maker.verify(TimePoint{}, addressNumber(2), first));
    Path otherPort = addressNumber(1), otherLink = otherPort;
    ++otherPort.remote.port;
    otherLink.link = LinkId{2};
    QVERIFY(!maker.verify(TimePoint{}, otherPort, first));
    QVERIFY(!maker.verify(TimePoint{}, otherLink, first));
    for (std::size_t i = 0; i < first.size(); ++i) {
        FirstMessage changed = first;
        changed[i] ^= 0x10;
        QVERIFY(!maker.verify(TimePoint{}, addressNumber(1), changed));
    }
    CookieMaker restarted(agent.publicKey, random);
    restarted.make(TimePoint{}, addressNumber(1), first);
    QVERIFY(!restarted.verify(TimePoint{}, addressNumber(1), first));
}

void CookieTest::livesTwoToFourMinutes()
{
    SeededRandom random(3);
    const auto agent = crypto::X25519KeyPair::generate(random);
    CookieMaker maker(agent.publicKey, random);
    FirstMessage first, probe;
    random.fill(first);
    probe = first;
    const TimePoint start{1h};
    const auto take = [&](TimePoint at) {
        return *openCookie(agent.publicKey, ByteView(first).last(16), maker.make(at, addressNumber(1), first));
    };
    take(start);
    const Cookie late = take(start + 119s); // Of the same secret, which is already that old.
    signWithCookie(late, probe);
    QVERIFY(maker.verify(start + 239s, addressNumber(1), probe));
    const Cookie next = take(start + 121s);
    QVERIFY(next != late);
    QVERIFY(maker.verify(start + 125s, addressNumber(1), probe));
    QVERIFY(!maker.verify(start + 242s, addressNumber(1), probe));
    signWithCookie(next, probe);
    QVERIFY(maker.verify(start + 242s, addressNumber(1), probe));
    take(start + 242s);
    QVERIFY(maker.verify(start + 243s, addressNumber(1), probe));
    take(start + 363s);
    QVERIFY(!maker.verify(start + 364s, addressNumber(1), probe));
}

void CookieTest::limitIsShared()
{
    SeededRandom random(4);
    TimePoint now{1h};
    const TimePoint start = now;
    HandshakeLimit limit(random, now);
    std::array<int, 3> admitted{};
    int best = 0;
    for (; now < start + 10s; now += 100us) {
        const auto number = static_cast<std::uint32_t>((now - start).count() / 100000);
        admitted[0] += limit.admit(now, addressNumber(number), Standing::Claimed);
        admitted[1] += limit.admit(now, addressNumber(number % 20), Standing::Proven); // 20 addresses at 500 a second each
        if (number % 5000 == 0)
            best += limit.admit(now, addressNumber(77777), Standing::Expected);
    }
    QCOMPARE(best, 20);                                                         // Twice a second, and never refused.
    QVERIFY2(admitted[1] >= 20 * 20, qPrintable(QString::number(admitted[1]))); // Their full shares: two a second each.
    QVERIFY2(admitted[1] <= 20 * 25, qPrintable(QString::number(admitted[1])));
    QVERIFY(admitted[0] + admitted[1] + best <= 50 * 10 + 20);
    limit.admit(now, addressNumber(1), Standing::Claimed);
    QVERIFY(limit.underLoad(now));
    QVERIFY(!limit.underLoad(now + 1s));
}

void CookieTest::floodForMinutes()
{
    // Secrets rotate, stations start and stop.
    Pair pair;
    Flood flood(pair, 1u << 20);
    pair.every(5ms, [&flood] { flood.sendOne(); });
    for (int round = 0; round < 30; ++round) {
        pair.kill(Ground);
        pair.run(9s);
        pair.start(Ground);
        const auto ups = pair.air().all<SessionUp>().size();
        QVERIFY2(pair.run(3s, [&] { return pair.bothUp() && pair.air().all<SessionUp>().size() > ups; }),
                 qPrintable(QString::number(round)));
    }
}

void CookieTest::activeSessionIsUnaffected()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    Flood flood(pair, 1u << 20);
    pair.every(1ms, [&flood] {
        for (int i = 0; i < kFloodPerMillisecond; ++i)
            flood.sendOne();
    });
    pair.every(20ms, [&pair] { pair.sendFrame(Air), pair.sendFrame(Ground); });
    pair.run(3s);
    pair.stopTraffic();
    pair.run(1s);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
    QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString());
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QVERIFY(pair.ground().all<SessionDown>().empty() && pair.air().all<SessionDown>().empty());
}

void CookieTest::unrelatedCookiesHaveNoEffect()
{
    // In every state: before an attempt, during one, and with a session.
    Pair pair;
    SeededRandom random(5);
    CookieMaker stranger(pair.ground().publicKey(), random), imitator(pair.air().publicKey(), random);
    FirstMessage unseen;
    random.fill(unseen);
    std::uint64_t given = 0, sent = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        sent += flight.bytes[0] == 0x59;
        return true;
    };
    pair.every(1ms, [&] {
        for (CookieMaker *maker : {&stranger, &imitator}) {
            CookieMessage message = maker->make(pair.now, pair.pathOf(Ground), unseen);
            pair.ground().handleDatagram(pair.now, pair.pathOf(Air), message);
            ++given;
        }
    });
    QVERIFY(pair.run(1s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    QCOMPARE(sent, std::uint64_t(1));
    QCOMPARE(pair.ground().unmatched().forged, given);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    CookieMessage toTheAgent = stranger.make(pair.now, pair.pathOf(Air), unseen);
    const auto malformed = pair.air().unmatched().malformed;
    pair.air().handleDatagram(pair.now, pair.pathOf(Ground), toTheAgent);
    QCOMPARE(pair.air().unmatched().malformed, malformed + 1);
}

void CookieTest::forgedCookieDelaysOneAttempt()
{
    // An attacker with the public key who reads the wire can forge a cookie. Every second copy is sent without one.
    Pair pair;
    SeededRandom random(6);
    CookieMaker imitator(pair.air().publicKey(), random);
    int swallow = 1; // so that the first one does not succeed at once
    std::uint64_t copies = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] != 0x59)
            return true;
        ++copies;
        CookieMessage cookie = imitator.make(pair.now, pair.pathOf(Ground), flight.bytes);
        pair.link.inject(pair.now, {Air, pair.air().port, 0, Bytes(cookie.begin(), cookie.end())});
        return --swallow < 0;
    };
    QVERIFY(pair.run(3s, [&] { return pair.bothUp(); }));
    QVERIFY(copies >= 3);
}

SKYSEAL_TEST(CookieTest)
#include "cookie_test.moc"
