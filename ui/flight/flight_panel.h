// The left dock: horizon, values and the buttons that move the vehicle.
#pragma once

#include "ui/flight/vehicle_actions.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"
#include "ui/text/units.h"

namespace skyseal::ui {

class Horizon;
class ValuesPanel;

class FlightPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit FlightPanel(VehicleCommands &commands, QWidget *parent = nullptr);

    /// The horizon follows every snapshot, numbers and buttons are renewed less often.
    void onSnapshot(const ViewState &view) override;
    void showViewState(const ViewState &view) override;
    void applySettings(const Settings &settings) override;
    bool scrollsAsAWhole() const override { return true; }

private:
    Horizon *m_horizon;
    ValuesPanel *m_values;
    VehicleActions *m_actions;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
