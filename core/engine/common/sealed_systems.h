// The MAVLink system ids that each peer has used over a sealed link, kept in a file beside the list of peers, so that a
// restarted station still refuses them in clear. One line each: the system id and the peer's public key in hex.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <bitset>
#include <map>
#include <string>
#include <string_view>

namespace skyseal::engine {

using SealedSystems = std::map<channel::PublicKey, std::bitset<256>>;

/// Empty if the file does not exist. A malformed line is an error: if it were skipped, clear frames would be accepted.
Result<SealedSystems, InputError> readSealedSystems(const std::string &path);
/// Replaces the file as a whole.
Result<void, InputError> writeSealedSystems(const std::string &path, const SealedSystems &systems);

} // namespace skyseal::engine
