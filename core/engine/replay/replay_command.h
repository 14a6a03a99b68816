// Commands to a replay.
#pragma once

#include "core/base/clock.h"

#include <variant>

namespace skyseal::engine {

/// At the end of the recording it has no effect.
struct PlayReplay
{};
struct PauseReplay
{};
struct SetReplaySpeed
{
    double factor = 1; ///< 2 = twice as fast as recorded; limited to the speeds of ReplayClock
};
/// Continues at another position, playing or paused as before.
struct SeekReplay
{
    Duration to{}; ///< on the time line of the recording; limited to its ends
};

using ReplayCommand = std::variant<PlayReplay, PauseReplay, SetReplaySpeed, SeekReplay>;

} // namespace skyseal::engine
