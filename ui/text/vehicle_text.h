// Texts of the window for states and commands. Texts that command lines show as well are in core/engine/text.
#pragma once

#include "core/channel/events.h"
#include "core/engine/text/qt_text.h"
#include "core/vehicle/vehicle_command.h"
#include "core/vehicle/vehicle_state.h"
#include "ui/text/units.h"

#include <QtCore/QString>

namespace skyseal::ui {

using engine::fromStd;
using engine::reasonText;

/// "3D fix", "no fix", …; a dash where unknown.
QString fixText(int gpsFixType);
/// All batteries of a vehicle, one a line: "Battery 2 (payload): 12.1 V · 40 %"; empty if it reports none.
QString batteriesText(const vehicle::VehicleState &state);
/// MAV_SEVERITY: "error", "warning", …
QString severityText(std::uint8_t severity);
/// The name of a command: "Arm", "Take off to 10 m", …
QString commandText(const vehicle::VehicleCommand &command, UnitSystem units);

} // namespace skyseal::ui
