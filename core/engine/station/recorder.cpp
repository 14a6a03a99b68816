#include "core/engine/station/recorder.h"

#include "core/base/byte_writer.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace skyseal::engine {

namespace {

constexpr auto kWriteEvery = std::chrono::milliseconds(200);
constexpr auto kSyncEvery = std::chrono::seconds(1);
constexpr auto kRetryAfter = std::chrono::seconds(10);
constexpr std::size_t kTimeLength = 8;

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
struct Recorder::File
{
    using Clock = std::chrono::steady_clock;

    int fd = -1;
    std::string name;
    std::uint64_t size = 0; ///< of whole entries
    Clock::time_point synced{};
    Clock::time_point retry{};

    ~File()
    {
        if (fd >= 0) {
            fdatasync(fd);
            close(fd);
        }
    }

    bool openIn(const std::string &folder)
    {
        size = 0;
        const std::string stem = folder + "/" + nameByTime();
        for (int copy = 1; copy < 100; ++copy) {
            name = stem + (copy > 1 ? "-" + std::to_string(copy) : "") + ".tlog";
            // Readable by the owner only: the file contains in clear the data that the link protects, such as positions.
            fd = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
            if (fd >= 0 || errno != EEXIST)
                break;
        }
        return fd >= 0;
    }

    /// Removes an empty file and an incomplete entry.
    void closeAfterError()
    {
        if (fd < 0)
            return;
        if (size == 0)
            unlink(name.c_str());
        else
            static_cast<void>(ftruncate(fd, static_cast<off_t>(size)) == 0);
        close(std::exchange(fd, -1));
    }

    bool writeAll(ByteView bytes)
    {
        const std::uint64_t after = size + bytes.size();
        while (!bytes.empty()) {
            const ssize_t done = ::write(fd, bytes.data(), bytes.size());
            if (done < 0 && errno == EINTR)
                continue;
            if (done <= 0)
                return false;
            bytes = bytes.subspan(static_cast<std::size_t>(done));
        }
        size = after;
        return true;
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

RecordingSnapshot Recorder::snapshot() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

std::optional<RecordingSnapshot> Recorder::takeProblem()
{
    const std::lock_guard lock(m_mutex);
    if (!m_problemPending)
        return std::nullopt;
    m_problemPending = false;
    return m_status;
}

void Recorder::run()
{
    File file;
    Bytes writing;
    writing.reserve(m_filling.capacity());
    std::unique_lock lock(m_mutex);
    for (bool last = false; !last;) {
        m_wake.wait_for(lock, kWriteEvery, [this] { return m_stop; });
        last = m_stop;
        writing.clear();
        std::swap(writing, m_filling);
        const std::uint64_t frames = std::exchange(m_fillingFrames, 0);
        lock.unlock();
        if (!writing.empty())
            write(file, writing, frames);
        lock.lock();
    }
}

void Recorder::write(File &file, ByteView bytes, std::uint64_t frames)
{
    const bool written = writeTo(file, bytes);
    const std::lock_guard lock(m_mutex);
    if (!written) {
        m_status.dropped += frames;
        return;
    }
    m_status.file = file.name;
    m_status.problem.clear();
    m_status.bytes += bytes.size();
    m_status.frames += frames;
}

bool Recorder::writeTo(File &file, ByteView bytes)
{
    const auto now = File::Clock::now();
    if (file.fd < 0 && now < file.retry)
        return false;
    const bool syncs = now - file.synced >= kSyncEvery;
    if ((file.fd < 0 || syncs) && !hasRoom()) {
        fail(file, "less than " + std::to_string(m_leaveFree >> 20) + " MiB are free there");
        return false;
    }
    if (file.fd < 0 && !file.openIn(m_folder)) {
        fail(file, std::string("cannot be created: ") + std::strerror(errno));
        return false;
    }
    if (!file.writeAll(bytes)) {
        fail(file, std::string("cannot be written: ") + std::strerror(errno));
        return false;
    }
    if (syncs) {
        file.synced = now;
        fdatasync(file.fd);
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

void Recorder::fail(File &file, const std::string &problem)
{
    file.closeAfterError();
    file.retry = File::Clock::now() + kRetryAfter;
    const std::lock_guard lock(m_mutex);
    // Reported once, not every ten seconds.
    m_problemPending = m_problemPending || m_status.problem != problem;
    m_status.file = file.name.empty() ? m_folder : file.name;
    m_status.problem = problem;
}

} // namespace skyseal::engine
