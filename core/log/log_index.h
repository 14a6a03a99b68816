// Index of a recording, made in one pass: length, gaps, vehicles, modes, times armed, and the cipher suites of the links, which
// come from the file beside the recording. For the time line of a replay and the list of recordings. Positions are those of
// LogTime.
#pragma once

#include "core/log/link_events.h"
#include "core/log/log_reader.h"
#include "core/log/log_time.h"
#include "core/mavlink/autopilot_heartbeat.h"

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
    bool operator==(const ModeChange &) const = default;
};

/// A span of the time line.
struct LogSpan
{
    Duration from{}, to{};
    bool operator==(const LogSpan &) const = default;
};

/// A vehicle was armed from its first HEARTBEAT that said so to the first that did not, or to the end of the recording.
struct ArmedSpan
{
    LogSpan span;
    std::uint8_t systemId = 0;
    bool operator==(const ArmedSpan &) const = default;
};

/// A link was sealed with this suite from a position on.
struct SuiteMark
{
    Duration at{};
    LinkEvent event;
    bool operator==(const SuiteMark &) const = default;
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
    std::vector<SuiteMark> suites;      ///< empty if nothing is noted beside the recording
    std::uint64_t unreadableEvents = 0; ///< lines of that file, see LinkEvents
    std::uint64_t omitted = 0;
    bool operator==(const LogIndex &) const = default;
};

/// Reads a recording in portions. Memory is bounded whatever the file contains; damage is skipped as by LogReader.
class LogIndexer
{
public:
    /// `input` must outlive the indexer. An event stands at the first entry that is not older; later ones stand at the end. An
    /// event that is older than the one before it was noted after the clock was set back, and stands behind that step.
    explicit LogIndexer(std::istream &input, LinkEvents events = {});

    void endWhen(const std::atomic<bool> &stopped) { m_reader.endWhen(stopped); } ///< see LogReader
    /// Reads up to `most` further entries; returns true at the end of the recording.
    bool read(std::size_t most);
    /// The index of what was read.
    LogIndex take();

private:
    struct HeardVehicle
    {
        mavlink::AutopilotClaim claim{}; ///< of its autopilot; None: no autopilot was heard
        std::uint8_t component = 0;
        bool armed = false;
        ModeChange mode;
        Duration armedAt{};
    };

    void takeFrame(const mavlink::Frame &frame, Duration at);
    void takeEventsUntil(WallTime time, Duration at);
    template<typename T> void list(std::vector<T> &entries, const T &entry);

    LogReader m_reader;
    LogTime m_time;
    std::vector<LinkEvent> m_events;
    std::size_t m_nextEvent = 0;
    std::optional<WallTime> m_entryTime;    ///< of the entry before
    int m_entrySteps = 0, m_eventSteps = 0; ///< how often the clock was set back before the next entry, before the next event
    LogIndex m_index;
    std::array<HeardVehicle, 256> m_heard; ///< by system id
};

/// What is noted of the protection of a vehicle's link at a position: the newest event of each peer that may be its own, or
/// that it was heard in plain MAVLink. Empty if nothing is noted. A sealed link is noted by the name of its peer, not by its
/// vehicles, so that there may be several.
std::vector<LinkEvent> protectionAt(const LogIndex &index, Duration at, std::uint8_t systemId);

/// Reads `input` to its end.
LogIndex indexOf(std::istream &input, LinkEvents events = {});

} // namespace skyseal::tlog
