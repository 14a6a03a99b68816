#include "ui/view_state.h"

#include "core/engine/station/snapshot.h"

#include <algorithm>

namespace skyseal::ui {

bool ViewState::stale() const
{
    return vehicle && vehicle->state.messageAge > vehicle->state.staleAfter;
}

const std::vector<engine::VehicleSnapshot> &ViewState::vehicles() const
{
    static const std::vector<engine::VehicleSnapshot> kNone;
    return snapshot ? snapshot->vehicles : kNone;
}

double ViewState::time() const
{
    return snapshot ? snapshot->time : 0;
}

const engine::SessionSnapshot *sessionOf(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle)
{
    const auto own = std::ranges::find_if(snapshot.sessions,
                                          [&](const auto &session) { return vehicle.session == session.info.session; });
    return own == snapshot.sessions.end() ? nullptr : &*own;
}

bool isAfterSeek(const engine::Snapshot &before, const engine::Snapshot &after)
{
    return before.replay && after.replay && (before.replay->seeking || before.replay->seeks != after.replay->seeks);
}

ViewState viewOf(SnapshotPtr snapshot, std::uint8_t systemId)
{
    ViewState view{std::move(snapshot)};
    if (!view.snapshot)
        return view;
    const auto &vehicles = view.snapshot->vehicles;
    const auto &sessions = view.snapshot->sessions;
    const auto chosen = std::ranges::find_if(vehicles, [&](const auto &v) { return v.state.systemId == systemId; });
    if (chosen != vehicles.end())
        view.vehicle = &*chosen;
    else if (!vehicles.empty())
        view.vehicle = &vehicles.front();

    if (view.vehicle) {
        const auto &links = view.snapshot->links;
        const auto over = std::ranges::find(links, view.vehicle->link, &engine::LinkSnapshot::id);
        view.link = over == links.end() ? nullptr : &*over;
    }
    if (view.vehicle)
        view.session = sessionOf(*view.snapshot, *view.vehicle);
    else if (!sessions.empty())
        view.session = &sessions.front();
    const auto &pendingApproval = view.snapshot->pendingApproval;
    const auto held = std::ranges::find_if(pendingApproval, [&](const engine::PendingVehicle &one) {
        return !view.vehicle || view.vehicle->state.systemId == one.systemId;
    });
    view.pendingApproval = held == pendingApproval.end() ? nullptr : &*held;
    return view;
}

AlarmState alarmStateOf(const ViewState &view)
{
    AlarmState state;
    state.plainRun = view.plainRun;
    state.attacked = view.refusedLastMinute > 0;
    if (view.snapshot) {
        state.security = view.snapshot->security;
        state.vehicles = view.snapshot->vehicles.size();
        state.sessions = view.snapshot->sessions.size();
        state.links = view.snapshot->links.size();
        state.pendingApproval = view.snapshot->pendingApproval.size();
    }
    if (view.session) {
        state.suite = view.session->info.suite;
        state.pending = view.session->info.pending;
    }
    if (view.vehicle) {
        state.systemId = view.vehicle->state.systemId;
        state.armed = view.vehicle->state.armed;
        state.mode = view.vehicle->state.mode;
        state.stale = view.stale();
    }
    return state;
}

} // namespace skyseal::ui
