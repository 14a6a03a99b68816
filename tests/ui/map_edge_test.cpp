// What the map shows of things that are hard to see: the selected vehicle beyond the edge, the centre that keys act on, and
// names of vehicles at one place.
#include "map_rig.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_painter.h"

#include <QtGui/QHelpEvent>
#include <QtTest/QTest>
#include <QtWidgets/QToolTip>

using namespace skyseal;
using namespace skyseal::ui;

class MapEdgeTest : public QObject, private MapRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void arrowPointsToTheVehicleBeyondTheMap_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<QPointF>("direction");
        QTest::newRow("left") << int(Qt::Key_Right) << QPointF(-1, 0);
        QTest::newRow("right") << int(Qt::Key_Left) << QPointF(1, 0);
        QTest::newRow("above") << int(Qt::Key_Down) << QPointF(0, -1);
        QTest::newRow("below") << int(Qt::Key_Up) << QPointF(0, 1);
    }
    void arrowPointsToTheVehicleBeyondTheMap()
    {
        QFETCH(int, key);
        QFETCH(QPointF, direction);
        QVERIFY(!m_map->edgeArrow());
        leaveBehind(static_cast<Qt::Key>(key));
        const EdgeArrow arrow = *m_map->edgeArrow();
        QVERIFY(QPointF::dotProduct(arrow.direction, direction) > 0.9);
        QVERIFY(QRectF(m_map->rect()).contains(arrow.caption) && QRectF(m_map->rect()).contains(arrow.tip));
        QVERIFY2(arrow.text.startsWith(QStringLiteral("Vehicle 1 · ")) && arrow.text.endsWith(QLatin1Char('m')),
                 qPrintable(arrow.text));
        QHelpEvent hover(QEvent::ToolTip, arrow.caption.center().toPoint(),
                         m_map->mapToGlobal(arrow.caption.center().toPoint()));
        QCoreApplication::sendEvent(m_map, &hover);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("Ctrl+Home")), qPrintable(QToolTip::text()));
        QTest::mouseClick(m_map, Qt::LeftButton, {}, arrow.caption.center().toPoint());
        EVENTUALLY(!m_map->edgeArrow());
        QVERIFY(m_map->isFollowing());
    }

    void keyCentresItAsWell()
    {
        leaveBehind(Qt::Key_Right);
        QTest::keyClick(m_window.get(), Qt::Key_Home, Qt::ControlModifier);
        EVENTUALLY(!m_map->edgeArrow());
    }

    void arrowIsPainted()
    {
        leaveBehind(Qt::Key_Right);
        const QRect caption = m_map->edgeArrow()->caption.toAlignedRect();
        const QImage with = m_map->grab(caption).toImage();
        QTest::keyClick(m_map, Qt::Key_Home);
        EVENTUALLY(!m_map->edgeArrow());
        QVERIFY(with != m_map->grab(caption).toImage());
    }

    void centreIsMarkedWhileKeysMoveTheMap()
    {
        QVERIFY(!m_map->isCentreMarked());
        const QRect middle(m_map->rect().center() - QPoint(14, 14), QSize(29, 29));
        m_map->setFocus(Qt::TabFocusReason);
        EVENTUALLY(m_map->isCentreMarked());
        leaveBehind(Qt::Key_Right);
        QVERIFY(m_map->isCentreMarked());
        const QImage marked = m_map->grab(middle).toImage();
        QTest::mouseClick(m_map, Qt::LeftButton, {}, {60, 60});
        QVERIFY(!m_map->isCentreMarked());
        QVERIFY(marked != m_map->grab(middle).toImage());
        QTest::keyClick(m_map, Qt::Key_Plus);
        QVERIFY(m_map->isCentreMarked());
        m_window->setFocus();
        EVENTUALLY(!m_map->isCentreMarked());
    }

    /// Also while the pointer rests elsewhere on the map.
    void keysActWhereTheMarkIs()
    {
        QTest::mouseMove(m_map, {70, 90});
        QTest::mouseMove(m_map, {80, 90});
        m_map->setFocus(Qt::TabFocusReason);
        QTest::keyClick(m_map, Qt::Key_Right);
        EVENTUALLY(!m_map->isMoving());
        QVERIFY(m_map->isCentreMarked());
        const auto place = m_map->pointedPlace();
        const LatLong centre = mercator::unproject(m_map->viewport().toMetres(QPointF(m_map->rect().center())));
        QVERIFY(place && qAbs(place->latitude - centre.latitude) < 1e-9 && qAbs(place->longitude - centre.longitude) < 1e-9);
    }

    void vehiclesAtOnePlaceAllHaveTheirNames()
    {
        const QFontMetricsF metrics(m_map->font());
        const auto places = MapPainter::placesOfNames({{{100, 100}, QStringLiteral("Vehicle 1 · sealed")},
                                                       {{100, 100}, QStringLiteral("Vehicle 2 · sealed")},
                                                       {{104, 101}, QStringLiteral("Vehicle 3 · not sealed")}},
                                                      metrics);
        QCOMPARE(places.size(), std::size_t(3));
        for (std::size_t i = 1; i < places.size(); ++i)
            QVERIFY(places[i].first.top() >= places[i - 1].first.bottom());
        MapPainter::Names many(100, {{100, 100}, QStringLiteral("Vehicle")});
        QVERIFY(MapPainter::placesOfNames(many, metrics).size() < 10); // no column over the whole map
    }

private:
    void leaveBehind(Qt::Key key)
    {
        m_map->setFocus(Qt::TabFocusReason);
        for (int i = 0; i < 30 && !m_map->edgeArrow(); ++i) {
            QTest::keyClick(m_map, key);
            EVENTUALLY(!m_map->isMoving());
        }
        QVERIFY(m_map->edgeArrow());
    }
};

SKYSEAL_TEST_WIDGETS(MapEdgeTest)
#include "map_edge_test.moc"
