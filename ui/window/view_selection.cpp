#include "ui/window/view_selection.h"

#include "core/engine/station/snapshot.h"

#include <cmath>

namespace skyseal::ui {

void ViewSelection::setSnapshot(const SnapshotPtr &snapshot)
{
    m_view = viewOf(snapshot, m_systemId);
    if (m_view.vehicle)
        m_systemId = m_view.vehicle->state.systemId;
    if (m_annotate)
        m_annotate(m_view);
    Q_EMIT viewChanged(m_view);
    AlarmState state = alarmStateOf(m_view);
    const bool changed = state != m_shownState;
    if (!changed && snapshot && std::abs(snapshot->time - m_numbersAt) < kNumbersInterval)
        return;
    m_shownState = std::move(state);
    m_numbersAt = snapshot ? snapshot->time : -1;
    Q_EMIT numbersDue(m_view);
}

void ViewSelection::selectVehicle(std::uint8_t systemId)
{
    m_systemId = systemId;
    refresh();
}

void ViewSelection::refresh()
{
    if (m_view.snapshot)
        setSnapshot(m_view.snapshot);
    else if (m_annotate)
        m_annotate(m_view);
    Q_EMIT numbersDue(m_view);
}

void ViewSelection::selectSession(quint32 session)
{
    if (!m_view.snapshot)
        return;
    for (const auto &vehicle : m_view.snapshot->vehicles) {
        if (vehicle.session && static_cast<quint32>(*vehicle.session) == session) {
            selectVehicle(vehicle.state.systemId);
            return;
        }
    }
}

} // namespace skyseal::ui
