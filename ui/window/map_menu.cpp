#include "ui/window/map_menu.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/vehicle/flight_rules.h"
#include "core/vehicle/geodesy.h"
#include "ui/flight/confirm_command.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/map/map_view.h"
#include "ui/text/command_permits.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/window/flight_target.h"
#include "ui/window/place_beside.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"

#include <QtGui/QAction>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

const QString kAtPlace = QStringLiteral("at_"); ///< begins the object names of the actions that are not in the menu

bool knowsHomeAltitude(const vehicle::VehicleState &state)
{
    return std::isfinite(state.home.altitude)
        || (std::isfinite(state.position.altitude) && std::isfinite(state.altitudeRelative));
}

} // namespace

MapMenu::MapMenu(MapView &map, const ViewSelection &selection, VehicleCommands &commands, WindowDialogs &dialogs,
                 QWidget &window)
    : QObject(&window), m_map(map), m_selection(selection), m_commands(commands), m_dialogs(dialogs), m_window(window),
      m_placeActions(new QMenu(&window))
{
    connect(&map, &MapView::menuRequested, this, &MapMenu::open);
    map.setFollowKeys([&window] { // which the operator may have changed
        const auto *follow = window.findChild<QAction *>(QStringLiteral("actionFollow"));
        return follow ? follow->shortcut().toString(QKeySequence::NativeText) : QString();
    });
    makePlaceActions();
}

/// The entries are made anew for the place of the moment that they are chosen in.
void MapMenu::makePlaceActions()
{
    const auto place = [this] {
        const MapViewport &viewport = m_map.viewport();
        const QPointF middle(m_map.width() / 2.0, m_map.height() / 2.0);
        return m_map.pointedPlace().value_or(mercator::unproject(viewport.toMetres(middle)));
    };
    const std::pair<const char *, QKeySequence> chosen[] = {{"mapGoHere", Qt::CTRL | Qt::Key_G},
                                                            {"mapAddWaypoint", Qt::ALT | Qt::SHIFT | Qt::Key_A},
                                                            {"mapPointAt", Qt::ALT | Qt::SHIFT | Qt::Key_C},
                                                            {"mapStopPointing", Qt::ALT | Qt::SHIFT | Qt::Key_N},
                                                            {"mapSetHome", Qt::ALT | Qt::SHIFT | Qt::Key_H},
                                                            {"mapMeasure", Qt::ALT | Qt::SHIFT | Qt::Key_G},
                                                            {"mapCopy", Qt::CTRL | Qt::SHIFT | Qt::Key_C}};
    MenuItems items;
    for (MenuItem &item : itemsFor(place())) {
        const auto found = std::ranges::find(chosen, item.id, [](const auto &row) { return QLatin1String(row.first); });
        if (found == std::ranges::end(chosen))
            continue;
        item.shortcut = found->second;
        item.trigger = [this, place, id = item.id] {
            const MenuItems now = itemsFor(place());
            std::ranges::find(now, id, &MenuItem::id)->trigger();
        };
        item.id = kAtPlace + item.id;
        items.push_back(std::move(item));
    }
    const auto refresh = fillMenu(*m_placeActions, items);
    connect(&m_selection, &ViewSelection::viewChanged, m_placeActions, refresh);
    refresh();
}

QList<QAction *> MapMenu::placeActions() const
{
    return m_placeActions->actions();
}

const vehicle::VehicleState *MapMenu::vehicle() const
{
    const auto *shown = m_selection.view().vehicle;
    return shown ? &shown->state : nullptr;
}

