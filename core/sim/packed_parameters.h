// The packed parameter file of ArduPilot, as the simulated vehicle serves and takes it: all parameters in a tenth of the time
// of PARAM_REQUEST_LIST. core/mavlink/packed_parameters.h describes the format.
#pragma once

#include "core/base/bytes.h"
#include "core/sim/parameters.h"

namespace skyseal::sim {

/// Selection requested in a file name by "?start=N&count=N&withdefaults=1".
struct PackedSelection
{
    std::uint16_t start = 0;
    std::uint16_t count = 0; ///< 0: all
    bool defaults = false;   ///< adds the defaults of changed parameters
};

/// Reads what follows the '?'; nullopt if a number is not one. Unknown names are ignored.
std::optional<PackedSelection> packedSelection(std::string_view query);

/// Empty if the vehicle has no parameter at `start`.
Bytes packParameters(const Parameters &parameters, const PackedSelection &selection);

/// Takes an uploaded file, whose header has the file's length as third number. Stores nothing, and returns false, if the file
/// is damaged; parameters that the vehicle does not have, and values out of range, are skipped.
bool unpackParameters(ByteView file, Parameters &parameters);

} // namespace skyseal::sim
