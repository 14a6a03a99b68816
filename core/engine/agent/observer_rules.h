// The frames of an observer that are forwarded to the autopilot: questions (read-only requests, question_rules.h) for which
// isPlainlySaid() is true, but no requests for rates (REQUEST_DATA_STREAM, SET_MESSAGE_INTERVAL) while a pilot is connected:
// the autopilot has one set of rates for all stations behind an agent, so an observer could slow down the pilot's telemetry.
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// `pilotThere`: a peer that may command has a session. A permitted frame must still pass mayBeMisread().
bool observerMaySend(const mavlink::Frame &frame, bool pilotThere);

} // namespace skyseal::engine
