// The parameters panel: fetch, filter and edit the vehicle's parameters.
#pragma once

#include "ui/parameters/parameter_model.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace skyseal::ui {

class ResultLabel;

class ParametersPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit ParametersPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    void handleEvent(const engine::Event &event);

private:
    void fetch();
    void writeOrAsk(const QString &name, double value);
    void askToWrite(const vehicle::Parameter &before, double value);
    void write(const QString &name, double value);
    void showName(int vehicle);
    void showCount();

    StationInterface &m_station;
    ParameterModel m_model;
    QSortFilterProxyModel *m_shown; ///< those that match what is typed
    int m_all = 0;                  ///< parameters that the vehicle has; 0 if it has not said
    QPushButton *m_fetch;
    QProgressBar *m_progress;
    QLabel *m_count;
    ResultLabel *m_result;
    double m_silence = 0; ///< seconds without a message of the vehicle; 0 while it is heard
    std::uint8_t m_systemId = 0;
    int m_name = 0; ///< see vehicleToName()
    bool m_isArmed = false;
    QString m_disabledReason; ///< reason why nothing can be sent to the vehicle
};

} // namespace skyseal::ui
