// The routes of outgoing frames, and when they expire.
#include "core/engine/station/route_table.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr TimePoint kRoutedAt{std::chrono::seconds(1000)};
constexpr channel::SessionId kRouteSession{1};

Path pathOf(std::uint16_t port)
{
    return {LinkId{1}, {{127}, port}};
}

} // namespace

class RouteTableTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sealedRouteWins();
    void clearTargetsExpire();
    void fixedRoutesStay();
    void boundedAgainstForgedHeartbeats();
    void pathWithNewestHeartbeatsIsTaken();
    void otherComponentsLeadNowhereElse();
    void routesEndWithTheirLink();
    void version1IsRemembered();
};

void RouteTableTest::sealedRouteWins()
{
    RouteTable routes;
    routes.ofSession(kRouteSession);
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    QVERIFY(!routes.leadingTo(1)->session);
    routes.heardSealed(1, kRouteSession);
    routes.heardClear(kRoutedAt, 1, pathOf(11), true);
    QVERIFY(routes.leadingTo(1)->session == kRouteSession);
    routes.sessionDown(kRouteSession);
    QVERIFY(!routes.leadingTo(1)); // nothing for it goes out in clear because the session ended
}

void RouteTableTest::clearTargetsExpire()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    routes.forgetSilent(kRoutedAt + RouteTable::kForgetAfter);
    QVERIFY(routes.leadingTo(1));
    routes.forgetSilent(kRoutedAt + RouteTable::kForgetAfter + std::chrono::seconds(1));
    QVERIFY(!routes.leadingTo(1));
    QVERIFY(routes.all().empty());
}

void RouteTableTest::fixedRoutesStay()
{
    RouteTable routes;
    routes.addFixed(pathOf(10));
    routes.addFixed(pathOf(10));
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    routes.forgetSilent(kRoutedAt + std::chrono::hours(1));
    QCOMPARE(routes.all().size(), std::size_t(1));
    QVERIFY(routes.leadingTo(1));
}

void RouteTableTest::boundedAgainstForgedHeartbeats()
{
    RouteTable routes;
    for (int port = 1; port < 5000; ++port)
        routes.heardClear(kRoutedAt, static_cast<std::uint8_t>(port), pathOf(static_cast<std::uint16_t>(port)), true);
    QVERIFY(routes.all().size() <= RouteTable::kMost);
}

/// Two modems of one vehicle: the present path is kept while its heartbeats arrive.
void RouteTableTest::pathWithNewestHeartbeatsIsTaken()
{
    using namespace std::chrono_literals;
    RouteTable routes;
    const auto leadsTo = [&routes](std::uint16_t port) { return routes.leadingTo(1)->path == pathOf(port); };
    TimePoint now = kRoutedAt;
    for (int second = 0; second < 10; ++second, now += 1s) {
        routes.heardClear(now, 1, pathOf(10), true);
        routes.heardClear(now + 300ms, 1, pathOf(11), true);
        QVERIFY(leadsTo(10));
    }
    QCOMPARE(routes.all().size(), std::size_t(2)); // the station's heartbeat goes to both
    for (int second = 0; second < 2; ++second, now += 1s)
        routes.heardClear(now + 300ms, 1, pathOf(11), true);
    QVERIFY(leadsTo(11));
    routes.heardClear(now, 1, pathOf(10), true); // is back
    QVERIFY(leadsTo(11));
    routes.forgetSilent(now + RouteTable::kForgetAfter + 1s);
    routes.heardClear(now + RouteTable::kForgetAfter + 1s, 1, pathOf(12), true);
    QVERIFY(leadsTo(12));
}

/// A companion computer with an address of its own.
void RouteTableTest::otherComponentsLeadNowhereElse()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(20), false);
    QVERIFY(routes.leadingTo(1)->path == pathOf(20)); // there is nothing better yet
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    QVERIFY(routes.leadingTo(1)->path == pathOf(10));
    routes.heardClear(kRoutedAt + std::chrono::seconds(5), 1, pathOf(20), false);
    QVERIFY(routes.leadingTo(1)->path == pathOf(10));
}

void RouteTableTest::routesEndWithTheirLink()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    routes.removeLink(LinkId{1});
    QVERIFY(!routes.leadingTo(1));
}

/// The station's heartbeat goes to a route, not to a vehicle: one that needs version 1 decides.
void RouteTableTest::version1IsRemembered()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(10), true);
    routes.heardClear(kRoutedAt, 2, pathOf(10), true);
    routes.heardVersion(1, pathOf(10), std::nullopt, 1);
    routes.heardVersion(2, pathOf(10), std::nullopt, 2);
    QVERIFY(routes.leadingTo(2)->version1.any());
    routes.heardVersion(1, pathOf(10), std::nullopt, 2);
    QVERIFY(routes.leadingTo(2)->version1.none());
    routes.heardSealed(3, kRouteSession);
    routes.heardVersion(3, {}, kRouteSession, 1);
    QVERIFY(routes.leadingTo(3)->version1.any());
}

SKYSEAL_TEST(RouteTableTest)
#include "route_table_test.moc"
