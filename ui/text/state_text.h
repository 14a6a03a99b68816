// Texts of the window for states and commands. What the command lines show as well is in core/engine/text.
#pragma once

#include "core/channel/events.h"
#include "core/vehicle/vehicle_command.h"

#include <QtCore/QString>

namespace skyseal::ui {

QString fromStd(std::string_view text);

/// "3D fix", "no fix", …; a dash where unknown.
QString fixText(int gpsFixType);
/// MAV_SEVERITY: "error", "warning", …
QString severityText(std::uint8_t severity);
QString commandOutcomeText(const vehicle::CommandResult &result);
/// What was asked for: "Arm", "Take off to 10 m", …
QString commandText(const vehicle::VehicleCommand &command);

} // namespace skyseal::ui
