// The window: status strip on top, map in the middle, docks around it, menus above. It creates the parts and connects them:
// snapshots to views, requests to the station. Lives on the GUI thread.
#pragma once

#include "ui/charts/session_memory.h"
#include "ui/refusal_meter.h"
#include "ui/settings.h"
#include "ui/view_state.h"

#include <QtCore/QElapsedTimer>
#include <QtWidgets/QMainWindow>

#include <functional>

namespace skyseal::ui {

class ActionBar;
class EmptyState;
class KeyringInterface;
class LinkDialog;
class LinkPopover;
class MapView;
class PairingInterface;
class ProblemBanner;
class ProblemReports;
class SourceBar;
class StatusStrip;
class SuiteActions;
class SweepInterface;
class SweepPresenter;
class TrafficBar;
class VehicleCommands;
class ViewSelection;
class WindowActions;
class WindowDialogs;
class WindowDocks;
class Workspaces;
struct UnfinishedRun;

/// Facts about this program that the window shows.
struct ProgramFacts
{
    QString version;
    QString recordFolder; ///< folder of the recordings
    QString cacheFolder;  ///< of map tiles; empty: none are kept
    bool demoAvailable = false;
    /// Heap of one end's session under a suite, for the diagnostics.
    SessionMemory::Measure sessionBytes = experiment::sessionBytes;
};

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// `store` keeps settings and the arrangement of the docks; it and `station` must outlive the window.
    MainWindow(StationInterface &station, QSettings &store, const ProgramFacts &facts, QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Shows a problem that the operator has to act on; `remedy` is the text of the button that calls `act`.
    void reportProblem(const QString &problem, const QString &remedy = {}, std::function<void()> act = {});
    /// For panels that would otherwise wait for a sealed link.
    void setKeyState(const KeyState &state);
    /// Adds a link by its URL, or replays it if it is a recording; an invalid URL is reported in the window.
    void addLink(const QString &url);
    /// Shows a replay in place of the live picture, which goes on underneath, until the operator returns to it.
    void startReplay(const QString &url);
    void endReplay();
    /// Offers to replay and to connect as a run did that has not ended properly, in a bar that waits.
    void offerRescue(const UnfinishedRun &run);
    /// Marks the window while the station is that of the demo.
    void setDemo(bool on);
    /// Closes the window without a question.
    void quit();
    /// Without a keyring, the dialog of keys and peers does not open. Both must outlive the window.
    void setKeyring(KeyringInterface &keyring, PairingInterface *pairing = nullptr);
    /// Without it, the window offers no sweeps. It must outlive the window.
    void setSweep(SweepInterface &sweep);
    SweepPresenter *sweep() const { return m_sweep; }
    const Settings &settings() const { return m_settings; }
    const ViewState &view() const;
    SuiteActions &suites() { return *m_suites; }

Q_SIGNALS:
    void demoRequested();
    void demoEndRequested();
    void settingsChanged(const skyseal::ui::Settings &settings);

protected:
    void closeEvent(QCloseEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void makeBars();
    void makeCentre(const ProgramFacts &facts);
    void makeMenus(const ProgramFacts &facts);
    void connectParts();
    void showNumbers(const ViewState &view);
    void openLink(const LinkDialog &dialog);
    void connectSources();
    double now() const; ///< seconds
    QString armedVehicles() const;
    void startReplayOrAsk(const QString &url);
    bool asksBeforeQuitting();
    void openSweep();
    void revealSweep();
    void applySettings(const Settings &settings);

    StationInterface &m_station;
    QSettings &m_store;
    Settings m_settings;
    ViewSelection *m_selection;
    SuiteActions *m_suites;
    VehicleCommands *m_commands;
    WindowDialogs *m_dialogs;
    SweepPresenter *m_sweep = nullptr;
    KeyState m_keyState;
    RefusalMeter m_refusals;
    QElapsedTimer m_clock;
    const bool m_demoAvailable;
    SourceBar *m_source;
    StatusStrip *m_strip;
    LinkPopover *m_popover;
    TrafficBar *m_traffic;
    MapView *m_map;
    EmptyState *m_empty;
    ActionBar *m_actionBar;
    ProblemBanner *m_banner;
    ProblemReports *m_problems;
    WindowDocks *m_docks;
    Workspaces *m_workspaces;
    WindowActions *m_actions;
    bool m_quitting = false; ///< without a question
};

} // namespace skyseal::ui
