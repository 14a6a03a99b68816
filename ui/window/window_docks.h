// The docks around the map, made from the table of panels. Lives on the GUI thread.
#pragma once

#include "ui/view_state.h"
#include "ui/window/workspace_table.h"

#include <QtCore/QObject>
#include <QtCore/QPointer>

#include <optional>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;

namespace skyseal::ui {

class DockPanel;
class WindowActions;
struct PanelContext;
struct PanelRow;
struct Settings;

class WindowDocks : public QObject
{
    Q_OBJECT

public:
    /// Adds a dock for each row of panelTable() to `window`, arranged for the first workspace.
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
    /// Adds the actions that the panels publish, under their titles, and those of the dock that has the focus.
    void publish(WindowActions &actions) const;

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
    /// Remembers the heights of the docks that are seen, before a bar comes that some of them have to give way to; a second
    /// call keeps those of the first.
    void keepHeights();
    /// The bar has gone: those that gave way get their heights back, unless another workspace is shown now.
    void returnHeights();

    /// Arranges all docks as the tables say for this workspace.
    void arrange(Workspace workspace);

protected:
    /// Of the window: when it is shown first.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Dock
    {
        const PanelRow *row;
        QDockWidget *widget;
        DockPanel *panel;
        QAction *viewAction;
    };

    void add(const PanelRow &row, const PanelContext &context);
    QAction *makeViewAction(QDockWidget *dock);
    void makeFocusActions();
    void noteFocus(QWidget *now);
    void raiseFloating();
    void toFront(QDockWidget *dock);
    int tabsAbove(const QDockWidget *dock) const;

    /// A dock that is higher than the operator left it, or lower.
    struct GrownDock
    {
        QDockWidget *widget;
        int before, height; ///< pixels
    };

    QMainWindow &m_window;
    std::vector<Dock> m_docks;
    QPointer<QDockWidget> m_focused; ///< the dock that has the focus of the window
    QAction *m_close, *m_float;      ///< of that dock: what the buttons of its title bar do
    std::optional<GrownDock> m_grown;
    std::vector<GrownDock> m_kept; ///< `before` is the height to return to
};

} // namespace skyseal::ui
