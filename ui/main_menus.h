// The menus of the window: File, Link, Vehicle, Security, View, Tools, Help. All that a panel's button does can be done from
// here.
#pragma once

#include "core/vehicle/vehicle_command.h"

#include <QtCore/QObject>

class QAction;
class QKeySequence;
class QMenu;

namespace skyseal::ui {

class MainWindow;

/// Built once; its actions belong to the window.
class MainMenus : public QObject
{
    Q_OBJECT

public:
    explicit MainMenus(MainWindow &window);

private:
    void fillFile(QMenu &menu);
    void fillLink(QMenu &menu);
    void fillVehicle(QMenu &menu);
    void fillSecurity(QMenu &menu);
    void fillView(QMenu &menu);
    void fillTools(QMenu &menu);
    void fillHelp(QMenu &menu);
    QAction *add(QMenu &menu, const QString &text, const QString &name, const QKeySequence &keys, std::function<void()> act);
    /// Asks once, about the vehicle that is shown now; closing the box or Esc means no.
    void askAndSend(const QString &question, const vehicle::VehicleCommand &command);

    MainWindow &m_window;
};

} // namespace skyseal::ui
