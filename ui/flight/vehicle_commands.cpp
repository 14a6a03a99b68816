#include "ui/flight/vehicle_commands.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/event_text.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_text.h"

#include <algorithm>

namespace skyseal::ui {

VehicleCommands::VehicleCommands(StationInterface &station, QObject *parent) : QObject(parent), m_station(station)
{
    connect(&station, &StationInterface::eventOccurred, this, &VehicleCommands::handleEvent);
}

void VehicleCommands::showViewState(const ViewState &view)
{
    m_systemId = view.vehicle ? view.vehicle->state.systemId : 0;
    m_severalVehicles = view.snapshot && view.snapshot->vehicles.size() > 1;
    m_preflight.showViewState(view);
    const QString reason = commandsDisabledReason(view);
    if (reason == m_disabledReason)
        return;
    m_disabledReason = reason;
    Q_EMIT disabledReasonChanged(reason);
}

void VehicleCommands::send(std::uint8_t systemId, const vehicle::VehicleCommand &command)
{
    if (systemId == 0)
        return;
    const QString text = commandText(command);
    if (m_systemId != 0 && systemId != m_systemId) {
        Q_EMIT resultReported(tr("%1: not sent: vehicle %2 is no longer selected").arg(text).arg(systemId), false);
        return;
    }
    if (!m_disabledReason.isEmpty()) {
        Q_EMIT resultReported(tr("%1: not sent: %2").arg(text, m_disabledReason), false);
        return;
    }
    const vehicle::RequestId id = m_station.perform(systemId, command);
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
    const auto *result = std::get_if<vehicle::CommandResult>(&event);
    if (!result)
        return;
    const auto asked = m_asked.constFind(static_cast<quint32>(result->id));
    if (asked == m_asked.constEnd())
        return;
    QString outcome = engine::commandOutcomeText(*result);
    outcome.replace(QStringLiteral(": %1: ").arg(asked.value()), QStringLiteral(": ")); // autopilots begin with "Arm: " as well
    const QString line = tr("%1: %2").arg(asked.value(), outcome);
    m_asked.erase(asked);
    Q_EMIT resultReported(line, result->outcome == vehicle::CommandOutcome::Accepted);
}

} // namespace skyseal::ui
