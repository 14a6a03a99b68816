// Reasons why commands cannot be sent to the selected vehicle.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// Returns the reason in a few words; empty if commands can be sent. A silent link is not a reason, because commands may still
/// arrive at the vehicle.
QString commandsDisabledReason(const ViewState &view);
/// The reason why the vehicle cannot be commanded to move to another place or altitude; empty if it can.
QString movesDisabledReason(const ViewState &view);
/// The reason why the vehicle cannot be commanded to change its altitude; empty if it can.
QString climbsDisabledReason(const ViewState &view);
/// A reason as a sentence: "Nothing can be sent: no vehicle"; empty for an empty reason.
QString nothingCanBeSent(const QString &reason);

/// The reason why the demo cannot be started, in a sentence; empty if it can. It takes the place of the links, so that it must
/// not be started while one is in use.
QString demoDisabledReason(const ViewState &view);

} // namespace skyseal::ui
