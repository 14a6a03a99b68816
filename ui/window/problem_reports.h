// Problems that the operator has to act on, shown in the banner of the window with a button for the remedy. Lives on the GUI
// thread.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <functional>

class QWidget;

namespace skyseal::ui {

class ProblemBanner;

class ProblemReports : public QObject
{
    Q_OBJECT

public:
    /// `station` and `banner` must outlive this; `window` becomes the parent of dialogs.
    ProblemReports(StationInterface &station, ProblemBanner &banner, QWidget &window);

    /// Shows a problem; `remedy` is the text of the button that calls `act`, empty for no button.
    void report(const QString &problem, const QString &remedy = {}, std::function<void()> act = {});
    /// Reports events that need the operator: a port in use, a vehicle that may be an impostor.
    void handleEvent(const engine::Event &event, const ViewState &view);

Q_SIGNALS:
    /// The operator accepted another port.
    void linkRequested(const QString &url);

private:
    void reportPortInUse(const engine::LinkSnapshot &link);

    StationInterface &m_station;
    ProblemBanner &m_banner;
    QWidget &m_window;
};

} // namespace skyseal::ui
