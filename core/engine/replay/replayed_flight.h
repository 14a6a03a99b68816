// The picture of a recorded flight at a position of its recording. Frames, and the readings and deadlines between them, are
// taken in the order of the recorded times, so that the picture depends on the position alone: not on the speed of the replay,
// nor on the positions at which it stopped before.
//
// Sans-I/O but for the stream. Only moves forward: a picture of before is that of a new object. Requests of its vehicles go
// nowhere, as the answers, if there were any, are in the recording.
#pragma once

#include "core/engine/station/fleet.h"
#include "core/engine/station/flown_tracks.h"
#include "core/log/log_reader.h"
#include "core/log/log_time.h"

#include <istream>
#include <optional>

namespace skyseal::engine {

struct Snapshot;

class ReplayedFlight
{
public:
    /// `input` must outlive this object and stand at the beginning of the recording. Events are passed to `notify`.
    ReplayedFlight(std::istream &input, Notify notify);

    void endWhen(const std::atomic<bool> &stopped) { m_reader.endWhen(stopped); } ///< see LogReader
    /// Moves to the position `to`, or to the end if that is before it, but takes no more than `most` entries and readings.
    /// Returns true when it has arrived.
    bool advance(Duration to, std::size_t most);
    Duration position() const { return m_position; }
    /// All of the recording was taken.
    bool isOver() const { return m_over; }
    /// True if the recording is over and had no frame of a known message.
    bool isEmpty() const { return m_over && !m_hasFrame; }
    /// The position of the next entry, if nothing was recorded for tlog::LogTime::kLongestWait before this position.
    std::optional<Duration> afterSilence() const;
    /// Recorded time of the newest frame; nullopt in a file without times.
    std::optional<WallTime> time() const { return m_wall; }
    void setInspecting(bool inspecting) { m_fleet.inspector().setWatching(inspecting); }
    void chooseFields(std::vector<FieldChoice> choices) { m_fleet.fields().choose(std::move(choices)); }

    /// The tracks of the vehicles so far.
    const FlownTracks &flown() const { return m_flown; }

    /// Fills in vehicles, inspector, fields and totals, and adds `link`, over which the vehicles are heard, with its counters.
    void describe(Snapshot &out, LinkSnapshot link) const;

private:
    struct NextEntry
    {
        tlog::LogItem item;
        Duration at{};
    };

    bool readNext();
    void take(const NextEntry &entry);
    bool passTime(Duration until, std::size_t &most);
    Duration nextDeadline() const;
    void drain(vehicle::Vehicle &vehicle);
    void noteTracks(TimePoint now, Duration at);

    tlog::LogReader m_reader;
    tlog::LogTime m_log;
    Notify m_notify;
    StationConfig m_config;
    Fleet m_fleet;
    FlownTracks m_flown;
    std::uint64_t m_frames = 0, m_bytes = 0, m_damaged = 0;
    std::optional<NextEntry> m_next;
    Duration m_position{};
    Duration m_frameAt{};    ///< position of the newest frame
    Duration m_nextSample{}; ///< of the readings four times a second
    Duration m_deadlineAt{}; ///< when deadlines were handled last
    std::optional<WallTime> m_wall;
    bool m_over = false, m_hasFrame = false;
};

} // namespace skyseal::engine
