// Detects frames that can be misread on a line that loses bytes. An autopilot whose serial line lost the first byte of a frame
// searches the rest for the next frame, and executes a whole frame that it finds there. A permitted frame of an observer must
// therefore not become another message when some of its bytes are missing.
//
// - A frame begins with 0xFD or 0xFE. If neither byte occurs after the first one, no frame can begin there: neither one that
//   is nested in this frame nor one that continues into the next, which a search for whole nested frames would overlook.
//   This refuses one honest TIMESYNC in thirteen, because of its sequence number and checksum; the next one passes.
// - The first byte may be kept and others lost. The header of MAVLink 1 is so short that one lost byte turns the sequence
//   number into the length and the first payload byte into the message id. The loss of one byte of a MAVLink 2 header yields
//   no other message; THREATS.md covers the loss of several. Unused compatibility flags, and payloads longer than the message,
//   have no meaning, so a sender that uses them does so for this attack.
// - A command id is followed by fields that the sender chooses. When bytes in or before it are lost, later bytes take their
//   place: no two of them may form another command id. The first byte of the id with a later one may form the same id again
//   (511 before a target of 1): then the parameters, which stand before it, are complete and were judged.
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::engine {

/// Returns true for MAVLink 2 without unused flags, surplus payload bytes or names that are not text, which honest stations
/// never send.
bool isPlainlySaid(const mavlink::Frame &frame);
/// Returns true if another frame or command could be read from the middle of this one. Happens to honest frames by chance.
bool mayBeMisread(const mavlink::Frame &frame);

} // namespace skyseal::engine
