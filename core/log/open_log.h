// Opens a recording for reading.
#pragma once

#include "core/base/reason.h"
#include "core/base/result.h"

#include <fstream>
#include <string>

namespace skyseal::tlog {

/// Why a file that was read to its end is no recording.
inline constexpr Sentence kNoFrame = sentence("Reason", "it contains no MAVLink frame");

/// Returns the open file, or the reason why it cannot be read, e.g. "No such file or directory". Folders and pipes
/// are refused: reading from them would fail or block.
Result<std::ifstream, Reason> openLog(const std::string &path);

} // namespace skyseal::tlog
