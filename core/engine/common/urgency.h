// Which frames do not wait for company on a slow link: what a pilot's hand or a conversation that answers step by step is
// waiting for, and the heartbeat by which a vehicle knows that its station lives.
#pragma once

#include "core/base/bytes.h"

namespace skyseal::engine {

/// `frame` is a whole MAVLink frame of either version.
bool isUrgent(ByteView frame);

} // namespace skyseal::engine
