#include "core/keys/signing_time_file.h"

#include "core/keys/file_io.h"

#include <charconv>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace skyseal::keys {

static constexpr std::string_view kTimeHeader = "skyseal-signing-time-v1\n";
static constexpr std::uint64_t kGreatestTime = (std::uint64_t(1) << 48) - 1; // signatures have 48 bits for it

Result<std::uint64_t, InputError> parseSigningTime(std::string_view text, const std::string &source)
{
    const auto damaged = [&source] {
        return tl::unexpected(fileError(source, "is not a file of signing times of Skyseal, or is damaged"));
    };
    if (!text.starts_with(kTimeHeader) || !text.ends_with('\n'))
        return damaged();
    text.remove_prefix(kTimeHeader.size());
    if (text.empty())
        return damaged();
    text.remove_suffix(1);
    std::uint64_t time = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
    if (error != std::errc() || end != text.data() + text.size() || time > kGreatestTime)
        return damaged();
    return time;
}

std::string signingTimeText(std::uint64_t time)
{
    return std::string(kTimeHeader) + std::to_string(time) + "\n";
}

/// State shared by both threads.
class SigningTimeFile::Writer
{
public:
    Writer(std::uint64_t stored, Write write, std::string name)
        : m_write(std::move(write)), m_name(std::move(name)), m_wanted(stored), m_stored(stored)
    {}

    /// The other thread.
    void run()
    {
        std::unique_lock lock(m_mutex);
        while (!m_stop || (isBehind() && m_error.empty())) {
            if (!isBehind()) {
                m_wake.wait(lock, [this] { return m_stop || isBehind(); });
                continue;
            }
            const std::uint64_t time = m_wanted;
            m_began = std::chrono::steady_clock::now();
            m_busy = true;
            lock.unlock();
            const auto written = m_write(time);
            lock.lock();
            m_busy = false;
            m_error = written ? std::string() : written.error().text();
            if (written)
                m_stored = time;
            else
                m_wake.wait_for(lock, kRetryAfter, [this] { return m_stop; });
        }
        m_ended = true;
        m_idle.notify_all();
    }

    void store(std::uint64_t time)
    {
        const std::lock_guard lock(m_mutex);
        if (time <= m_wanted)
            return;
        m_wanted = time;
        m_wake.notify_one();
    }

    std::string problem() const
    {
        const std::lock_guard lock(m_mutex);
        if (m_busy && std::chrono::steady_clock::now() - m_began >= kPatience)
            return m_name + ": the disk does not answer";
        return m_error;
    }

    /// Returns false if the disk does not answer.
    bool end()
    {
        std::unique_lock lock(m_mutex);
        m_stop = true;
        m_wake.notify_one();
        return m_idle.wait_for(lock, kPatience, [this] { return m_ended; });
    }

    std::thread thread;

private:
    bool isBehind() const { return m_wanted > m_stored; }

    const Write m_write;
    const std::string m_name;
    mutable std::mutex m_mutex; ///< of all that follows
    std::condition_variable m_wake, m_idle;
    std::uint64_t m_wanted, m_stored;
    std::string m_error; ///< of the last write
    bool m_stop = false, m_ended = false, m_busy = false;
    std::chrono::steady_clock::time_point m_began; ///< the write, while busy
};

Result<std::unique_ptr<SigningTimeFile>, InputError> SigningTimeFile::open(const std::string &path)
{
    std::uint64_t stored = 0;
    if (fileExists(path)) {
        const auto content = readFile(path, FileAccess::Trusted);
        if (!content)
            return tl::unexpected(content.error());
        const auto time = parseSigningTime(asText(*content), path);
        if (!time)
            return tl::unexpected(time.error());
        stored = *time;
    }
    return std::make_unique<SigningTimeFile>(
        stored, [path](std::uint64_t time) { return replaceFile(path, asBytes(signingTimeText(time))); }, path);
}

SigningTimeFile::SigningTimeFile(std::uint64_t stored, Write write, std::string name)
    : m_storedAtStart(stored), m_writer(std::make_shared<Writer>(stored, std::move(write), std::move(name)))
{
    m_writer->thread = std::thread([writer = m_writer] { writer->run(); });
}

SigningTimeFile::~SigningTimeFile()
{
    if (m_writer->end())
        m_writer->thread.join();
    else
        m_writer->thread.detach();
}

void SigningTimeFile::store(std::uint64_t time)
{
    m_writer->store(time);
}

std::string SigningTimeFile::problem() const
{
    return m_writer->problem();
}

} // namespace skyseal::keys
