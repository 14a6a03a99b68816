#include "core/keys/counter_file.h"

#include "core/base/hex.h"
#include "core/keys/file_io.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

namespace skyseal::keys {

/// Greater numbers are far beyond the last counter of the protocol. The sum of this one and a block does not overflow.
static constexpr std::uint64_t kGreatestCounter = std::uint64_t(1) << 62;

static constexpr std::string_view kCountersHeader = "skyseal-counters-v1";
static constexpr std::string_view kNext = "next ";
static constexpr std::string_view kSeen = "seen ";

static std::optional<std::uint64_t> numberOf(std::string_view text)
{
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

static bool readSeen(std::string_view text, StoredCounters &counters)
{
    static constexpr std::size_t kKeyDigits = 64;
    if (text.size() < kKeyDigits + 2 || text[kKeyDigits] != ' ')
        return false;
    const std::optional<Bytes> bytes = fromHex(text.substr(0, kKeyDigits));
    const std::optional<std::uint64_t> number = numberOf(text.substr(kKeyDigits + 1));
    if (!bytes || !number)
        return false;
    channel::PublicKey key{};
    std::copy(bytes->begin(), bytes->end(), key.begin());
    return counters.seen.emplace(key, *number).second;
}

Result<StoredCounters, InputError> StoredCounters::parse(std::string_view text, const std::string &source)
{
    const auto damaged = [&source](std::size_t line) {
        return tl::unexpected(fileError(source, sentence("Reason", "is not a counter file of Skyseal, or is damaged"), line));
    };
    StoredCounters counters;
    bool hasNext = false;
    // Every line ends with a newline, so that a truncated number is detected.
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos)
            return damaged(number);
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (number == 1) {
            if (line != kCountersHeader)
                return damaged(number);
        } else if (line.starts_with(kNext) && !hasNext) {
            const auto value = numberOf(line.substr(kNext.size()));
            if (!value)
                return damaged(number);
            counters.next = *value;
            hasNext = true;
        } else if (!line.starts_with(kSeen) || !readSeen(line.substr(kSeen.size()), counters)) {
            return damaged(number);
        }
    }
    return hasNext ? Result<StoredCounters, InputError>(std::move(counters)) : damaged(0);
}

std::string StoredCounters::text() const
{
    std::string out(kCountersHeader);
    out.append("\n").append(kNext).append(std::to_string(next)).append("\n");
    for (const auto &[key, number] : seen)
        out.append(kSeen).append(toHex(key)).append(" ").append(std::to_string(number)).append("\n");
    return out;
}

namespace {

Result<StoredCounters, InputError> readCounters(const std::string &path)
{
    const auto content = readFile(path, FileAccess::Trusted);
    if (!content)
        return tl::unexpected(content.error());
    return StoredCounters::parse(asText(*content), path);
}

/// Merges our counters and the changes of other programs, and takes `reserve` numbers. Counters never decrease.
Result<StoredCounters, InputError> updateCounters(const std::string &path, StoredCounters ours, std::uint64_t reserve,
                                                  bool create)
{
    const auto lock = FileLock::take(path);
    if (!lock)
        return tl::unexpected(lock.error());
    if (!create || fileExists(path)) {
        const auto read = readCounters(path);
        if (!read)
            return tl::unexpected(read.error());
        ours.next = std::max(ours.next, std::min(read->next, kGreatestCounter));
        for (const auto &[key, number] : read->seen) {
            std::uint64_t &known = ours.seen[key];
            known = std::max(known, number);
        }
    }
    ours.next += reserve;
    if (const auto written = replaceFile(path, asBytes(ours.text())); !written)
        return tl::unexpected(written.error());
    return ours;
}

} // namespace

