// Measuring on the map by clicks and keys; nothing of the vehicle is touched meanwhile.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "window_rig.h"

#include <QtGui/QContextMenuEvent>
#include <QtGui/QWindow>
#include <QtTest/QTest>
#include <QtWidgets/QMenu>

#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;

class MeasureTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_station->showTwoSealed(1, {}, [](auto &second) { second.position.latitude += 0.0005; }); // some 55 m further north
        m_map = find<MapView>("map");
        m_tool = &m_map->measure();
    }
    void cleanup() { tearDown(); }

    /// The lengths follow from the ellipsoid alone: a degree of the equator is a·π/180, a quadrant of a meridian
    /// 10,001,965.729 m (NGA.STND.0036). The long way is the example of GeographicLib, JFK to LHR, by PROJ 9.1.1's geod.
    void lengthsAndBearings_data()
    {
        QTest::addColumn<double>("fromLatitude");
        QTest::addColumn<double>("fromLongitude");
        QTest::addColumn<double>("toLatitude");
        QTest::addColumn<double>("toLongitude");
        QTest::addColumn<double>("metres");
        QTest::addColumn<double>("bearing");
        QTest::newRow("equator") << 0.0 << 0.0 << 0.0 << 1.0 << 111319.491 << 90.0;
        QTest::newRow("meridian") << 0.0 << 8.0 << 90.0 << 8.0 << 10001965.729 << 0.0;
        QTest::newRow("westwards") << 0.0 << 1.0 << 0.0 << 0.0 << 111319.491 << 270.0;
        QTest::newRow("southwards") << 47.3987 << 8.5456 << 47.3977 << 8.5456 << 111.179 << 180.0;
        QTest::newRow("across the date line") << 52.0 << 179.99 << 52.0 << -179.99 << 1373.560 << 89.992;
        QTest::newRow("JFK to LHR") << 40.6 << -73.8 << 51.6 << -0.5 << 5551759.400 << 51.199;
        QTest::newRow("no way") << 47.0 << 8.0 << 47.0 << 8.0 << 0.0 << 180.0;
    }

    void lengthsAndBearings()
    {
        QFETCH(double, fromLatitude);
        QFETCH(double, fromLongitude);
        QFETCH(double, toLatitude);
        QFETCH(double, toLongitude);
        QFETCH(double, metres);
        QFETCH(double, bearing);
        const Geodesic way = geodesicBetween({fromLatitude, fromLongitude}, {toLatitude, toLongitude});
        QVERIFY2(std::abs(way.metres - metres) < 0.002, qPrintable(QString::number(way.metres, 'f', 4)));
        QVERIFY2(metres == 0 || std::abs(way.bearing - bearing) < 0.001, qPrintable(QString::number(way.bearing, 'f', 5)));
    }

    void clicksSetPoints()
    {
        m_tool->action()->trigger();
        QVERIFY(m_map->hasFocus());
        const QPoint at[] = {{200, 100}, {300, 100}, {300, 180}};
        for (const QPoint &pixel : at)
            QTest::mouseClick(m_map, Qt::LeftButton, {}, pixel);
        QCOMPARE(m_tool->points().size(), std::size_t(3));
        QCOMPARE(m_tool->points()[1], placeAt(at[1]));
        const double scale = m_map->viewport().groundMetresPerPixel();
        QVERIFY(std::abs(m_tool->legs()[0].metres - 100 * scale) < scale);
        QVERIFY(std::abs(m_tool->legs()[0].bearing - 90) < 0.1);
        QVERIFY(std::abs(m_tool->legs()[1].bearing - 180) < 0.1);
        QVERIFY(std::abs(m_tool->totalMetres() - 180 * scale) < 2 * scale);
        const QString text = measuredText(*m_tool, UnitSystem::Metric);
        QVERIFY2(text.endsWith(QStringLiteral("in 2 legs")), qPrintable(text));
        QVERIFY(m_map->accessibleDescription().startsWith(text));
        QVERIFY(measuredText(*m_tool, UnitSystem::Imperial).contains(QStringLiteral("\u00a0ft ")));
    }

    void clicksAreNotForTheVehicle()
    {
        m_tool->action()->trigger();
        const QPoint other = m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint();
        QVERIFY(m_map->rect().contains(other));
        QTest::mouseClick(m_map, Qt::LeftButton, {}, other);
        QCOMPARE(m_map->content().systemId(), std::uint8_t(1));
        QCOMPARE(m_tool->points().size(), std::size_t(1));
        QTest::mouseClick(m_window->windowHandle(), Qt::RightButton, {}, m_map->mapTo(m_window.get(), QPoint(100, 100)));
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {3, 3}, m_map->mapToGlobal(QPoint(3, 3)));
        QCoreApplication::sendEvent(m_map, &key);
        QVERIFY(!m_map->findChild<QMenu *>());
        const double scale = m_map->viewport().metresPerPixel();
        QTest::mouseDClick(m_map, Qt::LeftButton, {}, {150, 150});
        QVERIFY(!m_map->isMoving());
        QCOMPARE(m_map->viewport().metresPerPixel(), scale);
        QVERIFY(m_station->commands.empty());
        m_tool->end();
        QTest::mouseClick(m_map, Qt::LeftButton, {},
                          m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint());
        QCOMPARE(m_map->content().systemId(), std::uint8_t(2));
    }

    void dragMovesTheMapAndSetsNoPoint()
    {
        m_tool->action()->trigger();
        const QPointF before = m_map->viewport().centre();
        QTest::mousePress(m_map, Qt::LeftButton, {}, {200, 100});
        QTest::mouseMove(m_map, {260, 140});
        QTest::mouseRelease(m_map, Qt::LeftButton, {}, {260, 140});
        QVERIFY(m_map->viewport().centre() != before);
        QVERIFY(m_tool->points().empty());
    }

    /// Wherever the focus was: the shortcut gives it to the map.
    void worksByKeysAlone()
    {
        QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
        EVENTUALLY(m_tool->isOn());
        EVENTUALLY(m_map->hasFocus());
        QCOMPARE(measuredText(*m_tool, UnitSystem::Metric), QStringLiteral("Measure: set the first point"));
        QTest::keyClick(m_map, Qt::Key_Return);
        QCOMPARE(m_tool->points().size(), std::size_t(1));
        QCOMPARE(m_tool->points().front(), placeAt(m_map->rect().center()));
        QTest::keyClick(m_map, Qt::Key_Right);
        EVENTUALLY(!m_map->isMoving());
        QTest::keyClick(m_map, Qt::Key_Space);
        QCOMPARE(m_tool->points().size(), std::size_t(2));
        QVERIFY(std::abs(m_tool->legs().front().bearing - 90) < 0.1);
        QTest::keyClick(m_map, Qt::Key_Backspace);
        QCOMPARE(m_tool->points().size(), std::size_t(1));
        QVERIFY(m_tool->legs().empty());
        QTest::keyClick(m_map, Qt::Key_Backspace);
        QTest::keyClick(m_map, Qt::Key_Backspace); // nothing is left to remove
        QVERIFY(m_tool->points().empty() && m_tool->isOn());
        QTest::keyClick(m_map, Qt::Key_Escape);
        QVERIFY(!m_tool->isOn());
        QTest::keyClick(m_map, Qt::Key_Return);
        QVERIFY(m_tool->points().empty());
        QVERIFY(m_station->commands.empty());
    }

    void anotherMeasurementBeginsAnew()
    {
        m_tool->action()->trigger();
        QTest::mouseClick(m_map, Qt::LeftButton, {}, {200, 100});
        m_tool->action()->trigger();
        QVERIFY(!m_tool->isOn() && m_tool->points().empty());
        m_tool->action()->trigger();
        QVERIFY(m_tool->points().empty());
    }

    void mapMenuMeasuresFromItsPlace()
    {
        const QPoint at(220, 130);
        QTest::mouseClick(m_window->windowHandle(), Qt::RightButton, {}, m_map->mapTo(m_window.get(), at));
        EVENTUALLY(m_map->findChild<QMenu *>(QStringLiteral("mapMenu")));
        auto *menu = m_map->findChild<QMenu *>(QStringLiteral("mapMenu"));
        EVENTUALLY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(menu->findChild<QAction *>(QStringLiteral("mapMeasure"))).center());
        EVENTUALLY(m_tool->isOn());
        QCOMPARE(m_tool->points().size(), std::size_t(1));
        QCOMPARE(m_tool->points().front(), placeAt(at));
        EVENTUALLY(m_map->hasFocus());
    }

private:
    LatLong placeAt(const QPoint &pixel) const { return mercator::unproject(m_map->viewport().toMetres(pixel)); }

    MapView *m_map = nullptr;
    MeasureTool *m_tool = nullptr;
};

SKYSEAL_TEST_WIDGETS(MeasureTest)
#include "measure_test.moc"
