// One snapshot with the vehicle and session that the operator has selected: the input of all panels.
#pragma once

#include "core/crypto/suite.h"
#include "core/engine/station/security.h"
#include "ui/station_interface.h"

#include <vector>

namespace skyseal::engine {
struct LinkSnapshot;
struct PendingVehicle;
struct SessionSnapshot;
struct VehicleSnapshot;
} // namespace skyseal::engine

namespace skyseal::ui {

/// Values older than this, in seconds, are shown as stale (the limit of a lost link).
inline constexpr double kStaleAfterSeconds = 3.5;
/// A battery with this percentage or less is shown as low.
inline constexpr double kLowBatteryPercent = 20;

/// Whether this station can use its key.
struct KeyState
{
    QString problem = {};   ///< why it cannot; empty if it can
    bool isOpening = false; ///< its passphrase is being recalled or hashed, so that the problem may be over in a moment
};

/// The pointers point into `snapshot`, which is null only before the first one.
struct ViewState
{
    SnapshotPtr snapshot;
    SnapshotPtr live = {}; ///< of the station, while `snapshot` is that of a replay
    const engine::VehicleSnapshot *vehicle = nullptr;
    const engine::LinkSnapshot *link = nullptr; ///< last link of the vehicle; null if it was removed
    const engine::SessionSnapshot *session = nullptr;
    const engine::PendingVehicle *pendingApproval = nullptr; ///< entry of the selected vehicle, or the first entry without one
    KeyState key = {};
    bool inSweep = false;  ///< a sweep measures the connected link and restarts sessions
    bool plainRun = false; ///< the sweep measures plain MAVLink with the consent of the operator

    std::uint64_t refusedLastMinute = 0; ///< frames that claimed to be this vehicle and were refused
    std::uint64_t refused = 0;           ///< the same since the link came up

    /// True if the values of the vehicle are older than the limit.
    bool stale() const;
    /// Of the snapshot; none before the first one. With these and `time`, most panels need not know the rest of it.
    const std::vector<engine::VehicleSnapshot> &vehicles() const;
    /// Seconds since the station started, as in the snapshot; 0 before the first one.
    double time() const;
    bool isReplay() const { return live != nullptr; }
    /// The snapshot of the station, also during a replay, for its own links and recording.
    const SnapshotPtr &station() const { return live ? live : snapshot; }
};

/// The part of the view whose changes are shown at once, independent of the refresh interval of numbers.
struct AlarmState
{
    engine::Security security{};
    std::optional<crypto::SuiteId> suite, pending;
    std::uint8_t systemId = 0;
    bool armed = false, stale = false, plainRun = false, attacked = false;
    std::string mode;
    std::size_t vehicles = 0, sessions = 0, links = 0, pendingApproval = 0;
    bool operator==(const AlarmState &) const = default;
};

AlarmState alarmStateOf(const ViewState &view);

/// The session in which the vehicle is heard; null without one. Points into the snapshot.
const engine::SessionSnapshot *sessionOf(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle);

/// True if the second picture of a replay does not continue the first one.
bool isAfterSeek(const engine::Snapshot &before, const engine::Snapshot &after);

/// Selects the vehicle with `systemId` (the first one if it is gone or 0) and its session. Without a vehicle, the first session
/// is selected, so that an agent without an autopilot is visible.
ViewState viewOf(SnapshotPtr snapshot, std::uint8_t systemId);

} // namespace skyseal::ui
