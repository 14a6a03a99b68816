#include "ui/window/main_window.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "core/link/link_url.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/links/link_dialog.h"
#include "ui/links/links_panel.h"
#include "ui/links/problem_banner.h"
#include "ui/map/empty_state.h"
#include "ui/map/map_view.h"
#include "ui/security/allow_plain.h"
#include "ui/security/suite_actions.h"
#include "ui/status/status_strip.h"
#include "ui/status/traffic_bar.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_presenter.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/window/panel_table.h"
#include "ui/window/problem_reports.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_menus.h"

#include <QtCore/QSettings>
#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QToolBar>
#include <QtWidgets/QVBoxLayout>

#include <utility>

namespace skyseal::ui {

namespace {
constexpr int kSweepHeight = 320; ///< pixels: room for a row of each suite
} // namespace

MainWindow::MainWindow(StationInterface &station, QSettings &store, const ProgramFacts &facts, QWidget *parent)
    : QMainWindow(parent), m_station(station), m_store(store), m_settings(loadSettings(store)),
      m_selection(new ViewSelection(this)), m_suites(new SuiteActions(station, this)),
      m_commands(new VehicleCommands(station, this)),
      m_dialogs(new WindowDialogs(*this, *m_commands, m_settings, facts.recordFolder))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Skyseal"));
    setWindowIcon(icon(QStringLiteral("skyseal")));
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    makeStatusStrip();
    makeCentre(facts.demoAvailable);
    m_commands->setTakeOffAltitude(m_settings.takeOffAltitude);
    m_docks = new WindowDocks(
        *this, {m_station, *m_commands, *m_suites, *m_selection, *m_dialogs, facts.recordFolder, facts.sessionBytes});
    makeMenus(facts);
    connectParts();
    resize(1280, 800);
    m_docks->rememberDefault();
    m_docks->restore(m_store);
    applySettings(m_settings);
    setFocus(); // no control has the focus at the start; the map takes the keys once it is clicked or reached by Tab
}

MainWindow::~MainWindow() = default;

