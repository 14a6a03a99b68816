#include "ui/window/workspaces.h"

#include "ui/window/window_docks.h"

#include <QtCore/QSettings>
#include <QtGui/QAction>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMainWindow>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kArrangementVersion = 2;
const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kCurrentKey = QStringLiteral("window/workspace");

QString arrangementKey(const WorkspaceRow &row)
{
    return QStringLiteral("window/workspaces/") + QLatin1String(row.id);
}

} // namespace

const std::array<WorkspaceRow, kWorkspaces> &workspaceTable()
{
    static constexpr std::array<WorkspaceRow, kWorkspaces> kRows{{
        {"fly", QT_TRANSLATE_NOOP("skyseal::ui::Workspaces", "Fly"), 280, 22, 30},
        {"plan", QT_TRANSLATE_NOOP("skyseal::ui::Workspaces", "Plan"), 280, 45, 30},
        {"vehicle", QT_TRANSLATE_NOOP("skyseal::ui::Workspaces", "Vehicle"), 280, 55, 30},
        {"lab", QT_TRANSLATE_NOOP("skyseal::ui::Workspaces", "Lab"), 280, 22, 48},
    }};
    return kRows;
}

Workspaces::Workspaces(QMainWindow &window, WindowDocks &docks) : QObject(&window), m_window(window), m_docks(docks)
{
    auto *group = new QActionGroup(this);
    for (std::size_t i = 0; i < kWorkspaces; ++i) {
        const WorkspaceRow &row = workspaceTable()[i];
        auto *action = new QAction(tr(row.title), group);
        action->setObjectName(QStringLiteral("workspace_") + QLatin1String(row.id));
        action->setCheckable(true);
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i))));
        connect(action, &QAction::triggered, this, [this, i] { show(static_cast<Workspace>(i)); });
        m_actions[i] = action;
    }
    m_actions[static_cast<std::size_t>(m_current)]->setChecked(true);
}

void Workspaces::show(Workspace workspace)
{
    m_actions[static_cast<std::size_t>(workspace)]->setChecked(true);
    if (workspace == m_current)
        return;
    m_docks.shrinkBack();
    arrangement() = m_window.saveState(kArrangementVersion);
    m_current = workspace;
    arrange();
}

void Workspaces::reset()
{
    arrangement().clear();
    arrange();
}

void Workspaces::arrange()
{
    if (!m_window.restoreState(arrangement(), kArrangementVersion))
        m_docks.arrange(m_current);
}

void Workspaces::restore(const QSettings &store)
{
    m_window.restoreGeometry(store.value(kGeometryKey).toByteArray());
    for (std::size_t i = 0; i < kWorkspaces; ++i)
        m_arrangements[i] = store.value(arrangementKey(workspaceTable()[i])).toByteArray();
    const QByteArray last = store.value(kCurrentKey).toByteArray();
    const auto found = std::ranges::find_if(workspaceTable(), [&last](const WorkspaceRow &row) { return last == row.id; });
    m_current = found == workspaceTable().end() ? Workspace::Fly : static_cast<Workspace>(found - workspaceTable().begin());
    m_actions[static_cast<std::size_t>(m_current)]->setChecked(true);
    arrange();
}

void Workspaces::save(QSettings &store)
{
    m_docks.shrinkBack();
    arrangement() = m_window.saveState(kArrangementVersion);
    store.setValue(kGeometryKey, m_window.saveGeometry());
    store.setValue(kCurrentKey, QLatin1String(workspaceTable()[static_cast<std::size_t>(m_current)].id));
    for (std::size_t i = 0; i < kWorkspaces; ++i)
        store.setValue(arrangementKey(workspaceTable()[i]), m_arrangements[i]);
}

} // namespace skyseal::ui

#include "moc_workspaces.cpp"
