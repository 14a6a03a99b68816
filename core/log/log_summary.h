// What a recording holds, for `log info` and `log verify`.
#pragma once

#include "core/base/json_writer.h"
#include "core/log/log_reader.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace skyseal::tlog {

/// A spot that is no valid message.
struct BadSpot
{
    mavlink::FrameFault fault{};
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
};

/// A pause in the recording, or time that runs back.
struct TimeGap
{
    std::uint64_t offset = 0; ///< of the entry behind it
    WallTime before, after;
};

struct LogSummary
{
    static constexpr std::size_t kListed = 1000; ///< at most so many spots and gaps are kept; all are counted

    LogFormat format = LogFormat::Auto;
    std::uint64_t bytes = 0;
    std::uint64_t frames = 0;
    std::uint64_t signedFrames = 0;
    std::uint64_t version1Frames = 0;
    std::uint64_t unknownMessages = 0; ///< whole frames with an id that the dialect does not have
    std::uint64_t badSpots = 0, badBytes = 0;
    std::uint64_t pauses = 0, backwardSteps = 0;
    std::optional<WallTime> first, last; ///< the earliest and the latest, in a .tlog
    std::map<std::string, std::uint64_t, std::less<>> byMessage;
    std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint64_t> bySender; ///< system and component
    std::vector<BadSpot> listedSpots;
    std::vector<TimeGap> listedGaps;

    /// Nothing is damaged and time never runs back; unknown messages and pauses are no fault of the recording.
    bool isSound() const { return badSpots == 0 && backwardSteps == 0; }
};

/// Reads all of `input`. Neighbouring entries more than `pause` apart count as a pause.
LogSummary summarize(std::istream &input, const mavlink::Dialect &dialect,
                     std::chrono::microseconds pause = std::chrono::seconds(5));

/// The counts as an object's members: {"format","bytes","frames",…,"messages":{name:n},"senders":[…],"bad":[…],
/// "gaps":[…]}.
void writeSummaryFields(JsonWriter &json, const LogSummary &summary);

/// "2026-11-21T10:00:00.000000Z".
std::string utcText(WallTime time);

} // namespace skyseal::tlog
