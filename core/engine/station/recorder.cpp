#include "core/engine/station/recorder.h"

#include "core/base/byte_writer.h"
#include "core/engine/station/link_event_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <utility>

#include <unistd.h>

namespace skyseal::engine {

namespace {

constexpr auto kWriteEvery = std::chrono::milliseconds(200);
constexpr auto kSyncEvery = std::chrono::seconds(1);
constexpr auto kRetryAfter = std::chrono::seconds(10);
constexpr std::size_t kTimeLength = 8;
constexpr std::size_t kMostWaiting = 1000; ///< link events that a slow disk keeps in memory

constexpr Sentence kCannotCreate = sentence("Reason", "cannot be created: %1");
constexpr Sentence kCannotWrite = sentence("Reason", "cannot be written: %1");
constexpr Sentence kNoRoom = sentence("Reason", "less than %1 MiB are free there");

std::string nameByTime()
{
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char out[32];
    std::strftime(out, sizeof out, "%Y-%m-%dT%H-%M-%SZ", &utc);
    return out;
}

} // namespace

/// Used by the writer thread alone.
struct Recorder::Files
{
    using Clock = std::chrono::steady_clock;

    RecordingFile log;
    LinkEventFile events;
    Clock::time_point synced{};
    Clock::time_point retry{};

    bool openIn(const std::string &folder)
    {
        const std::string stem = folder + "/" + nameByTime();
        for (int copy = 1; copy < 100; ++copy) {
            const std::string name = stem + (copy > 1 ? "-" + std::to_string(copy) : "") + ".tlog";
            if (log.create(name)) {
                events.begin(name);
                return true;
            }
            if (errno != EEXIST)
                break;
        }
        return false;
    }

    void closeAfterError()
    {
        log.closeAfterError();
        events.end();
    }
};

Recorder::Recorder(std::string folder, std::size_t bufferBytes, std::uint64_t leaveFree)
    : m_folder(std::move(folder)), m_leaveFree(leaveFree)
{
    m_filling.reserve(bufferBytes);
    m_status.active = true;
    m_status.file = m_folder;
    m_writer = std::thread([this] { run(); });
}

Recorder::~Recorder()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_one();
    m_writer.join();
}

void Recorder::record(WallTime time, ByteView frame)
{
    std::array<std::uint8_t, kTimeLength> stamp;
    ByteWriter(stamp).bigEndian(static_cast<std::uint64_t>(time.time_since_epoch().count()));
    const std::lock_guard lock(m_mutex);
    if (m_filling.capacity() - m_filling.size() < stamp.size() + frame.size()) {
        ++m_status.dropped;
        return;
    }
    m_filling.insert(m_filling.end(), stamp.begin(), stamp.end());
    m_filling.insert(m_filling.end(), frame.begin(), frame.end());
    ++m_fillingFrames;
}

void Recorder::note(tlog::LinkEvent event)
{
    const std::lock_guard lock(m_mutex);
    if (m_noted.size() < kMostWaiting)
        m_noted.push_back(std::move(event));
}

RecordingSnapshot Recorder::snapshot() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

std::optional<RecordingSnapshot> Recorder::takeProblem()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_problem, std::nullopt);
}

void Recorder::run()
{
    Files files;
    Bytes writing;
    writing.reserve(m_filling.capacity());
    if (const int error = folderError(); error != 0)
        fail(files, kCannotCreate(std::strerror(error)));
    std::unique_lock lock(m_mutex);
    for (bool last = false; !last;) {
        m_wake.wait_for(lock, kWriteEvery, [this] { return m_stop; });
        last = m_stop;
        writing.clear();
        std::swap(writing, m_filling);
        const std::uint64_t frames = std::exchange(m_fillingFrames, 0);
        const std::vector<tlog::LinkEvent> noted = std::exchange(m_noted, {});
        lock.unlock();
        if (!writing.empty())
            write(files, writing, frames);
        const int error = files.events.add(noted) ? 0 : errno;
        lock.lock();
        if (error != 0 && !m_problem) { // the recording itself goes on
            m_problem = m_status;
            m_problem->file = files.events.name();
            m_problem->problem = kCannotWrite(std::strerror(error));
        }
    }
}

void Recorder::write(Files &files, ByteView bytes, std::uint64_t frames)
{
    const bool written = writeTo(files, bytes);
    const std::lock_guard lock(m_mutex);
    if (!written) {
        m_status.dropped += frames;
        return;
    }
    m_status.file = files.log.name();
    m_status.problem = {};
    m_status.bytes += bytes.size();
    m_status.frames += frames;
}

bool Recorder::writeTo(Files &files, ByteView bytes)
{
    const auto now = Files::Clock::now();
    if (!files.log.isOpen() && now < files.retry)
        return false;
    const bool syncs = now - files.synced >= kSyncEvery;
    if ((!files.log.isOpen() || syncs) && !hasRoom()) {
        fail(files, kNoRoom(m_leaveFree >> 20));
        return false;
    }
    if (!files.log.isOpen() && !files.openIn(m_folder)) {
        fail(files, kCannotCreate(std::strerror(errno)));
        return false;
    }
    if (!files.log.append(bytes)) {
        fail(files, kCannotWrite(std::strerror(errno)));
        return false;
    }
    if (syncs) {
        files.synced = now;
        files.log.sync();
        files.events.sync();
    }
    return true;
}

/// Also creates the folder. An error counts as room, since opening the file reports a better one.
bool Recorder::hasRoom() const
{
    std::error_code error;
    std::filesystem::create_directories(m_folder, error);
    const auto space = std::filesystem::space(m_folder, error);
    return error || space.available >= m_leaveFree;
}

/// Why no file can be created there, without creating the folder; 0 if nothing is known to prevent it.
int Recorder::folderError() const
{
    std::error_code error;
    std::filesystem::path folder = std::filesystem::absolute(m_folder, error);
    while (!std::filesystem::exists(folder, error) && folder.has_relative_path())
        folder = folder.parent_path();
    if (!std::filesystem::is_directory(folder, error))
        return ENOTDIR;
    return ::access(folder.c_str(), W_OK | X_OK) == 0 ? 0 : errno;
}

void Recorder::fail(Files &files, const Reason &problem)
{
    files.closeAfterError();
    files.retry = Files::Clock::now() + kRetryAfter;
    const std::lock_guard lock(m_mutex);
    const bool isNew = !(m_status.problem == problem); // reported once, not every ten seconds
    m_status.file = files.log.name().empty() ? m_folder : files.log.name();
    m_status.problem = problem;
    if (isNew)
        m_problem = m_status;
}

} // namespace skyseal::engine
