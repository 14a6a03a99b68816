#include "ui/main_menus.h"

#include "ui/flight/command_permits.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/security/allow_plain.h"
#include "ui/security/suite_actions.h"
#include "ui/text/state_text.h"
#include "ui/window_docks.h"

#include <QtGui/QAction>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

MainMenus::MainMenus(MainWindow &window) : QObject(&window), m_window(window)
{
    QMenuBar *bar = window.menuBar();
    fillFile(*bar->addMenu(tr("&File")));
    fillLink(*bar->addMenu(tr("&Link")));
    fillVehicle(*bar->addMenu(tr("&Vehicle")));
    fillSecurity(*bar->addMenu(tr("&Security")));
    fillView(*bar->addMenu(tr("V&iew")));
    fillTools(*bar->addMenu(tr("&Tools")));
    fillHelp(*bar->addMenu(tr("&Help")));
}

QAction *MainMenus::add(QMenu &menu, const QString &text, const QString &name, const QKeySequence &keys,
                        std::function<void()> act)
{
    auto *action = new QAction(text, &m_window);
    action->setObjectName(name);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, &m_window, std::move(act));
    menu.addAction(action);
    return action;
}

void MainMenus::fillFile(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuFile"));
    add(menu, tr("&Settings …"), QStringLiteral("actionSettings"), QKeySequence::Preferences,
        [this] { m_window.openSettings(); });
    add(menu, tr("&Replay a log …"), QStringLiteral("actionReplay"), QKeySequence::Open, [this] {
        const QString file = QFileDialog::getOpenFileName(&m_window, tr("Replay a log"), m_window.m_facts.recordFolder,
                                                          tr("Telemetry logs (*.tlog);;All files (*)"));
        if (!file.isEmpty())
            m_window.replay(file);
    });
    menu.addSeparator();
    add(menu, tr("&Quit"), QStringLiteral("actionQuit"), QKeySequence::Quit, [this] { m_window.close(); });
}

void MainMenus::fillLink(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuLink"));
    add(menu, tr("&Connect …"), QStringLiteral("actionConnect"), Qt::Key_F12, [this] { m_window.openLinkDialog(); });
}

