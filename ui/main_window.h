// The window: status strip on top, map in the middle, docks around it. It hands every snapshot to the panels and wires
// their wishes to the station; what the panels look like is their own business.
#pragma once

#include "ui/charts/session_memory.h"
#include "ui/view_state.h"
#include "ui/settings.h"

#include <QtWidgets/QMainWindow>

#include <functional>

class QMenu;
class QSettings;

namespace skyseal::ui {

class EmptyState;
class KeyringInterface;
class LinkDialog;
class MapView;
class PairingInterface;
class ProblemBanner;
class StatusStrip;
class SuiteActions;
class SweepPresenter;
class SweepInterface;
class TrafficBar;
class VehicleCommands;
class WindowDocks;

/// Facts about this program that some dialogs show.
struct ProgramFacts
{
    QString version;
    QString recordFolder;
    QString demoCommand; ///< words of the empty state; unused when empty
    bool demoAvailable = false;
    /// Heap of one end's session under a suite; for the diagnostics.
    SessionMemory::Measure sessionBytes = experiment::sessionBytes;
};

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// `store` keeps settings and the arrangement of the docks; it and `station` must outlive the window.
    MainWindow(StationInterface &station, QSettings &store, ProgramFacts facts, QWidget *parent = nullptr);
    ~MainWindow() override;

    void showSnapshot(const SnapshotPtr &snapshot);
    /// Something that the operator must know; `remedy` is a button's text.
    void tellProblem(const QString &problem, const QString &remedy = {}, std::function<void()> act = {});
    /// Adds a link by its URL; a bad URL is told in the window.
    void addLink(const QString &url);
    /// Of the link dialog, once it was accepted.
    void addLink(const LinkDialog &dialog);
    /// What the dialog of keys and peers works on; without it that dialog does not open. They must outlive the window.
    void setKeyring(KeyringInterface &keyring, PairingInterface *pairing = nullptr)
    {
        m_keyring = &keyring, m_pairing = pairing;
    }
    /// What sweeps are made with; without it there are none.
    void setSweep(SweepInterface &sweep);
    SweepPresenter *sweep() const { return m_sweep; }
    const Settings &settings() const { return m_settings; }
    const ViewState &view() const { return m_view; }
    SuiteActions &suites() { return *m_suites; }

Q_SIGNALS:
    void demoWanted();
    void settingsChanged(const skyseal::ui::Settings &settings);

protected:
    void showEvent(QShowEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    friend class MainMenus;

    void makeCentre();
    void connectPanels();
    void showNumbers();
    void take(const engine::Event &event);
    void tellPortInUse(const engine::LinkSnapshot &link);
    void chooseVehicle(std::uint8_t systemId);
    void popUpVehicles();
    void openLinkDialog();
    void openSettings();
    void openTakeOff();
    void openHelp(const QString &page);
    void openKeys();
    void openSweep();
    void replay(const QString &file);
    void applySettings(const Settings &settings);

    StationInterface &m_station;
    KeyringInterface *m_keyring = nullptr;
    PairingInterface *m_pairing = nullptr;
    SweepPresenter *m_sweep = nullptr;
    QSettings &m_store;
    ProgramFacts m_facts;
    Settings m_settings;
    ViewState m_view;
    std::uint8_t m_chosenVehicle = 0; ///< by hand, or as the first one that there was; 0 before that
    double m_numbersAt = -1;          ///< when the numbers were last shown, by the snapshots' clock
    AlarmState m_shownState;
    bool m_wasShown = false;

    SuiteActions *m_suites;
    VehicleCommands *m_commands;
    StatusStrip *m_strip;
    TrafficBar *m_traffic;
    MapView *m_map;
    EmptyState *m_empty;
    ProblemBanner *m_banner;
    WindowDocks *m_docks;
};

} // namespace skyseal::ui
