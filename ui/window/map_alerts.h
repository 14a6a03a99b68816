// The alerts over the map: what the station reports goes into the list, and what the list has becomes lines and speech. Lives
// on the GUI thread.
#pragma once

#include "ui/alerts/alert_list.h"
#include "ui/alerts/speech.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QTimer>

class QAction;

namespace skyseal::ui {

class AlertStack;
class MapView;
class ViewSelection;
class WindowDialogs;
struct Settings;

class MapAlerts : public QObject
{
    Q_OBJECT

public:
    /// Lies over `map` and becomes a child of its parent. All must outlive this.
    MapAlerts(StationInterface &station, ViewSelection &selection, WindowDialogs &dialogs, MapView &map,
              const Settings &settings);

    /// Moves the focus to the first alert; for a menu. Enabled while there is one.
    QAction *goToAction() const { return m_goTo; }
    /// For the palette and for shortcuts.
    QList<QAction *> actions() const;

Q_SIGNALS:
    /// All alerts that are shown now, of all vehicles.
    void alertsShown(const std::vector<skyseal::ui::Alert> &alerts);

private:
    void showView(const ViewState &live);
    void refresh();
    double now() const; ///< seconds

    AlertList m_list;
    AlertStack *m_stack;
    QAction *m_goTo;
    Speech m_speech;
    QElapsedTimer m_clock;
    QTimer m_tick; ///< while a momentary alert is shown
};

} // namespace skyseal::ui
