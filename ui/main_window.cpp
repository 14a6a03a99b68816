#include "ui/main_window.h"

#include "core/engine/text/state_text.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/flight_panel.h"
#include "ui/flight/take_off_dialog.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/keys/keys_dialog.h"
#include "ui/keys/pairing_dialog.h"
#include "ui/links/link_dialog.h"
#include "ui/links/links_panel.h"
#include "ui/links/problem_banner.h"
#include "ui/logs/logs_panel.h"
#include "ui/main_menus.h"
#include "ui/map/empty_state.h"
#include "ui/map/map_view.h"
#include "ui/messages/messages_panel.h"
#include "ui/security/allow_plain.h"
#include "ui/security/secure_link_panel.h"
#include "ui/security/suite_actions.h"
#include "ui/status/status_strip.h"
#include "ui/status/traffic_bar.h"
#include "ui/sweep/sweep_presenter.h"
#include "ui/sweep/sweep_page.h"
#include "ui/text/state_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/window_docks.h"

#include <QtCore/QSettings>
#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolBar>
#include <QtWidgets/QVBoxLayout>

#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {
constexpr double kNumbersEvery = 0.2; ///< seconds: nobody reads numbers quicker, and every repaint costs
}

MainWindow::MainWindow(StationInterface &station, QSettings &store, ProgramFacts facts, QWidget *parent)
    : QMainWindow(parent), m_station(station), m_store(store), m_facts(std::move(facts)), m_settings(loadSettings(store)),
      m_suites(new SuiteActions(station, this)), m_commands(new VehicleCommands(station, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Skyseal"));
    setWindowIcon(icon(QStringLiteral("skyseal")));
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    makeCentre();
    m_commands->setTakeOffAltitude(m_settings.takeOffAltitude);
    m_docks = new WindowDocks(*this, {m_station, *m_commands, *m_suites, m_facts.recordFolder});
    m_docks->diagnostics->setSessionMeasure(m_facts.sessionBytes);
    new MainMenus(*this);
    connectPanels();
    resize(1280, 800);
    m_docks->rememberDefault();
    m_docks->restore(m_store);
    applySettings(m_settings);
    setFocus(); // no control is the first one: the map takes the keys once it is clicked or reached by Tab
}

MainWindow::~MainWindow() = default;

void MainWindow::makeCentre()
{
    auto *bar = new QToolBar(tr("Status"), this);
    bar->setObjectName(QStringLiteral("statusToolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setEnabled(false);
    m_strip = new StatusStrip(bar);
    bar->addWidget(m_strip);
    addToolBar(Qt::TopToolBarArea, bar);

    auto *centre = new QWidget(this);
    m_banner = new ProblemBanner(centre);
    m_map = new MapView(centre);
    m_empty = new EmptyState(centre);
    m_empty->setDemoAvailable(m_facts.demoAvailable);
    m_empty->setAutoFillBackground(true);
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *ground = new QGridLayout;
    ground->addWidget(m_map, 0, 0);
    ground->addWidget(m_empty, 0, 0, Qt::AlignCenter);
    column->addWidget(m_banner);
    column->addLayout(ground, 1);
    setCentralWidget(centre);

    m_traffic = new TrafficBar(this);
    setStatusBar(m_traffic);
}

void MainWindow::connectPanels()
{
    connect(&m_station, &StationInterface::snapshotReady, this, &MainWindow::showSnapshot);
    connect(&m_station, &StationInterface::eventOccurred, this, &MainWindow::take);
    connect(m_strip, &StatusStrip::lockClicked, this, [this] { m_docks->reveal("dockSecure"); });
    connect(m_strip, &StatusStrip::vehicleClicked, this, &MainWindow::popUpVehicles);
    connect(m_strip, &StatusStrip::linkClicked, this, [this] { m_docks->reveal("dockLinks"); });
    connect(m_empty, &EmptyState::demoWanted, this, &MainWindow::demoWanted);
    connect(m_empty, &EmptyState::connectWanted, this, &MainWindow::openLinkDialog);
    connect(m_empty, &EmptyState::keysWanted, this, &MainWindow::openKeys);
    connect(m_empty, &EmptyState::plainWanted, this,
            [this](const engine::PendingVehicle &held) { askAllowPlain(m_station, held, this); });
    connect(m_docks->secure, &SecureLinkPanel::helpWanted, this, &MainWindow::openHelp);
    connect(m_docks->secure, &SecureLinkPanel::keysWanted, this, &MainWindow::openKeys);
    connect(m_docks->secure, &SecureLinkPanel::sessionChosen, this, [this](quint32 session) {
        for (const auto &vehicle : m_view.snapshot->vehicles)
            if (vehicle.session && static_cast<quint32>(*vehicle.session) == session)
                chooseVehicle(vehicle.state.systemId);
    });
    connect(m_docks->links, &LinksPanel::addWanted, this, &MainWindow::openLinkDialog);
    connect(m_docks->logs, &LogsPanel::replayWanted, this, &MainWindow::replay);
    connect(m_commands, &VehicleCommands::takeOffAltitudeChanged, this, [this](double metres) {
        m_settings.takeOffAltitude = metres;
        storeSettings(m_store, m_settings);
    });
    connect(m_commands, &VehicleCommands::said, this, [this](const QString &line, bool ok) {
        constexpr std::uint8_t kWarning = 4, kInfo = 6;
        m_docks->messages->say(line, ok ? kInfo : kWarning);
    });
}

void MainWindow::showSnapshot(const SnapshotPtr &snapshot)
{
    m_view = viewOf(snapshot, m_chosenVehicle);
    if (m_view.vehicle)
        m_chosenVehicle = m_view.vehicle->state.systemId; // it keeps its place: commands go to the one that is shown
    if (m_sweep)
        m_sweep->mark(m_view);
    m_commands->showViewState(m_view);
    m_map->showViewState(m_view);
    m_docks->showMoving(m_view);
    AlarmState state = stateOf(m_view);
    const bool changed = state != m_shownState;
    if (!changed && snapshot && std::abs(snapshot->time - m_numbersAt) < kNumbersEvery)
        return;
    m_shownState = std::move(state);
    m_numbersAt = snapshot ? snapshot->time : -1;
    showNumbers();
}

void MainWindow::showNumbers()
{
    m_suites->showViewState(m_view);
    m_strip->showViewState(m_view);
    m_traffic->showViewState(m_view);
    m_empty->showViewState(m_view);
    m_docks->showNumbers(m_view);
}

void MainWindow::take(const engine::Event &event)
{
    m_docks->messages->take(event);
    if (const auto *changed = std::get_if<engine::LinkChanged>(&event); changed && changed->link.addressInUse)
        tellPortInUse(changed->link);
    // With neither vehicle nor session the middle of the window says it.
    if (const auto *refused = std::get_if<engine::PlaintextRefused>(&event);
        refused && !refused->mayBe.empty() && (m_view.vehicle || m_view.session)) {
        const engine::PendingVehicle held{refused->systemId, refused->remoteAddress, refused->mayBe};
        tellProblem(tr("Vehicle %1 at %2 is not sealed and may be an impostor of %3: it is held back.")
                        .arg(held.systemId)
                        .arg(fromStd(held.remoteAddress), engine::anyOfNames(held.mayBe)),
                    allowPlainText(held), [this, held] { askAllowPlain(m_station, held, this); });
    }
}

void MainWindow::tellPortInUse(const engine::LinkSnapshot &link)
{
    const QString url = fromStd(link.url);
    const qsizetype colon = url.lastIndexOf(QLatin1Char(':'));
    bool ok = false;
    const int port = url.mid(colon + 1).toInt(&ok);
    if (!ok || port <= 0 || port >= 65535) {
        tellProblem(tr("%1 is in use by another program: %2").arg(url, fromStd(link.problem)));
        return;
    }
    const QString other = url.left(colon + 1) + QString::number(port + 1);
    const LinkId id = link.id;
    QString problem = fromStd(link.problem);
    if (!problem.isEmpty())
        problem[0] = problem[0].toUpper();
    tellProblem(problem, tr("Listen on %1 instead").arg(port + 1), [this, other, id] {
        m_station.removeLink(id);
        addLink(other);
    });
}

void MainWindow::tellProblem(const QString &problem, const QString &remedy, std::function<void()> act)
{
    m_banner->notify(problem, remedy, std::move(act));
}

void MainWindow::addLink(const QString &url)
{
    const auto added = m_station.addLink(url.toStdString());
    if (!added)
        tellProblem(fromStd(added.error().text()));
}

void MainWindow::addLink(const LinkDialog &dialog)
{
    const auto mavsec = dialog.mavsec();
    if (!mavsec)
        return addLink(dialog.url());
    if (const auto added = m_station.addMavsecLink(dialog.url().toStdString(), *mavsec); !added)
        tellProblem(fromStd(added.error().text()));
}

void MainWindow::chooseVehicle(std::uint8_t systemId)
{
    m_chosenVehicle = systemId;
    if (m_view.snapshot)
        showSnapshot(m_view.snapshot);
    showNumbers();
}

void MainWindow::popUpVehicles()
{
    if (!m_view.snapshot || m_view.snapshot->vehicles.empty())
        return;
    QMenu menu(this);
    for (const auto &vehicle : m_view.snapshot->vehicles) {
        const std::uint8_t id = vehicle.state.systemId;
        const QString type = engine::vehicleTypeText(vehicle.state.type);
        QAction *action = menu.addAction(vehicle.session ? tr("Vehicle %1 · %2").arg(id).arg(type)
                                                         : tr("Vehicle %1 · %2 · not sealed").arg(id).arg(type));
        action->setCheckable(true);
        action->setChecked(m_view.vehicle && m_view.vehicle->state.systemId == id);
        connect(action, &QAction::triggered, this, [this, id] { chooseVehicle(id); });
    }
    menu.exec(m_strip->mapToGlobal(QPoint(kGrid, m_strip->height())));
}

void MainWindow::openLinkDialog()
{
    auto *dialog = new LinkDialog(m_settings.defaultLink, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { addLink(*dialog); });
    dialog->open();
}

void MainWindow::openSettings()
{
    auto *dialog = new SettingsDialog(m_settings, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { applySettings(dialog->settings()); });
    dialog->open();
}

void MainWindow::openTakeOff()
{
    auto *dialog = new TakeOffDialog(*m_commands, m_settings.units, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::openHelp(const QString &page)
{
    auto *dialog = new HelpDialog(page, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void MainWindow::openKeys()
{
    if (!m_keyring)
        return;
    auto *dialog = new KeysDialog(*m_keyring, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (m_pairing) {
        dialog->offerPairing();
        connect(dialog, &KeysDialog::pairWanted, dialog, [this, dialog] {
            auto *pairing = new PairingDialog(*m_pairing, *m_keyring, dialog);
            pairing->setAttribute(Qt::WA_DeleteOnClose);
            pairing->open();
        });
    }
    dialog->open();
}

void MainWindow::replay(const QString &file)
{
    addLink(QStringLiteral("tlog:") + file);
}

void MainWindow::applySettings(const Settings &settings)
{
    const bool changed = !(settings == m_settings);
    m_settings = settings;
    applyTheme(settings.theme);
    m_docks->flight->setUnits(settings.units);
    m_suites->setResearchAllowed(settings.allowResearch);
    m_suites->setWeakest(settings.weakestSuite);
    showNumbers();
    if (!changed)
        return;
    storeSettings(m_store, settings);
    m_station.setAllowResearch(settings.allowResearch);
    m_station.setWeakestSuite(settings.weakestSuite);
    m_station.setRecording(settings.record);
    Q_EMIT settingsChanged(settings);
}

void MainWindow::setSweep(SweepInterface &sweep)
{
    SweepPage *page = m_docks->diagnostics->sweep();
    m_sweep = new SweepPresenter(sweep, *page, *m_suites, *this);
    page->setPossible(true);
    connect(m_sweep, &SweepPresenter::askWanted, this, &MainWindow::openSweep);
    connect(m_sweep, &SweepPresenter::began, this, [this] {
        m_docks->reveal("dockDiagnostics");
        m_docks->diagnostics->showSweep();
        constexpr int kEnough = 320; // for a row of each suite
        auto *dock = findChild<QDockWidget *>(QStringLiteral("dockDiagnostics"));
        if (dock && !dock->isFloating() && dock->height() < kEnough)
            resizeDocks({dock}, {kEnough}, Qt::Vertical);
    });
}

void MainWindow::openSweep()
{
    if (m_sweep && m_sweep->isRunning())
        m_docks->diagnostics->showSweep();
    else if (m_sweep)
        m_sweep->ask(m_view, m_settings.requireSealed);
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
        // The link goes back to its suite first; that takes a few seconds at the most.
        connect(m_sweep, &SweepPresenter::finished, this, &MainWindow::close, Qt::UniqueConnection);
        m_sweep->cancel();
        event->ignore();
        return;
    }
    m_docks->save(m_store);
    event->accept();
}

} // namespace skyseal::ui
