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
    void routesEndWithTheirLink();
};

void RouteTableTest::sealedRouteWins()
{
    RouteTable routes;
    routes.ofSession(kRouteSession);
    routes.heardClear(kRoutedAt, 1, pathOf(10));
    QVERIFY(!routes.leadingTo(1)->session);
    routes.heardSealed(1, kRouteSession);
    routes.heardClear(kRoutedAt, 1, pathOf(11));
    QVERIFY(routes.leadingTo(1)->session == kRouteSession);
    routes.sessionDown(kRouteSession);
    QVERIFY(!routes.leadingTo(1)); // nothing for it goes out in clear because the session ended
}

void RouteTableTest::clearTargetsExpire()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(10));
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
    routes.heardClear(kRoutedAt, 1, pathOf(10));
    routes.forgetSilent(kRoutedAt + std::chrono::hours(1));
    QCOMPARE(routes.all().size(), std::size_t(1));
    QVERIFY(routes.leadingTo(1));
}

void RouteTableTest::boundedAgainstForgedHeartbeats()
{
    RouteTable routes;
    for (int port = 1; port < 5000; ++port)
        routes.heardClear(kRoutedAt, static_cast<std::uint8_t>(port), pathOf(static_cast<std::uint16_t>(port)));
    QVERIFY(routes.all().size() <= RouteTable::kMost);
}

void RouteTableTest::routesEndWithTheirLink()
{
    RouteTable routes;
    routes.heardClear(kRoutedAt, 1, pathOf(10));
    routes.removeLink(LinkId{1});
    QVERIFY(!routes.leadingTo(1));
}

SKYSEAL_TEST(RouteTableTest)
#include "route_table_test.moc"
