// What a peer that may only look may say to an autopilot: a list of what is let through, so that whatever it does not name
// (messages that were invented later, and those of dialects that are not known here) stays outside.
//
// Let through are questions about the vehicle that change nothing in it. Not let through, though they look harmless:
// - HEARTBEAT of a ground station: autopilots take it for the pilot's, and their failsafe would not act when the pilot's
//   own link is lost. https://ardupilot.org/copter/docs/gcs-failsafe.html
// - SET_MESSAGE_INTERVAL, and REQUEST_DATA_STREAM while a pilot is there: the rates are the autopilot's, one set for all
//   stations behind an agent, so that an observer could take the pilot's instruments away.
// - SYSTEM_TIME sets clocks, and an answer by TIMESYNC moves PX4's; FILE_TRANSFER_PROTOCOL writes as well as it reads;
//   LOG_REQUEST_DATA stops logging.
// - PING, which TIMESYNC replaced long ago, is fourteen bytes of the sender's choice: a whole frame of MAVLink 1. And
//   GET_MESSAGE_INTERVAL, whose number 510 holds a frame's first byte: REQUEST_MESSAGE asks the same (misreading.h).
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// A command that only asks.
bool isQuestion(std::uint16_t command);
/// `pilotThere`: a peer that may command has a session. What is true here may still have to be left out by mayBeMisread().
bool observerMaySend(const mavlink::Frame &frame, bool pilotThere);

} // namespace skyseal::engine
