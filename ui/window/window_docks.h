// The docks around the map, made from the table of panels, and their arrangement. Lives on the GUI thread.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QByteArray>
#include <QtCore/QObject>

#include <optional>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;
class QSettings;

namespace skyseal::ui {

class DockPanel;
struct PanelContext;
struct PanelRow;
struct Settings;

class WindowDocks : public QObject
{
    Q_OBJECT

public:
    /// Adds a dock for each row of panelTable() to `window`.
    WindowDocks(QMainWindow &window, const PanelContext &context);

    /// The panel of this class; null if the table has none.
    template<typename Panel> Panel *panel() const
    {
        for (const Dock &dock : m_docks)
            if (auto *found = qobject_cast<Panel *>(dock.panel))
                return found;
        return nullptr;
    }
    /// For the View menu, in the order of the table: each brings its dock to the front.
    std::vector<QAction *> viewActions() const;

    /// For each snapshot.
    void onSnapshot(const ViewState &view);
    /// A few times a second, see ViewSelection.
    void showViewState(const ViewState &view);
    void applySettings(const Settings &settings);

    /// Shows the dock of this object name, brings its tab to the front and gives it the focus.
    void reveal(const char *id);
    /// Makes the dock of this object name at least `height` pixels high, unless it floats, until shrinkBack().
    void growTo(const char *id, int height);
    /// Returns a dock to the height that it had before growTo(), unless the operator has made it even higher.
    void shrinkBack();

    /// Saves the arrangement that reset() returns to. To be called once the window has its first size.
    void rememberDefault();
    /// Raises floating panels above the window; some window managers place restored ones behind it.
    void raiseFloating();
    void restore(const QSettings &store);
    void reset();
    void save(QSettings &store) const;

private:
    struct Dock
    {
        QDockWidget *widget;
        DockPanel *panel;
        QAction *viewAction;
    };

    void add(const PanelRow &row, const PanelContext &context);
    QAction *makeViewAction(QDockWidget *dock);
    void setFirstSizes();
    QDockWidget *firstIn(Qt::DockWidgetArea area) const;
    void toFront(QDockWidget *dock);
    int tabsAbove(const QDockWidget *dock) const;

    /// A dock that is higher than the operator left it.
    struct GrownDock
    {
        QDockWidget *widget;
        int before, height; ///< pixels
    };

    QMainWindow &m_window;
    std::vector<Dock> m_docks;
    std::optional<GrownDock> m_grown;
    QByteArray m_default;
};

} // namespace skyseal::ui
