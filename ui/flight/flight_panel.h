// The left dock: horizon and chosen values.
#pragma once

#include "ui/dock_panel.h"
#include "ui/view_state.h"
#include "ui/text/units.h"

namespace skyseal::ui {

class Horizon;
class ValuesGrid;

class FlightPanel : public DockPanel
{
    Q_OBJECT

public:
    /// `station` is told which fields of messages the values need.
    explicit FlightPanel(StationInterface &station, QWidget *parent = nullptr);

    /// The horizon follows every snapshot, numbers are renewed less often.
    void onSnapshot(const ViewState &view) override;
    void showViewState(const ViewState &view) override;
    void applySettings(const Settings &settings) override;
    bool scrollsAsAWhole() const override { return true; }

Q_SIGNALS:
    /// The operator wants to choose the values.
    void editValuesRequested();

private:
    StationInterface &m_station;
    Horizon *m_horizon;
    ValuesGrid *m_values;
    std::vector<engine::FieldChoice> m_fields; ///< that the station reads
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
