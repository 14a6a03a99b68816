// What a frame can be taken for on a line that loses bytes. An autopilot whose serial line dropped the first byte of a frame
// looks for the next one within it, and executes a whole frame that it finds there; so what an observer says, which is
// harmless as it stands, must be nothing else either when part of it is missing.
//
// - A frame begins with 0xFD or 0xFE. Where neither stands behind the first byte nothing can begin there, neither a frame
//   that is nested in one of ours nor one that goes on into the next: to look for whole nested frames would overlook the
//   latter. That refuses one honest TIMESYNC in thirteen, with sequence and checksum; the next one passes.
// - The first byte may be kept and others lost. MAVLink 1 has so short a head that one lost byte makes the sequence number
//   the length and the first byte of the payload the message. One lost byte of MAVLink 2's head makes no other message; what
//   several make is in THREATS.md. Its flags for compatibility and payloads longer than the message have no meaning, so
//   whatever stands there was put there for this.
// - A command is a number before fields that the sender chooses. When bytes of it or before it are lost, others of the frame
//   take their place: no two of them may be another command.
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// MAVLink 2, nothing in it that the message does not have, and names are text: what an honest station always says.
bool isPlainlySaid(const mavlink::Frame &frame);
/// A frame or a command could be read out of its middle. Happens to honest frames by chance.
bool mayBeMisread(const mavlink::Frame &frame);

} // namespace skyseal::engine
