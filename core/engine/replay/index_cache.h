// The indexes of recordings in one file, so that a start of the program does not read all recordings again. A cache: a file
// that is missing, damaged, too large or of another version holds nothing, and the recordings are read again. All functions
// wait for the disk: call them on a thread for files.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/engine/replay/recording_info.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyseal::engine {

struct IndexCache
{
    /// Increase it with every change of what LogIndexer finds in a recording, or of how it is stored.
    static constexpr std::uint32_t kVersion = 2;
    /// Of the file; the index of a usual flight takes a few hundred bytes.
    static constexpr std::size_t kMostBytes = 16u << 20, kMostRecordings = 2000;
};

/// The recordings in the file, with their indexes, and as they were when these were made.
std::vector<RecordingInfo> loadIndexes(const std::string &file);

/// Replaces the file, which only its owner can read, by the indexes of the first of `recordings` that fit. Those without an
/// index are left out. Makes the folder.
Result<void, InputError> saveIndexes(const std::string &file, const std::vector<RecordingInfo> &recordings);

} // namespace skyseal::engine
