// The left dock: horizon and values.
#pragma once

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
    explicit FlightPanel(QWidget *parent = nullptr);

    /// The horizon follows every snapshot, numbers are renewed less often.
    void onSnapshot(const ViewState &view) override;
    void showViewState(const ViewState &view) override;
    void applySettings(const Settings &settings) override;
    bool scrollsAsAWhole() const override { return true; }

private:
    Horizon *m_horizon;
    ValuesPanel *m_values;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
