// Callback by which a session learns its cost at this end.
#pragma once

#include "core/channel/session_id.h"
#include "core/channel/stats.h"

#include <functional>

namespace skyseal::channel {

/// Callback that returns the local cost (CPU time, memory) of a session.
using CostSource = std::function<EndCosts(SessionId)>;

} // namespace skyseal::channel
