#include "ui/map/vehicle_markers.h"

#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "ui/text/recorded_link.h"
#include "ui/tiles/mercator.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

struct VehicleMarkersText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::VehicleMarker)
};

bool looksTheSame(const VehicleMarker &a, const VehicleMarker &b, double metresPerPixel)
{
    constexpr double kTurn = 0.7; // degrees
    const bool turned = std::isfinite(a.heading) != std::isfinite(b.heading) || std::abs(a.heading - b.heading) > kTurn;
    return a.systemId == b.systemId && a.suite == b.suite && a.age == b.age && !turned
        && (a.metres - b.metres).manhattanLength() <= metresPerPixel * 0.5;
}

} // namespace

int staleAge(const vehicle::VehicleState &state)
{
    return state.messageAge > state.staleAfter ? static_cast<int>(std::min(state.messageAge, 1e6)) : 0;
}

std::vector<VehicleMarker> otherVehicles(const ViewState &view)
{
    std::vector<VehicleMarker> out;
    for (const engine::VehicleSnapshot &vehicle : view.vehicles()) {
        const auto &state = vehicle.state;
        if (&vehicle == view.vehicle || !state.position.known())
            continue;
        out.push_back({.systemId = state.systemId,
                       .metres = mercator::project({state.position.latitude, state.position.longitude}),
                       .heading = state.heading,
                       .suite = linkSuiteOf(view, vehicle),
                       .age = staleAge(state)});
    }
    return out;
}

std::optional<crypto::SuiteId> linkSuiteOf(const ViewState &view, const engine::VehicleSnapshot &vehicle)
{
    if (const auto recorded = recordedLinkOf(view, vehicle))
        return recorded->suite;
    const engine::SessionSnapshot *session = sessionOf(*view.snapshot, vehicle);
    return session ? session->info.suite : crypto::SuiteId::None;
}

QString markerText(std::uint8_t systemId, std::optional<crypto::SuiteId> suite, int age)
{
    if (age > 0)
        return VehicleMarkersText::tr("Vehicle %1 · %2 s ago").arg(systemId).arg(age);
    if (!suite)
        return VehicleMarkersText::tr("Vehicle %1").arg(systemId);
    return suite == crypto::SuiteId::None ? VehicleMarkersText::tr("Vehicle %1 · not sealed").arg(systemId)
                                          : VehicleMarkersText::tr("Vehicle %1 · sealed").arg(systemId);
}

bool looksTheSame(const std::vector<VehicleMarker> &a, const std::vector<VehicleMarker> &b, double metresPerPixel)
{
    return std::ranges::equal(a, b, [metresPerPixel](const VehicleMarker &one, const VehicleMarker &other) {
        return looksTheSame(one, other, metresPerPixel);
    });
}

} // namespace skyseal::ui
