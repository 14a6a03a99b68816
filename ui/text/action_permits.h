// Reasons why a command makes no sense for the selected vehicle now, for the action bar and the Vehicle menu.
#pragma once

#include "core/vehicle/vehicle_command.h"
#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// Returns the reason in a sentence: that nothing can be sent at all, or "Not now: the vehicle is disarmed"; empty if the
/// command makes sense. A reason that depends on the armed state counts only while heartbeats arrive.
QString actionDisabledReason(const vehicle::VehicleCommand &command, const ViewState &view);

} // namespace skyseal::ui
