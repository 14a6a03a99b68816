// How far the replay of a recording has come, as a part of its snapshots.
#pragma once

#include "core/base/clock.h"
#include "core/engine/station/flown_tracks.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace skyseal::tlog {
struct LogIndex;
}

namespace skyseal::engine {

struct ReplayStatus
{
    Duration position{};            ///< on the time line of the recording (tlog::LogTime); the target of a seek on its way
    std::optional<WallTime> time{}; ///< recorded time of the newest frame; nullopt in a file without times
    double speed = 1;               ///< 2 = twice as fast as recorded
    bool playing = false;
    bool seeking = false;                          ///< the picture is still that of before the seek
    bool ended = false;                            ///< at the end of the recording
    std::uint64_t seeks = 0;                       ///< seeks so far: pictures with different numbers do not continue each other
    std::shared_ptr<const tlog::LogIndex> index{}; ///< null until the whole recording was read
    std::shared_ptr<const FlownTracks> flown{};    ///< up to where the last seek went; null before, and during one
};

} // namespace skyseal::engine
