#include "ui/window/window_docks.h"

#include "ui/dock_panel.h"
#include "ui/fitting_scroll.h"
#include "ui/window/panel_dock.h"
#include "ui/window/panel_table.h"
#include "ui/window/window_actions.h"
#include "ui/yielding_scroll.h"

#include <QtCore/QEvent>
#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QTabBar>

#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace skyseal::ui {

namespace {
/// With Alt: the keys of a keyboard's first row, from left to right.
constexpr std::array kKeys{Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5,    Qt::Key_6,
                           Qt::Key_7, Qt::Key_8, Qt::Key_9, Qt::Key_0, Qt::Key_Minus};
} // namespace

WindowDocks::WindowDocks(QMainWindow &window, const PanelContext &context)
    : QObject(&window), m_window(window), m_close(new QAction(tr("Close the panel that has the focus"), this)),
      m_float(new QAction(tr("Float or dock the panel that has the focus"), this))
{
    makeFocusActions();
    for (const PanelRow &row : panelTable())
        add(row, context);
    arrange(Workspace::Fly);
    window.installEventFilter(this);
}

void WindowDocks::add(const PanelRow &row, const PanelContext &context)
{
    auto *dock = new PanelDock(tr(row.title), &m_window);
    dock->setObjectName(QLatin1String(row.id));
    dock->setAccessibleName(dock->windowTitle());
    DockPanel *panel = row.make(context, &m_window);
    if (!panel->scrollsAsAWhole()) {
        auto *scroll = new YieldingScroll(panel);
        scroll->setAccessibleName(dock->windowTitle());
        dock->setWidget(scroll);
    } else {
        auto *scroll = new FittingScroll(panel);
        scroll->setAccessibleName(dock->windowTitle());
        connect(scroll, &FittingScroll::heightChanged, panel, &DockPanel::fitHeight);
        dock->setWidget(scroll);
    }
    connect(dock, &QDockWidget::visibilityChanged, panel, &DockPanel::setInFront);
    m_docks.push_back({&row, dock, panel, makeViewAction(dock)});
}

void WindowDocks::arrange(Workspace workspace)
{
    const auto isPlaced = [workspace](const Dock &dock) {
        return dock.row->places[static_cast<std::size_t>(workspace)] != Qt::NoDockWidgetArea;
    };
    for (const Dock &dock : m_docks) {
        dock.widget->setFloating(false);
        m_window.removeDockWidget(dock.widget);
    }
    std::map<Qt::DockWidgetArea, QDockWidget *> fronts;
    for (const bool placed : {true, false}) { // a dock that is hidden comes behind the tabs that are there
        for (const Dock &dock : m_docks) {
            if (isPlaced(dock) != placed)
                continue;
            const Qt::DockWidgetArea area = areaIn(*dock.row, workspace);
            m_window.addDockWidget(area, dock.widget);
            if (const auto [front, isFirst] = fronts.try_emplace(area, dock.widget); !isFirst)
                m_window.tabifyDockWidget(front->second, dock.widget);
            dock.widget->setVisible(placed);
        }
    }
    const WorkspaceRow &sizes = workspaceTable()[static_cast<std::size_t>(workspace)];
    const auto resize = [&](Qt::DockWidgetArea area, int size, Qt::Orientation orientation) {
        const auto front = fronts.find(area);
        if (front == fronts.end() || front->second->isHidden())
            return;
        front->second->raise();
        m_window.resizeDocks({front->second}, {size}, orientation);
    };
    resize(Qt::LeftDockWidgetArea, sizes.leftWidth, Qt::Horizontal);
    resize(Qt::RightDockWidgetArea, m_window.width() * sizes.rightPercent / 100, Qt::Horizontal);
    resize(Qt::BottomDockWidgetArea, m_window.height() * sizes.bottomPercent / 100, Qt::Vertical);
}

