// The dialogs that the window opens from menus, panels and the empty state. Each deletes itself when it closes; the results
// leave as signals. Lives on the GUI thread.
#pragma once

#include "core/engine/station/snapshot_ptr.h"
#include "ui/settings.h"

#include <QtCore/QObject>

class QDialog;
class QWidget;

namespace skyseal::ui {

class KeyringInterface;
class LinkDialog;
class MapView;
class PairingInterface;
class Shortcuts;
class StationInterface;
class VehicleCommands;
struct LatLong;
struct ViewState;

class WindowDialogs : public QObject
{
    Q_OBJECT

public:
    /// `station`, `commands` and `settings` must outlive this; `window` becomes the parent of the dialogs. Recordings are
    /// looked for in `recordFolder`, unless the settings name a folder.
    WindowDialogs(QWidget &window, StationInterface &station, VehicleCommands &commands, const Settings &settings,
                  QString recordFolder);

    /// Without a keyring, openKeys() does nothing; without pairing, the dialog of keys does not offer it. Both must outlive
    /// this.
    void setKeyring(KeyringInterface &keyring, PairingInterface *pairing);

    void openLink();
    void openReplay();
    void openSettings();
    void openShortcuts(Shortcuts &shortcuts);
    void openValues();
    void setTrackColors(TrackColors colors);
    TrackColors trackColors() const { return m_settings.trackColors; }
    void openTakeOff();
    /// Offers the present altitude of the vehicle in `view`.
    void openChangeAltitude(const ViewState &view);
    /// `place` in degrees, `where` as a text. The mission of the selected vehicle must be known.
    QDialog *openAddWaypoint(const LatLong &place, const QString &where);
    void openKeys();
    /// Over the keys and peers; only these, without pairing.
    void openPairing();
    void openMapSource();
    void openOverlays(MapView &map);
    /// Fetches what `map` shows, for use without a network.
    void openRegion(MapView &map);
    /// `page` is the name of a help page without its suffix.
    void openHelp(const QString &page);
    void openAbout(const QString &version);

Q_SIGNALS:
    void linkAccepted(const skyseal::ui::LinkDialog &dialog);
    void replayAccepted(const QString &file);
    void mapSourceAccepted(const skyseal::ui::MapSource &source);
    void settingsAccepted(const skyseal::ui::Settings &settings);

private:
    QWidget &m_window;
    StationInterface &m_station;
    VehicleCommands &m_commands;
    const Settings &m_settings;
    QString m_recordFolder;
    engine::SnapshotPtr m_live; ///< the newest one of the station
    KeyringInterface *m_keyring = nullptr;
    PairingInterface *m_pairing = nullptr;
};

} // namespace skyseal::ui
