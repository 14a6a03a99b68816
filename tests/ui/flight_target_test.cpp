// The place that a vehicle is sent to by the map's menu: the question stands beside it, and the map marks it until it is over.
#include "map_rig.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/window/place_beside.h"

#include <QtGui/QScreen>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class FlightTargetTest : public QObject, private MapRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    /// Wherever the place is, the question stands beside it and on the screen.
    void questionStandsBesideThePlace()
    {
        const QRect room = m_window->screen()->availableGeometry();
        for (const QPoint &at : {QPoint(30, 60), QPoint(m_map->width() - 30, 60), m_map->rect().center(),
                                 QPoint(30, m_map->height() - 30), QPoint(m_map->width() - 30, m_map->height() - 30)}) {
            choose(openMenu(at), "mapGoHere");
            EVENTUALLY(question());
            const QRect box = question()->frameGeometry();
            QVERIFY(!box.contains(m_map->mapToGlobal(at)));
            QVERIFY(room.intersects(box));
            QTest::keyClick(question(), Qt::Key_Escape);
            EVENTUALLY(!question());
        }
        const QRect screen(0, 0, 1000, 800);
        const QSize box(300, 200);
        for (int x = 0; x < 1000; x += 50) {
            for (int y = 0; y < 800; y += 50) {
                const QRect placed(placeBeside(box, {x, y}, screen), box);
                QVERIFY(screen.contains(placed) && !placed.contains(x, y));
            }
        }
        const QRect small(placeBeside(box, {100, 100}, QRect(0, 0, 320, 220)), box); // no side has room
        QVERIFY(QRect(0, 0, 320, 220).contains(small));
    }

    void targetIsMarkedUntilItIsOver_data()
    {
        QTest::addColumn<QString>("end");
        for (const char *end : {"reached", "refused", "mode", "disarmed", "pause", "another place"})
            QTest::newRow(end) << QString::fromLatin1(end);
    }

    /// From the confirmation on.
    void targetIsMarkedUntilItIsOver()
    {
        QFETCH(QString, end);
        show([](vehicle::VehicleState &state) { enterMode(state, "AUTO"); });
        const QPoint at = m_map->rect().center() + QPoint(80, -40);
        const LatLong place = placeAt(at);
        goTo(at);
        QVERIFY(isTarget(place));
        show([](vehicle::VehicleState &state) { enterMode(state, "AUTO"); }); // not yet in GUIDED
        QVERIFY(isTarget(place));
        show([](vehicle::VehicleState &) {});
        QVERIFY(isTarget(place));
        const vehicle::RequestId id{1};
        if (end != QLatin1String("refused")) {
            m_station->notify(vehicle::CommandResult{id, 1, vehicle::CommandOutcome::Accepted, 0, {}});
            QVERIFY(isTarget(place));
        }
        if (end == QLatin1String("reached")) {
            show([&](vehicle::VehicleState &state) { state.position = {place.latitude, place.longitude, 500}; });
        } else if (end == QLatin1String("refused")) {
            m_station->notify(vehicle::CommandResult{id, 1, vehicle::CommandOutcome::Refused, 2, "denied"});
        } else if (end == QLatin1String("mode")) {
            show([](vehicle::VehicleState &state) { enterMode(state, "RTL"); });
        } else if (end == QLatin1String("disarmed")) {
            show([](vehicle::VehicleState &state) { state.armed = false; });
        } else if (end == QLatin1String("pause")) {
            choose(openMenu(at), "mapPause");
            EVENTUALLY(question());
            QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
            EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(2));
        } else {
            const LatLong other = placeAt({120, 90});
            goTo({120, 90});
            QVERIFY(isTarget(other));
            return;
        }
        QVERIFY(!m_map->target());
        show([](vehicle::VehicleState &) {});
        QVERIFY(!m_map->target()); // it does not come back
    }

    /// It is that of one vehicle, and kept while another one is shown.
    void targetIsThatOfTheSelectedVehicle()
    {
        const QPoint at = m_map->rect().center() + QPoint(80, -40);
        const LatLong place = placeAt(at);
        goTo(at);
        addOther();
        QVERIFY(m_map->target());
        QTest::mouseClick(m_map, Qt::LeftButton, {},
                          m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint());
        QCOMPARE(m_map->content().systemId(), std::uint8_t(2));
        QVERIFY(!m_map->target());
        QTest::mouseClick(m_map, Qt::LeftButton, {},
                          m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint());
        QVERIFY(isTarget(place));
    }

private:
    bool isTarget(const LatLong &place) const { return isAt(m_map->target(), place); }

    void goTo(const QPoint &at)
    {
        const std::size_t before = m_station->commands.size();
        choose(openMenu(at), "mapGoHere");
        EVENTUALLY(question());
        QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), before + 1);
    }
};

SKYSEAL_TEST_WIDGETS(FlightTargetTest)
#include "flight_target_test.moc"
