#include "ui/window/main_window.h"

#include "core/engine/station/snapshot.h"
#include "core/link/link_url.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/action_bar.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/links/link_dialog.h"
#include "ui/links/links_panel.h"
#include "ui/links/problem_banner.h"
#include "ui/map/empty_state.h"
#include "ui/map/map_view.h"
#include "ui/replay/replay_bar.h"
#include "ui/replay/rescue_bar.h"
#include "ui/security/allow_plain.h"
#include "ui/security/link_popover.h"
#include "ui/security/suite_actions.h"
#include "ui/shortcuts/disabled_shortcuts.h"
#include "ui/shortcuts/shortcuts.h"
#include "ui/status/status_strip.h"
#include "ui/status/traffic_bar.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_presenter.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/icons.h"
#include "ui/vehicles/vehicles_panel.h"
#include "ui/window/armed_questions.h"
#include "ui/window/flight_target.h"
#include "ui/window/map_alerts.h"
#include "ui/window/map_menu.h"
#include "ui/window/menu_bar_focus.h"
#include "ui/window/menu_key.h"
#include "ui/window/panel_table.h"
#include "ui/window/problem_reports.h"
#include "ui/window/remembered_checklists.h"
#include "ui/window/source_bar.h"
#include "ui/window/tab_stops.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_menus.h"
#include "ui/window/workspace_tabs.h"
#include "ui/window/workspaces.h"

#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtGui/QCloseEvent>
#include <QtGui/QScreen>
#include <QtWidgets/QDialog>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QToolBar>
#include <QtWidgets/QVBoxLayout>

#include <utility>

namespace skyseal::ui {

namespace {
constexpr int kSweepHeight = 320; ///< pixels: room for a row of each suite
constexpr int kListHeight = 260;  ///< pixels: room for nine vehicles
constexpr QSize kFirstSize(1280, 800);
constexpr QSize kFrame(16, 48); ///< pixels: about what a window manager adds
} // namespace

MainWindow::MainWindow(StationInterface &station, QSettings &store, const ProgramFacts &facts, QWidget *parent)
    : QMainWindow(parent), m_station(station), m_store(store), m_settings(loadSettings(store)),
      m_selection(new ViewSelection(this)), m_suites(new SuiteActions(station, this, &store)),
      m_commands(new VehicleCommands(station, this)),
      m_dialogs(new WindowDialogs(*this, station, *m_commands, m_settings, facts.recordFolder)),
      m_demoAvailable(facts.demoAvailable)
{
    m_clock.start();
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Skyseal"));
    setWindowIcon(icon(QStringLiteral("skyseal")));
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea); // what stands at the sides needs height
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_docks = new WindowDocks(
        *this, {m_station, *m_commands, *m_suites, *m_selection, *m_dialogs, facts.recordFolder, facts.sessionBytes});
    m_workspaces = new Workspaces(*this, *m_docks);
    makeBars();
    makeCentre(facts);
    rememberChecklists(m_commands->preflight(), m_store);
    m_commands->setTakeOffAltitude(m_settings.takeOffAltitude);
    makeMenus(facts);
    connectParts();
    connectSources();
    resize(kFirstSize.boundedTo(screen()->availableSize() - kFrame));
    m_workspaces->restore(m_store);
    applySettings(m_settings);
    m_map->overlays().setFiles(loadOverlays(m_store));
    setFocus(); // no control has the focus at the start; the map takes the keys once it is clicked or reached by Tab
}

MainWindow::~MainWindow()
{
    // Before the parts that they work with; QWidget would delete them last.
    qDeleteAll(findChildren<QDialog *>(QString(), Qt::FindDirectChildrenOnly));
}

