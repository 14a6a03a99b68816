// Where frames go out, and for how long.
#include "core/engine/outlets.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr TimePoint kNow{std::chrono::seconds(1000)};
constexpr channel::SessionId kSession{1};

Path pathOf(std::uint16_t port)
{
    return {LinkId{1}, {{127}, port}};
}

} // namespace

class OutletsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sealedWayWins();
    void clearTargetsExpire();
    void fixedOnesStay();
    void boundedAgainstForgedHeartbeats();
    void goneWithTheirLink();
};

void OutletsTest::sealedWayWins()
{
    Outlets outlets;
    outlets.ofSession(kSession);
    outlets.heardClear(kNow, 1, pathOf(10));
    QVERIFY(!outlets.leadingTo(1)->session);
    outlets.heardSealed(1, kSession);
    outlets.heardClear(kNow, 1, pathOf(11));
    QVERIFY(outlets.leadingTo(1)->session == kSession);
    outlets.sessionDown(kSession);
    QVERIFY(!outlets.leadingTo(1)); // nothing for it goes out in clear because the session ended
}

void OutletsTest::clearTargetsExpire()
{
    Outlets outlets;
    outlets.heardClear(kNow, 1, pathOf(10));
    outlets.forgetSilent(kNow + Outlets::kForgetAfter);
    QVERIFY(outlets.leadingTo(1));
    outlets.forgetSilent(kNow + Outlets::kForgetAfter + std::chrono::seconds(1));
    QVERIFY(!outlets.leadingTo(1));
    QVERIFY(outlets.all().empty());
}

void OutletsTest::fixedOnesStay()
{
    Outlets outlets;
    outlets.addFixed(pathOf(10));
    outlets.addFixed(pathOf(10));
    outlets.heardClear(kNow, 1, pathOf(10));
    outlets.forgetSilent(kNow + std::chrono::hours(1));
    QCOMPARE(outlets.all().size(), std::size_t(1));
    QVERIFY(outlets.leadingTo(1));
}

void OutletsTest::boundedAgainstForgedHeartbeats()
{
    Outlets outlets;
    for (int port = 1; port < 5000; ++port)
        outlets.heardClear(kNow, static_cast<std::uint8_t>(port), pathOf(static_cast<std::uint16_t>(port)));
    QVERIFY(outlets.all().size() <= Outlets::kMost);
}

void OutletsTest::goneWithTheirLink()
{
    Outlets outlets;
    outlets.heardClear(kNow, 1, pathOf(10));
    outlets.removeLink(LinkId{1});
    QVERIFY(!outlets.leadingTo(1));
}

QTEST_GUILESS_MAIN(OutletsTest)
#include "outlets_test.moc"
