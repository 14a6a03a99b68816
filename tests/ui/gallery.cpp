// Draws the window in its states and sizes, and its dialogs, into a folder for people to look at: ui_gallery DIR [STATE SIZE
// THEME WORKSPACE LANGUAGE WITH], where STATE and the others are lists with commas, "dialogs" among the states being all
// dialogs, "map" the menu of the map, and the name of one of its entries, such as "mapGoHere", what that opens. WITH are
// settings of all pictures: touch, aviation, rotated, altitude (of the track).
#include "confirm_question.h"
#include "fake_station.h"
#include "gallery_dialogs.h"
#include "gallery_sweep.h"
#include "scripted_snapshots.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/language.h"
#include "ui/map/map_view.h"
#include "ui/tiles/mbtiles_writer.h"
#include "ui/window/main_window.h"
#include "ui/replay/rescue_bar.h"
#include "ui/security/suite_actions.h"

#include <QtCore/QBuffer>
#include <QtCore/QDir>
#include <QtCore/QEventLoop>
#include <QtCore/QFile>
#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Two stations at the gateway, one of which reads only.
void addClients(engine::Snapshot &snapshot)
{
    engine::LinkSnapshot link;
    link.url = "tcpin:127.0.0.1:5790";
    link.phase = engine::LinkPhase::Listening;
    snapshot.served.push_back(link);
    snapshot.clients.push_back({link.url, "127.0.0.1:50123", "all", {1'284, 0, 0, 0}});
    snapshot.clients.push_back({link.url, "127.0.0.1:50124", "none", {96, 12, 0, 0}});
}

/// On the ground, with reasons against arming.
void refuseArming(vehicle::VehicleState &state)
{
    state.armed = false;
    enterMode(state, "LOITER");
    state.altitudeRelative = state.groundSpeed = state.climb = state.throttle = state.roll = state.pitch = 0;
    state.preArmOk = false;
    state.preArmReasons = {"Compass not calibrated", "GPS 1: Bad fix", "Battery 1 below minimum arming voltage"};
}

/// A file of drawn tiles around the place of the flight, each with its number.
MapSource drawnTiles(const QString &path)
{
    auto writer = MbtilesWriter::create(path);
    const QPointF place = mercator::project({47.3977, 8.5456});
    for (int level = 15; level <= 18; ++level) {
        const TileRange range = tilesIn(QRectF(place - QPointF(1500, 1500), QSizeF(3000, 3000)), level);
        for (int row = range.top; writer && row <= range.bottom; ++row) {
            for (int column = range.left; column <= range.right; ++column) {
                QImage image(256, 256, QImage::Format_RGB32);
                image.fill(QColor((row + column) % 2 ? 0xd8e2c8 : 0xc4d6b0));
                QPainter painter(&image);
                painter.setPen(QColor(0x60705a));
                painter.drawRect(0, 0, 256, 256);
                painter.drawText(image.rect(), Qt::AlignCenter, QStringLiteral("%1/%2/%3").arg(level).arg(column).arg(row));
                painter.end();
                QByteArray bytes;
                QBuffer buffer(&bytes);
                buffer.open(QIODevice::WriteOnly);
                image.save(&buffer, "png");
                (void)(*writer)->add(range.at(column, row), bytes);
            }
        }
    }
    if (writer)
        (void)(*writer)->finish({{QStringLiteral("attribution"), QStringLiteral("© the gallery")}});
    MapSource out;
    out.kind = MapSource::Kind::File;
    out.file = path;
    return out;
}

vehicle::MissionItem placeNorthEast(std::uint16_t command, double north, double east, float first)
{
    constexpr double kMetresPerDegree = 111319.5;
    vehicle::MissionItem item{.command = command, .frame = mavlink::MAV_FRAME_GLOBAL};
    item.latitude = 47.3977 + north / kMetresPerDegree;
    item.longitude = 8.5456 + east / kMetresPerDegree / 0.6769;
    item.parameters[0] = first;
    return item;
}

/// All kinds of places: a spline, loiters, a jump, a region of interest, and the way home.
std::shared_ptr<const std::vector<vehicle::MissionItem>> routeMission()
{
    const auto place = [](std::uint16_t sequence, std::uint16_t command, double north, double east, float first = 0,
                          float third = 0) {
        vehicle::MissionItem item = placeNorthEast(command, north, east, first);
        item.sequence = sequence;
        item.parameters[2] = third;
        item.frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT;
        item.altitude = 20.0f + 6.0f * static_cast<float>(sequence % 4);
        return item;
    };
    std::vector<vehicle::MissionItem> out{place(0, mavlink::MAV_CMD_NAV_WAYPOINT, 0, 0),
                                          {.sequence = 1, .command = mavlink::MAV_CMD_NAV_TAKEOFF, .altitude = 20},
                                          place(2, mavlink::MAV_CMD_NAV_WAYPOINT, 60, -60),
                                          place(3, mavlink::MAV_CMD_NAV_SPLINE_WAYPOINT, 80, 0),
                                          place(4, mavlink::MAV_CMD_NAV_SPLINE_WAYPOINT, 60, 60),
                                          place(5, mavlink::MAV_CMD_NAV_LOITER_TURNS, 0, 80, 3, 15),
                                          place(6, mavlink::MAV_CMD_NAV_LOITER_TIME, -50, 40, 30),
                                          place(7, mavlink::MAV_CMD_DO_SET_ROI_LOCATION, -10, 30),
                                          place(8, mavlink::MAV_CMD_NAV_WAYPOINT, -60, -40),
                                          {.sequence = 9, .command = mavlink::MAV_CMD_DO_JUMP},
                                          {.sequence = 10, .command = mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH}};
    out[9].parameters[0] = 5;
    out[9].parameters[1] = 2;
    return std::make_shared<const std::vector<vehicle::MissionItem>>(std::move(out));
}

/// An area to stay in, two to keep out of, the place to return to, and two rally points.
void addFence(engine::VehicleSnapshot &vehicle)
{
    using namespace mavlink;
    std::vector<vehicle::MissionItem> fence;
    for (const auto &[north, east] : {std::pair(95, -130), {105, 60}, {60, 140}, {-70, 130}, {-85, -110}})
        fence.push_back(placeNorthEast(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, north, east, 5));
    for (const auto &[north, east] : {std::pair(40, 70), {45, 115}, {5, 120}, {10, 80}})
        fence.push_back(placeNorthEast(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION, north, east, 4));
    fence.push_back(placeNorthEast(MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, -40, -70, 22));
    fence.push_back(placeNorthEast(MAV_CMD_NAV_FENCE_RETURN_POINT, -50, 60, 0));
    vehicle.fence = std::make_shared<const std::vector<vehicle::MissionItem>>(std::move(fence));
    vehicle.rally = std::make_shared<const std::vector<vehicle::MissionItem>>(std::vector{
        placeNorthEast(MAV_CMD_NAV_RALLY_POINT, 75, -100, 0), placeNorthEast(MAV_CMD_NAV_RALLY_POINT, -60, 105, 0)});
}

/// States that are alerts, each from another moment on.
void addAlerts(engine::Snapshot &snapshot)
{
    vehicle::VehicleState &vehicle = snapshot.vehicles.front().state;
    engine::SessionSnapshot &session = snapshot.sessions.front();
    if (snapshot.time > 20)
        vehicle.batteryPercent = 18;
    if (snapshot.time > 30) {
        snapshot.security = engine::Security::UnderAttack;
        session.forgedLastMinute = session.stats.rx.forged = 87;
    }
    if (snapshot.time > 40)
        enterMode(vehicle, "RTL");
    if (snapshot.time > 46)
        vehicle.messageAge = 4.2;
}

void notifyAlerts(FakeStation &station)
{
    station.notify(engine::PlaintextRefused{9, "192.0.2.66:40000", 522, {}});
    channel::HandshakeRefused stranger;
    stranger.path.remote = {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 192, 0, 2, 7}, 14560};
    stranger.reason = channel::RefusalReason::UnknownPeer;
    station.notify(stranger);
}

/// One that is near, one higher, and one of unknown height and heading.
void addAircraft(vehicle::VehicleState &state)
{
    const double places[][3] = {{70, 60, 80}, {-60, -90, 640}, {20, -150, vehicle::kUnknown}}; // metres north, east and above
    const char *const names[] = {"SWR12A", "HBZVX", ""};
    for (std::size_t i = 0; i < std::size(places); ++i) {
        vehicle::Aircraft aircraft;
        aircraft.address = 0x4b1800u + static_cast<std::uint32_t>(i);
        aircraft.callsign = names[i];
        const vehicle::MissionItem place = placeNorthEast(0, places[i][0], places[i][1], 0);
        aircraft.position = {place.latitude, place.longitude, state.position.altitude + places[i][2]};
        aircraft.heading = i == 2 ? vehicle::kUnknown : 70.0 + 140.0 * static_cast<double>(i);
        state.traffic.push_back(aircraft);
    }
}

/// Vehicle 2 in the same session, 3 not sealed, 4 silent, 5 next to it.
void addVehicles(engine::Snapshot &snapshot)
{
    const double places[][2] = {{60, 90}, {-70, 60}, {30, -110}, {32, -104}}; // metres north and east
    for (std::uint8_t i = 0; i < std::size(places); ++i) {
        engine::VehicleSnapshot other = snapshot.vehicles.front();
        constexpr double kMetresPerDegree = 111319.5;
        other.state.systemId = static_cast<std::uint8_t>(i + 2);
        other.state.position.latitude = 47.3977 + places[i][0] / kMetresPerDegree;
        other.state.position.longitude = 8.5456 + places[i][1] / kMetresPerDegree / 0.6769;
        other.state.heading = 70.0 * i;
        snapshot.vehicles.push_back(other);
    }
    snapshot.vehicles[2].session.reset();
    snapshot.vehicles[3].state.messageAge = 12.6;
}

/// Fifty, of several kinds, one of them silent and one not sealed.
void addFleet(engine::Snapshot &snapshot)
{
    const std::uint8_t types[] = {mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_TYPE_FIXED_WING, mavlink::MAV_TYPE_GROUND_ROVER};
    const char *const modes[] = {"AUTO", "GUIDED", "RTL", "LOITER"};
    const engine::VehicleSnapshot one = snapshot.vehicles.front();
    snapshot.vehicles.clear();
    for (int i = 1; i <= 50; ++i) {
        engine::VehicleSnapshot &made = snapshot.vehicles.emplace_back(one);
        made.state.systemId = static_cast<std::uint8_t>(i);
        made.state.type = types[i % 3];
        enterMode(made.state, modes[i % 4]);
        made.state.armed = i % 5 != 0;
        made.state.batteryPercent = 15 + (i * 11) % 80;
        made.state.position.latitude += 0.0002 * (i % 7);
        made.state.position.longitude += 0.0002 * (i / 7);
    }
    snapshot.vehicles[2].session.reset();
    snapshot.vehicles[4].state.messageAge = 12.6;
    snapshot.vehicles[5].lossPercent = 14;
}

void chooseChecklist(MainWindow &window)
{
    static const QTemporaryDir folder; // it is read again when its dialog opens
    QFile file(folder.filePath(QStringLiteral("quadrotor.txt")));
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write("Propellers tight\nArea clear of people\nBattery full [battery_percent>=70]\nPosition known [gps_fix>=4]\n"
               "Charged [charge>90]\n");
    file.close();
    Preflight &preflight = window.findChild<VehicleCommands *>()->preflight();
    preflight.setFile(1, file.fileName());
    preflight.tick(1, QStringLiteral("Propellers tight"), true);
}

/// Values with lines, a limit that is passed, a field that is old, and one that never came.
ChosenValues limitedValues()
{
    ChosenValues out;
    const auto source = [](const char *id) { return *findValueSource(QLatin1String(id)); };
    out.list[0].low = 20;
    out.list[0].line = true;
    out.list.push_back({.source = source("BATTERY_STATUS.voltages[2]"), .caption = QStringLiteral("cell 3"), .line = true});
    out.list.push_back({.source = source("RADIO_STATUS.rssi")});
    out.list.push_back({.source = source("EXTENDED_SYS_STATE.landed_state")});
    out.list.push_back({.source = source("RANGEFINDER.distance")});
    return out;
}

void addFields(engine::Snapshot &snapshot)
{
    const auto add = [&](const char *id, double number, double age) {
        const engine::FieldChoice choice = findValueSource(QLatin1String(id))->fieldChoice().value();
        snapshot.fields.push_back({choice, 1, 1, mavlink::FieldValue::fromNumber(choice.field->type, number), age});
    };
    add("BATTERY_STATUS.voltages[2]", 3900 + 40 * std::sin(snapshot.time / 3) - snapshot.time, 0.2);
    add("RADIO_STATUS.rssi", 187, 64);
    add("EXTENDED_SYS_STATE.landed_state", mavlink::MAV_LANDED_STATE_IN_AIR, 0.4);
}

void waitForTiles(MapView &map)
{
    QEventLoop loop;
    QTimer quiet; // since the last tile
    quiet.setSingleShot(true);
    QObject::connect(&quiet, &QTimer::timeout, &loop, &QEventLoop::quit);
    QObject::connect(&map.tiles(), &TileLayer::changed, &quiet, [&] { quiet.start(300); });
    quiet.start(2000);
    map.repaint();
    loop.exec();
}

/// A field with a hole, a way and a place, an area to keep out of, and a file that is not read, with their dialog.
void showOverlays(MainWindow &window, const QString &folder)
{
    const auto write = [&folder](const char *name, const QByteArray &content) {
        QFile file(folder + QLatin1Char('/') + QLatin1String(name));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        return file.fileName();
    };
    OverlayModel &overlays = window.findChild<MapView *>(QStringLiteral("map"))->overlays();
    int read = 0;
    QEventLoop loop;
    QObject::connect(&overlays, &OverlayModel::pictureChanged, &loop, [&] { ++read == 3 ? loop.quit() : void(); });
    overlays.add(
        write("fields.kml", R"(<kml><Placemark><name>North field</name><Polygon><outerBoundaryIs><LinearRing><coordinates>
8.5444,47.3979 8.5467,47.3980 8.5469,47.3986 8.5450,47.3987 8.5443,47.3983</coordinates></LinearRing></outerBoundaryIs>
<innerBoundaryIs><LinearRing><coordinates>8.5458,47.3982 8.5463,47.3982 8.5463,47.39845
8.5458,47.39845</coordinates></LinearRing>
</innerBoundaryIs></Polygon></Placemark><Placemark><name>Track</name><LineString><coordinates>8.5440,47.3976 8.5450,47.3975
8.5462,47.39755 8.5475,47.3972</coordinates></LineString></Placemark>
<Placemark><name>Gate</name><Point><coordinates>8.5449,47.3973
</coordinates></Point></Placemark></kml>)"));
    overlays.add(
        write("no-fly areas.geojson", R"({"type":"Feature","properties":{"name":"Hospital"},"geometry":{"type":"Polygon",
"coordinates":[[[8.5463,47.3966],[8.5478,47.3967],[8.5476,47.3971],[8.5464,47.3971]]]}})"));
    overlays.setColor(1, OverlayColor::Red);
    overlays.add(
        write("survey.kml", "<kml>\n<Placemark><Point><coordinates>8.54,473.97</coordinates></Point></Placemark></kml>"));
    loop.exec();
    window.findChild<QAction *>(QStringLiteral("actionOverlays"))->trigger();
    QDialog *dialog = window.findChild<QDialog *>(QStringLiteral("overlayDialog"));
    dialog->move(window.pos() + QPoint(window.width() - dialog->width() - 8, window.height() - dialog->height() - 60));
    dialog->findChild<QTreeView *>()->setCurrentIndex(overlays.index(2, 0));
}

/// The window, with the menus and dialogs that it has opened over it.
QPixmap pictureOf(MainWindow &window)
{
    QPixmap out = window.grab();
    QPainter painter(&out);
    for (QWidget *over : window.findChildren<QWidget *>())
        if (over->isWindow() && over->isVisible())
            painter.drawPixmap(over->pos() - window.pos(), over->grab());
    return out;
}

void moveTo(MapView &map, const QPoint &at)
{
    QMouseEvent pointer(QEvent::MouseMove, at, map.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&map, &pointer);
}

/// Opens the menu of the map as a click does, and chooses one of its entries.
void openMapMenu(MainWindow &window, const QString &entry)
{
    auto *map = window.findChild<MapView *>(QStringLiteral("map"));
    const QPoint at = map->rect().center() + QPoint(60, -60);
    moveTo(*map, at);
    QContextMenuEvent click(QContextMenuEvent::Mouse, at, map->mapToGlobal(at));
    QCoreApplication::sendEvent(map, &click);
    auto *menu = map->findChild<QMenu *>(QStringLiteral("mapMenu"));
    if (auto *action = menu->findChild<QAction *>(entry)) {
        menu->close();
        action->trigger();
    }
}

/// Three points, and the pointer at the next place.
void measure(MapView &map)
{
    map.measure().action()->trigger();
    const QPoint middle = map.rect().center();
    for (const QPoint &at : {QPoint(-160, 60), QPoint(-40, -50), QPoint(70, 20), QPoint(150, -80)}) {
        moveTo(map, middle + at);
        if (at.x() < 100)
            map.measure().add(*map.pointedPlace());
    }
}

/// Brings the window into a state by the same signals that the engine would send.
void play(FakeStation &station, MainWindow &window, const QString &state)
{
    if (state == QLatin1String("empty"))
        return;
    if (state == QLatin1String("waiting")) {
        station.show(waitingSnapshot());
        return;
    }
    if (state == QLatin1String("opening")) { // the key
        window.setKeyState({QStringLiteral("the passphrase was not given"), true});
        station.show(engine::Snapshot());
        return;
    }
    if (state == QLatin1String("held")) {
        station.show(pendingApprovalSnapshot());
        return;
    }
    if (state == QLatin1String("heldbeside")) {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.systemId = 2;
        snapshot.pendingApproval = pendingApprovalSnapshot().pendingApproval;
        station.show(snapshot);
        station.notify(engine::PlaintextRefused{1, "192.0.2.66:40000", 1, "air-2"});
        return;
    }
    const crypto::SuiteId suites[] = {crypto::SuiteId::ChaCha20Poly1305, crypto::SuiteId::Aes256Gcm, crypto::SuiteId::Rc4,
                                      crypto::SuiteId::Aes256Ctr};
    std::uint64_t number = 0;
    for (int part = 0; part < 4; ++part) {
        for (double t = part * 12.0; t < (part + 1) * 12.0; t += 0.5) {
            engine::Snapshot snapshot = state == QLatin1String("plain")
                ? plainSnapshot(t)
                : sealedSnapshot(t, suites[part], static_cast<std::uint32_t>(part));
            snapshot.samples = samplesOf(number, t, t + 0.5,
                                         state == QLatin1String("plain") ? crypto::SuiteId::None : suites[part],
                                         static_cast<std::uint32_t>(part));
            number += snapshot.samples.size();
            if (state == QLatin1String("route"))
                snapshot.vehicles.front().mission = routeMission();
            if (state == QLatin1String("traffic"))
                addAircraft(snapshot.vehicles.front().state);
            if (state == QLatin1String("fence"))
                addFence(snapshot.vehicles.front());
            if (state == QLatin1String("switching") && t > 46)
                snapshot.sessions.front().info.pending = crypto::SuiteId::Aes256Cbc;
            if (state == QLatin1String("attack")) {
                snapshot.security = engine::Security::UnderAttack;
                snapshot.sessions.front().forgedLastMinute = 214;
                snapshot.sessions.front().replayedLastMinute = 31;
                snapshot.sessions.front().stats.rx.forged = 214;
                snapshot.sessions.front().stats.rx.replayed = 31;
            }
            if (state == QLatin1String("revoked") && t > 46) {
                snapshot.sessions.clear();
                snapshot.security = engine::Security::Nothing;
                snapshot.vehicles.front().ended = engine::EndedSession{"air-1", channel::DownReason::Revoked, 12.6};
            }
            if (state == QLatin1String("disarmed") || state == QLatin1String("prearm") || state == QLatin1String("checklist"))
                refuseArming(snapshot.vehicles.front().state);
            if (state == QLatin1String("served"))
                addClients(snapshot);
            snapshot.vehicles.front().state.inAir = snapshot.vehicles.front().state.armed;
            if (state == QLatin1String("heardlate"))
                snapshot.vehicles.front().state.takeOffSeen = false;
            if (state == QLatin1String("limits"))
                addFields(snapshot);
            if (state == QLatin1String("several"))
                addVehicles(snapshot);
            if (state == QLatin1String("fleet"))
                addFleet(snapshot);
            if (state == QLatin1String("lost") && t > 46)
                snapshot.vehicles.front().state.messageAge = 12.6;
            if (state == QLatin1String("alerts"))
                addAlerts(snapshot);
            station.show(snapshot);
        }
    }
    if (state == QLatin1String("alerts"))
        notifyAlerts(station);
    if (state == QLatin1String("impostor")) {
        station.notify(engine::PlaintextRefused{1, "192.0.2.66:40000", 522, {}});
        station.show(sealedSnapshot(49, suites[3], 3));
    }
    station.notify(channel::SwitchDone{channel::SessionId{7}, suites[2], suites[3], channel::Epoch{3}, false, false,
                                       state == QLatin1String("attack") ? channel::SwitchFailure::NotConfirmed
                                                                        : channel::SwitchFailure::None,
                                       std::chrono::milliseconds(84)});
    station.notify(vehicle::TextReceived{1, {1, 6, "EKF3 IMU0 is using GPS", {}}});
    station.notify(vehicle::TextReceived{1, {2, 4, "Battery 1 low voltage", {}}});
    station.notify(vehicle::TextReceived{1, {3, 3, "PreArm: Compass not calibrated", {}}});
    if (state == QLatin1String("refused")) {
        auto *commands = window.findChild<VehicleCommands *>();
        commands->send(1, vehicle::Disarm{});
        station.notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 4,
                                              "failed: the vehicle is not landed, and a forced disarm was not requested"});
    }
    if (state == QLatin1String("checklist"))
        chooseChecklist(window);
    if (state == QLatin1String("rescue"))
        window.offerRescue(
            {QStringLiteral("/logs/2026-05-02.tlog"), {QStringLiteral("udpin:0.0.0.0:14551")}, QDateTime::currentDateTime()});
    if (state == QLatin1String("prearm") || state == QLatin1String("checklist"))
        window.findChild<QPushButton *>(QStringLiteral("preArmButton"))->click();
    if (state == QLatin1String("fleet"))
        window.findChild<QAbstractButton *>(QStringLiteral("stripVehicle"))->click();
    if (state == QLatin1String("demo"))
        window.setDemo(true);
    if (state == QLatin1String("popover"))
        window.findChild<QAbstractButton *>(QStringLiteral("stripLock"))->click();
    if (state == QLatin1String("sweep"))
        showGallerySweep(window);
    if (state.startsWith(QLatin1String("map")))
        openMapMenu(window, state);
    if (state == QLatin1String("target")) {
        openMapMenu(window, QStringLiteral("mapGoHere"));
        test::shownQuestion(window)->button(QMessageBox::Yes)->click();
        engine::Snapshot guided = sealedSnapshot(49, suites[3], 3);
        enterMode(guided.vehicles.front().state, "GUIDED");
        guided.vehicles.front().state.inAir = true;
        station.show(guided);
    }
    auto *map = window.findChild<MapView *>(QStringLiteral("map"));
    if (state == QLatin1String("measure"))
        measure(*map);
    if (state == QLatin1String("utm") || state == QLatin1String("mgrs"))
        moveTo(*map, map->rect().center());
    if (state == QLatin1String("replay")) {
        window.startReplay(QStringLiteral("tlog:/logs/2026-05-02 field.tlog"));
        for (double t = 280; t < 320; t += 0.5)
            station.showReplay(replayedSnapshot(t));
        engine::Snapshot lost = sealedSnapshot(50);
        lost.vehicles.front().state.messageAge = 12.6;
        station.show(lost);
    }
}

