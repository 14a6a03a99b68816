// The map that turns with the vehicle: its arithmetic at random rotations, and the window by real input.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "tile_server.h"
#include "ui/map/map_painter.h"
#include "ui/map/map_view.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <random>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Viewports with any centre, scale, size and rotation, the same in each run.
class RandomViewports
{
public:
    MapViewport next()
    {
        MapViewport out;
        out.setSize({std::round(between(200, 2500)), std::round(between(150, 1500))});
        out.setMetresPerPixel(std::exp2(between(std::log2(MapViewport::kNearest), std::log2(1000))));
        out.setCentre(mercator::project({between(-80, 80), between(-179, 179)}));
        out.setHeading(between(-720, 720));
        return out;
    }
    QPointF pixelIn(const MapViewport &viewport)
    {
        return {between(0, viewport.size().width()), between(0, viewport.size().height())};
    }
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(m_engine); }

private:
    std::mt19937 m_engine{20261126};
};

bool isNear(const QPointF &a, const QPointF &b, double by)
{
    return std::abs(a.x() - b.x()) <= by && std::abs(a.y() - b.y()) <= by;
}

} // namespace

class MapRotationTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup()
    {
        tearDown();
        m_server.reset();
    }

    void pixelsAndPlacesGoRoundAtRandomRotations()
    {
        RandomViewports random;
        for (int i = 0; i < 2000; ++i) {
            const MapViewport viewport = random.next();
            QVERIFY(viewport.heading() >= 0 && viewport.heading() < 360);
            const QPointF pixel = random.pixelIn(viewport);
            const QPointF metres = viewport.toMetres(pixel);
            QVERIFY(isNear(viewport.toPixels(metres), pixel, 1e-3));
            const LatLong place = mercator::unproject(metres);
            QPointF back = mercator::project(place);
            back.setX(mercator::nearestTurn(back.x(), metres.x()));
            if (std::abs(place.latitude) < 85)
                QVERIFY(isNear(viewport.toPixels(back), pixel, 1e-2));
            QVERIFY(viewport.visible().adjusted(-1, -1, 1, 1).contains(metres)); // of the corners as well
        }
    }

    void zoomTurnAndPanKeepWhatIsUnderThePointer()
    {
        RandomViewports random;
        for (int i = 0; i < 500; ++i) {
            MapViewport viewport = random.next();
            if (std::abs(viewport.centre().y()) > mercator::kHalfWorld / 2)
                continue; // the end of the map limits its centre
            const QPointF pixel = random.pixelIn(viewport);
            const QPointF metres = viewport.toMetres(pixel);
            viewport.zoomAt(pixel, random.between(0.5, 2));
            QVERIFY(isNear(viewport.toPixels(metres), pixel, 1e-3));
            viewport.turnAt(pixel, random.between(0, 360));
            QVERIFY(isNear(viewport.toPixels(metres), pixel, 1e-3));
            viewport.pan({30, -20});
            QVERIFY(isNear(viewport.toPixels(metres), pixel + QPointF(30, -20), 1e-3));
        }
    }

    void headingPointsUp()
    {
        MapViewport viewport;
        viewport.setSize({400, 300});
        viewport.setHeading(90);
        QVERIFY(isNear(viewport.toPixels({10, 0}), {200, 130}, 1e-9)); // 10 m to the east at 0.5 m per pixel
        QVERIFY(isNear(viewport.toPixels({0, 10}), {180, 150}, 1e-9)); // north is at the left
        QCOMPARE(MapViewport::turnBetween(350, 10), 20.0);
        QCOMPARE(MapViewport::turnBetween(10, 350), -20.0);
    }

    void turnsWithTheVehicleOnlyOnceChosen()
    {
        open(90, 5);
        QCOMPARE(map()->viewport().heading(), 0.0);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 90.0);
        fly(94, 5);
        EVENTUALLY_EQUAL(map()->viewport().heading(), 94.0);
        QVERIFY(loadSettings(*m_store).rotateMap);
        WindowRig::open(); // the choice stays
        fly(200, 5);
        EVENTUALLY_EQUAL(map()->viewport().heading(), 200.0);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 0.0);
        QVERIFY(!loadSettings(*m_store).rotateMap);
    }

    /// The compass of a vehicle that stands is never quite still.
    void standingVehicleDoesNotShakeTheMap()
    {
        open(90, 0.2);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 90.0);
        for (const double heading : {93.0, 86.0, 99.0, 81.0, 90.0}) {
            fly(heading, 0.2);
            QVERIFY(!map()->isMoving());
            QCOMPARE(map()->viewport().heading(), 90.0);
        }
        fly(102, 0.2);
        EVENTUALLY_EQUAL(map()->viewport().heading(), 102.0);
        fly(104, 8); // less than a step
        QVERIFY(!map()->isMoving());
    }

    void clickOnTheArrowTurnsBackToNorth()
    {
        open(90, 5);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 90.0);
        EVENTUALLY(!map()->isMoving());
        QTest::mouseClick(map(), Qt::LeftButton, {}, MapPainter::placeOfNorth(map()->viewport()).center().toPoint());
        EVENTUALLY_EQUAL(map()->viewport().heading(), 0.0);
        QVERIFY(!map()->rotation().isOn());
        QVERIFY(map()->isFollowing());
    }

    /// The place that the operator looks at does not turn under the pointer.
    void movedMapKeepsItsRotation()
    {
        open(90, 5);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 90.0);
        EVENTUALLY(!map()->isMoving());
        const QPointF under = map()->viewport().toMetres({400, 300});
        QTest::mousePress(map(), Qt::LeftButton, {}, {400, 300});
        QTest::mouseMove(map(), {300, 250});
        QTest::mouseRelease(map(), Qt::LeftButton, {}, {300, 250});
        QVERIFY(isNear(map()->viewport().toPixels(under), {300, 250}, 1e-3));
        fly(180, 5);
        QVERIFY(!map()->isMoving());
        QCOMPARE(map()->viewport().heading(), 90.0);
        map()->setFocus();
        QTest::keyClick(map(), Qt::Key_Home);
        EVENTUALLY_EQUAL(map()->viewport().heading(), 180.0);
    }

    void menuIsThatOfTheClickedPlace()
    {
        open(135, 5);
        chooseByKeys();
        EVENTUALLY_EQUAL(map()->viewport().heading(), 135.0);
        EVENTUALLY(!map()->isMoving());
        QSignalSpy asked(map(), &MapView::menuRequested);
        const QPoint at = map()->rect().center() + QPoint(120, -80);
        const LatLong place = mercator::unproject(map()->viewport().toMetres(at));
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, map()->mapToGlobal(at));
        QCoreApplication::sendEvent(map(), &event);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked.front().front().value<LatLong>(), place);
        const QPointF there = map()->viewport().toPixels(mercator::project(place));
        QVERIFY(isNear(there, at, 1e-2));
    }

    /// Every pixel of the ground is that of a tile, in the corners and between the tiles.
    void tilesHaveNoGaps_data()
    {
        QTest::addColumn<double>("heading");
        for (const double heading : {7.0, 45.0, 90.0, 133.0, 271.5})
            QTest::addRow("%g", heading) << heading;
    }

    void tilesHaveNoGaps()
    {
        QFETCH(double, heading);
        m_server = std::make_unique<TileServer>();
        m_server->answer = [](const QString &) { return TileServer::Answer{200, tileBytes(Qt::magenta)}; };
        MapView map({QStringLiteral("Skyseal/test"), {}});
        map.resize(900, 500);
        MapSource source;
        source.kind = MapSource::Kind::Server;
        source.url = m_server->address();
        map.setSource(source);
        map.rotation().action()->setChecked(true);
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.heading = heading;
        snapshot.vehicles.front().mission.reset();
        map.show();
        map.showViewState(viewOf(std::make_shared<const engine::Snapshot>(snapshot), 1));
        EVENTUALLY_EQUAL(map.viewport().heading(), heading);
        EVENTUALLY(m_server->paths.size() > 5 && !map.isMoving());
        EVENTUALLY2(gapsIn(map) == 0, qPrintable(QString::number(gapsIn(map))));
    }

