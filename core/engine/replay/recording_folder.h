// The recordings in a folder. Both functions wait for the disk: call them on a thread for files.
#pragma once

#include "core/engine/replay/recording_info.h"

#include <atomic>
#include <vector>

namespace skyseal::engine {

/// The files of `folder` whose names end in ".tlog", not read, the newest first; none if the folder cannot be read.
std::vector<RecordingInfo> recordingsIn(const std::string &folder);

/// Reads the index. Stops soon, without one, when `stopped` becomes true.
RecordingInfo readRecording(RecordingInfo recording, const std::atomic<bool> &stopped);

} // namespace skyseal::engine
