#include "ui/window_docks.h"

#include "ui/charts/diagnostics_panel.h"
#include "ui/fitting_scroll.h"
#include "ui/flight/flight_panel.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/links/links_panel.h"
#include "ui/logs/logs_panel.h"
#include "ui/messages/messages_panel.h"
#include "ui/mission/mission_panel.h"
#include "ui/parameters/parameters_panel.h"
#include "ui/security/secure_link_panel.h"

#include <QtCore/QSettings>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMainWindow>

namespace skyseal::ui {

namespace {
constexpr int kArrangementVersion = 1;
}

WindowDocks::WindowDocks(QMainWindow &window, const PanelNeeds &needs) : QObject(&window), m_window(window)
{
    makeSides(needs);
    makeBottom(needs);
}

QDockWidget *WindowDocks::add(const QString &title, const char *name, QWidget *panel, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(title, &m_window);
    dock->setObjectName(QLatin1String(name));
    dock->setAccessibleName(title);
    dock->setWidget(panel);
    m_window.addDockWidget(area, dock);
    m_docks.push_back(dock);
    return dock;
}

void WindowDocks::makeSides(const PanelNeeds &needs)
{
    flight = new FlightPanel(needs.commands, &m_window);
    secure = new SecureLinkPanel(needs.suites, &m_window);
    auto *left = new FittingScroll(flight);
    auto *right = new FittingScroll(secure);
    connect(right, &FittingScroll::heightChanged, secure, &SecureLinkPanel::fitHeight);
    QDockWidget *flightDock = add(tr("Flight"), "dockFlight", left, Qt::LeftDockWidgetArea);
    QDockWidget *secureDock = add(tr("Secure link"), "dockSecure", right, Qt::RightDockWidgetArea);
    m_window.resizeDocks({flightDock, secureDock}, {280, 272}, Qt::Horizontal);
}

void WindowDocks::makeBottom(const PanelNeeds &needs)
{
    QWidget *parent = &m_window;
    const auto below = [this](const QString &title, const char *name, QWidget *panel) {
        return add(title, name, panel, Qt::BottomDockWidgetArea);
    };
    diagnostics = new DiagnosticsPanel(parent);
    messages = new MessagesPanel(parent);
    inspector = new InspectorPanel(needs.station, parent);
    parameters = new ParametersPanel(needs.station, parent);
    mission = new MissionPanel(needs.station, parent);
    logs = new LogsPanel(needs.station, needs.recordFolder, parent);
    links = new LinksPanel(needs.station, parent);

    QDockWidget *first = below(tr("Diagnostics"), "dockDiagnostics", diagnostics);
    QDockWidget *messagesDock = below(tr("Messages"), "dockMessages", messages);
    QDockWidget *inspectorDock = below(tr("Inspector"), "dockInspector", inspector);
    for (QDockWidget *dock : {messagesDock, inspectorDock, below(tr("Parameters"), "dockParameters", parameters),
                              below(tr("Mission"), "dockMission", mission), below(tr("Logs"), "dockLogs", logs),
                              below(tr("Links"), "dockLinks", links)})
        m_window.tabifyDockWidget(first, dock);
    first->raise();
    inspector->setInFront(false);
    watch(first, diagnostics);
    watch(inspectorDock, inspector);
    m_window.resizeDocks({first}, {216}, Qt::Vertical);
}

void WindowDocks::watch(QDockWidget *dock, DockPanel *panel)
{
    connect(dock, &QDockWidget::visibilityChanged, panel, &DockPanel::setInFront);
}

void WindowDocks::showMoving(const ViewState &view)
{
    flight->showAttitude(view);
    diagnostics->showViewState(view);
}

void WindowDocks::showNumbers(const ViewState &view)
{
    flight->showViewState(view);
    secure->showViewState(view);
    inspector->showViewState(view);
    parameters->showViewState(view);
    mission->showViewState(view);
    logs->showViewState(view);
    links->showViewState(view);
}

void WindowDocks::reveal(QDockWidget *dock)
{
    if (!dock)
        return;
    dock->show();
    dock->raise();
    if (QWidget *inside = dock->widget())
        inside->setFocus(Qt::ShortcutFocusReason);
}

void WindowDocks::reveal(const char *name)
{
    reveal(m_window.findChild<QDockWidget *>(QLatin1String(name)));
}

void WindowDocks::rememberDefault()
{
    m_default = m_window.saveState(kArrangementVersion);
}

void WindowDocks::restore(const QSettings &store)
{
    m_window.restoreGeometry(store.value(QStringLiteral("window/geometry")).toByteArray());
    m_window.restoreState(store.value(QStringLiteral("window/docks")).toByteArray(), kArrangementVersion);
}

void WindowDocks::raiseFloating()
{
    for (QDockWidget *dock : m_docks) {
        if (!dock->isFloating() || dock->isHidden())
            continue;
        dock->hide(); // shown anew, it knows the window that it belongs to
        dock->show();
        dock->raise();
    }
}

void WindowDocks::reset()
{
    m_window.restoreState(m_default, kArrangementVersion);
}

void WindowDocks::save(QSettings &store) const
{
    store.setValue(QStringLiteral("window/geometry"), m_window.saveGeometry());
    store.setValue(QStringLiteral("window/docks"), m_window.saveState(kArrangementVersion));
}

} // namespace skyseal::ui
