#include "ui/flight/flight_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/flight/horizon.h"
#include "ui/flight/values_panel.h"
#include "ui/settings.h"

#include <QtWidgets/QVBoxLayout>

#include <numbers>

namespace skyseal::ui {

namespace {

constexpr double kFeetPerMetre = 3.280839895;
constexpr double kMilesPerHourPerMetreASecond = 2.236936292;

double degrees(double radians)
{
    return radians * 180 / std::numbers::pi;
}

} // namespace

FlightPanel::FlightPanel(QWidget *parent) : DockPanel(parent), m_horizon(new Horizon(this)), m_values(new ValuesPanel(this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_horizon, 1);
    column->addWidget(m_values);
}

void FlightPanel::onSnapshot(const ViewState &view)
{
    HorizonValues values;
    if (view.vehicle) {
        const auto &state = view.vehicle->state;
        const bool metric = m_units == UnitSystem::Metric;
        values.roll = degrees(state.roll);
        values.pitch = degrees(state.pitch);
        values.heading = state.heading;
        values.speed = state.groundSpeed * (metric ? 1 : kMilesPerHourPerMetreASecond);
        values.altitude = state.altitudeRelative * (metric ? 1 : kFeetPerMetre);
        values.climb = state.climb;
        values.stale = view.stale();
    }
    m_horizon->showValues(values);
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
}

} // namespace skyseal::ui