void MainWindow::makeBars()
{
    auto *bar = new QToolBar(tr("Status"), this);
    bar->setObjectName(QStringLiteral("statusToolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setEnabled(false);
    auto *rows = new QWidget(bar); // in one bar, since a saved arrangement would show or hide a bar of its own
    rows->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_source = new SourceBar(rows);
    m_strip = new StatusStrip(rows);
    auto *column = new QVBoxLayout(rows);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_source);
    column->addWidget(m_source->replayBar());
    auto *line = new QHBoxLayout;
    line->setSpacing(0);
    line->addWidget(new WorkspaceTabs(*m_workspaces, rows));
    line->addWidget(m_strip, 1);
    column->addLayout(line);
    bar->addWidget(rows);
    addToolBar(Qt::TopToolBarArea, bar);
    m_popover = new LinkPopover(*this);
    m_traffic = new TrafficBar(this);
    setStatusBar(m_traffic);
}

void MainWindow::makeCentre(const ProgramFacts &facts)
{
    auto *centre = new QWidget(this);
    m_banner = new ProblemBanner(centre);
    m_problems = new ProblemReports(m_station, *m_banner, *this);
    m_map = new MapView({QStringLiteral("Skyseal/") + facts.version, facts.cacheFolder}, centre);
    m_empty = new EmptyState(centre);
    m_empty->setDemoAvailable(facts.demoAvailable);
    m_empty->setAutoFillBackground(true);
    centre->setFocusProxy(m_map); // for the focus that no command may have, see CommandGuard
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *ground = new QGridLayout;
    ground->addWidget(m_map, 0, 0);
    ground->addWidget(m_empty, 0, 0, Qt::AlignCenter);
    column->addWidget(m_banner);
    column->addLayout(ground, 1);
    m_actionBar = new ActionBar(*m_commands, centre);
    m_actionBar->setUnits(m_settings.units);
    connect(this, &MainWindow::settingsChanged, m_actionBar, [this](const Settings &now) { m_actionBar->setUnits(now.units); });
    connect(m_selection, &ViewSelection::numbersDue, m_actionBar, &ActionBar::showViewState);
    column->addWidget(m_actionBar);
    setCentralWidget(centre);
}

void MainWindow::makeMenus(const ProgramFacts &facts)
{
    const auto *alerts = new MapAlerts(m_station, *m_selection, *m_dialogs, *m_map, m_settings);
    connect(alerts, &MapAlerts::alertsShown, m_docks->panel<VehiclesPanel>(), &VehiclesPanel::showAlerts);
    auto *shortcuts = new Shortcuts(m_store, this);
    m_actions = new WindowActions(*this, *shortcuts);
    MenuTargets targets{.window = *this,
                        .station = m_station,
                        .selection = *m_selection,
                        .commands = *m_commands,
                        .suites = *m_suites,
                        .dialogs = *m_dialogs,
                        .docks = *m_docks,
                        .workspaces = *m_workspaces,
                        .map = *m_map,
                        .shortcuts = *shortcuts,
                        .actions = *m_actions,
                        .goToAlerts = alerts->goToAction(),
                        .version = facts.version,
                        .openSweep = [this] { openSweep(); }};
    if (facts.demoAvailable) {
        targets.startDemo = [this] { Q_EMIT demoRequested(); };
        targets.endDemo = [this] { Q_EMIT demoEndRequested(); };
        targets.inDemo = [this] { return m_source->source() == SourceBar::Source::Demo; };
    }
    // At each view: a shortcut works as if the menu had been opened just before.
    connect(m_selection, &ViewSelection::viewChanged, menuBar(), addMenus(*menuBar(), windowMenus(targets)));
    shortcuts->take(*menuBar());
    const auto *mapMenu = new MapMenu(*m_map, *m_selection, *m_commands, *m_dialogs, *this);
    new FlightTarget(*m_map, *m_selection, *m_commands);
    m_docks->publish(*m_actions);
    m_actions->add(tr("Menus"), {(new MenuBarFocus(*menuBar()))->action()});
    m_actions->add(tr("Flight actions"), m_actionBar->actions());
    m_actions->add(tr("Place on the map"), mapMenu->placeActions());
    m_actions->add(tr("Alerts"), alerts->actions());
    m_actions->add(tr("Replay and demo"), m_source->actions());
    m_actions->add(tr("Problem"), m_banner->actions());
    connect(new DisabledShortcuts(*shortcuts, *this), &DisabledShortcuts::refused, m_actionBar,
            [this](const QString &line) { m_actionBar->say(line, false); });
    new MenuKey(*this);
}

void MainWindow::connectParts()
{
    m_selection->setAnnotation([this](ViewState &view) {
        view.key = m_keyState;
        m_refusals.mark(view, now());
        if (m_sweep)
            m_sweep->mark(view);
    });
    connect(&m_station, &StationInterface::snapshotReady, m_selection, &ViewSelection::setSnapshot);
    connect(&m_station, &StationInterface::eventOccurred, m_problems, [this](const engine::Event &event) {
        m_refusals.handleEvent(event, now());
        m_problems->handleEvent(event, m_selection->liveView());
    });
    connect(m_selection, &ViewSelection::viewChanged, m_commands, &VehicleCommands::showViewState);
    connect(m_selection, &ViewSelection::viewChanged, m_map, &MapView::showViewState);
    connect(m_map, &MapView::vehicleClicked, m_selection, &ViewSelection::selectVehicle);
    connect(m_selection, &ViewSelection::viewChanged, m_docks, &WindowDocks::onSnapshot);
    connect(m_selection, &ViewSelection::numbersDue, this, &MainWindow::showNumbers);

    connect(m_strip, &StatusStrip::lockClicked, this, [this] {
        if (m_workspaces->current() == Workspace::Lab)
            m_docks->reveal("dockSecure");
        else
            m_popover->toggleAt(*m_strip->lock());
    });
    connect(m_popover, &LinkPopover::panelRequested, this, [this] { m_docks->reveal("dockSecure"); });
    connect(m_strip, &StatusStrip::vehicleClicked, this, [this] {
        const bool wasOpen = m_docks->panel<VehiclesPanel>()->isVisible(); // at the height that the operator gave it
        m_docks->reveal("dockVehicles");
        if (!wasOpen)
            m_docks->growTo("dockVehicles", kListHeight);
    });
    for (const auto clicked : {&StatusStrip::linkClicked, &StatusStrip::sharingClicked})
        connect(m_strip, clicked, this, [this] { m_docks->reveal("dockLinks"); });
    connect(m_docks->panel<LinksPanel>(), &LinksPanel::sharingChanged, m_strip, &StatusStrip::showSharing);
    connect(m_empty, &EmptyState::demoRequested, this, &MainWindow::demoRequested);
    connect(m_empty, &EmptyState::connectRequested, m_dialogs, &WindowDialogs::openLink);
    connect(m_empty, &EmptyState::keysRequested, m_dialogs, &WindowDialogs::openKeys);
    connect(m_empty, &EmptyState::plainRequested, this,
            [this](const engine::PendingVehicle &pending) { askAllowPlain(m_station, pending, this); });

    connect(m_dialogs, &WindowDialogs::linkAccepted, this, &MainWindow::openLink);
    connect(m_dialogs, &WindowDialogs::replayAccepted, this,
            [this](const QString &file) { startReplayOrAsk(fromStd(link::LinkUrl::ofRecording(file.toStdString()))); });
    connect(m_dialogs, &WindowDialogs::settingsAccepted, this, &MainWindow::applySettings);
    connect(m_dialogs, &WindowDialogs::mapSourceAccepted, this, [this](const MapSource &source) {
        m_settings.map = source;
        storeSettings(m_store, m_settings);
        m_map->setSource(source);
    });
    connect(&m_map->rotation(), &MapRotation::toggled, this, [this](bool on) {
        m_settings.rotateMap = on;
        storeSettings(m_store, m_settings);
    });
    connect(&m_map->overlays(), &OverlayModel::filesChanged, this,
            [this] { storeOverlays(m_store, m_map->overlays().files()); });
    connect(m_problems, &ProblemReports::linkRequested, this, &MainWindow::addLink);
    connect(m_commands, &VehicleCommands::takeOffAltitudeChanged, this, [this](double metres) {
        m_settings.takeOffAltitude = metres;
        storeSettings(m_store, m_settings);
    });
    connect(m_docks->panel<LinksPanel>(), &LinksPanel::servingChanged, this, [this](const Serving &serving) {
        m_settings.serving = serving;
        storeSettings(m_store, m_settings);
    });
}

void MainWindow::connectSources()
{
    connect(&m_station, &StationInterface::replaySnapshotReady, this, [this](const SnapshotPtr &snapshot) {
        if (m_selection->isAfterSeek(*snapshot))
            m_map->forgetFlight();
        m_selection->setReplaySnapshot(snapshot);
        if (m_selection->isReplaying())
            m_source->showReplay(view());
    });
    connect(m_source->replayBar(), &ReplayBar::commandRequested, &m_station, &StationInterface::controlReplay);
    connect(m_selection, &ViewSelection::liveChanged, m_source, &SourceBar::showLive);
    connect(m_selection, &ViewSelection::liveChanged, m_map, &MapView::noteLive);
    connect(m_source, &SourceBar::endRequested, this, [this] {
        if (m_source->source() == SourceBar::Source::Replay)
            endReplay();
        else
            Q_EMIT demoEndRequested();
    });
}

double MainWindow::now() const
{
    return static_cast<double>(m_clock.elapsed()) / 1000;
}

const ViewState &MainWindow::view() const
{
    return m_selection->view();
}

void MainWindow::showNumbers(const ViewState &view)
{
    m_suites->showViewState(view);
    m_strip->showViewState(view);
    m_popover->showViewState(view);
    m_traffic->showViewState(view);
    m_empty->showViewState(view);
    m_docks->showViewState(view);
}

void MainWindow::reportProblem(const QString &problem, const QString &remedy, std::function<void()> act)
{
    m_problems->report(problem, remedy, std::move(act));
}

void MainWindow::setKeyState(const KeyState &state)
{
    m_keyState = state;
    m_selection->refresh();
}

void MainWindow::addLink(const QString &url)
{
    if (const auto parsed = link::LinkUrl::parse(url.toStdString()); parsed && parsed->traits().isRecording)
        return startReplay(url);
    if (const auto added = m_station.addLink(url.toStdString()); !added)
        reportProblem(reasonText(added.error().reason()));
}

/// Those of the live picture; empty in the demo, where nothing can come to harm.
QString MainWindow::armedVehicles() const
{
    const SnapshotPtr live = m_selection->liveView().snapshot;
    return live && m_source->source() != SourceBar::Source::Demo ? ui::armedVehicles(*live) : QString();
}

void MainWindow::startReplayOrAsk(const QString &url)
{
    const QString armed = armedVehicles();
    if (armed.isEmpty())
        startReplay(url);
    else
        askToReplay(armed, this, [this, url] { startReplay(url); });
}

void MainWindow::startReplay(const QString &url)
{
    if (m_source->source() == SourceBar::Source::Demo)
        return reportProblem(tr("End the demo before you replay a log"));
    if (const auto started = m_station.startReplay(url.toStdString()); !started)
        return reportProblem(reasonText(started.error().reason()));
    const auto parsed = link::LinkUrl::parse(url.toStdString());
    m_docks->keepHeights(); // which may give way to the bar of the replay
    m_source->showSource(SourceBar::Source::Replay, parsed ? QFileInfo(fromStd(parsed->path())).fileName() : url);
    m_source->showLive(m_selection->liveView());
    m_map->beginReplay();
    m_selection->beginReplay();
}

void MainWindow::endReplay()
{
    m_station.endReplay();
    m_source->showSource(SourceBar::Source::Live);
    m_map->endReplay();
    m_selection->endReplay();
    m_docks->returnHeights();
}

void MainWindow::offerRescue(const UnfinishedRun &run)
{
    auto *bar = new RescueBar(run, centralWidget());
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, bar);
    m_actions->addPassing(tr("Last run"), bar->actions());
    connect(bar, &RescueBar::replayRequested, this,
            [this](const QString &file) { startReplayOrAsk(fromStd(link::LinkUrl::ofRecording(file.toStdString()))); });
    connect(bar, &RescueBar::linksRequested, this, [this](const QStringList &urls) {
        for (const QString &url : urls)
            addLink(url);
    });
}

