#include "ui/window/window_dialogs.h"

#include "core/engine/station/snapshot.h"
#include "ui/charts/quantities.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/add_waypoint_dialog.h"
#include "ui/flight/change_altitude_dialog.h"
#include "ui/flight/take_off_dialog.h"
#include "ui/keys/keys_dialog.h"
#include "ui/keys/pairing_dialog.h"
#include "ui/links/link_dialog.h"
#include "ui/map/map_source_dialog.h"
#include "ui/map/map_view.h"
#include "ui/map/region_dialog.h"
#include "ui/modeless.h"
#include "ui/overlays/overlay_dialog.h"
#include "ui/replay/recordings_dialog.h"
#include "ui/shortcuts/shortcut_dialog.h"
#include "ui/values/values_editor.h"
#include "ui/view_state.h"
#include "ui/window/armed_questions.h"

#include <QtWidgets/QMessageBox>

namespace skyseal::ui {

namespace {

/// A dialog that deletes itself when it closes.
template<typename Dialog, typename... Arguments> Dialog *make(Arguments &&...arguments)
{
    auto *dialog = new Dialog(std::forward<Arguments>(arguments)...);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}

/// Those that are open or will be.
std::vector<link::LinkUrl> linksOf(const engine::Snapshot &snapshot)
{
    std::vector<link::LinkUrl> out;
    for (const auto *list : {&snapshot.links, &snapshot.served})
        for (const engine::LinkSnapshot &one : *list)
            if (const auto url = link::LinkUrl::parse(one.url); url && one.phase != engine::LinkPhase::Closed)
                out.push_back(*url);
    return out;
}

} // namespace

WindowDialogs::WindowDialogs(QWidget &window, StationInterface &station, VehicleCommands &commands, const Settings &settings,
                             QString recordFolder)
    : QObject(&window), m_window(window), m_station(station), m_commands(commands), m_settings(settings),
      m_recordFolder(std::move(recordFolder))
{
    connect(&station, &StationInterface::snapshotReady, this, [this](const SnapshotPtr &snapshot) { m_live = snapshot; });
}

void WindowDialogs::setKeyring(KeyringInterface &keyring, PairingInterface *pairing)
{
    m_keyring = &keyring;
    m_pairing = pairing;
}

void WindowDialogs::openLink()
{
    if (raiseOpen<LinkDialog>(m_window))
        return;
    auto *dialog = make<LinkDialog>(m_settings.defaultLink, &m_window);
    if (m_live)
        dialog->setOwnLinks(linksOf(*m_live));
    connect(dialog, &QDialog::accepted, this, [this, dialog] { Q_EMIT linkAccepted(*dialog); });
    showModeless(*dialog);
}

void WindowDialogs::openReplay()
{
    if (raiseOpen<RecordingsDialog>(m_window))
        return;
    const QString folder = m_settings.recordFolder.isEmpty() ? m_recordFolder : m_settings.recordFolder;
    auto *dialog = make<RecordingsDialog>(m_station, folder, &m_window);
    connect(dialog, &RecordingsDialog::fileChosen, this, &WindowDialogs::replayAccepted);
    showModeless(*dialog);
}

void WindowDialogs::openSettings()
{
    if (raiseOpen<SettingsDialog>(m_window))
        return;
    auto *dialog = make<SettingsDialog>(m_settings, &m_window);
    std::bitset<256> vehicles;
    if (m_live) {
        for (const engine::VehicleSnapshot &vehicle : m_live->vehicles)
            vehicles.set(vehicle.state.systemId);
    }
    if (m_keyring) {
        for (const KnownPeer &peer : m_keyring->peerList().peers) {
            for (const std::uint8_t systemId : peer.systems)
                vehicles.set(systemId);
        }
    }
    dialog->setVehicles(vehicles);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        Settings changed = dialog->settings();
        changed.takeOffAltitude = m_settings.takeOffAltitude; // set in the panels, perhaps while the dialog was open
        changed.serving = m_settings.serving;
        changed.map = m_settings.map;
        changed.rotateMap = m_settings.rotateMap;
        changed.trackColors = m_settings.trackColors;
        changed.values = m_settings.values;
        Q_EMIT settingsAccepted(changed);
    });
    showModeless(*dialog);
}

void WindowDialogs::openShortcuts(Shortcuts &shortcuts)
{
    if (!raiseOpen<ShortcutDialog>(m_window))
        showModeless(*make<ShortcutDialog>(shortcuts, &m_window));
}

