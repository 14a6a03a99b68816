// The parts of the map: the viewport's arithmetic, and the content that view states change.
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/map/graticule.h"
#include "ui/map/map_content.h"
#include "ui/map/map_viewport.h"
#include "ui/tiles/tile_range.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

ViewState viewAt(double time, std::uint8_t systemId = 1)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    snapshot.vehicles.front().state.systemId = systemId;
    return viewOf(std::make_shared<const engine::Snapshot>(std::move(snapshot)), systemId);
}

/// Vehicle 1, and others beside it: 2 in the same session, 3 in none, 4 silent for 12 s, 5 without a position.
engine::Snapshot severalVehicles(double time)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    for (std::uint8_t id = 2; id <= 5; ++id) {
        engine::VehicleSnapshot other = snapshot.vehicles.front();
        other.state.systemId = id;
        other.state.position.latitude += 0.001 * id;
        snapshot.vehicles.push_back(other);
    }
    snapshot.vehicles[2].session.reset();
    snapshot.vehicles[3].state.messageAge = 12.4;
    snapshot.vehicles[4].state.position = {};
    return snapshot;
}

ViewState viewOfSeveral(const engine::Snapshot &snapshot, std::uint8_t systemId = 1)
{
    return viewOf(std::make_shared<const engine::Snapshot>(snapshot), systemId);
}

} // namespace

class MapTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void zoomKeepsThePositionUnderThePixel()
    {
        MapViewport viewport;
        viewport.setSize({400, 300});
        viewport.setCentre({100, 50});
        QCOMPARE(viewport.toPixels({100, 50}), QPointF(200, 150));
        const QPointF metres(150, 80);
        const QPointF before = viewport.toPixels(metres);
        QCOMPARE(before, QPointF(300, 90)); // 0.5 m per pixel, north is up
        viewport.zoomAt(before, 4);
        QCOMPARE(viewport.metresPerPixel(), 0.125);
        QCOMPARE(viewport.toPixels(metres), before);
        viewport.zoomAt(before, 1e9);
        QCOMPARE(viewport.metresPerPixel(), MapViewport::kNearest);
        viewport.zoomAt(before, 1e-9);
        QCOMPARE(viewport.metresPerPixel(), MapViewport::kFarthest);
    }

    void projectionIsWebMercator()
    {
        QVERIFY((mercator::project({0, 180}) - QPointF(20037508.342789, 0)).manhattanLength() < 1e-5);
        QVERIFY((mercator::project({mercator::kLastLatitude, 0}) - QPointF(0, 20037508.342789)).manhattanLength() < 1e-3);
        for (const LatLong place : {LatLong{47.3977, 8.5456}, LatLong{-35.363261, 149.165230}, LatLong{0, -179.9999}}) {
            const LatLong back = mercator::unproject(mercator::project(place));
            QVERIFY(qAbs(back.latitude - place.latitude) < 1e-10 && qAbs(back.longitude - place.longitude) < 1e-10);
        }
        // A metre on the ground at 60° is two on the map.
        QVERIFY(qAbs(mercator::stretch(mercator::project({60, 0}).y()) - 2) < 1e-9);
        QCOMPARE(mercator::unproject({1.5 * mercator::kHalfWorld, 0}).longitude, -90.0);
    }

    void tilesCoverThePicture()
    {
        MapViewport viewport;
        viewport.setSize({500, 500});
        viewport.setMetresPerPixel(2 * mercator::kHalfWorld / 256 / 8); // level 3
        QCOMPARE(viewport.zoomLevel(), 3.0);
        const TileRange middle = tilesIn(viewport.visible(), 3);
        QCOMPARE(middle.left, 3);
        QCOMPARE(middle.right, 4);
        viewport.setCentre({-mercator::kHalfWorld, 0}); // across the date line
        const TileRange around = tilesIn(viewport.visible(), 3);
        QCOMPARE(around.at(around.left, 0).column, 7);
        QCOMPARE(around.at(around.left + 1, 0).column, 0);
        QCOMPARE(tilesIn(QRectF(-1e9, -1e9, 2e9, 2e9), 2).bottom, 3);
    }

    void otherVehiclesAreShown()
    {
        const ViewState view = viewOfSeveral(severalVehicles(10));
        MapContent content;
        content.show(view, 0.5);
        const auto &others = content.others();
        QCOMPARE(others.size(), std::size_t(3));
        QCOMPARE(others[0].systemId, std::uint8_t(2));
        QCOMPARE(others[0].suite, view.session->info.suite);
        const auto &where = view.snapshot->vehicles[1].state.position;
        QCOMPARE(others[0].metres, mercator::project({where.latitude, where.longitude}));
        const auto textOf = [](const VehicleMarker &marker) { return markerText(marker.systemId, marker.suite, marker.age); };
        QCOMPARE(textOf(others[0]), QStringLiteral("Vehicle 2 · sealed"));
        QCOMPARE(textOf(others[1]), QStringLiteral("Vehicle 3 · not sealed"));
        QCOMPARE(textOf(others[2]), QStringLiteral("Vehicle 4 · 12 s ago"));
        // The one that was selected before is one of the others then.
        content.show(viewOfSeveral(severalVehicles(10), 2), 0.5);
        QCOMPARE(content.others().front().systemId, std::uint8_t(1));
        QCOMPARE(content.systemId(), std::uint8_t(2));
    }

    void otherVehiclesThatMoveArePaintedAgain()
    {
        engine::Snapshot snapshot = severalVehicles(10);
        MapContent content;
        content.show(viewOfSeveral(snapshot), 0.5);
        QVERIFY(!content.show(viewOfSeveral(snapshot), 0.5).vehicle);
        snapshot.vehicles[1].state.position.latitude += 1e-7; // a centimetre
        QVERIFY(!content.show(viewOfSeveral(snapshot), 0.5).vehicle);
        for (int i = 0; i < 50; ++i) // slowly, but far in the end
            snapshot.vehicles[1].state.position.latitude += 1e-7;
        QVERIFY(content.show(viewOfSeveral(snapshot), 0.5).vehicle);
        snapshot.vehicles[2].state.heading += 5;
        const MapContent::Changes changes = content.show(viewOfSeveral(snapshot), 0.5);
        QVERIFY(changes.vehicle && !changes.ground && !changes.moved);
        snapshot.vehicles[3].state.messageAge = 13.5;
        QVERIFY(content.show(viewOfSeveral(snapshot), 0.5).vehicle);
    }

    void graticuleHasRoundDegrees()
    {
        MapViewport viewport;
        viewport.setSize({800, 600});
        viewport.setCentre(mercator::project({47.3977, 8.5456}));
        const Graticule lines = graticuleOf(viewport);
        QVERIFY(lines.meridians.size() > 3 && lines.parallels.size() > 3);
        QStringList labels;
        for (const GraticuleLine &line : lines.meridians)
            labels << line.label;
        QVERIFY2(labels.contains(QStringLiteral("8.5450° E")), qPrintable(labels.join(QLatin1Char(' '))));
        viewport.setCentre(mercator::project({-0.0001, -0.0001}));
        labels.clear();
        for (const GraticuleLine &line : graticuleOf(viewport).parallels)
            labels << line.label;
        QVERIFY2(labels.first().endsWith(QLatin1Char('S')) && labels.last().endsWith(QLatin1Char('N')),
                 qPrintable(labels.join(QLatin1Char(' '))));
        viewport.setMetresPerPixel(MapViewport::kFarthest);
        QVERIFY(graticuleOf(viewport).meridians.size() < 100);
        viewport.setMetresPerPixel(MapViewport::kNearest);
        QVERIFY(graticuleOf(viewport).meridians.size() < 100);
    }

    void panMovesThePicture()
    {
        MapViewport viewport;
        viewport.setSize({400, 300});
        const QPointF before = viewport.toPixels({10, 10});
        viewport.pan({30, -20});
        QCOMPARE(viewport.toPixels({10, 10}), before + QPointF(30, -20));
    }

    void contentReportsOnlyVisibleChanges()
    {
        MapContent content;
        QVERIFY(!content.show(ViewState{}, 0.5).ground);
        MapContent::Changes changes = content.show(viewAt(0), 0.5);
        QVERIFY(changes.ground && changes.vehicle && changes.moved);
        QVERIFY(content.vehicle() && content.home());
        changes = content.show(viewAt(0), 0.5);
        QVERIFY(!changes.ground && !changes.vehicle && !changes.moved);
        const QPointF before = *content.vehicle();
        QVERIFY(!content.show(viewAt(10), 1e6).moved); // below half a pixel at this scale
        QCOMPARE(*content.vehicle(), before);
        QVERIFY(content.show(viewAt(10), 0.5).moved);
        QVERIFY(*content.vehicle() != before);
    }

    void trackIsNotJoinedAcrossAnOutage()
    {
        MapContent content;
        content.show(viewAt(0), 0.5);
        content.show(viewAt(5), 0.5);
        engine::Snapshot lost = sealedSnapshot(6);
        lost.vehicles.front().state.messageAge = 4;
        content.show(viewOf(std::make_shared<const engine::Snapshot>(std::move(lost)), 1), 0.5);
        content.show(viewAt(30), 0.5);
        content.show(viewAt(35), 0.5);
        const auto &points = content.track().points();
        QCOMPARE(points.size(), std::size_t(4));
        QVERIFY(points[0].begins && !points[1].begins && points[2].begins && !points[3].begins);
    }

    /// After a restart the vehicle may be elsewhere before its link counts as lost.
    void trackIsNotJoinedAcrossAJump()
    {
        MapContent content;
        content.show(viewAt(0), 0.5);
        engine::Snapshot elsewhere = sealedSnapshot(1);
        elsewhere.vehicles.front().state.position.latitude += 0.1;
        content.show(viewOf(std::make_shared<const engine::Snapshot>(std::move(elsewhere)), 1), 0.5);
        QCOMPARE(content.track().points().size(), std::size_t(2));
        QVERIFY(content.track().points()[1].begins);
    }

    void anotherVehicleStartsOver()
    {
        MapContent content;
        for (double t = 0; t < 20; t += 0.5)
            content.show(viewAt(t), 0.5);
        QVERIFY(content.track().points().size() > 10);
        QVERIFY(content.show(viewAt(20, 2), 0.5).ground);
        QCOMPARE(content.track().points().size(), std::size_t(1));
        content.clearTrack();
        QVERIFY(content.track().points().empty());
    }
};

SKYSEAL_TEST(MapTest)
#include "map_test.moc"
