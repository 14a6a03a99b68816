// One recording in a folder, and what its index tells.
#pragma once

#include "core/base/reason.h"
#include "core/log/log_index.h"

#include <cstdint>
#include <memory>
#include <string>

namespace skyseal::engine {

struct RecordingInfo
{
    std::string path, name;
    std::uint64_t bytes = 0;
    std::uint64_t eventBytes = 0;                  ///< of the file with link events beside it
    WallTime modified{};                           ///< when the file was written last
    std::shared_ptr<const tlog::LogIndex> index{}; ///< null before the file was read, and if it cannot be
    Reason problem{};                              ///< reason why it cannot be read; empty if it can

    bool isRead() const { return index || !problem.empty(); }
};

} // namespace skyseal::engine