void MainWindow::makeStatusStrip()
{
    auto *bar = new QToolBar(tr("Status"), this);
    bar->setObjectName(QStringLiteral("statusToolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setEnabled(false);
    m_strip = new StatusStrip(bar);
    bar->addWidget(m_strip);
    addToolBar(Qt::TopToolBarArea, bar);
    m_traffic = new TrafficBar(this);
    setStatusBar(m_traffic);
}

void MainWindow::makeCentre(bool demoAvailable)
{
    auto *centre = new QWidget(this);
    auto *banner = new ProblemBanner(centre);
    m_problems = new ProblemReports(m_station, *banner, *this);
    m_map = new MapView(centre);
    m_empty = new EmptyState(centre);
    m_empty->setDemoAvailable(demoAvailable);
    m_empty->setAutoFillBackground(true);
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *ground = new QGridLayout;
    ground->addWidget(m_map, 0, 0);
    ground->addWidget(m_empty, 0, 0, Qt::AlignCenter);
    column->addWidget(banner);
    column->addLayout(ground, 1);
    setCentralWidget(centre);
}

void MainWindow::makeMenus(const ProgramFacts &facts)
{
    MenuTargets targets{.window = *this,
                        .station = m_station,
                        .selection = *m_selection,
                        .commands = *m_commands,
                        .suites = *m_suites,
                        .dialogs = *m_dialogs,
                        .docks = *m_docks,
                        .map = *m_map,
                        .version = facts.version,
                        .openSweep = [this] { openSweep(); },
                        .startDemo = {}};
    if (facts.demoAvailable)
        targets.startDemo = [this] { Q_EMIT demoRequested(); };
    addMenus(*menuBar(), windowMenus(targets));
}

void MainWindow::connectParts()
{
    m_selection->setAnnotation([this](ViewState &view) {
        view.keyProblem = m_keyProblem;
        if (m_sweep)
            m_sweep->mark(view);
    });
    connect(&m_station, &StationInterface::snapshotReady, m_selection, &ViewSelection::setSnapshot);
    connect(&m_station, &StationInterface::eventOccurred, m_problems,
            [this](const engine::Event &event) { m_problems->handleEvent(event, m_selection->view()); });
    connect(m_selection, &ViewSelection::viewChanged, m_commands, &VehicleCommands::showViewState);
    connect(m_selection, &ViewSelection::viewChanged, m_map, &MapView::showViewState);
    connect(m_selection, &ViewSelection::viewChanged, m_docks, &WindowDocks::onSnapshot);
    connect(m_selection, &ViewSelection::numbersDue, this, &MainWindow::showNumbers);

    connect(m_strip, &StatusStrip::lockClicked, this, [this] { m_docks->reveal("dockSecure"); });
    connect(m_strip, &StatusStrip::vehicleClicked, this, &MainWindow::popUpVehicles);
    connect(m_strip, &StatusStrip::linkClicked, this, [this] { m_docks->reveal("dockLinks"); });
    connect(m_empty, &EmptyState::demoRequested, this, &MainWindow::demoRequested);
    connect(m_empty, &EmptyState::connectRequested, m_dialogs, &WindowDialogs::openLink);
    connect(m_empty, &EmptyState::keysRequested, m_dialogs, &WindowDialogs::openKeys);
    connect(m_empty, &EmptyState::plainRequested, this,
            [this](const engine::PendingVehicle &pending) { askAllowPlain(m_station, pending, this); });

    connect(m_dialogs, &WindowDialogs::linkAccepted, this, &MainWindow::openLink);
    connect(m_dialogs, &WindowDialogs::replayAccepted, this,
            [this](const QString &file) { addLink(fromStd(link::LinkUrl::ofRecording(file.toStdString()))); });
    connect(m_dialogs, &WindowDialogs::settingsAccepted, this, &MainWindow::applySettings);
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

const ViewState &MainWindow::view() const
{
    return m_selection->view();
}

void MainWindow::showNumbers(const ViewState &view)
{
    m_suites->showViewState(view);
    m_strip->showViewState(view);
    m_traffic->showViewState(view);
    m_empty->showViewState(view);
    m_docks->showViewState(view);
}

void MainWindow::reportProblem(const QString &problem, const QString &remedy, std::function<void()> act)
{
    m_problems->report(problem, remedy, std::move(act));
}

void MainWindow::setKeyProblem(const QString &problem)
{
    m_keyProblem = problem;
    m_selection->refresh();
}

void MainWindow::addLink(const QString &url)
{
    if (const auto added = m_station.addLink(url.toStdString()); !added)
        reportProblem(fromStd(added.error().text()));
}

void MainWindow::openLink(const LinkDialog &dialog)
{
    const auto mavsec = dialog.mavsec();
    if (!mavsec)
        return addLink(dialog.url());
    if (const auto added = m_station.addMavsecLink(dialog.url().toStdString(), *mavsec); !added)
        reportProblem(fromStd(added.error().text()));
}

void MainWindow::popUpVehicles()
{
    const ViewState &shown = view();
    if (!shown.snapshot || shown.snapshot->vehicles.empty())
        return;
    QMenu menu(this);
    for (const auto &vehicle : shown.snapshot->vehicles) {
        const std::uint8_t id = vehicle.state.systemId;
        const QString type = engine::vehicleTypeText(vehicle.state.type);
        QAction *action = menu.addAction(vehicle.session ? tr("Vehicle %1 · %2").arg(id).arg(type)
                                                         : tr("Vehicle %1 · %2 · not sealed").arg(id).arg(type));
        action->setCheckable(true);
        action->setChecked(shown.vehicle && shown.vehicle->state.systemId == id);
        connect(action, &QAction::triggered, m_selection, [this, id] { m_selection->selectVehicle(id); });
    }
    menu.exec(m_strip->mapToGlobal(QPoint(kGrid, m_strip->height())));
}

void MainWindow::applySettings(const Settings &settings)
{
    const bool changed = !(settings == m_settings);
    m_settings = settings;
    applyTheme(settings.theme);
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

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (!std::exchange(m_wasShown, true))
        QTimer::singleShot(0, m_docks, &WindowDocks::raiseFloating);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_sweep && m_sweep->isRunning()) {
        // Cancelling restores the suite of the link, which takes a few seconds at most.
        connect(m_sweep, &SweepPresenter::finished, this, &MainWindow::close, Qt::UniqueConnection);
        m_sweep->cancel();
        event->ignore();
        return;
    }
    m_docks->shrinkBack();
    m_docks->save(m_store);
    event->accept();
}

} // namespace skyseal::ui
