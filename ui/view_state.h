// What the panels draw: one snapshot, and which vehicle and session of it the operator looks at.
#pragma once

#include "ui/station_interface.h"

namespace skyseal::ui {

/// Values older than this are shown as stale (the same limit as a lost link).
inline constexpr double kStaleAfterSeconds = 3.5;

/// Never null once a first snapshot came; the pointers point into it.
struct ViewState
{
    SnapshotPtr snapshot;
    const engine::VehicleSnapshot *vehicle = nullptr;
    const engine::LinkSnapshot *link = nullptr; ///< over which the vehicle was heard last; null when that was removed
    const engine::SessionSnapshot *session = nullptr;
    const engine::PendingVehicle *pendingApproval = nullptr; ///< the view's vehicle; without one, the first that is
    bool inSweep = false;                                    ///< the connected link is being measured: sessions begin anew
    bool plainRun = false;                                   ///< and just now in clear, which the operator consented to

    /// True where the vehicle's values are older than the limit.
    bool stale() const { return vehicle && vehicle->state.messageAge > kStaleAfterSeconds; }
};

/// What must show at once when it changes, whatever the rate at which numbers are renewed.
struct AlarmState
{
    engine::Security security{};
    std::optional<crypto::SuiteId> suite, pending;
    std::uint8_t systemId = 0;
    bool armed = false, stale = false, plainRun = false;
    std::string mode;
    std::size_t vehicles = 0, sessions = 0, links = 0, pendingApproval = 0;
    bool operator==(const AlarmState &) const = default;
};

AlarmState alarmStateOf(const ViewState &view);

/// Finds the vehicle with `systemId` (or the first one when it is gone or 0) and its session. Where no vehicle is known yet,
/// the first session stands in, so that an agent without an autopilot is seen.
ViewState viewOf(SnapshotPtr snapshot, std::uint8_t systemId);

} // namespace skyseal::ui
