#include "ui/window/view_selection.h"

#include "core/engine/station/snapshot.h"

#include <cmath>

namespace skyseal::ui {

void ViewSelection::setSnapshot(const SnapshotPtr &snapshot)
{
    m_live = snapshot;
    if (m_replaying)
        Q_EMIT liveChanged(liveView());
    else
        show(snapshot);
}

ViewState ViewSelection::liveView() const
{
    if (!m_replaying)
        return m_view;
    ViewState live = viewOf(m_live, m_liveSystemId);
    if (m_annotate)
        m_annotate(live);
    return live;
}

void ViewSelection::beginReplay()
{
    if (!m_replaying)
        m_liveSystemId = m_systemId;
    m_replaying = true;
    m_systemId = 0;
    m_numbersAt = -1;
    show(std::make_shared<const engine::Snapshot>()); // nothing of the live picture remains
}

bool ViewSelection::isAfterSeek(const engine::Snapshot &next) const
{
    if (!m_replaying || !m_view.snapshot->replay || !next.replay)
        return false;
    return m_view.snapshot->replay->seeking || m_view.snapshot->replay->seeks != next.replay->seeks;
}

void ViewSelection::setReplaySnapshot(const SnapshotPtr &snapshot)
{
    if (m_replaying)
        show(snapshot);
}

void ViewSelection::endReplay()
{
    if (!m_replaying)
        return;
    m_replaying = false;
    m_systemId = m_liveSystemId;
    m_numbersAt = -1;
    show(m_live ? m_live : std::make_shared<const engine::Snapshot>());
}

void ViewSelection::show(const SnapshotPtr &snapshot)
{
    m_view = viewOf(snapshot, m_systemId);
    if (m_replaying)
        m_view.live = m_live ? m_live : std::make_shared<const engine::Snapshot>();
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
        show(m_view.snapshot);
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

#include "moc_view_selection.cpp"