void WindowDialogs::openValues()
{
    if (raiseOpen<ValuesEditor>(m_window))
        return;
    auto *dialog = make<ValuesEditor>(m_settings.values.list, m_settings.units, &m_window);
    connect(dialog, &ValuesEditor::applied, this, [this](const ValueChoices &choices) {
        Settings changed = m_settings;
        changed.values = {choices};
        Q_EMIT settingsAccepted(changed);
    });
    showModeless(*dialog);
}

void WindowDialogs::setTrackColors(TrackColors colors)
{
    Settings changed = m_settings;
    changed.trackColors = colors;
    Q_EMIT settingsAccepted(changed);
}

void WindowDialogs::openTakeOff()
{
    if (!raiseOpen<TakeOffDialog>(m_window))
        showModeless(*make<TakeOffDialog>(m_commands, m_settings.units, &m_window));
}

void WindowDialogs::openChangeAltitude(const ViewState &view)
{
    if (view.vehicle && !raiseOpen<ChangeAltitudeDialog>(m_window))
        showModeless(
            *make<ChangeAltitudeDialog>(m_commands, m_settings.units, view.vehicle->state.altitudeRelative, &m_window));
}

QDialog *WindowDialogs::openAddWaypoint(const LatLong &place, const QString &where)
{
    if (auto *open = m_window.findChild<AddWaypointDialog *>())
        open->reject(); // it is about another place
    auto *dialog = make<AddWaypointDialog>(m_commands, m_settings.units, place.latitude, place.longitude, where, &m_window);
    showModeless(*dialog);
    return dialog;
}

void WindowDialogs::openMapSource()
{
    if (raiseOpen<MapSourceDialog>(m_window))
        return;
    auto *dialog = make<MapSourceDialog>(m_settings.map, &m_window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { Q_EMIT mapSourceAccepted(dialog->source()); });
    showModeless(*dialog);
}

void WindowDialogs::openOverlays(MapView &map)
{
    if (!raiseOpen<OverlayDialog>(m_window))
        showModeless(*make<OverlayDialog>(map.overlays(), &m_window));
}

void WindowDialogs::openRegion(MapView &map)
{
    if (raiseOpen<RegionDialog>(m_window))
        return;
    const MapViewport &viewport = map.viewport();
    auto *dialog = make<RegionDialog>(map.tiles().loader(), m_settings.map, viewport.visible(),
                                      std::max(0, qRound(viewport.zoomLevel())), &m_window);
    connect(dialog, &RegionDialog::useRequested, this, [this](const QString &file) {
        MapSource source = m_settings.map;
        source.kind = MapSource::Kind::File;
        source.file = file;
        Q_EMIT mapSourceAccepted(source);
    });
    showModeless(*dialog);
}

void WindowDialogs::openKeys()
{
    if (!m_keyring || raiseOpen<KeysDialog>(m_window))
        return;
    auto *dialog = make<KeysDialog>(*m_keyring, &m_window);
    dialog->setArmed([this](const QString &peer) { return m_live ? armedVehiclesOf(*m_live, peer) : QString(); });
    if (m_pairing) {
        dialog->offerPairing();
        connect(dialog, &KeysDialog::pairRequested, dialog, [this, dialog] {
            if (!raiseOpen<PairingDialog>(*dialog))
                showModeless(*make<PairingDialog>(*m_pairing, *m_keyring, dialog));
        });
    }
    showModeless(*dialog);
}

void WindowDialogs::openPairing()
{
    openKeys();
    for (KeysDialog *dialog : m_window.findChildren<KeysDialog *>(QString(), Qt::FindDirectChildrenOnly))
        if (!dialog->isHidden())
            Q_EMIT dialog->pairRequested();
}

void WindowDialogs::openHelp(const QString &page)
{
    const QHash<QString, QString> inserts{{QStringLiteral("quantities"), quantitiesHelp()}};
    make<HelpDialog>(page, inserts, &m_window)->show();
}

void WindowDialogs::openAbout(const QString &version)
{
    auto *box = make<QMessageBox>(
        QMessageBox::NoIcon, tr("About Skyseal"),
        tr("Skyseal %1\n\nA ground control station whose MAVLink link is sealed.\nGPL-3.0-or-later; built with Qt %2, "
           "Qt Charts, libsodium and OpenSSL.")
            .arg(version, QLatin1String(qVersion())),
        QMessageBox::Ok, &m_window);
    showModeless(*box);
}

} // namespace skyseal::ui

#include "moc_window_dialogs.cpp"
