// Summary of a recording, for `log info` and `log verify`.
#pragma once

#include "core/base/json_writer.h"
#include "core/log/log_reader.h"
#include "core/log/log_time.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace skyseal::tlog {

/// Bytes that are no valid message.
struct BadSpot
{
    mavlink::FrameFault fault{};
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
};

/// A pause in the recording, or a clock that was set.
struct TimeGap
{
    std::uint64_t offset = 0; ///< of the entry after the gap
    WallTime before, after;
};

struct LogSummary
{
    static constexpr std::size_t kListed = 1000; ///< limit of listedSpots and of listedGaps; the counts have no limit

    LogFormat format = LogFormat::Auto;
    std::uint64_t bytes = 0;
    std::uint64_t frames = 0;
    std::uint64_t signedFrames = 0;
    std::uint64_t version1Frames = 0;
    std::uint64_t unknownMessages = 0; ///< complete frames with a message id that the dialect does not define
    std::uint64_t badSpots = 0, badBytes = 0;
    std::uint64_t pauses = 0;
    std::uint64_t backwardSteps = 0, forwardSteps = 0; ///< of a clock that was set; forward: by more than LogTime::kLongestStep
    std::optional<WallTime> first, last;               ///< recorded times of the first and the last entry; .tlog only
    Duration length{};                                 ///< between them, without steps of the clock
    std::map<std::string, std::uint64_t, std::less<>> byMessage;
    std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint64_t> bySender; ///< system and component
    std::vector<BadSpot> listedSpots;
    std::vector<TimeGap> listedGaps;

    /// At least one frame, no damage and no step back in time. Unknown messages, pauses and a clock that is set forward, as
    /// when a computer learns the time, are not faults of the recording.
    bool isSound() const { return frames > 0 && badSpots == 0 && backwardSteps == 0; }
};

/// Reads `input` to its end. Two consecutive entries more than `pause` apart count as a pause.
LogSummary summarize(std::istream &input, const mavlink::Dialect &dialect,
                     std::chrono::microseconds pause = std::chrono::seconds(5));

/// Writes the members of a JSON object: {"format","bytes","frames",…,"messages":{name:n},"senders":[…],"bad":[…],
/// "gaps":[…]}.
void writeSummaryFields(JsonWriter &json, const LogSummary &summary);

/// "2026-11-21T10:00:00.000000Z".
std::string utcText(WallTime time);

} // namespace skyseal::tlog
