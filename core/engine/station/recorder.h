// Writes the .tlog of a flight: every frame with its time, as ground stations have always kept them. A slow or full disk
// must never hold up a flight, so the I/O thread only copies into a bounded buffer, and a thread of the recorder's own
// writes it out five times a second and makes it durable once a second: a crash costs no more than the last second.
//
// record(), snapshot() and takeProblem() are called from one thread (I/O); the file is touched by the writer thread alone.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/engine/station/snapshot.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace skyseal::engine {

class Recorder
{
public:
    /// Begins a file in `folder`, named by the time in UTC, with the first frame; the folder is made when it is missing.
    explicit Recorder(std::string folder, std::size_t bufferBytes = 4u << 20);
    /// Writes out what waits and closes the file.
    ~Recorder();
    Recorder(const Recorder &) = delete;
    Recorder &operator=(const Recorder &) = delete;

    void record(WallTime time, ByteView frame);
    RecordingSnapshot snapshot() const;
    /// A problem that was not told yet: what could not be written and why, in the system's words.
    std::optional<RecordingSnapshot> takeProblem();

private:
    struct File;

    void run();
    void write(File &file, ByteView bytes, std::uint64_t frames);
    void fail(File &file, const char *what);

    const std::string m_folder;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    Bytes m_filling; ///< capacity is fixed; what does not fit is dropped and counted
    std::uint64_t m_fillingFrames = 0;
    RecordingSnapshot m_status;
    bool m_problemPending = false;
    bool m_stop = false;
    std::thread m_writer;
};

} // namespace skyseal::engine
