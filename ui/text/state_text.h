// The words for what the engine reports as numbers and enums. Made in one place, so that the same thing has the same
// name everywhere.
#pragma once

#include "core/channel/events.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/vehicle_command.h"

#include <QtCore/QString>

namespace skyseal::ui {

QString fromStd(std::string_view text);
/// Of names that are joined by ", ": "air-1", "air-1 or air-2", "air-1, air-2 or air-3".
QString anyOfNames(std::string_view names);

/// "3D fix", "no fix", …; a dash where unknown.
QString fixText(int gpsFixType);
/// MAV_TYPE in words: "quadrotor", "plane", …
QString vehicleTypeText(std::uint8_t type);
/// MAV_SEVERITY: "error", "warning", …
QString severityText(std::uint8_t severity);
QString switchFailureText(channel::SwitchFailure failure);
QString downReasonText(channel::DownReason reason);
QString refusalText(channel::RefusalReason reason);
QString linkPhaseText(engine::LinkPhase phase);
QString commandOutcomeText(const vehicle::CommandResult &result);
/// What was asked for: "Arm", "Take off to 10 m", …
QString commandText(const vehicle::VehicleCommand &command);

} // namespace skyseal::ui
