#include "core/keys/counter_file.h"

#include "core/base/hex.h"
#include "core/base/weakness.h"
#include "core/keys/file_io.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <utility>

namespace skyseal::keys {

/// Greater numbers are far beyond the last counter of the protocol. The sum of this one and a block does not overflow.
static constexpr std::uint64_t kGreatest = std::uint64_t(1) << 62;

static constexpr std::string_view kHeader = "skyseal-counters-v1";
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
        return tl::unexpected(fileError(source, "is not a counter file of Skyseal, or is damaged", line));
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
            if (line != kHeader)
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
    std::string out(kHeader);
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
        ours.next = std::max(ours.next, std::min(read->next, kGreatest));
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
    disk.now = [] {
        return TimePoint(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
    };
    disk.name = path;
    return disk;
}

Result<std::unique_ptr<FileCounterStore>, InputError> FileCounterStore::open(const std::string &path, std::uint64_t first)
{
    return open(counterDisk(path), first);
}

Result<std::unique_ptr<FileCounterStore>, InputError> FileCounterStore::open(CounterDisk disk, std::uint64_t first)
{
    std::unique_ptr<FileCounterStore> store(new FileCounterStore(std::move(disk), first));
    {
        std::unique_lock lock(store->m_mutex);
        store->update(lock, true);
        if (!store->m_error.message.empty()) {
            const auto read = store->m_disk.read();
            if (!read)
                return tl::unexpected(store->m_error);
            store->add(*read);
            const std::uint64_t begin = std::max(first, std::min(read->next, kGreatest));
            store->m_spare = {begin, begin + kBlock};
            store->m_floor = store->m_spare.end;
        }
    }
    store->m_writer = std::thread([opened = store.get()] { opened->run(); });
    return store;
}

FileCounterStore::~FileCounterStore()
{
    if (!m_writer.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_one();
    m_writer.join();
}

std::optional<std::uint64_t> FileCounterStore::next()
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

bool FileCounterStore::skipTo(std::uint64_t counter)
{
    const std::lock_guard lock(m_mutex);
    const std::uint64_t from = std::min(counter, kGreatest) + 1;
    for (Block *block : {&m_block, &m_spare})
        block->begin = std::max(block->begin, from);
    if (!m_block.empty() || !m_spare.empty())
        return true;
    m_floor = std::max(m_floor, from);
    m_wantsBlock = true;
    m_wake.notify_one();
    return false;
}

std::uint64_t FileCounterStore::lastSeen(const channel::PublicKey &peer)
{
    const std::lock_guard lock(m_mutex);
    const auto found = m_seen.find(peer);
    return found == m_seen.end() ? 0 : found->second;
}

bool FileCounterStore::remember(const channel::PublicKey &peer, std::uint64_t counter)
{
    const std::lock_guard lock(m_mutex);
    std::uint64_t &known = m_seen[peer];
    if (counter > known) {
        known = counter;
        m_wantsSeen = true;
        m_wake.notify_one();
    }
    return true;
}

std::string FileCounterStore::problem() const
{
    const std::lock_guard lock(m_mutex);
    if (isSlow())
        return InputError{"the disk does not answer", m_disk.name}.text();
    return m_error.message.empty() ? std::string() : m_error.text();
}

InputError FileCounterStore::waitUntilStored()
{
    std::unique_lock lock(m_mutex);
    m_idle.wait(lock, [this] { return isIdle(); });
    return m_error;
}

void FileCounterStore::run()
{
    std::unique_lock lock(m_mutex);
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
}

/// Takes the accepted numbers of the file.
void FileCounterStore::add(const StoredCounters &stored)
{
    for (const auto &[key, number] : stored.seen) {
        std::uint64_t &known = m_seen[key];
        known = std::max(known, number);
    }
}

/// Stores what is wanted. Call with the mutex locked; it is free while the disk works.
void FileCounterStore::update(std::unique_lock<std::mutex> &lock, bool create)
{
    const std::uint64_t reserve = m_wantsBlock ? weakened(Weakness::CountersOneByOne) ? 1 : kBlock : 0;
    const StoredCounters ours{std::min(m_floor, kGreatest), m_seen};
    m_wantsSeen = false;
    m_busy = true;
    m_busySince = m_disk.now();
    lock.unlock();
    const auto stored = m_disk.update(ours, reserve, create);
    lock.lock();
    m_busy = false;
    m_error = stored ? InputError() : stored.error();
    if (stored)
        add(*stored);
    if (reserve > 0) {
        const std::uint64_t end = stored ? stored->next : ours.next + reserve;
        m_spare = {std::max(end - reserve, m_floor), end}; // the floor may have risen meanwhile
        m_floor = std::max(m_floor, end);
        m_wantsBlock = m_spare.empty() && m_floor < kGreatest;
    }
    m_idle.notify_all();
}

} // namespace skyseal::keys
