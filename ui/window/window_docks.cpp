#include "ui/window/window_docks.h"

#include "ui/dock_panel.h"
#include "ui/fitting_scroll.h"
#include "ui/window/panel_table.h"

#include <QtCore/QSettings>
#include <QtGui/QAction>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QTabBar>

#include <cstdlib>

namespace skyseal::ui {

namespace {
constexpr int kArrangementVersion = 1;
constexpr int kLeftWidth = 280, kRightWidth = 272, kBottomHeight = 216; ///< pixels, before the operator resizes them
constexpr std::size_t kKeys = 9;                                        ///< Ctrl+1 … Ctrl+9
} // namespace

WindowDocks::WindowDocks(QMainWindow &window, const PanelContext &context) : QObject(&window), m_window(window)
{
    for (const PanelRow &row : panelTable())
        add(row, context);
    setFirstSizes();
}

void WindowDocks::add(const PanelRow &row, const PanelContext &context)
{
    auto *dock = new QDockWidget(tr(row.title), &m_window);
    dock->setObjectName(QLatin1String(row.id));
    dock->setAccessibleName(dock->windowTitle());
    DockPanel *panel = row.make(context, &m_window);
    QDockWidget *first = firstIn(row.area);
    if (row.area == Qt::BottomDockWidgetArea) {
        dock->setWidget(panel);
    } else {
        auto *scroll = new FittingScroll(panel);
        connect(scroll, &FittingScroll::heightChanged, panel, &DockPanel::fitHeight);
        dock->setWidget(scroll);
    }
    m_window.addDockWidget(row.area, dock);
    if (first) {
        m_window.tabifyDockWidget(first, dock);
        panel->setInFront(false);
    }
    connect(dock, &QDockWidget::visibilityChanged, panel, &DockPanel::setInFront);
    m_docks.push_back({dock, panel, makeViewAction(dock)});
}

QAction *WindowDocks::makeViewAction(QDockWidget *dock)
{
    auto *action = new QAction(dock->windowTitle(), &m_window);
    action->setObjectName(QStringLiteral("view_") + dock->objectName());
    action->setCheckable(true);
    action->setChecked(!dock->isHidden());
    if (m_docks.size() < kKeys)
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(m_docks.size()))));
    connect(action, &QAction::triggered, this, [this, dock, action] {
        action->setChecked(true); // whatever was in front: a key never hides what the operator wants to see
        toFront(dock);
    });
    connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
    return action;
}

QDockWidget *WindowDocks::firstIn(Qt::DockWidgetArea area) const
{
    for (const Dock &dock : m_docks)
        if (m_window.dockWidgetArea(dock.widget) == area)
            return dock.widget;
    return nullptr;
}

void WindowDocks::setFirstSizes()
{
    QDockWidget *left = firstIn(Qt::LeftDockWidgetArea);
    QDockWidget *right = firstIn(Qt::RightDockWidgetArea);
    QDockWidget *bottom = firstIn(Qt::BottomDockWidgetArea);
    bottom->raise();
    m_window.resizeDocks({left, right}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
    m_window.resizeDocks({bottom}, {kBottomHeight}, Qt::Vertical);
}

std::vector<QAction *> WindowDocks::viewActions() const
{
    std::vector<QAction *> actions;
    for (const Dock &dock : m_docks)
        actions.push_back(dock.viewAction);
    return actions;
}

void WindowDocks::onSnapshot(const ViewState &view)
{
    for (const Dock &dock : m_docks)
        dock.panel->onSnapshot(view);
}

void WindowDocks::showViewState(const ViewState &view)
{
    for (const Dock &dock : m_docks)
        dock.panel->showViewState(view);
}

void WindowDocks::applySettings(const Settings &settings)
{
    for (const Dock &dock : m_docks)
        dock.panel->applySettings(settings);
}

void WindowDocks::toFront(QDockWidget *dock)
{
    dock->show();
    dock->raise();
    if (QWidget *inside = dock->widget())
        inside->setFocus(Qt::ShortcutFocusReason);
}

void WindowDocks::reveal(const char *id)
{
    if (auto *dock = m_window.findChild<QDockWidget *>(QLatin1String(id)))
        toFront(dock);
}

void WindowDocks::growTo(const char *id, int height)
{
    auto *dock = m_window.findChild<QDockWidget *>(QLatin1String(id));
    if (!dock || dock->isFloating() || dock->height() >= height)
        return;
    if (!m_grown)
        m_grown = {dock, tabsAbove(dock) + dock->height(), height};
    m_window.resizeDocks({dock}, {height}, Qt::Vertical);
}

/// The height of the tabs above a dock, which QMainWindow::resizeDocks() counts as a part of it.
int WindowDocks::tabsAbove(const QDockWidget *dock) const
{
    for (const QTabBar *tabs : m_window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
        const bool meets = tabs->isVisible() && tabs->geometry().left() <= dock->geometry().right()
            && tabs->geometry().right() >= dock->geometry().left()
            && std::abs(dock->geometry().top() - tabs->geometry().bottom()) <= 2;
        if (meets)
            return dock->geometry().top() - tabs->geometry().top();
    }
    return 0;
}

void WindowDocks::shrinkBack()
{
    if (m_grown && !m_grown->widget->isFloating() && m_grown->widget->height() <= m_grown->height)
        m_window.resizeDocks({m_grown->widget}, {m_grown->before}, Qt::Vertical);
    m_grown.reset();
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
    for (const Dock &dock : m_docks) {
        if (!dock.widget->isFloating() || dock.widget->isHidden())
            continue;
        dock.widget->hide(); // showing it again makes it transient for the window
        dock.widget->show();
        dock.widget->raise();
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
