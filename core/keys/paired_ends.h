// The files of a station and an agent that know each other from the start, for a demonstration or an experiment on one machine.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"

#include <string>

namespace skyseal::keys {

/// Writes into the folder fresh keys without a passphrase (station.key, air.key) and the lists of peers (station.peers with the
/// agent by the name `agent`, air.peers with "station"). Returns the error of the first file that could not be written.
Result<void, InputError> writePairedEnds(const std::string &folder, const std::string &agent, RandomSource &random);

} // namespace skyseal::keys
