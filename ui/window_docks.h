// The docks around the map and the panels in them: where each stands, in which order the keys reach them, what is shown in
// them, and how the arrangement is kept.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QByteArray>
#include <QtCore/QObject>

#include <vector>

class QDockWidget;
class QMainWindow;
class QSettings;

namespace skyseal::ui {

class DiagnosticsPanel;
class DockPanel;
class FlightPanel;
class InspectorPanel;
class LinksPanel;
class LogsPanel;
class MessagesPanel;
class MissionPanel;
class ParametersPanel;
class SecureLinkPanel;
class SuiteActions;
class VehicleCommands;

/// What the panels work with; all of it outlives the window.
struct PanelNeeds
{
    StationInterface &station;
    VehicleCommands &commands;
    SuiteActions &suites;
    QString recordFolder;
};

class WindowDocks : public QObject
{
    Q_OBJECT

public:
    WindowDocks(QMainWindow &window, const PanelNeeds &needs);

    FlightPanel *flight = nullptr;
    SecureLinkPanel *secure = nullptr;
    MessagesPanel *messages = nullptr;
    DiagnosticsPanel *diagnostics = nullptr;
    InspectorPanel *inspector = nullptr;
    ParametersPanel *parameters = nullptr;
    MissionPanel *mission = nullptr;
    LogsPanel *logs = nullptr;
    LinksPanel *links = nullptr;

    /// In the order of Ctrl+1 … n.
    const std::vector<QDockWidget *> &all() const { return m_docks; }
    /// What must follow every snapshot.
    void showMoving(const ViewState &view);
    /// The rest: numbers and lists, which nobody reads quicker than a few times a second.
    void showNumbers(const ViewState &view);
    /// Shows a dock, brings its tab to the front and puts the focus into it.
    void reveal(QDockWidget *dock);
    void reveal(const char *name);

    /// To be called once the window has its first size.
    void rememberDefault();
    /// Floating panels that were restored before their window was there: openbox and others leave them behind it.
    void raiseFloating();
    void restore(const QSettings &store);
    void reset();
    void save(QSettings &store) const;

private:
    QDockWidget *add(const QString &title, const char *name, QWidget *panel, Qt::DockWidgetArea area);
    void makeSides(const PanelNeeds &needs);
    void makeBottom(const PanelNeeds &needs);
    void watch(QDockWidget *dock, DockPanel *panel);

    QMainWindow &m_window;
    std::vector<QDockWidget *> m_docks;
    QByteArray m_default;
};

} // namespace skyseal::ui
