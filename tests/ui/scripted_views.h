// The scripted snapshots as a widget is shown them, for tests that need not know the type of a snapshot.
#pragma once

#include "ui/view_state.h"

#include <functional>

namespace skyseal::ui {

using ChangeState = std::function<void(vehicle::VehicleState &)>;

/// Of vehicle 1 in sealedSnapshot(), after `change` of its state.
ViewState sealedView(double time, const ChangeState &change = {});

} // namespace skyseal::ui
