// The place that a vehicle is sent to by the map's menu: the question stands beside it, and the map marks it until it is over.
#include "confirm_question.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/window/place_beside.h"
#include "window_rig.h"

#include <QtGui/QScreen>
#include <QtGui/QWindow>
#include <QtTest/QTest>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class FlightTargetTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_time = 0;
        show([](vehicle::VehicleState &) {});
        m_map = find<MapView>("map");
    }
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
        show([](vehicle::VehicleState &state) { state.mode = "AUTO"; });
        const QPoint at = m_map->rect().center() + QPoint(80, -40);
        const LatLong place = placeAt(at);
        goTo(at);
        QVERIFY(isTarget(place));
        show([](vehicle::VehicleState &state) { state.mode = "AUTO"; }); // not yet in GUIDED
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
            show([](vehicle::VehicleState &state) { state.mode = "RTL"; });
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
    template<typename Change> void show(Change change)
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        vehicle::VehicleState &state = snapshot.vehicles.front().state;
        state.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
        state.type = mavlink::MAV_TYPE_QUADROTOR;
        state.mode = "GUIDED";
        state.armed = true;
        state.altitudeRelative = m_altitude;
        change(state);
        m_station->show(snapshot);
    }

    /// Vehicle 2, some 50 m north of vehicle 1.
    void addOther()
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.push_back(snapshot.vehicles.front());
        snapshot.vehicles.back().state.systemId = 2;
        snapshot.vehicles.back().state.position.latitude += 0.0005;
        m_station->show(snapshot);
    }

    LatLong placeAt(const QPoint &pixel) const { return mercator::unproject(m_map->viewport().toMetres(pixel)); }
    bool isTarget(const LatLong &place) const
    {
        return m_map->target() && (*m_map->target() - mercator::project(place)).manhattanLength() < 1e-3;
    }

    void goTo(const QPoint &at)
    {
        const std::size_t before = m_station->commands.size();
        choose(openMenu(at), "mapGoHere");
        EVENTUALLY(question());
        QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), before + 1);
    }

    QMenu *shownMenu() const
    {
        for (QMenu *menu : m_map->findChildren<QMenu *>(QStringLiteral("mapMenu")))
            if (menu->isVisible())
                return menu;
        return nullptr;
    }

    /// By a click as the window system reports it, which QTest's clicks on widgets are not.
    QMenu *openMenu(const QPoint &at)
    {
        QTest::mouseClick(m_window->windowHandle(), Qt::RightButton, {}, m_map->mapTo(m_window.get(), at));
        if (!QTest::qWaitFor([this] { return shownMenu() != nullptr; }, test::kDeadlineMs))
            qFatal("no menu");
        return shownMenu();
    }

    static void choose(QMenu *menu, const char *name)
    {
        auto *entry = menu->findChild<QAction *>(QLatin1String(name));
        if (!entry)
            qFatal("no %s", name);
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    }

    QMessageBox *question() const { return test::shownQuestion(*m_window); }

    MapView *m_map = nullptr;
    double m_time = 0;
    const double m_altitude = 12.4;
};

SKYSEAL_TEST_WIDGETS(FlightTargetTest)
#include "flight_target_test.moc"
