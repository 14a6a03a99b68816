#include "ui/window/flight_target.h"

#include "core/engine/station/snapshot.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/geodesy.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/map/map_view.h"
#include "ui/text/vehicle_text.h"
#include "ui/window/view_selection.h"

namespace skyseal::ui {

namespace {

/// Metres from the target at which a vehicle is there: a little more than autopilots allow themselves. A plane circles it.
double reachOf(const vehicle::VehicleState &state)
{
    constexpr double kHovers = 3, kCircles = 120;
    return vehicle::VehicleKind{state.type, state.autopilot}.isPlane() ? kCircles : kHovers;
}

} // namespace

QString modeOfTargets(const vehicle::VehicleState &state)
{
    const vehicle::VehicleKind kind{state.type, state.autopilot};
    return kind.isArduPilot() ? QStringLiteral("GUIDED") : kind.isPx4() ? QStringLiteral("LOITER") : QString();
}

FlightTarget::FlightTarget(MapView &map, const ViewSelection &selection, VehicleCommands &commands)
    : QObject(&map), m_map(map), m_selection(selection)
{
    connect(&commands, &VehicleCommands::commandSent, this, &FlightTarget::handleSent);
    connect(&commands, &VehicleCommands::commandEnded, this, [this](vehicle::RequestId id, vehicle::CommandOutcome outcome) {
        if (m_target && m_target->id == id && outcome != vehicle::CommandOutcome::Accepted)
            m_target.reset();
        show(m_selection.view());
    });
    connect(&selection, &ViewSelection::viewChanged, this, [this](const ViewState &view) {
        if (!view.isReplay())
            follow(view);
        show(view);
    });
    connect(&selection, &ViewSelection::liveChanged, this, &FlightTarget::follow);
}

void FlightTarget::handleSent(std::uint8_t systemId, vehicle::RequestId id, const vehicle::VehicleCommand &command)
{
    if (const auto *place = std::get_if<vehicle::GoTo>(&command))
        m_target = Target{systemId, id, *place};
    else if (m_target && m_target->systemId == systemId && vehicle::changesMode(command))
        m_target.reset();
    show(m_selection.view());
}

/// Also while another vehicle is selected.
void FlightTarget::follow(const ViewState &live)
{
    if (!m_target || !live.snapshot)
        return;
    for (const engine::VehicleSnapshot &vehicle : live.snapshot->vehicles) {
        if (vehicle.state.systemId == m_target->systemId && isOver(vehicle.state))
            return m_target.reset();
    }
}

bool FlightTarget::isOver(const vehicle::VehicleState &state)
{
    if (!state.armed)
        return true;
    const QString mode = modeOfTargets(state);
    const bool inMode = mode.isEmpty() || fromStd(state.mode) == mode;
    if (m_target->entered && !inMode)
        return true;
    m_target->entered = inMode;
    const vehicle::Position place{m_target->place.latitude, m_target->place.longitude, 0};
    return inMode && vehicle::distanceMetres(state.position, place) <= reachOf(state); // false while the position is unknown
}

void FlightTarget::show(const ViewState &view)
{
    if (!m_target || view.isReplay() || !view.vehicle || view.vehicle->state.systemId != m_target->systemId)
        return m_map.setTarget(std::nullopt);
    m_map.setTarget(LatLong{m_target->place.latitude, m_target->place.longitude},
                    view.snapshot->vehicles.size() > 1 ? tr("Target of vehicle %1").arg(m_target->systemId) : tr("Target"));
}

} // namespace skyseal::ui

#include "moc_flight_target.cpp"
