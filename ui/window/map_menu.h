// The menu of the map: commands for the place that was clicked, or without the menu for the one that is pointed at. Each is
// asked once, while the map marks the place; an entry that makes no sense now is disabled with its reason. Lives on the GUI
// thread.
#pragma once

#include "ui/window/menu_table.h"

#include <QtCore/QObject>
#include <QtCore/QPointer>

class QAction;
class QDialog;
class QMenu;
class QMessageBox;
class QPoint;
class QWidget;

namespace skyseal::vehicle {
struct VehicleState;
}

namespace skyseal::ui {

class MapView;
class VehicleCommands;
class ViewSelection;
class WindowDialogs;
struct LatLong;

class MapMenu : public QObject
{
    Q_OBJECT

public:
    /// All must outlive this; `window` becomes its parent and that of the questions.
    MapMenu(MapView &map, const ViewSelection &selection, VehicleCommands &commands, WindowDialogs &dialogs, QWidget &window);

    /// For the palette and for shortcuts: those that need a place, for the one under the pointer or in the middle of the map.
    QList<QAction *> placeActions() const;

private:
    void makePlaceActions();
    void open(const LatLong &place, const QPoint &at);
    MenuItems itemsFor(const LatLong &place);
    MenuItem goHere(const LatLong &place);
    MenuItem setHome(const LatLong &place);
    /// Marks `place` until the question is answered, with a word beside it that may be empty.
    void ask(const LatLong &place, QMessageBox *question, const QString &label = {});
    void markUntilClosed(const LatLong &place, QDialog *dialog, const QString &label = {});
    QString describe(const LatLong &place) const;
    const vehicle::VehicleState *vehicle() const;

    MapView &m_map;
    const ViewSelection &m_selection;
    VehicleCommands &m_commands;
    WindowDialogs &m_dialogs;
    QWidget &m_window;
    QMenu *m_placeActions;            ///< never opened
    QPointer<QMessageBox> m_question; ///< about the marked place
};

} // namespace skyseal::ui
