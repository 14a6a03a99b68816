#include "ui/flight/flight_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/flight/horizon.h"
#include "ui/settings.h"
#include "ui/values/values_grid.h"

#include <QtGui/QAction>
#include <QtWidgets/QVBoxLayout>

#include <numbers>

namespace skyseal::ui {

namespace {

double degrees(double radians)
{
    return radians * 180 / std::numbers::pi;
}

} // namespace

FlightPanel::FlightPanel(StationInterface &station, QWidget *parent)
    : DockPanel(parent), m_station(station), m_horizon(new Horizon(this)), m_values(new ValuesGrid(this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_horizon, 3);
    column->addWidget(m_values, 2);
    connect(m_values, &ValuesGrid::editRequested, this, &FlightPanel::editValuesRequested);
    addAction(m_values->editAction());
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

void FlightPanel::onSnapshot(const ViewState &view)
{
    HorizonValues values;
    if (view.vehicle) {
        const auto &state = view.vehicle->state;
        values.roll = degrees(state.roll);
        values.pitch = degrees(state.pitch);
        values.heading = state.heading;
        values.speed = state.groundSpeed * speedScale(m_units).factor;
        values.altitude = state.altitudeRelative * altitudeScale(m_units).factor;
        values.climb = state.climb;
        values.stale = view.stale();
    }
    m_horizon->showValues(values);
    m_values->onSnapshot(view);
}

void FlightPanel::showViewState(const ViewState &view)
{
    m_values->showViewState(view);
}

void FlightPanel::applySettings(const Settings &settings)
{
    m_units = settings.units;
    m_horizon->setUnits(m_units);
    m_values->setUnits(m_units);
    m_values->setValues(settings.values);
    std::vector<engine::FieldChoice> fields;
    for (const ValueChoice &choice : settings.values.list) {
        if (const auto field = choice.source.fieldChoice())
            fields.push_back(*field);
    }
    if (fields != m_fields) {
        m_fields = fields;
        m_station.chooseFields(std::move(fields));
    }
}

} // namespace skyseal::ui

#include "moc_flight_panel.cpp"
