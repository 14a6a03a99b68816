// Which heartbeats are those of a vehicle.
#pragma once

#include "core/mavlink/messages.h"

namespace skyseal::mavlink {

/// True for the heartbeat of an autopilot, the only component that announces a vehicle: false for ground stations, gimbals,
/// cameras, companion computers and other parts, by autopilot and type of the message.
bool isAutopilot(const Heartbeat &heartbeat);

} // namespace skyseal::mavlink
