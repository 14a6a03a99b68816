#include "ui/scene.h"

#include <algorithm>

namespace skyseal::ui {

Scene sceneOf(SnapshotPtr snapshot, std::uint8_t systemId)
{
    Scene scene{std::move(snapshot)};
    if (!scene.snapshot)
        return scene;
    const auto &vehicles = scene.snapshot->vehicles;
    const auto &sessions = scene.snapshot->sessions;
    const auto chosen = std::ranges::find_if(vehicles, [&](const auto &v) { return v.state.systemId == systemId; });
    if (chosen != vehicles.end())
        scene.vehicle = &*chosen;
    else if (!vehicles.empty())
        scene.vehicle = &vehicles.front();

    if (scene.vehicle) {
        const auto &links = scene.snapshot->links;
        const auto over = std::ranges::find(links, scene.vehicle->link, &engine::LinkSnapshot::id);
        scene.link = over == links.end() ? nullptr : &*over;
    }
    if (scene.vehicle && scene.vehicle->session) {
        const auto own
            = std::ranges::find_if(sessions, [&](const auto &s) { return s.info.session == *scene.vehicle->session; });
        if (own != sessions.end())
            scene.session = &*own;
    } else if (!scene.vehicle && !sessions.empty()) {
        scene.session = &sessions.front();
    }
    const auto &heldBack = scene.snapshot->heldBack;
    const auto held = std::ranges::find_if(heldBack, [&](const engine::HeldBackVehicle &one) {
        return !scene.vehicle || scene.vehicle->state.systemId == one.systemId;
    });
    scene.heldBack = held == heldBack.end() ? nullptr : &*held;
    return scene;
}

SceneState stateOf(const Scene &scene)
{
    SceneState state;
    state.plainRun = scene.plainRun;
    if (scene.snapshot) {
        state.security = scene.snapshot->security;
        state.vehicles = scene.snapshot->vehicles.size();
        state.sessions = scene.snapshot->sessions.size();
        state.links = scene.snapshot->links.size();
        state.heldBack = scene.snapshot->heldBack.size();
    }
    if (scene.session) {
        state.suite = scene.session->info.suite;
        state.pending = scene.session->info.pending;
    }
    if (scene.vehicle) {
        state.systemId = scene.vehicle->state.systemId;
        state.armed = scene.vehicle->state.armed;
        state.mode = scene.vehicle->state.mode;
        state.stale = scene.stale();
    }
    return state;
}

} // namespace skyseal::ui
