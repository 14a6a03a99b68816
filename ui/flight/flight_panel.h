// The left dock: horizon, values and the buttons that move the vehicle.
#pragma once

#include "ui/flight/vehicle_actions.h"
#include "ui/view_state.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class Horizon;
class ValuesPanel;

class FlightPanel : public QWidget
{
    Q_OBJECT

public:
    explicit FlightPanel(VehicleCommands &commands, QWidget *parent = nullptr);

    /// The horizon: as often as there is something new.
    void showAttitude(const ViewState &view);
    /// Numbers and buttons.
    void showViewState(const ViewState &view);
    void setUnits(UnitSystem units);

private:
    Horizon *m_horizon;
    ValuesPanel *m_values;
    VehicleActions *m_actions;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
