// The workspaces of the window: which one is shown, the actions that show another, and the arrangement of the docks in each,
// as the operator left it. Lives on the GUI thread.
#pragma once

#include "ui/window/workspace_table.h"

#include <QtCore/QByteArray>
#include <QtCore/QObject>

#include <array>

class QAction;
class QMainWindow;
class QSettings;

namespace skyseal::ui {

class WindowDocks;

class Workspaces : public QObject
{
    Q_OBJECT

public:
    /// `docks` must outlive it.
    Workspaces(QMainWindow &window, WindowDocks &docks);

    /// One checkable action for each workspace, in the order of the table.
    const std::array<QAction *, kWorkspaces> &actions() const { return m_actions; }
    Workspace current() const { return m_current; }
    void show(Workspace workspace);
    /// Arranges the docks of the current workspace as at the first start.
    void reset();

    /// The window's geometry, the last workspace and all arrangements. To be called once all tool bars are there, since a saved
    /// arrangement holds them as well.
    void restore(const QSettings &store);
    void save(QSettings &store);

private:
    QByteArray &arrangement() { return m_arrangements[static_cast<std::size_t>(m_current)]; }
    void arrange();

    QMainWindow &m_window;
    WindowDocks &m_docks;
    std::array<QAction *, kWorkspaces> m_actions{};
    std::array<QByteArray, kWorkspaces> m_arrangements; ///< empty: as at the first start
    Workspace m_current = Workspace::Fly;
};

} // namespace skyseal::ui
