// The menu of the map: opened by a right click or the menu key, each command confirmed and sent for the place that was clicked,
// and the coordinates at the map's edge.
#include "map_rig.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/text/coordinates.h"

#include <QtGui/QClipboard>
#include <QtGui/QContextMenuEvent>
#include <QtGui/QGuiApplication>
#include <QtTest/QTest>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class MapMenuTest : public QObject, private MapRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void goesToTheClickedPlaceOnceConfirmed()
    {
        const QPoint at = m_map->rect().center() + QPoint(80, -40);
        const LatLong place = placeAt(at);
        choose(openMenu(at), "mapGoHere");
        EVENTUALLY(question());
        QVERIFY(m_map->mark());
        QVERIFY(isMarked(place));
        QVERIFY2(question()->text().contains(coordinatesText(place.latitude, place.longitude, CoordinateFormat::Decimal)),
                 qPrintable(question()->text()));
        QVERIFY(question()->text().contains(QStringLiteral("above home")));
        QVERIFY(question()->text().contains(QStringLiteral("from the vehicle")));
        QVERIFY(m_station->commands.empty());
        QVERIFY(!question()->frameGeometry().contains(m_map->mapToGlobal(at))); // beside the place
        QVERIFY(!m_map->target());
        QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        const auto &order = std::get<vehicle::GoTo>(m_station->commands[0].second);
        QCOMPARE((LatLong{order.latitude, order.longitude}), place);
        QCOMPARE(order.altitudeRelative, m_altitude);
        QVERIFY(order.changeMode);
        QVERIFY(!m_map->mark());
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Go here: requested…"));
        m_station->notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 2, "denied"});
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Go here: denied"));
    }

    /// Only a mission that is known can be added to: the whole mission is sent.
    void addsToTheMission()
    {
        QMenu *menu = openMenu(m_map->rect().center());
        const auto *entry = menu->findChild<QAction *>(QStringLiteral("mapAddWaypoint"));
        QVERIFY(!entry->isEnabled());
        QVERIFY2(entry->toolTip().contains(QStringLiteral("has not been read")), qPrintable(entry->toolTip()));
        menu->close();
        std::vector<vehicle::MissionItem> items(3);
        items[1] = {.sequence = 1, .command = mavlink::MAV_CMD_NAV_TAKEOFF, .altitude = 18};
        items[2] = {.sequence = 2, .command = mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH};
        m_mission = std::make_shared<const std::vector<vehicle::MissionItem>>(items);
        show([](vehicle::VehicleState &) {});

        const QPoint at = m_map->rect().center() + QPoint(80, -40);
        const LatLong place = placeAt(at);
        choose(openMenu(at), "mapAddWaypoint");
        auto *altitude = find<QDoubleSpinBox>("addWaypointDialogAltitude");
        QVERIFY(altitude);
        QVERIFY(isMarked(place));
        QCOMPARE(altitude->value(), 18.0);
        QTest::keyClicks(altitude, QStringLiteral("42"));
        auto *go = find<HoldButton>("addWaypointDialogGo");
        QTest::mouseClick(go, Qt::LeftButton); // too short
        QVERIFY(m_station->missionWrites.empty());
        QTest::mousePress(go, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->missionWrites.size(), std::size_t(1));
        QVERIFY(!m_map->mark());
        const auto &[systemId, sent] = m_station->missionWrites.front();
        QCOMPARE(systemId, std::uint8_t(1));
        QCOMPARE(sent.size(), std::size_t(4));
        QCOMPARE((LatLong{sent[2].latitude, sent[2].longitude}), place);
        QCOMPARE(sent[2].altitude, 42.0f);
        QCOMPARE(sent[3].command, std::uint16_t(mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH));
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Add to the mission: requested…"));
        m_station->notify(vehicle::MissionResult{.id = vehicle::RequestId{1}, .systemId = 1, .ok = false, .reason = "denied"});
        QVERIFY2(find<QLabel>("commandResult")->text().contains(QStringLiteral("denied")),
                 qPrintable(find<QLabel>("commandResult")->text()));
    }

    void clickSelectsAnotherVehicle()
    {
        addOther();
        QCOMPARE(m_map->content().systemId(), std::uint8_t(1));
        const QPoint other = m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint();
        QVERIFY(m_map->rect().contains(other));
        QTest::mouseClick(m_map, Qt::LeftButton, {}, other + QPoint(40, 0)); // beside it
        QCOMPARE(m_map->content().systemId(), std::uint8_t(1));
        QTest::mousePress(m_map, Qt::LeftButton, {}, other); // a drag that begins there
        QTest::mouseMove(m_map, other + QPoint(60, 0));
        QTest::mouseRelease(m_map, Qt::LeftButton, {}, other + QPoint(60, 0));
        QCOMPARE(m_map->content().systemId(), std::uint8_t(1));
        QTest::mouseClick(m_map, Qt::LeftButton, {},
                          m_map->viewport().toPixels(m_map->content().others().front().metres).toPoint());
        QCOMPARE(m_map->content().systemId(), std::uint8_t(2));
        QCOMPARE(m_map->content().others().front().systemId, std::uint8_t(1));
        QVERIFY(m_station->commands.empty());
    }

    void escapeSendsNothing()
    {
        QMenu *menu = openMenu(m_map->rect().center());
        QVERIFY(m_map->mark());
        QTest::keyClick(menu, Qt::Key_Escape);
        EVENTUALLY(!m_map->findChild<QMenu *>());
        QVERIFY(!m_map->mark());
        choose(openMenu(m_map->rect().center()), "mapSetHome");
        EVENTUALLY(question());
        QTest::keyClick(question(), Qt::Key_Escape);
        EVENTUALLY(!question());
        QVERIFY(!m_map->mark());
        QVERIFY(m_station->commands.empty());
    }

    void changeOfModeIsAnnounced()
    {
        choose(openMenu({100, 100}), "mapGoHere");
        EVENTUALLY(question());
        QCOMPARE(question()->informativeText(), QString()); // in GUIDED
        show([](vehicle::VehicleState &state) { enterMode(state, "AUTO"); });
        choose(openMenu({100, 100}), "mapGoHere");
        EVENTUALLY(question() && !question()->informativeText().isEmpty());
        QCOMPARE(question()->informativeText(), QStringLiteral("The mode changes from AUTO to GUIDED."));
    }

    /// One place at a time: the question about the one before is no longer asked.
    void anotherMenuEndsTheQuestion()
    {
        choose(openMenu({100, 100}), "mapGoHere");
        EVENTUALLY(question());
        const QPointer<QMessageBox> first = question();
        openMenu({200, 200});
        EVENTUALLY(!first);
        QVERIFY(m_station->commands.empty());
        QVERIFY(isMarked(placeAt({200, 200})));
    }

    void commands_data()
    {
        QTest::addColumn<QString>("action");
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("result");
        const auto row = [](const char *action, const vehicle::VehicleCommand &expected, const char *result) {
            QTest::newRow(action) << QString::fromLatin1(action) << static_cast<int>(expected.index())
                                  << QString::fromUtf8(result);
        };
        row("mapPause", vehicle::Loiter{}, "Pause: requested…");
        row("mapPointAt", vehicle::PointAt{}, "Point camera here: requested…");
        row("mapStopPointing", vehicle::StopPointing{}, "Stop pointing camera: requested…");
        row("mapSetHome", vehicle::SetHome{}, "Set home here: requested…");
    }

    void commands()
    {
        QFETCH(QString, action);
        QFETCH(int, index);
        QFETCH(QString, result);
        choose(openMenu({120, 90}), action.toLatin1());
        EVENTUALLY(question());
        QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        const vehicle::VehicleCommand &sent = m_station->commands[0].second;
        QCOMPARE(static_cast<int>(sent.index()), index);
        if (const auto *point = std::get_if<vehicle::PointAt>(&sent))
            QCOMPARE((LatLong{point->latitude, point->longitude}), placeAt({120, 90}));
        if (const auto *home = std::get_if<vehicle::SetHome>(&sent))
            QCOMPARE((LatLong{home->latitude, home->longitude}), placeAt({120, 90}));
        QCOMPARE(find<QLabel>("commandResult")->text(), result);
    }

    void altitudeIsHeldToConfirm()
    {
        choose(openMenu({100, 100}), "mapChangeAltitude");
        EVENTUALLY(m_window->findChild<QDialog *>(QStringLiteral("changeAltitudeDialog")));
        auto *altitude = find<QDoubleSpinBox>("changeAltitudeDialogAltitude");
        QCOMPARE(altitude->value(), std::round(m_altitude));
        QTest::keyClicks(altitude, QStringLiteral("750")); // higher than a take-off may go; the present value is selected
        QTest::keyClick(altitude, Qt::Key_Return);
        QVERIFY(m_station->commands.empty());
        auto *go = find<HoldButton>("changeAltitudeDialogGo");
        QTest::mousePress(go, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        const auto &order = std::get<vehicle::ChangeAltitude>(m_station->commands[0].second);
        QCOMPARE(order.altitudeRelative, 750.0);
        QVERIFY(order.changeMode);
    }

    void whatMakesNoSenseIsDisabledWithItsReason_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<QString>("action");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char *name, State state, const char *action, const char *reason = "") {
            QTest::newRow(name) << int(state) << QString::fromLatin1(action) << QString::fromUtf8(reason);
        };
        row("go, disarmed", State::Disarmed, "mapGoHere", "the vehicle is disarmed");
        row("altitude, disarmed", State::Disarmed, "mapChangeAltitude", "the vehicle is disarmed");
        row("pause, disarmed", State::Disarmed, "mapPause", "the vehicle is disarmed");
        row("home, disarmed", State::Disarmed, "mapSetHome");
        row("point, disarmed", State::Disarmed, "mapPointAt");
        row("go, no position", State::NoPosition, "mapGoHere", "its position is not known");
        row("home, no altitude", State::NoPosition, "mapSetHome", "the altitude of home is not known");
        row("altitude, rover", State::Rover, "mapChangeAltitude", "this kind of vehicle does not fly");
        row("go, rover", State::Rover, "mapGoHere");
        row("go, none", State::NoVehicle, "mapGoHere", "no vehicle");
        row("copy, none", State::NoVehicle, "mapCopy");
    }

    void whatMakesNoSenseIsDisabledWithItsReason()
    {
        QFETCH(int, state);
        QFETCH(QString, action);
        QFETCH(QString, reason);
        showIn(State(state));
        const QMenu *menu = openMenu({100, 100});
        const auto *entry = menu->findChild<QAction *>(action);
        QVERIFY(entry);
        QCOMPARE(entry->isEnabled(), reason.isEmpty());
        if (!reason.isEmpty())
            QCOMPARE(entry->toolTip(), reason);
        QVERIFY(menu->toolTipsVisible());
    }

    /// The window system turns the menu key into this event.
    void menuKeyOpensInTheMiddle()
    {
        m_map->setFocus();
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {3, 3}, m_map->mapToGlobal(QPoint(3, 3)));
        QCoreApplication::sendEvent(m_map, &key);
        QMenu *menu = shownMenu();
        QVERIFY(menu);
        const LatLong middle = placeAt(m_map->rect().center());
        QVERIFY(isMarked(middle));
        for (const QAction *entry : menu->actions()) {
            QTest::keyClick(menu, Qt::Key_Down);
            if (menu->activeAction() && menu->activeAction()->objectName() == QLatin1String("mapCopy"))
                break;
            Q_UNUSED(entry);
        }
        QTest::keyClick(menu, Qt::Key_Return);
        EVENTUALLY_EQUAL(QGuiApplication::clipboard()->text(),
                         coordinatesToCopy(middle.latitude, middle.longitude, CoordinateFormat::Decimal));
    }

    /// For keyboards without that key.
    void shiftF10OpensInTheMiddle()
    {
        m_map->setFocus();
        EVENTUALLY(m_map->hasFocus());
        QTest::keyClick(m_map, Qt::Key_F10, Qt::ShiftModifier);
        EVENTUALLY(shownMenu());
        QVERIFY(isMarked(placeAt(m_map->rect().center())));
    }

    void entriesShowTheirKeys()
    {
        const QMenu *menu = openMenu(m_map->rect().center());
        const auto *entry = menu->findChild<QAction *>(QStringLiteral("mapGoHere"));
        QCOMPARE(entry->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_G));
        QVERIFY(entry->isShortcutVisibleInContextMenu());
        QTest::keyClick(shownMenu(), Qt::Key_Escape);
        EVENTUALLY(!shownMenu());
        m_map->setFocus();
        QTest::keyClick(m_map, Qt::Key_G, Qt::ControlModifier); // which are still the keys of one action only
        EVENTUALLY(question());
    }

    void copiesInTheFormatOfTheSettings()
    {
        Settings settings;
        settings.coordinates = CoordinateFormat::Mgrs;
        storeSettings(*m_store, settings);
        open();
        const LatLong place = placeAt({120, 90});
        QMenu *menu = openMenu({120, 90});
        QCOMPARE(menu->actions().first()->text(), coordinatesText(place.latitude, place.longitude, CoordinateFormat::Mgrs));
        choose(menu, "mapCopy");
        EVENTUALLY_EQUAL(QGuiApplication::clipboard()->text(),
                         coordinatesToCopy(place.latitude, place.longitude, CoordinateFormat::Mgrs));
        QCOMPARE(QGuiApplication::clipboard()->text().left(5), QStringLiteral("32TMT")); // at 47.4° N 8.5° E
    }

    void pointerShowsItsPlace()
    {
        m_map->clearFocus();
        QVERIFY(!m_map->pointedPlace());
        QTest::mouseMove(m_window->windowHandle(), m_map->mapTo(m_window.get(), QPoint(50, 60)));
        EVENTUALLY(m_map->pointedPlace());
        QCOMPARE(*m_map->pointedPlace(), placeAt({50, 60}));
        QTest::mouseMove(m_window->windowHandle(), QPoint(2, 2));
        EVENTUALLY(!m_map->pointedPlace());
        m_map->setFocus();
        EVENTUALLY(m_map->pointedPlace());
        QCOMPARE(*m_map->pointedPlace(), placeAt(m_map->rect().center()));
    }

    void coordinatesAreWritten_data()
    {
        QTest::addColumn<double>("latitude");
        QTest::addColumn<double>("longitude");
        QTest::addColumn<QString>("decimal");
        QTest::addColumn<QString>("sexagesimal");
        QTest::newRow("south east") << -35.363261 << 149.165230 << QStringLiteral("−35.363261 149.165230")
                                    << QStringLiteral("35°21'47.7\" S 149°09'54.8\" E");
        QTest::newRow("rounds up") << 59.99999999 << -0.00000001 << QStringLiteral("60.000000 −0.000000")
                                   << QStringLiteral("60°00'00.0\" N 0°00'00.0\" W");
        QTest::newRow("north west") << 47.5 << -8.25 << QStringLiteral("47.500000 −8.250000")
                                    << QStringLiteral("47°30'00.0\" N 8°15'00.0\" W");
    }

    void coordinatesAreWritten()
    {
        QFETCH(double, latitude);
        QFETCH(double, longitude);
        QTEST(coordinatesText(latitude, longitude, CoordinateFormat::Decimal), "decimal");
        QTEST(coordinatesText(latitude, longitude, CoordinateFormat::DegreesMinutesSeconds), "sexagesimal");
        const QString copied = coordinatesToCopy(latitude, longitude, CoordinateFormat::Decimal);
        QVERIFY(copied.contains(QStringLiteral(", ")) && !copied.contains(QChar(0x2212)));
    }

private:
    enum class State { Disarmed, NoPosition, Rover, NoVehicle };

    void showIn(State state)
    {
        if (state == State::NoVehicle)
            return m_station->showWaiting();
        show([state](vehicle::VehicleState &vehicle) {
            if (state == State::Disarmed)
                vehicle.armed = false;
            if (state == State::NoPosition)
                vehicle.position = vehicle.home = {};
            if (state == State::Rover)
                vehicle.type = mavlink::MAV_TYPE_GROUND_ROVER;
        });
    }

    bool isMarked(const LatLong &place) const { return isAt(m_map->mark(), place); }
};

SKYSEAL_TEST_WIDGETS(MapMenuTest)
#include "map_menu_test.moc"