void MainWindow::setDemo(bool on)
{
    m_source->showSource(on ? SourceBar::Source::Demo : SourceBar::Source::Live);
    m_empty->setDemoAvailable(m_demoAvailable && !on);
    m_suites->setKeeping(!on);
    m_map->startOver();
    m_suites->startOver();
    setWindowTitle(on ? tr("Skyseal: demo") : tr("Skyseal"));
}

void MainWindow::openLink(const LinkDialog &dialog)
{
    if (m_source->source() == SourceBar::Source::Demo)
        return reportProblem(tr("End the demo before you add a link"));
    if (const auto parsed = link::LinkUrl::parse(dialog.url().toStdString()); parsed && parsed->traits().isRecording)
        return startReplayOrAsk(dialog.url());
    const auto mavsec = dialog.mavsec();
    if (!mavsec)
        return addLink(dialog.url());
    if (const auto added = m_station.addMavsecLink(dialog.url().toStdString(), *mavsec); !added)
        reportProblem(reasonText(added.error().reason()));
}

void MainWindow::applySettings(const Settings &settings)
{
    const bool changed = !(settings == m_settings);
    m_settings = settings;
    applyTheme(settings.theme, settings.touchSized);
    m_commands->setUnits(settings.units);
    m_map->setUnits(settings.units);
    m_map->setCoordinateFormat(settings.coordinates);
    m_map->setSource(settings.map);
    m_map->rotation().action()->setChecked(settings.rotateMap);
    m_map->setTrackColors(settings.trackColors);
    m_docks->applySettings(settings);
    m_suites->setResearchAllowed(settings.allowResearch);
    m_suites->setWeakest(settings.weakestSuite);
    showNumbers(view());
    if (!changed)
        return;
    storeSettings(m_store, settings);
    m_station.setAllowResearch(settings.allowResearch);
    m_station.setWeakestSuite(settings.weakestSuite);
    m_station.setRecording(settings.record);
    Q_EMIT settingsChanged(settings);
}

