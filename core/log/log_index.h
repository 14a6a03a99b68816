// Index of a recording, made in one pass: length, gaps, vehicles, modes and times armed. For the time line of a replay and the
// list of recordings. Positions are those of LogTime.
//
// A recording does not hold the cipher suites of the link: its frames are recorded in clear, after they were opened.
#pragma once

#include "core/log/log_reader.h"
#include "core/log/log_time.h"

#include <array>
#include <vector>

namespace skyseal::tlog {

/// The mode of a vehicle from a position on, as the numbers of its HEARTBEAT.
struct ModeChange
{
    Duration at{};
    std::uint8_t systemId = 0;
    std::uint8_t type = 0;      ///< MAV_TYPE
    std::uint8_t autopilot = 0; ///< MAV_AUTOPILOT
    std::uint8_t baseMode = 0;  ///< MAV_MODE_FLAG
    std::uint32_t customMode = 0;
};

/// A span of the time line.
struct LogSpan
{
    Duration from{}, to{};
};

/// A vehicle was armed from its first HEARTBEAT that said so to the first that did not, or to the end of the recording.
struct ArmedSpan
{
    LogSpan span;
    std::uint8_t systemId = 0;
};

struct LogIndex
{
    /// Limit of each list but that of the vehicles; `omitted` counts the entries beyond it.
    static constexpr std::size_t kListed = 2000;
    /// A longer time without any frame is a gap (the time after which a link counts as lost).
    static constexpr std::chrono::milliseconds kGap{3500};

    std::optional<WallTime> first; ///< recorded time of position 0; nullopt in a file without times
    Duration length{};             ///< position of the last frame
    std::uint64_t frames = 0;
    std::uint64_t damaged = 0;          ///< spots that are no frame
    std::vector<std::uint8_t> vehicles; ///< system ids, in the order in which they were heard
    std::vector<ModeChange> modes;      ///< for each vehicle also the first one
    std::vector<ArmedSpan> armed;       ///< by their end
    std::vector<LogSpan> gaps;
    std::uint64_t omitted = 0;
};

/// Reads a recording in portions. Memory is bounded whatever the file contains; damage is skipped as by LogReader.
class LogIndexer
{
public:
    /// `input` must outlive the indexer.
    explicit LogIndexer(std::istream &input);

    void endWhen(const std::atomic<bool> &stopped) { m_reader.endWhen(stopped); } ///< see LogReader
    /// Reads up to `most` further entries; returns true at the end of the recording.
    bool read(std::size_t most);
    /// The index of what was read.
    LogIndex take();

private:
    struct HeardVehicle
    {
        bool known = false, armed = false;
        std::uint8_t component = 0;
        ModeChange mode;
        Duration armedAt{};
    };

    void takeHeartbeat(const mavlink::Frame &frame, Duration at);
    template<typename T> void list(std::vector<T> &entries, const T &entry);

    LogReader m_reader;
    LogTime m_time;
    LogIndex m_index;
    std::array<HeardVehicle, 256> m_heard; ///< by system id
};

/// Reads `input` to its end.
LogIndex indexOf(std::istream &input);

} // namespace skyseal::tlog