private:
    void open(double heading, double speed)
    {
        setUp();
        fly(heading, speed);
        fly(heading, speed);
    }

    void fly(double heading, double speed)
    {
        m_heading = heading;
        m_speed = speed;
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.front().state.heading = heading;
        snapshot.vehicles.front().state.groundSpeed = speed;
        m_station->show(snapshot);
    }

    void chooseByKeys()
    {
        m_window->activateWindow();
        QTest::keyClick(m_window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        fly(m_heading, m_speed);
    }

    /// Pixels along two frames and the diagonals that show no tile; what stands above the ground is left out.
    static int gapsIn(MapView &map)
    {
        const QImage picture = map.grab().toImage();
        int gaps = 0;
        const auto look = [&](int x, int y) { // smooth edges round
            const QColor color = picture.pixelColor(x, y);
            gaps += color.green() > 8 || color.red() < 247 || color.blue() < 247;
        };
        for (int y = 2; y < picture.height() * 3 / 4; ++y) {
            look(2, y);
            look(picture.width() / 4, y);
        }
        for (int x = 2; x < picture.width() - 60; ++x) {
            look(x, 2);
            look(x, picture.height() / 6);
        }
        for (int x = picture.width() / 2; x < picture.width() - 160; ++x)
            look(x, picture.height() - 3);
        return gaps;
    }

    MapView *map() const { return find<MapView>("map"); }

    std::unique_ptr<TileServer> m_server;
    double m_time = 0, m_heading = 0, m_speed = 0;
};

SKYSEAL_TEST_WIDGETS(MapRotationTest)
#include "map_rotation_test.moc"