void MainWindow::setKeyring(KeyringInterface &keyring, PairingInterface *pairing)
{
    m_dialogs->setKeyring(keyring, pairing);
}

void MainWindow::setSweep(SweepInterface &sweep)
{
    SweepPage *page = m_docks->panel<DiagnosticsPanel>()->sweep();
    m_sweep = new SweepPresenter(sweep, *page, *m_suites, *this);
    page->setPossible(true);
    connect(m_sweep, &SweepPresenter::dialogRequested, this, &MainWindow::openSweep);
    connect(m_sweep, &SweepPresenter::began, this, &MainWindow::revealSweep);
    connect(m_docks->panel<DiagnosticsPanel>(), &DiagnosticsPanel::sweepShown, this, [this, page](bool shown) {
        if (shown && page->results())
            m_docks->growTo("dockDiagnostics", kSweepHeight);
        else if (!shown)
            m_docks->shrinkBack();
    });
}

void MainWindow::openSweep()
{
    if (m_sweep && m_sweep->isRunning())
        m_docks->panel<DiagnosticsPanel>()->showSweep();
    else if (m_sweep)
        m_sweep->ask(view(), m_settings.requireSealed);
}

void MainWindow::revealSweep()
{
    m_docks->reveal("dockDiagnostics");
    m_docks->panel<DiagnosticsPanel>()->showSweep();
    m_docks->growTo("dockDiagnostics", kSweepHeight);
}

void MainWindow::quit()
{
    m_quitting = true;
    close();
}

/// Asks if the link of an armed vehicle would end.
bool MainWindow::asksBeforeQuitting()
{
    const QString armed = armedVehicles();
    if (m_quitting || armed.isEmpty())
        return false;
    askToQuit(armed, this, [this] { quit(); });
    return true;
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (asksBeforeQuitting()) {
        event->ignore();
        return;
    }
    if (m_sweep && m_sweep->isRunning()) {
        // Cancelling restores the suite of the link, which takes a few seconds at most.
        connect(m_sweep, &SweepPresenter::finished, this, &MainWindow::close, Qt::UniqueConnection);
        m_sweep->cancel();
        event->ignore();
        return;
    }
    m_workspaces->save(m_store);
    event->accept();
}

bool MainWindow::focusNextPrevChild(bool next)
{
    return moveFocusInSight(*this, [this, next] { return QMainWindow::focusNextPrevChild(next); });
}

} // namespace skyseal::ui

#include "moc_main_window.cpp"