void MapMenu::open(const LatLong &place, const QPoint &at)
{
    if (m_question)
        m_question->reject(); // it was about another place
    auto *menu = new QMenu(&m_map);
    menu->setObjectName(QStringLiteral("mapMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    MenuItems items = itemsFor(place);
    for (MenuItem &item : items)
        if (const auto *sameByKeys = item.id.isEmpty() ? nullptr : m_placeActions->findChild<QAction *>(kAtPlace + item.id))
            item.shortcut = sameByKeys->shortcut();
    fillMenu(*menu, items);
    for (QAction *entry : menu->actions())
        entry->setShortcutVisibleInContextMenu(true);
    connect(menu, &QMenu::aboutToHide, &m_map, [this] { m_map.setMark(std::nullopt); });
    m_map.setMark(place);
    menu->popup(at);
}

MenuItems MapMenu::itemsFor(const LatLong &place)
{
    const auto sendable = [this] { return commandsDisabledReason(m_selection.view()); };
    const auto command = [this, place](const QString &question, const QString &details, const vehicle::VehicleCommand &order) {
        ask(place, confirmCommand(m_commands, order, question, details, &m_window));
    };
    return {{.text = coordinatesText(place.latitude, place.longitude, m_map.coordinateFormat())},
            goHere(place),
            {.id = QStringLiteral("mapChangeAltitude"),
             .text = tr("Change &altitude…"),
             .trigger = [this] { m_dialogs.openChangeAltitude(m_selection.view()); },
             .disabledReason = [this] { return climbsDisabledReason(m_selection.view()); }},
            {.id = QStringLiteral("mapPause"),
             .text = tr("Pa&use…"),
             .trigger = [command] { command(tr("Stop and hold the present position?"), {}, vehicle::Loiter{}); },
             .disabledReason = [this] { return movesDisabledReason(m_selection.view()); }},
            {.id = QStringLiteral("mapAddWaypoint"),
             .text = tr("Add &to the mission…"),
             .trigger = [this, place] { markUntilClosed(place, m_dialogs.openAddWaypoint(place, describe(place))); },
             .disabledReason =
                 [this] {
                     if (QString reason = commandsDisabledReason(m_selection.view()); !reason.isEmpty())
                         return reason;
                     if (!m_commands.mission())
                         return tr("the mission has not been read: Plan, Read from the vehicle");
                     if (!m_commands.missionOutdated().isEmpty())
                         return tr("the mission is outdated (%1): Plan, Read again").arg(m_commands.missionOutdated());
                     return QString();
                 }},
            {},
            {.id = QStringLiteral("mapPointAt"),
             .text = tr("&Point camera here…"),
             .trigger =
                 [this, command, place] {
                     command(tr("Point the camera at this location?\n%1").arg(describe(place)),
                             tr("The target is at the altitude of home. A copter whose camera cannot pan yaws instead."),
                             vehicle::PointAt{place.latitude, place.longitude});
                 },
             .disabledReason = sendable},
            {.id = QStringLiteral("mapStopPointing"),
             .text = tr("&Stop pointing camera…"),
             .trigger = [command] { command(tr("Stop pointing the camera at a location?"), {}, vehicle::StopPointing{}); },
             .disabledReason = sendable},
            setHome(place),
            {},
            {.id = QStringLiteral("mapMeasure"),
             .text = tr("&Measure from here"),
             .trigger =
                 [this, place] {
                     m_map.measure().action()->trigger();
                     m_map.measure().add(place);
                 }},
            {.id = QStringLiteral("mapCopy"), .text = tr("&Copy coordinates"), .trigger = [this, place] {
                 QGuiApplication::clipboard()->setText(
                     coordinatesToCopy(place.latitude, place.longitude, m_map.coordinateFormat()));
             }}};
}

MenuItem MapMenu::goHere(const LatLong &place)
{
    const auto trigger = [this, place] {
        const vehicle::VehicleState *state = vehicle();
        if (!state)
            return;
        const QString mode = modeOfTargets(*state);
        const QString altitude = altitudeFigure(state->altitudeRelative, m_map.units()).text();
        QString question = tr("Go to this location?\n%1").arg(describe(place));
        if (vehicle::rulesOf(*state).flies)
            question = tr("Go to this location at %1 above home?\n%2").arg(altitude, describe(place));
        const QString details = mode.isEmpty() || fromStd(state->mode) == mode
            ? QString()
            : tr("The mode changes from %1 to %2.").arg(fromStd(state->mode), mode);
        const vehicle::GoTo order{place.latitude, place.longitude, state->altitudeRelative, true};
        ask(place, confirmCommand(m_commands, order, question, details, &m_window), tr("Target"));
    };
    return {.id = QStringLiteral("mapGoHere"), .text = tr("&Go here…"), .trigger = trigger, .disabledReason = [this] {
                return movesDisabledReason(m_selection.view());
            }};
}

MenuItem MapMenu::setHome(const LatLong &place)
{
    const auto trigger = [this, place] {
        ask(place,
            confirmCommand(m_commands, vehicle::SetHome{place.latitude, place.longitude},
                           tr("Set home to this location?\n%1").arg(describe(place)),
                           tr("RTL will fly there. The altitude of home stays the same; the ground elevation there is "
                              "not known."),
                           &m_window));
    };
    return {.id = QStringLiteral("mapSetHome"), .text = tr("Set &home here…"), .trigger = trigger, .disabledReason = [this] {
                const QString reason = commandsDisabledReason(m_selection.view());
                return reason.isEmpty() && !knowsHomeAltitude(*vehicle()) ? tr("the altitude of home is not known") : reason;
            }};
}

void MapMenu::ask(const LatLong &place, QMessageBox *question, const QString &label)
{
    m_question = question;
    markUntilClosed(place, question, label);
}

/// The dialog stands beside the place, which the operator wants to see while confirming.
void MapMenu::markUntilClosed(const LatLong &place, QDialog *dialog, const QString &label)
{
    m_map.setMark(place, label);
    dialog->move(placeBeside(dialog->frameGeometry().size(), m_map.mapToGlobal(m_map.pixelOf(place)),
                             m_window.screen()->availableGeometry()));
    connect(dialog, &QDialog::finished, &m_map, [this] { m_map.setMark(std::nullopt); });
}

/// The coordinates, and how far they are from the vehicle.
QString MapMenu::describe(const LatLong &place) const
{
    QString text = coordinatesText(place.latitude, place.longitude, m_map.coordinateFormat());
    const vehicle::VehicleState *state = vehicle();
    if (!state || !state->position.known())
        return text;
    const double metres = vehicle::distanceMetres(state->position, {place.latitude, place.longitude, 0});
    return tr("%1, %2 from the vehicle").arg(text, distanceFigure(metres, m_map.units()).text());
}

} // namespace skyseal::ui

#include "moc_map_menu.cpp"
