// The vehicles on the map beside the selected one: where each is, where it heads, and whether its link is sealed.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QPointF>
#include <QtCore/QString>

#include <optional>
#include <vector>

namespace skyseal::ui {

struct VehicleMarker
{
    std::uint8_t systemId = 0;
    QPointF metres;                         ///< of the projection, see mercator.h
    double heading = 0;                     ///< degrees; NaN if it is unknown
    std::optional<crypto::SuiteId> suite{}; ///< None: its link is not sealed; nullopt: it is not known
    int age = 0;                            ///< see staleAge()

    bool isStale() const { return age > 0; }
};

/// Whole seconds since the last message of a vehicle whose values are stale; otherwise 0.
int staleAge(const vehicle::VehicleState &state);

/// All vehicles of the snapshot that have a position, without the selected one, in the order of the snapshot.
std::vector<VehicleMarker> otherVehicles(const ViewState &view);

/// The suite of the vehicle's link, or of the recorded one; None: it is not sealed; nullopt: a recording does not note it.
std::optional<crypto::SuiteId> linkSuiteOf(const ViewState &view, const engine::VehicleSnapshot &vehicle);

/// Number and lock state in words, or the age of stale values: "Vehicle 2 · not sealed".
QString markerText(std::uint8_t systemId, std::optional<crypto::SuiteId> suite, int age);

/// True if the map looks the same with both: nothing moved by more than half a pixel.
bool looksTheSame(const std::vector<VehicleMarker> &a, const std::vector<VehicleMarker> &b, double metresPerPixel);

} // namespace skyseal::ui