CounterDisk counterDisk(const std::string &path)
{
    CounterDisk disk;
    disk.update = [path](StoredCounters ours, std::uint64_t reserve, bool create) {
        return updateCounters(path, std::move(ours), reserve, create);
    };
    disk.read = [path] { return readCounters(path); };
    disk.isMissing = [path] {
        std::error_code error;
        const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
        return !fileExists(path) && std::filesystem::is_directory(folder, error);
    };
    disk.now = [] {
        return TimePoint(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
    };
    disk.name = path;
    return disk;
}

/// The numbers, shared by the endpoint's thread and the store's own.
class FileCounterStore::Shared
{
public:
    Shared(CounterDisk disk, std::uint64_t first) : m_disk(std::move(disk)), m_floor(first) {}

    /// The store's thread.
    void run();
    /// Waits until the file was read; an error if it cannot be used.
    Result<void, InputError> waitUntilOpen();
    /// Ends the thread. Returns false if it waits for a disk that does not answer.
    bool end();

    std::optional<std::uint64_t> next();
    bool skipTo(std::uint64_t counter);
    std::uint64_t lastSeen(const channel::PublicKey &peer) const;
    void remember(const channel::PublicKey &peer, std::uint64_t counter);
    Reason problem() const;
    InputError waitUntilStored();

    std::thread thread;

private:
    /// Numbers from `begin` up to, but not with, `end`.
    struct Block
    {
        std::uint64_t begin = 0, end = 0;
        bool empty() const { return begin >= end; }
        std::uint64_t size() const { return empty() ? 0 : end - begin; }
    };
    enum class Phase { Opening, Open, Failed, Ended };

    bool isIdle() const { return !m_wantsBlock && !m_wantsSeen && !m_busy; }
    bool isSlow() const { return m_busy && m_disk.now() - m_busySince >= kSlow; }
    InputError slowError() const { return {sentence("Reason", "the disk does not answer"), m_disk.name}; }
    template<typename Condition> bool waitFor(std::unique_lock<std::mutex> &lock, Condition condition);
    bool openFile(std::unique_lock<std::mutex> &lock);
    void add(const StoredCounters &stored);
    void update(std::unique_lock<std::mutex> &lock);

    const CounterDisk m_disk;
    mutable std::mutex m_mutex; ///< of all that follows
    std::condition_variable m_wake, m_idle;
    Phase m_phase = Phase::Opening;
    Block m_block;         ///< in use
    Block m_spare;         ///< in use after it
    std::uint64_t m_floor; ///< least number of the next block to be reserved
    std::map<channel::PublicKey, std::uint64_t> m_seen;
    bool m_wantsBlock = true; ///< another block has to be reserved
    bool m_wantsSeen = false; ///< m_seen has to be stored
    bool m_mayCreate = true;  ///< the file was not there so far
    bool m_busy = true;       ///< the file is read or changed
    TimePoint m_busySince = m_disk.now();
    bool m_stop = false;
    InputError m_error; ///< of the last change of the file
};

Result<std::unique_ptr<FileCounterStore>, InputError> FileCounterStore::open(const std::string &path, std::uint64_t first)
{
    return open(counterDisk(path), first);
}

Result<std::unique_ptr<FileCounterStore>, InputError> FileCounterStore::open(CounterDisk disk, std::uint64_t first)
{
    const auto shared = std::make_shared<Shared>(std::move(disk), first);
    std::unique_ptr<FileCounterStore> store(new FileCounterStore(shared));
    shared->thread = std::thread([shared] { shared->run(); });
    if (const auto opened = shared->waitUntilOpen(); !opened)
        return tl::unexpected(opened.error());
    return store;
}

FileCounterStore::~FileCounterStore()
{
    if (m_shared->end())
        m_shared->thread.join();
    else
        m_shared->thread.detach();
}

std::optional<std::uint64_t> FileCounterStore::next()
{
    return m_shared->next();
}

bool FileCounterStore::skipTo(std::uint64_t counter)
{
    return m_shared->skipTo(counter);
}

std::uint64_t FileCounterStore::lastSeen(const channel::PublicKey &peer)
{
    return m_shared->lastSeen(peer);
}

bool FileCounterStore::remember(const channel::PublicKey &peer, std::uint64_t counter)
{
    m_shared->remember(peer, counter);
    return true;
}

Reason FileCounterStore::problem() const
{
    return m_shared->problem();
}

InputError FileCounterStore::waitUntilStored()
{
    return m_shared->waitUntilStored();
}

/// Waits for a change by the store's thread, until the disk has not answered for kSlow. Returns the condition.
template<typename Condition> bool FileCounterStore::Shared::waitFor(std::unique_lock<std::mutex> &lock, Condition condition)
{
    static constexpr std::chrono::milliseconds kLookAtTheClock{20};
    while (!condition() && !isSlow())
        m_idle.wait_for(lock, kLookAtTheClock);
    return condition();
}

Result<void, InputError> FileCounterStore::Shared::waitUntilOpen()
{
    std::unique_lock lock(m_mutex);
    if (!waitFor(lock, [this] { return m_phase != Phase::Opening; }))
        return tl::unexpected(slowError());
    if (m_phase == Phase::Failed)
        return tl::unexpected(m_error);
    return {};
}

bool FileCounterStore::Shared::end()
{
    std::unique_lock lock(m_mutex);
    m_stop = true;
    m_wake.notify_one();
    return waitFor(lock, [this] { return m_phase == Phase::Ended || m_phase == Phase::Failed; });
}

std::optional<std::uint64_t> FileCounterStore::Shared::next()
{
    const std::lock_guard lock(m_mutex);
    if (m_block.empty())
        m_block = std::exchange(m_spare, Block());
    if (m_block.size() <= kBlock / 2 && m_spare.empty()) {
        m_wantsBlock = true;
        m_wake.notify_one();
    }
    if (m_block.empty() && isSlow()) {
        m_block = {m_floor, m_floor + kBlock};
        m_floor = m_block.end;
    }
    if (m_block.empty())
        return std::nullopt;
    return m_block.begin++;
}

bool FileCounterStore::Shared::skipTo(std::uint64_t counter)
{
    const std::lock_guard lock(m_mutex);
    const std::uint64_t from = std::min(counter, kGreatestCounter) + 1;
    for (Block *block : {&m_block, &m_spare})
        block->begin = std::max(block->begin, from);
    if (!m_block.empty() || !m_spare.empty())
        return true;
    m_floor = std::max(m_floor, from);
    m_wantsBlock = true;
    m_wake.notify_one();
    return false;
}

std::uint64_t FileCounterStore::Shared::lastSeen(const channel::PublicKey &peer) const
{
    const std::lock_guard lock(m_mutex);
    const auto found = m_seen.find(peer);
    return found == m_seen.end() ? 0 : found->second;
}

void FileCounterStore::Shared::remember(const channel::PublicKey &peer, std::uint64_t counter)
{
    const std::lock_guard lock(m_mutex);
    std::uint64_t &known = m_seen[peer];
    if (counter > known) {
        known = counter;
        m_wantsSeen = true;
        m_wake.notify_one();
    }
}

Reason FileCounterStore::Shared::problem() const
{
    const std::lock_guard lock(m_mutex);
    if (isSlow())
        return slowError().reason();
    return m_error.message.empty() ? Reason() : m_error.reason();
}

InputError FileCounterStore::Shared::waitUntilStored()
{
    std::unique_lock lock(m_mutex);
    m_idle.wait(lock, [this] { return isIdle(); });
    return m_error;
}

void FileCounterStore::Shared::run()
{
    std::unique_lock lock(m_mutex);
    m_phase = openFile(lock) ? Phase::Open : Phase::Failed;
    m_idle.notify_all();
    if (m_phase == Phase::Failed)
        return;
    const auto isWanted = [this] { return m_stop || m_wantsBlock || m_wantsSeen; };
    for (bool last = false; !last;) {
        if (m_error.message.empty())
            m_wake.wait(lock, isWanted);
        else
            m_wake.wait_for(lock, kRetryAfter, isWanted);
        last = m_stop;
        if (!last || m_wantsSeen || !m_error.message.empty())
            update(lock);
    }
    m_phase = Phase::Ended;
    m_idle.notify_all();
}

/// Returns false if the file cannot be used; m_error says why.
bool FileCounterStore::Shared::openFile(std::unique_lock<std::mutex> &lock)
{
    const std::uint64_t first = m_floor;
    update(lock);
    if (m_error.message.empty())
        return true;
    m_busy = true;
    m_busySince = m_disk.now();
    lock.unlock();
    auto stored = m_disk.read();
    const bool isMissing = !stored && m_disk.isMissing();
    lock.lock();
    m_busy = false;
    m_mayCreate = isMissing;
    if (isMissing)
        stored = StoredCounters(); // as safe as a new file: lost counters recover in the same way
    if (!stored)
        return false;
    add(*stored);
    const std::uint64_t begin = std::max(first, std::min(stored->next, kGreatestCounter));
    m_spare = {begin, begin + kBlock};
    m_floor = m_spare.end;
    return true;
}

/// Takes the accepted numbers of the file.
void FileCounterStore::Shared::add(const StoredCounters &stored)
{
    for (const auto &[key, number] : stored.seen) {
        std::uint64_t &known = m_seen[key];
        known = std::max(known, number);
    }
}

/// Stores what is wanted. Call with the mutex locked; it is free while the disk works.
void FileCounterStore::Shared::update(std::unique_lock<std::mutex> &lock)
{
    const std::uint64_t reserve = m_wantsBlock ? kBlock : 0;
    const StoredCounters ours{std::min(m_floor, kGreatestCounter), m_seen};
    m_wantsSeen = false;
    m_busy = true;
    m_busySince = m_disk.now();
    lock.unlock();
    const auto stored = m_disk.update(ours, reserve, m_mayCreate);
    lock.lock();
    m_busy = false;
    m_error = stored ? InputError() : stored.error();
    if (stored) {
        m_mayCreate = false;
        add(*stored);
    }
    if (reserve > 0) {
        const std::uint64_t end = stored ? stored->next : ours.next + reserve;
        m_spare = {std::max(end - reserve, m_floor), end}; // the floor may have risen meanwhile
        m_floor = std::max(m_floor, end);
        m_wantsBlock = m_spare.empty() && m_floor < kGreatestCounter;
    }
    m_idle.notify_all();
}

} // namespace skyseal::keys
