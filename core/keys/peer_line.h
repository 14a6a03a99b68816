// Parses and formats one line of the file of known peers.
#pragma once

#include "core/keys/peers_file.h"

namespace skyseal::keys {

/// False for empty lines and comments.
bool isPeerLine(std::string_view line);
/// The errors have no line number; the reader of the file adds it.
Result<PeerEntry, InputError> parsePeerLine(std::string_view line);
std::string formatPeerLine(const PeerEntry &entry);

/// Checks a name: 1..32 bytes, of letters, digits, "-" (but not first), "_", "." or visible characters beyond ASCII.
Result<void, InputError> checkPeerName(const std::string &name);
/// Checks the values that a line allows: a name as above, ids in 1..255, a path without blanks.
Result<void, InputError> checkPeerEntry(const PeerEntry &entry);

} // namespace skyseal::keys
