// Questions: read-only requests, which do not change the vehicle. They are a list of permitted messages, so that all other
// messages, including those of later or unknown dialects, are not among them. The questions of observers and of clients that
// may only read are forwarded to the autopilot.
//
// Not permitted, although they look harmless:
// - HEARTBEAT of a ground station: autopilots do not distinguish it from the pilot's, so their failsafe would not act when the
//   pilot's own link is lost. https://ardupilot.org/copter/docs/gcs-failsafe.html
// - REQUEST_DATA_STREAM and MAV_CMD_SET_MESSAGE_INTERVAL beyond 1 to 10 Hz: a rate of 0 or an interval of -1 stops a stream,
//   and high rates saturate the line.
// - SYSTEM_TIME sets clocks, and an answer by TIMESYNC moves PX4's; FILE_TRANSFER_PROTOCOL writes as well as it reads;
//   LOG_REQUEST_DATA stops logging.
// - PING, which TIMESYNC replaced long ago, has fourteen bytes of the sender's choice: room for a whole MAVLink 1 frame. And
//   GET_MESSAGE_INTERVAL, whose id 510 contains the first byte of a frame: REQUEST_MESSAGE replaces it (misreading.h).
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// Returns true for a read-only command, whatever its parameters. Not for MAV_CMD_SET_MESSAGE_INTERVAL, which depends on them.
bool isQuestion(std::uint16_t command);
/// Returns true for messages that make the vehicle send a whole list.
bool isListRequest(std::uint32_t messageId);
/// `mayStartStreams`: whole rates of 1 to 10 Hz are permitted, which an autopilot sets for all receivers behind one line, by
/// REQUEST_DATA_STREAM or MAV_CMD_SET_MESSAGE_INTERVAL.
bool isHarmlessQuestion(const mavlink::Frame &frame, bool mayStartStreams);

} // namespace skyseal::engine
