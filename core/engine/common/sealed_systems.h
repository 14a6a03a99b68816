// Which MAVLink systems each peer was heard to speak as over a sealed link, kept in a file beside the list of peers: a
// station that is started anew still refuses them in clear. One line for each: the system id and the peer's public key in
// hex.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <bitset>
#include <map>
#include <string>
#include <string_view>

namespace skyseal::engine {

using SealedSystems = std::map<channel::PublicKey, std::bitset<256>>;

/// Empty when there is no such file. Lines that cannot be read are an error: forgetting them would let clear frames in.
Result<SealedSystems, InputError> readSealedSystems(const std::string &path);
/// Replaces the file as a whole.
Result<void, InputError> writeSealedSystems(const std::string &path, const SealedSystems &systems);

} // namespace skyseal::engine