void MainMenus::askAndSend(const QString &question, const vehicle::VehicleCommand &command)
{
    const vehicle::VehicleCommand asked = command;
    const std::uint8_t systemId = m_window.m_commands->systemId();
    const bool several = m_window.m_commands->isOneOfSeveral();
    const QString words = several ? tr("Vehicle %1: %2").arg(systemId).arg(question) : question;
    auto *box = new QMessageBox(QMessageBox::Question, tr("Confirm"), words, QMessageBox::Yes | QMessageBox::Cancel, &m_window);
    box->setObjectName(QStringLiteral("confirmCommand"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setEscapeButton(QMessageBox::Cancel);
    box->button(QMessageBox::Yes)->setText(commandText(asked));
    connect(box, &QMessageBox::finished, &m_window, [this, systemId, asked](int result) {
        if (result == QMessageBox::Yes)
            m_window.m_commands->send(systemId, asked);
    });
    box->open();
}

void MainMenus::fillVehicle(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuVehicle"));
    menu.setToolTipsVisible(true);
    const auto ask = [this, &menu](const QString &text, const QString &name, const QString &question,
                                   const vehicle::VehicleCommand &command) {
        return add(menu, text, name, {}, [this, question, command] { askAndSend(question, command); });
    };
    QList<QAction *> all;
    all << ask(tr("&Arm …"), QStringLiteral("actionArm"), tr("Arm the motors? The propellers will turn."), vehicle::Arm{});
    all << ask(tr("&Disarm …"), QStringLiteral("actionDisarm"), tr("Disarm the motors?"), vehicle::Disarm{});
    menu.addSeparator();
    all << add(menu, tr("&Take off …"), QStringLiteral("actionTakeOff"), {}, [this] { m_window.openTakeOff(); });
    all << ask(tr("&Land …"), QStringLiteral("actionLand"), tr("Land here?"), vehicle::Land{});
    all << ask(tr("&Return to launch …"), QStringLiteral("actionReturn"), tr("Return to launch and land there?"),
               vehicle::ReturnToLaunch{});
    all << ask(tr("&Start the mission …"), QStringLiteral("actionStartMission"), tr("Fly the mission?"),
               vehicle::StartMission{});
    menu.addSeparator();
    QMenu *modes = menu.addMenu(tr("&Mode"));
    modes->setObjectName(QStringLiteral("menuMode"));
    connect(modes, &QMenu::aboutToShow, &m_window, [this, modes] {
        modes->clear();
        if (!m_window.m_view.vehicle)
            return;
        for (const std::string &mode : m_window.m_view.vehicle->state.modes) {
            QAction *action = modes->addAction(fromStd(mode) + QStringLiteral(" …"));
            action->setCheckable(true);
            action->setChecked(mode == m_window.m_view.vehicle->state.mode);
            connect(action, &QAction::triggered, &m_window,
                    [this, mode] { askAndSend(tr("Change the mode to %1?").arg(fromStd(mode)), vehicle::SetMode{mode}); });
        }
    });
    all << modes->menuAction();
    menu.addSeparator();
    QMenu *choose = menu.addMenu(tr("S&how"));
    choose->setObjectName(QStringLiteral("menuChooseVehicle"));
    connect(choose, &QMenu::aboutToShow, &m_window, [this, choose] {
        choose->clear();
        if (!m_window.m_view.snapshot)
            return;
        for (const auto &vehicle : m_window.m_view.snapshot->vehicles) {
            const std::uint8_t id = vehicle.state.systemId;
            QAction *action = choose->addAction(tr("Vehicle %1").arg(id));
            action->setCheckable(true);
            action->setChecked(m_window.m_view.vehicle && m_window.m_view.vehicle->state.systemId == id);
            connect(action, &QAction::triggered, &m_window, [this, id] { m_window.chooseVehicle(id); });
        }
    });
    connect(&menu, &QMenu::aboutToShow, &m_window, [this, all, choose] {
        const QString reason = whyNoCommands(m_window.m_view);
        for (QAction *action : all) {
            action->setEnabled(reason.isEmpty());
            action->setToolTip(reason); // empty: its own text
            action->setStatusTip(reason);
        }
        choose->setEnabled(m_window.m_view.vehicle != nullptr);
    });
}

void MainMenus::fillSecurity(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuSecurity"));
    menu.setToolTipsVisible(true);
    menu.addSection(tr("Cipher suite"));
    for (QAction *action : m_window.m_suites->actions())
        menu.addAction(action);
    menu.addSeparator();
    menu.addAction(m_window.m_suites->changeKeysAction());
    QMenu *plain = menu.addMenu(tr("Allow &plain MAVLink"));
    plain->setObjectName(QStringLiteral("menuAllowPlain"));
    connect(plain, &QMenu::aboutToShow, &m_window, [this, plain] {
        plain->clear();
        if (!m_window.m_view.snapshot)
            return;
        for (const engine::PendingVehicle &held : m_window.m_view.snapshot->pendingApproval) {
            QAction *action = plain->addAction(tr("Vehicle %1 at %2 …").arg(held.systemId).arg(fromStd(held.remoteAddress)));
            connect(action, &QAction::triggered, &m_window,
                    [this, held] { askAllowPlain(m_window.m_station, held, &m_window); });
        }
    });
    connect(&menu, &QMenu::aboutToShow, &m_window, [this, plain] {
        const bool any = m_window.m_view.snapshot && !m_window.m_view.snapshot->pendingApproval.empty();
        plain->setEnabled(any);
        plain->menuAction()->setToolTip(any ? QString() : tr("No vehicle is held back"));
    });
    add(menu, tr("&Keys and peers …"), QStringLiteral("actionKeys"), Qt::CTRL | Qt::Key_K, [this] { m_window.openKeys(); });
}

void MainMenus::fillView(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuView"));
    int key = 0;
    for (QDockWidget *dock : m_window.m_docks->all()) {
        auto *action = new QAction(dock->windowTitle(), &m_window);
        action->setObjectName(QStringLiteral("view_") + dock->objectName());
        action->setCheckable(true);
        action->setChecked(!dock->isHidden());
        if (key < 9)
            action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + key++)));
        // A dock behind another tab comes to the front; only one that is in front goes away.
        connect(action, &QAction::triggered, &m_window, [this, dock] {
            const bool inFront = dock->isVisible() && !dock->visibleRegion().isEmpty();
            if (inFront)
                dock->hide();
            else
                m_window.m_docks->reveal(dock);
        });
        connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
        menu.addAction(action);
    }
    menu.addSeparator();
    add(menu, tr("&Follow the vehicle"), QStringLiteral("actionFollow"), Qt::CTRL | Qt::Key_Home,
        [this] { m_window.m_map->followVehicle(); });
    add(menu, tr("Zoom &in"), QStringLiteral("actionZoomIn"), QKeySequence::ZoomIn, [this] { m_window.m_map->zoomBy(1.5); });
    add(menu, tr("Zoom &out"), QStringLiteral("actionZoomOut"), QKeySequence::ZoomOut,
        [this] { m_window.m_map->zoomBy(1 / 1.5); });
    add(menu, tr("&Clear the track"), QStringLiteral("actionClearTrack"), {}, [this] { m_window.m_map->clearTrack(); });
    menu.addSeparator();
    add(menu, tr("&Reset the arrangement"), QStringLiteral("actionResetView"), {}, [this] { m_window.m_docks->reset(); });
    auto *full = add(menu, tr("F&ull screen"), QStringLiteral("actionFullScreen"), Qt::Key_F11,
                     [this] { m_window.setWindowState(m_window.windowState() ^ Qt::WindowFullScreen); });
    full->setCheckable(true);
}

void MainMenus::fillTools(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuTools"));
    add(menu, tr("Run a s&weep …"), QStringLiteral("actionSweep"), Qt::CTRL | Qt::Key_R, [this] { m_window.openSweep(); });
    if (m_window.m_facts.demoAvailable)
        add(menu, tr("Start the &demo"), QStringLiteral("actionDemo"), {}, [this] { Q_EMIT m_window.demoWanted(); });
}

void MainMenus::fillHelp(QMenu &menu)
{
    menu.setObjectName(QStringLiteral("menuHelp"));
    add(menu, tr("&First steps"), QStringLiteral("actionHelp"), QKeySequence::HelpContents,
        [this] { m_window.openHelp(QStringLiteral("start")); });
    add(menu, tr("&Sealing a link"), QStringLiteral("actionHelpSealing"), {},
        [this] { m_window.openHelp(QStringLiteral("sealing")); });
    add(menu, tr("&Diagnostics"), QStringLiteral("actionHelpDiagnostics"), {},
        [this] { m_window.openHelp(QStringLiteral("diagnostics")); });
    menu.addSeparator();
    add(menu, tr("&About Skyseal"), QStringLiteral("actionAbout"), {}, [this] {
        QMessageBox::about(
            &m_window, tr("About Skyseal"),
            tr("Skyseal %1\n\nA ground control station whose MAVLink link is sealed.\nGPL-3.0-or-later; built with Qt %2, "
               "Qt Charts, libsodium and OpenSSL.")
                .arg(m_window.m_facts.version, QLatin1String(qVersion())));
    });
}

} // namespace skyseal::ui
