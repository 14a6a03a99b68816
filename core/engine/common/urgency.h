// The frames that are not coalesced on a slow link: manual control, steps of protocols in which each frame answers another, and
// the heartbeat that keeps a vehicle's failsafe from acting.
#pragma once

#include "core/base/bytes.h"

namespace skyseal::engine {

/// `frame` is a whole MAVLink frame of either version.
bool isUrgent(ByteView frame);

} // namespace skyseal::engine
