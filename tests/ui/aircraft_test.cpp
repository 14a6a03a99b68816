// Aircraft in the neighbourhood: distance and height from the selected vehicle, in words and on the map, and the alert.
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_list.h"
#include "ui/map/traffic.h"
#include "ui/text/aircraft_text.h"
#include "ui/tiles/mercator.h"

#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

constexpr double kMetresPerDegree = 111'195; // of the sphere that vehicle::distanceMetres() measures on

/// North of the vehicle and above it.
vehicle::Aircraft aircraftAt(const vehicle::VehicleState &own, double north, double above)
{
    vehicle::Aircraft out;
    out.address = 0x4b18a5;
    out.callsign = "SWR12A";
    out.position = own.position;
    out.position.latitude += north / kMetresPerDegree;
    out.position.altitude += above;
    out.heading = 90;
    return out;
}

} // namespace

class AircraftTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_snapshot = sealedSnapshot(1);
        m_snapshot.number = 1;
    }

    void nearOnesAreFound_data()
    {
        QTest::addColumn<double>("north");
        QTest::addColumn<double>("above");
        QTest::addColumn<bool>("isNear");
        QTest::addColumn<QString>("text");
        QTest::newRow("near, above") << 320.0 << 80.0 << true << QStringLiteral("SWR12A · +80\u00a0m · near");
        QTest::newRow("near, below") << -320.0 << -80.0 << true << QStringLiteral("SWR12A · −80\u00a0m · near");
        QTest::newRow("near, height unknown")
            << 100.0 << vehicle::kUnknown << true << QStringLiteral("SWR12A · altitude unknown · near");
        QTest::newRow("just near enough") << 499.0 << 149.0 << true << QStringLiteral("SWR12A · +149\u00a0m · near");
        QTest::newRow("too far") << 501.0 << 0.0 << false << QStringLiteral("SWR12A · +0\u00a0m");
        QTest::newRow("too high") << 100.0 << 151.0 << false << QStringLiteral("SWR12A · +151\u00a0m");
        QTest::newRow("too low") << 100.0 << -151.0 << false << QStringLiteral("SWR12A · −151\u00a0m");
    }

    void nearOnesAreFound()
    {
        QFETCH(double, north);
        QFETCH(double, above);
        QFETCH(bool, isNear);
        const AircraftSight sight = sightOf(aircraftAt(own(), north, above), own().position);
        QCOMPARE(sight.isNear, isNear);
        QVERIFY(std::abs(sight.metres - std::abs(north)) < 0.5);
        QTEST(aircraftText(sight, UnitSystem::Metric), "text");
        own().traffic = {aircraftAt(own(), north, above)};
        QCOMPARE(nearestOf(own()).has_value(), isNear);
    }

    void nearestOneIsNamed()
    {
        own().traffic = {aircraftAt(own(), 400, 0), aircraftAt(own(), 200, 100), aircraftAt(own(), 10, 5000)};
        own().traffic[1].callsign.clear();
        QCOMPARE(nearestOf(own())->name, QStringLiteral("4B18A5"));
        own().position = {};
        QVERIFY(!nearestOf(own()));
    }

    void mapShowsThoseWithAPlace()
    {
        own().traffic = {aircraftAt(own(), 400, vehicle::kUnknown), aircraftAt(own(), 300, 10)};
        own().traffic[0].heading = vehicle::kUnknown;
        own().traffic[1].position.latitude = vehicle::kUnknown;
        TrafficContent content;
        QVERIFY(content.show(view()));
        QCOMPARE(content.marks().size(), std::size_t(1));
        QCOMPARE(content.marks()[0].at,
                 mercator::project({own().traffic[0].position.latitude, own().traffic[0].position.longitude}));
        QVERIFY(!content.show(view()));
        own().traffic[0].position.latitude += 1e-5;
        QVERIFY(content.show(view()));
        own().traffic.clear();
        QVERIFY(content.show(view()));
        QVERIFY(!content.show(ViewState{}));
    }

    void alertLastsWhileOneIsNear()
    {
        AlertList list;
        const auto alerts = [&list, this](double time) {
            ++m_snapshot.number;
            list.showView(view(), time);
            return list.alerts();
        };
        own().traffic = {aircraftAt(own(), 600, 0)};
        QVERIFY(alerts(1).empty());
        own().traffic = {aircraftAt(own(), 400, 0)};
        const auto near = alerts(2);
        QCOMPARE(near.size(), std::size_t(1));
        QCOMPARE(near[0].text, QStringLiteral("Aircraft near: SWR12A"));
        QVERIFY(near[0].severity == AlertSeverity::Severe && near[0].ongoing);
        own().traffic.clear();
        QVERIFY(alerts(3).empty());
    }

    void dismissedOneHidesNoOther()
    {
        AlertList list;
        const auto alerts = [&list, this](double time) {
            ++m_snapshot.number;
            list.showView(view(), time);
            return list.alerts();
        };
        own().traffic = {aircraftAt(own(), 400, 0)};
        QCOMPARE(alerts(1).size(), std::size_t(1));
        list.dismiss({AlertKind::AircraftNear, own().systemId});
        QVERIFY(alerts(2).empty());
        own().traffic.push_back(aircraftAt(own(), 50, 0));
        own().traffic.back().address += 1;
        QCOMPARE(alerts(3).size(), std::size_t(1));
    }

private:
    vehicle::VehicleState &own() { return m_snapshot.vehicles.front().state; }
    ViewState view() const { return viewOf(std::make_shared<const engine::Snapshot>(m_snapshot), 1); }

    engine::Snapshot m_snapshot;
};

SKYSEAL_TEST(AircraftTest)
#include "aircraft_test.moc"
