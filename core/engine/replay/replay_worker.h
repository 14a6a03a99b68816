// The thread of a replay: reads the recording, keeps the pace, and builds snapshots. Part of Replay.
#pragma once

#include "core/engine/common/mailbox.h"
#include "core/engine/replay/replay_clock.h"
#include "core/engine/replay/replay_command.h"
#include "core/engine/replay/replayed_flight.h"
#include "core/engine/station/field_reading.h"
#include "core/engine/station/output_queue.h"
#include "core/engine/station/replay_status.h"
#include "core/engine/station/snapshot_pace.h"
#include "core/link/link_url.h"
#include "core/log/log_index.h"

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <atomic>
#include <fstream>
#include <memory>
#include <optional>
#include <variant>

namespace skyseal::engine {

/// post(), stop() and takeOutput() are for the reader's thread, all else runs on the replay's own.
class ReplayWorker : public QObject
{
    Q_OBJECT

public:
    struct Inspecting
    {
        bool on = false;
    };
    struct ChosenFields
    {
        std::vector<FieldChoice> choices;
    };
    /// Ends the thread.
    struct End
    {};
    using Task = std::variant<ReplayCommand, Inspecting, ChosenFields, End>;

    explicit ReplayWorker(const link::LinkUrl &recording);

    void begin();
    void post(const Task &task);
    /// From the reader's thread, before End: whatever is being read ends soon.
    void stop() { m_stopped = true; }
    std::deque<OutputQueue::Item> takeOutput() { return m_output.takeAll(); }

Q_SIGNALS:
    void tasksPosted();
    void outputReady();

private:
    void runTasks();
    void perform(const PlayReplay &);
    void perform(const PauseReplay &);
    void perform(const SetReplaySpeed &command);
    void perform(const SeekReplay &command);
    bool open();
    void fail(const Reason &why);
    void startOver();
    void wake();
    TimePoint nextWake(TimePoint now) const;
    void readIndex();
    void followFlight(TimePoint now, bool arrived);
    void publish(OutputQueue::Item item);
    void publishSnapshot(TimePoint now);
    ReplayStatus status(TimePoint now) const;

    const link::LinkUrl m_recording;
    std::atomic<bool> m_stopped = false;
    Mailbox<Task> m_tasks;
    OutputQueue m_output;
    QTimer *m_timer = nullptr; ///< a child, so that it lives on the thread
    std::ifstream m_file, m_indexFile;
    std::unique_ptr<ReplayedFlight> m_flight; ///< null if the recording cannot be read
    std::unique_ptr<tlog::LogIndexer> m_indexer;
    std::shared_ptr<const tlog::LogIndex> m_index;
    ReplayClock m_clock;
    std::optional<Duration> m_seek; ///< the target, until it is reached
    std::shared_ptr<const FlownTracks> m_flown;
    std::uint64_t m_seeks = 0;
    LinkSnapshot m_link; ///< all but its counters
    SnapshotPace m_pace{30};
    SnapshotPtr m_last;
    TimePoint m_start{};
    bool m_inspecting = false;
    std::vector<FieldChoice> m_fields;
};

} // namespace skyseal::engine
