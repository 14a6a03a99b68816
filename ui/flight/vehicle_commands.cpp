#include "ui/flight/vehicle_commands.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/flight_rules.h"
#include "core/vehicle/mission_edit.h"
#include "ui/text/action_permits.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyseal::ui {

VehicleCommands::VehicleCommands(StationInterface &station, QObject *parent) : QObject(parent), m_station(station)
{
    connect(&station, &StationInterface::eventOccurred, this, &VehicleCommands::handleEvent);
}

void VehicleCommands::showViewState(const ViewState &view)
{
    m_systemId = view.vehicle ? view.vehicle->state.systemId : 0;
    m_mission = view.vehicle ? view.vehicle->mission : nullptr;
    m_missionOutdated = view.vehicle ? reasonText(view.vehicle->missionOutdated) : QString();
    m_home.reset();
    if (view.vehicle && vehicle::keepsHomeFirst(view.vehicle->state.autopilot))
        m_home = vehicle::homeItem(view.vehicle->state.home);
    m_severalVehicles = view.vehicles().size() > 1;
    m_preflight.showViewState(view);
    m_disabledReason = commandsDisabledReason(view);
    m_view = view;
    Q_EMIT permitsChanged();
}

QString VehicleCommands::disabledReason(const vehicle::VehicleCommand &command) const
{
    return actionDisabledReason(command, m_view);
}

bool VehicleCommands::armsFirst(const vehicle::VehicleCommand &command) const
{
    return m_view.vehicle && vehicle::armsFirst(command, m_view.vehicle->state);
}

bool VehicleCommands::armingTakesOff() const
{
    return m_view.vehicle && vehicle::armingTakesOff(m_view.vehicle->state);
}

void VehicleCommands::send(std::uint8_t systemId, const vehicle::VehicleCommand &command)
{
    const QString text = commandText(command, m_units);
    if (maySend(systemId, text))
        request(systemId, command, text);
}

void VehicleCommands::addWaypoint(std::uint8_t systemId, double latitude, double longitude, float altitude)
{
    const QString text = tr("Add to the mission");
    if (!maySend(systemId, text))
        return;
    if (!m_mission) {
        Q_EMIT resultReported(tr("%1: not sent: %2").arg(text, tr("the mission is not known")), false);
        return;
    }
    if (!m_missionOutdated.isEmpty()) {
        Q_EMIT resultReported(
            tr("%1: not sent: %2").arg(text, tr("the mission is outdated (%1): read it again").arg(m_missionOutdated)), false);
        return;
    }
    request(systemId,
            vehicle::WriteMission{.items = vehicle::withWaypoint(*m_mission, latitude, longitude, altitude, m_home),
                                  .basis = m_mission},
            text);
}

bool VehicleCommands::maySend(std::uint8_t systemId, const QString &text)
{
    if (systemId == 0)
        return false;
    if (m_systemId != 0 && systemId != m_systemId) {
        Q_EMIT resultReported(tr("%1: not sent: vehicle %2 is no longer selected").arg(text).arg(systemId), false);
        return false;
    }
    if (!m_disabledReason.isEmpty()) {
        Q_EMIT resultReported(tr("%1: not sent: %2").arg(text, m_disabledReason), false);
        return false;
    }
    return true;
}

void VehicleCommands::request(std::uint8_t systemId, vehicle::Request request, const QString &text)
{
    const auto *asCommand = std::get_if<vehicle::VehicleCommand>(&request);
    const auto command = asCommand ? std::optional(*asCommand) : std::nullopt;
    const vehicle::RequestId id = m_station.perform(systemId, std::move(request));
    if (command)
        Q_EMIT commandSent(systemId, id, *command);
    m_asked.insert(static_cast<quint32>(id), text);
    Q_EMIT resultReported(tr("%1: requested…").arg(text), true);
}

void VehicleCommands::setTakeOffAltitude(double metres)
{
    metres = std::clamp(metres, kLowestTakeOff, kHighestTakeOff);
    if (metres == m_takeOffAltitude)
        return;
    m_takeOffAltitude = metres;
    Q_EMIT takeOffAltitudeChanged(metres);
}

void VehicleCommands::handleEvent(const engine::Event &event)
{
    if (const auto *result = std::get_if<vehicle::CommandResult>(&event)) {
        reportResult(result->id, engine::commandOutcomeText(*result), result->outcome == vehicle::CommandOutcome::Accepted);
        Q_EMIT commandEnded(result->id, result->outcome);
    } else if (const auto *mission = std::get_if<vehicle::MissionResult>(&event)) {
        reportResult(mission->id, engine::eventText(event, {}).sentence, mission->ok);
    }
}

void VehicleCommands::reportResult(vehicle::RequestId id, const QString &outcome, bool ok)
{
    const auto asked = m_asked.constFind(static_cast<quint32>(id));
    if (asked == m_asked.constEnd())
        return;
    QString shown = outcome;
    shown.replace(QStringLiteral(": %1: ").arg(asked.value()), QStringLiteral(": ")); // autopilots begin with "Arm: " as well
    const QString line = tr("%1: %2").arg(asked.value(), shown);
    m_asked.erase(asked);
    Q_EMIT resultReported(line, ok);
}

} // namespace skyseal::ui

#include "moc_vehicle_commands.cpp"