QAction *WindowDocks::makeViewAction(QDockWidget *dock)
{
    auto *action = new QAction(dock->windowTitle(), &m_window);
    action->setObjectName(QStringLiteral("view_") + dock->objectName());
    action->setCheckable(true);
    action->setChecked(!dock->isHidden());
    if (m_docks.size() < kKeys.size())
        action->setShortcut(QKeySequence(Qt::ALT | kKeys[m_docks.size()]));
    connect(action, &QAction::triggered, this, [this, dock, action] {
        action->setChecked(true); // whatever was in front: a key never hides what the operator wants to see
        toFront(dock);
    });
    connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
    return action;
}

std::vector<QAction *> WindowDocks::viewActions() const
{
    std::vector<QAction *> actions;
    for (const Dock &dock : m_docks)
        actions.push_back(dock.viewAction);
    return actions;
}

void WindowDocks::publish(WindowActions &actions) const
{
    for (const Dock &dock : m_docks)
        actions.add(dock.widget->windowTitle(), dock.panel->actions());
    actions.add(tr("Panels"), {m_close, m_float});
}

void WindowDocks::makeFocusActions()
{
    m_close->setObjectName(QStringLiteral("panelClose"));
    m_close->setShortcut(Qt::CTRL | Qt::Key_W);
    m_float->setObjectName(QStringLiteral("panelFloat"));
    m_float->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_W);
    connect(m_close, &QAction::triggered, this, [this] {
        if (m_focused)
            m_focused->close();
    });
    connect(m_float, &QAction::triggered, this, [this] {
        if (m_focused)
            m_focused->setFloating(!m_focused->isFloating());
    });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) { noteFocus(now); });
    noteFocus(nullptr);
}

/// A dialog, such as the palette, takes the focus without changing which panel has that of the window.
void WindowDocks::noteFocus(QWidget *now)
{
    QWidget *at = now;
    while (at && at != &m_window && !qobject_cast<QDockWidget *>(at) && !at->isWindow())
        at = at->parentWidget();
    auto *dock = qobject_cast<QDockWidget *>(at);
    if (dock || at == &m_window)
        m_focused = dock;
    for (QAction *action : {m_close, m_float}) {
        action->setAutoRepeat(false);
        action->setEnabled(m_focused);
        action->setStatusTip(m_focused ? QString() : tr("No panel has the focus"));
    }
}

void WindowDocks::onSnapshot(const ViewState &view)
{
    for (const Dock &dock : m_docks)
        dock.panel->onSnapshot(view);
}

void WindowDocks::showViewState(const ViewState &view)
{
    for (const Dock &dock : m_docks) {
        dock.panel->showViewState(view);
        dock.viewAction->setChecked(!dock.widget->isHidden()); // Qt says nothing of a dock that is hidden before it was shown
    }
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

void WindowDocks::keepHeights()
{
    if (!m_kept.empty())
        return;
    for (const Dock &dock : m_docks)
        if (dock.panel->isExposed() && !dock.widget->isFloating())
            m_kept.push_back({dock.widget, tabsAbove(dock.widget) + dock.widget->height(), dock.widget->height()});
}

void WindowDocks::returnHeights()
{
    // Once the bar's room is free.
    QTimer::singleShot(0, this, [this] {
        QList<QDockWidget *> docks;
        QList<int> heights;
        for (const GrownDock &kept : std::exchange(m_kept, {})) {
            if (!kept.widget->isVisible() || kept.widget->isFloating() || kept.widget->height() >= kept.height)
                continue;
            docks << kept.widget;
            heights << kept.before;
        }
        m_window.resizeDocks(docks, heights, Qt::Vertical);
    });
}

bool WindowDocks::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window && event->type() == QEvent::Show) {
        m_window.removeEventFilter(this);
        QTimer::singleShot(0, this, &WindowDocks::raiseFloating);
    }
    return QObject::eventFilter(watched, event);
}

/// Raises floating panels above the window; some window managers place restored ones behind it.
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

} // namespace skyseal::ui

#include "moc_window_docks.cpp"
