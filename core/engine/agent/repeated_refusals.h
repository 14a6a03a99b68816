// Merges refusals of the same message in the log for people: a station repeats a command that is not answered, and each
// repetition is refused in another second. No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/engine/agent/agent_event.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace skyseal::engine {

class RepeatedRefusals
{
public:
    /// Time for which repetitions are collected after a refusal was shown.
    static constexpr Duration kWindow = std::chrono::seconds(10);

    /// Returns true if the refusal is to be shown now; otherwise its frames are part of a later one.
    bool isNew(TimePoint now, const FramesRefused &refused)
    {
        const auto [at, added] = m_windows.try_emplace(Key{refused.reason, refused.peer, refused.messageId, refused.command});
        Window &window = at->second;
        if (added) {
            window = {now + kWindow, refused};
            window.repeated.frames = 0;
            return true;
        }
        window.repeated.frames += refused.frames;
        return false;
    }

    /// The repetitions whose window has ended at `now`; kNever returns all of them.
    std::vector<FramesRefused> takeDue(TimePoint now)
    {
        std::vector<FramesRefused> out;
        for (auto at = m_windows.begin(); at != m_windows.end();) {
            Window &window = at->second;
            if (now < window.end) {
                ++at;
            } else if (window.repeated.frames == 0) {
                at = m_windows.erase(at);
            } else {
                out.push_back(window.repeated);
                window.repeated.frames = 0;
                window.end = now == kNever ? kNever : now + kWindow;
                ++at;
            }
        }
        return out;
    }

private:
    using Key = std::tuple<FramesRefused::Reason, std::string, std::uint32_t, std::uint16_t>;
    struct Window
    {
        TimePoint end{};
        FramesRefused repeated; ///< since the last one that was shown
    };

    std::map<Key, Window> m_windows; ///< bounded by the peers and their messages within kWindow
};

} // namespace skyseal::engine
