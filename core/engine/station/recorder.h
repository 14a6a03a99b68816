// Writes the .tlog of a flight: every frame with its time, in the common format of ground stations. A slow or full disk must
// never delay the flight, so the I/O thread only copies into a bounded buffer. The recorder's own thread writes it to the file
// five times a second and syncs the file once a second, so that a crash loses at most the last second. The cipher suites of
// the links, of which the frames say nothing, go into a file beside it (core/log/link_events.h).
//
// record(), note(), snapshot() and takeProblem() are called from one thread (I/O); the files are touched by the writer thread
// alone.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/engine/station/recording_snapshot.h"
#include "core/log/link_events.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace skyseal::engine {

class Recorder
{
public:
    /// Space that is left free, since a full disk affects more than the recording.
    static constexpr std::uint64_t kLeaveFree = 256u << 20;

    /// The first frame starts a file in `folder`, named after the time in UTC; a missing folder is created. If it cannot be,
    /// that is a problem at once. Recording stops with a problem when less than `leaveFree` bytes are free there, and continues
    /// in another file when there is room again.
    explicit Recorder(std::string folder, std::size_t bufferBytes = 4u << 20, std::uint64_t leaveFree = kLeaveFree);
    /// Writes the buffer and closes the file.
    ~Recorder();
    Recorder(const Recorder &) = delete;
    Recorder &operator=(const Recorder &) = delete;

    void record(WallTime time, ByteView frame);
    /// Before the first frame only the newest event of each peer counts: it stands at the beginning of the recording.
    void note(tlog::LinkEvent event);
    RecordingSnapshot snapshot() const;
    /// Returns a problem that was not returned before, with the system's error text.
    std::optional<RecordingSnapshot> takeProblem();

private:
    struct Files;

    void run();
    void write(Files &files, ByteView bytes, std::uint64_t frames);
    bool writeTo(Files &files, ByteView bytes);
    bool hasRoom() const;
    int folderError() const;
    void fail(Files &files, const Reason &problem);

    const std::string m_folder;
    const std::uint64_t m_leaveFree;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    Bytes m_filling; ///< of fixed capacity; frames that do not fit are dropped and counted
    std::uint64_t m_fillingFrames = 0;
    std::vector<tlog::LinkEvent> m_noted; ///< not yet taken by the writer
    RecordingSnapshot m_status;
    std::optional<RecordingSnapshot> m_problem; ///< not yet taken
    bool m_stop = false;
    std::thread m_writer;
};

} // namespace skyseal::engine