/// "STATE-WORKSPACE" for all pairs; a dialog, which is drawn alone, has one picture.
QStringList combined(const QStringList &states, const QStringList &workspaces)
{
    QStringList all;
    for (const QString &state : states)
        for (const QString &workspace : dialogStates().contains(state) ? workspaces.mid(0, 1) : workspaces)
            all << state + QLatin1Char('-') + workspace;
    return all;
}

} // namespace

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    const QStringList args = app.arguments();
    if (args.size() < 2)
        return 2;
    const WindowTranslation translation(args.value(6, QStringLiteral("en")));
    const QDir out(args.at(1));
    out.mkpath(QStringLiteral("."));
    QStringList states{QStringLiteral("waiting"), QStringLiteral("sealed"),  QStringLiteral("plain"),
                       QStringLiteral("attack"),  QStringLiteral("revoked"), QStringLiteral("dialogs")};
    QStringList sizes{QStringLiteral("1280x800")}, themes{QStringLiteral("light"), QStringLiteral("dark")};
    if (args.size() > 2)
        states = args.at(2).split(QLatin1Char(','));
    if (args.size() > 3)
        sizes = args.at(3).split(QLatin1Char(','));
    if (args.size() > 4)
        themes = args.at(4).split(QLatin1Char(','));
    if (const auto all = states.indexOf(QStringLiteral("dialogs")); all >= 0) {
        states.removeAt(all);
        states += dialogStates();
    }
    const QStringList with = args.value(7).split(QLatin1Char(','));
    const QStringList workspaces = args.value(5, QStringLiteral("lab")).split(QLatin1Char(','));
    for (const QString &theme : themes) {
        for (const QString &size : sizes) {
            for (const QString &shown : combined(states, workspaces)) {
                const QString state = shown.section(QLatin1Char('-'), 0, -2);
                QTemporaryDir folder;
                QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
                Settings settings;
                settings.theme = theme == QLatin1String("dark") ? Theme::Dark
                    : theme == QLatin1String("contrast")        ? Theme::HighContrast
                                                                : Theme::Light;
                settings.touchSized = with.contains(QStringLiteral("touch"));
                settings.rotateMap = with.contains(QStringLiteral("rotated"));
                settings.trackColors = with.contains(QStringLiteral("altitude")) ? TrackColors::Altitude : TrackColors::Suite;
                settings.units = with.contains(QStringLiteral("aviation")) ? UnitSystem::Aviation : UnitSystem::Metric;
                settings.serving.on = settings.serving.write = state == QLatin1String("served");
                settings.coordinates = state == QLatin1String("utm") || state == QLatin1String("measure")
                    ? CoordinateFormat::Utm
                    : state == QLatin1String("mgrs") ? CoordinateFormat::Mgrs
                                                     : CoordinateFormat::Decimal;
                if (state == QLatin1String("tiles"))
                    settings.map = drawnTiles(folder.filePath(QStringLiteral("drawn.mbtiles")));
                if (state == QLatin1String("limits"))
                    settings.values = limitedValues();
                storeSettings(store, settings);
                FakeStation station;
                ProgramFacts facts;
                facts.demoAvailable = true;
                MainWindow window(station, store, facts);
                window.resize(size.section(QLatin1Char('x'), 0, 0).toInt(), size.section(QLatin1Char('x'), 1).toInt());
                window.show();
                QCoreApplication::processEvents();
                FakeKeyring keyring;
                FakePairing pairing;
                fillKeyring(keyring);
                if (QWidget *dialog = openDialog(state, window, keyring, pairing)) {
                    QCoreApplication::processEvents();
                    dialog->grab().save(out.filePath(QStringLiteral("%1-%2.png").arg(state, theme)));
                    delete dialog;
                    continue;
                }
                window.findChild<QAction *>(QStringLiteral("workspace_") + shown.section(QLatin1Char('-'), -1))->trigger();
                play(station, window, state);
                window.findChild<DiagnosticsPanel *>()->refresh();
                if (state == QLatin1String("served"))
                    window.findChild<QDockWidget *>(QStringLiteral("dockLinks"))->raise();
                if (state == QLatin1String("tiles"))
                    waitForTiles(*window.findChild<MapView *>());
                if (state == QLatin1String("overlays"))
                    showOverlays(window, folder.path());
                QCoreApplication::processEvents();
                pictureOf(window).save(out.filePath(QStringLiteral("%1-%2-%3.png").arg(shown, size, theme)));
            }
        }
    }
    return 0;
}
