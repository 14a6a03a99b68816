// The part of a snapshot that describes the recording of telemetry.
#pragma once

#include "core/base/reason.h"

#include <cstdint>
#include <string>

namespace skyseal::engine {

struct RecordingSnapshot
{
    bool active = false;
    std::string file;
    std::uint64_t bytes = 0, frames = 0, dropped = 0;
    Reason problem; ///< why nothing is recorded; empty without one
};

} // namespace skyseal::engine
