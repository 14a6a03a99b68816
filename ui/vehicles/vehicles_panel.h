// The panel of all vehicles: their mode, battery, link, lock and alerts in a table that is sorted by a click on a column and
// filtered by typing. A click or Enter selects the vehicle for the whole window.
#pragma once

#include "ui/alerts/alert.h"
#include "ui/dock_panel.h"
#include "ui/refusal_meter.h"
#include "ui/vehicles/vehicle_list_model.h"
#include "ui/vehicles/vehicle_list_order.h"
#include "ui/view_state.h"

#include <QtCore/QElapsedTimer>

#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QTreeView;

namespace skyseal::ui {

class VehiclesPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit VehiclesPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    /// The alerts of the station, of all vehicles.
    void showAlerts(const std::vector<skyseal::ui::Alert> &alerts) { m_alerts = alerts; }

Q_SIGNALS:
    /// The operator has chosen this vehicle.
    void vehicleChosen(std::uint8_t systemId);
    void connectRequested();

protected:
    void exposedChanged(bool exposed) override;
    /// Of the list and of the field above it: letters go to the field, arrows and Enter to the list.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeEmptyPage();
    void refresh();
    void keepOrder();
    void showCount();
    void followSelection();
    void choose(const QModelIndex &at);
    void showRemove();
    void removeCurrent();
    std::uint8_t currentVehicle() const;
    double now() const; ///< seconds

    StationInterface &m_station;
    VehicleListModel m_model;
    VehicleListOrder m_order;
    QTreeView *m_list;
    QLineEdit *m_typed;
    QLabel *m_count, *m_empty;
    QPushButton *m_connect, *m_remove;
    QStackedWidget *m_pages;
    ViewState m_shown;
    std::vector<Alert> m_alerts;
    std::uint8_t m_selected = 0; ///< 0: none
    RefusalMeter m_refusals;
    QElapsedTimer m_clock;
};

} // namespace skyseal::ui
