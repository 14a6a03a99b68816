// The frames of an observer that reach the autopilot: questions (question_rules.h) that are said plainly, and no request for
// streams while a pilot is there: the rates are the autopilot's, one set for all stations behind an agent, so an observer
// could take the pilot's instruments away. SET_MESSAGE_INTERVAL is refused for the same reason.
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// `pilotThere`: a peer that may command has a session. A permitted frame must still pass mayBeMisread().
bool observerMaySend(const mavlink::Frame &frame, bool pilotThere);

} // namespace skyseal::engine
