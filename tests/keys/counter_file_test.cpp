// Counters on disk never repeat, with killed processes and with several processes.
#include "core/channel/handshake_payload.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/counter_file.h"
#include "core/keys/file_io.h"
#include "tests/support/test_runner.h"

#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;

namespace {

/// The next number, once it is stored.
std::uint64_t numberFrom(FileCounterStore &store)
{
    std::optional<std::uint64_t> number = store.next();
    for (; !number; number = store.next())
        store.waitUntilStored();
    return *number;
}

} // namespace

class CounterFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void countsOverRestarts();
    void blocksAreReservedAhead();
    void twoProgramsNeverShareANumber();
    void killedInTheMiddleNeverRepeats();
    void skipsAhead();
    void remembersPeers();
    void refusesDamagedFiles();
    void lockedFileHoldsNothingUp();
    void survivesAFullOrReadOnlyDisk();
    void hangingDiskHoldsNothingUp();
    void hangingDiskDelaysNeitherStartNorEnd();
    void fileThatCannotBeWrittenIsUsedAsItIs();
    void fileThatCannotBeCreatedIsMadeLater();

private:
    test::TemporaryFolder m_folder;
};

void CounterFileTest::countsOverRestarts()
{
    const std::string path = m_folder.path("counters");
    std::uint64_t last = 0;
    for (int run = 0; run < 5; ++run) {
        const auto store = FileCounterStore::open(path);
        QVERIFY(store.has_value());
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t number = numberFrom(**store);
            QVERIFY(number > last);
            last = number;
        }
    }
    QCOMPARE(last, 4 * FileCounterStore::kBlock + 3); // a restart skips the rest of its block
    QCOMPARE(numberFrom(**FileCounterStore::open(m_folder.path("later"), 10000)), std::uint64_t(10000));
    QCOMPARE(numberFrom(**FileCounterStore::open(path, 10000)), std::uint64_t(10000)); // at least the given start
}

/// The file changes once in a block, before the block is needed, so that no number waits for it.
void CounterFileTest::blocksAreReservedAhead()
{
    const std::string path = m_folder.path("ahead");
    const auto store = std::move(*FileCounterStore::open(path));
    const auto reserved = [&path] { return StoredCounters::parse(test::readText(path), path)->next; };
    const std::uint64_t first = *store->next();
    QCOMPARE(reserved(), first + FileCounterStore::kBlock);
    std::uint64_t last = first;
    for (std::uint64_t i = 2; i <= 10 * FileCounterStore::kBlock; ++i) {
        const auto number = store->next();
        QVERIFY2(number == last + 1, std::to_string(i).c_str());
        last = *number;
        QVERIFY(last < reserved());
        if (i % (FileCounterStore::kBlock / 2) == 0)
            store->waitUntilStored();
    }
    QVERIFY(reserved() <= last + 2 * FileCounterStore::kBlock);
}

void CounterFileTest::twoProgramsNeverShareANumber()
{
    const std::string path = m_folder.path("shared");
    const auto one = std::move(*FileCounterStore::open(path));
    const auto other = std::move(*FileCounterStore::open(path));
    std::set<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < 3 * FileCounterStore::kBlock; ++i) {
        for (FileCounterStore *store : {one.get(), other.get()})
            QVERIFY(numbers.insert(numberFrom(*store)).second);
    }
    // One that is behind for the other end takes numbers above all others.
    const std::uint64_t greatest = *numbers.rbegin();
    for (FileCounterStore *store : {one.get(), other.get()}) {
        store->skipTo(greatest);
        const std::uint64_t number = numberFrom(*store);
        QVERIFY(number > greatest && numbers.insert(number).second);
    }
    channel::PublicKey peer{};
    QVERIFY(one->remember(peer, 5) && other->remember(peer, 3));
    QVERIFY(one->waitUntilStored().message.empty() && other->waitUntilStored().message.empty());
    QCOMPARE((*FileCounterStore::open(path))->lastSeen(peer), std::uint64_t(5));
}

/// A child process counts and reports each number through a pipe until SIGKILL; later numbers must be greater.
void CounterFileTest::killedInTheMiddleNeverRepeats()
{
    const std::string path = m_folder.path("killed");
    std::uint64_t last = 0;
    for (int round = 0; round < 20; ++round) {
        int ends[2];
        QCOMPARE(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const auto store = FileCounterStore::open(path);
            while (store) {
                const std::uint64_t number = numberFrom(**store);
                if (::write(ends[1], &number, sizeof number) != sizeof number)
                    break;
            }
            ::_exit(1);
        }
        ::close(ends[1]);
        std::uint64_t number = 0;
        for (int i = 0; i <= round % 7; ++i) {
            QCOMPARE(::read(ends[0], &number, sizeof number), ssize_t(sizeof number));
            QVERIFY(number > last);
            last = number;
        }
        ::kill(child, SIGKILL);
        while (::read(ends[0], &number, sizeof number) == ssize_t(sizeof number)) { // numbers reported before the kill
            QVERIFY(number > last);
            last = number;
        }
        ::close(ends[0]);
        QCOMPARE(::waitpid(child, nullptr, 0), child);
    }
    const auto store = FileCounterStore::open(path);
    QVERIFY2(store.has_value(), store ? "" : store.error().text().c_str());
    QVERIFY(numberFrom(**store) > last);
}

void CounterFileTest::skipsAhead()
{
    const std::string path = m_folder.path("skipping");
    auto store = std::move(*FileCounterStore::open(path));
    QVERIFY(store->skipTo(1000)); // within the block
    QCOMPARE(store->next(), std::optional<std::uint64_t>(1001));
    QVERIFY(store->skipTo(5)); // never decreases
    QCOMPARE(store->next(), std::optional<std::uint64_t>(1002));
    store->waitUntilStored();
    QVERIFY(!store->skipTo(1'000'000)); // in a block that has to be reserved
    QCOMPARE(numberFrom(*store), std::uint64_t(1'000'001));
    QVERIFY(!store->skipTo(~std::uint64_t(0)));
    QVERIFY(numberFrom(*store) > channel::kGreatestCounter);
    store.reset();
    QVERIFY(numberFrom(**FileCounterStore::open(path)) > channel::kGreatestCounter);
}

void CounterFileTest::remembersPeers()
{
    const std::string path = m_folder.path("seen");
    channel::PublicKey one{};
    channel::PublicKey other{};
    other[0] = 1;
    {
        const auto store = FileCounterStore::open(path);
        QCOMPARE((*store)->lastSeen(one), std::uint64_t(0));
        QVERIFY((*store)->remember(one, 17) && (*store)->remember(other, ~std::uint64_t(0)));
        QVERIFY((*store)->remember(one, 4));
        QCOMPARE((*store)->lastSeen(one), std::uint64_t(17)); // never decreases
    }
    const auto store = FileCounterStore::open(path);
    QCOMPARE((*store)->lastSeen(one), std::uint64_t(17));
    QCOMPARE((*store)->lastSeen(other), ~std::uint64_t(0));
    // A number that was stored outlives a kill.
    (*store)->remember(one, 18);
    QVERIFY((*store)->waitUntilStored().message.empty());
    QCOMPARE(StoredCounters::parse(test::readText(path), path)->seen.at(one), std::uint64_t(18));
}

void CounterFileTest::refusesDamagedFiles()
{
    const std::string key(64, 'a');
    const std::string good = "skyseal-counters-v1\nnext 12\nseen " + key + " 34\n";
    QVERIFY(StoredCounters::parse(good, "f").has_value());
    QCOMPARE(StoredCounters::parse(good, "f")->text(), good);
    for (std::size_t size = 0; size < good.size(); ++size) {
        const auto cut = StoredCounters::parse(good.substr(0, size), "f");
        QVERIFY2(!cut || good.substr(0, size).ends_with("next 12\n"), std::to_string(size).c_str());
    }
    for (const char *bad :
         {"next -1", "next 18446744073709551616", "next 1x", "next ", "next 1\nnext 2", "seen 12 3", "what 1"})
        QVERIFY2(!StoredCounters::parse(std::string("skyseal-counters-v1\n") + bad + "\n", "f"), bad);
    const auto refused = FileCounterStore::open(m_folder.write("damaged", "skyseal-counters-v1\nnext 1\nseen\n"));
    QVERIFY(!refused && refused.error().line == 3);
    QVERIFY(!FileCounterStore::open(m_folder.path("no/such/folder")));
}

void CounterFileTest::lockedFileHoldsNothingUp()
{
    using Clock = std::chrono::steady_clock;
    const std::string path = m_folder.path("locked");
    auto store = std::move(*FileCounterStore::open(path));
    auto lock = std::optional(std::move(*FileLock::take(path)));
    // A file that another program keeps locked is an error after a while, with the reason.
    const auto begun = Clock::now();
    const auto refused = FileLock::take(path, std::chrono::milliseconds(50));
    QVERIFY(!refused && Clock::now() - begun >= std::chrono::milliseconds(50));
    QVERIFY2(refused.error().text().find("locked by another program") != std::string::npos, refused.error().text().c_str());
    // Meanwhile the thread of the endpoint does not wait.
    const auto counted = Clock::now();
    std::uint64_t last = 0;
    for (std::uint64_t i = 0; i < FileCounterStore::kBlock; ++i) {
        const auto number = store->next();
        QVERIFY(number && *number > last);
        last = *number;
    }
    QVERIFY(!store->next()); // nothing is used before it is reserved
    QVERIFY(!store->skipTo(100'000));
    QVERIFY(store->remember({}, 7));
    QCOMPARE(store->lastSeen({}), std::uint64_t(7));
    QVERIFY(Clock::now() - counted < FileLock::kPatience);
    lock.reset();
    QVERIFY(numberFrom(*store) > 100'000);
}

void CounterFileTest::survivesAFullOrReadOnlyDisk()
{
    // The folder is gone, as on a disk that fails.
    QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("counters")).toStdString();
    const auto store = std::move(*FileCounterStore::open(path));
    const std::uint64_t before = *store->next();
    QVERIFY(folder.remove());
    QVERIFY(store->remember({}, 1));
    QVERIFY(!store->waitUntilStored().message.empty());
    std::uint64_t last = before;
    for (std::uint64_t i = 0; i < 3 * FileCounterStore::kBlock; ++i) {
        const std::uint64_t number = numberFrom(*store);
        QVERIFY(number > last);
        last = number;
    }
    QCOMPARE(store->lastSeen({}), std::uint64_t(1));
}

void CounterFileTest::hangingDiskHoldsNothingUp()
{
    // A disk that stops to answer after the first block, and a clock that the test moves.
    std::mutex mutex;
    std::condition_variable answers;
    bool hangs = false;
    std::atomic<std::int64_t> second = 0;
    std::atomic<int> updates = 0;
    CounterDisk disk;
    disk.name = "/disk/counters";
    disk.now = [&] { return TimePoint(std::chrono::seconds(second)); };
    disk.read = [] { return Result<StoredCounters, InputError>(StoredCounters()); };
    disk.update = [&](StoredCounters ours, std::uint64_t reserve, bool) {
        ++updates;
        std::unique_lock lock(mutex);
        answers.wait(lock, [&] { return !hangs; });
        ours.next += reserve;
        return Result<StoredCounters, InputError>(std::move(ours));
    };
    const auto store = std::move(*FileCounterStore::open(disk));
    std::uint64_t last = *store->next();
    store->waitUntilStored();
    QCOMPARE(store->problem().text(), std::string());
    {
        const std::lock_guard lock(mutex);
        hangs = true;
    }
    const int before = updates;
    QVERIFY(store->remember({}, 7)); // wakes the thread of the store
    while (updates == before)
        std::this_thread::yield();
    QCOMPARE(store->problem().text(), std::string()); // perhaps it is just slow
    while (const auto number = store->next()) {
        QVERIFY(*number > last);
        last = *number;
    }
    QVERIFY(!store->next());
    second = std::chrono::duration_cast<std::chrono::seconds>(FileCounterStore::kSlow).count();
    QCOMPARE(store->problem().text(), std::string("/disk/counters: the disk does not answer"));
    for (std::uint64_t i = 0; i < 3 * FileCounterStore::kBlock; ++i) { // goes on in memory
        const auto number = store->next();
        QVERIFY(number && *number > last);
        last = *number;
    }
    QVERIFY(store->remember({}, 8));
    QCOMPARE(store->lastSeen({}), std::uint64_t(8));
    {
        const std::lock_guard lock(mutex);
        hangs = false;
    }
    answers.notify_all();
    QVERIFY(store->waitUntilStored().message.empty());
    QCOMPARE(store->problem().text(), std::string());
    const auto number = store->next();
    QVERIFY(number && *number > last);
}

void CounterFileTest::hangingDiskDelaysNeitherStartNorEnd()
{
    // The store's thread is still in the disk's functions when the test is over.
    struct Hang
    {
        std::mutex mutex;
        std::condition_variable over;
        bool hangs = true;
        std::atomic<std::int64_t> looks = 0;
    };
    const auto hang = std::make_shared<Hang>();
    CounterDisk disk;
    disk.name = "/disk/counters";
    disk.now = [hang] { return TimePoint(std::chrono::seconds(++hang->looks)); };
    disk.read = [] { return Result<StoredCounters, InputError>(StoredCounters()); };
    disk.update = [hang](StoredCounters ours, std::uint64_t reserve, bool) {
        std::unique_lock lock(hang->mutex);
        hang->over.wait(lock, [&] { return !hang->hangs; });
        ours.next += reserve;
        return Result<StoredCounters, InputError>(std::move(ours));
    };
    const auto set = [&hang](bool hangs) {
        {
            const std::lock_guard lock(hang->mutex);
            hang->hangs = hangs;
        }
        hang->over.notify_all();
    };
    const auto refused = FileCounterStore::open(disk);
    QVERIFY(!refused);
    QCOMPARE(refused.error().text(), std::string("/disk/counters: the disk does not answer"));

    set(false);
    auto store = std::move(*FileCounterStore::open(disk));
    QVERIFY(store->waitUntilStored().message.empty());
    set(true);
    QVERIFY(store->remember({}, 7));
    store.reset();
    set(false);
}

void CounterFileTest::fileThatCannotBeWrittenIsUsedAsItIs()
{
    StoredCounters stored;
    stored.next = 5000;
    stored.seen[channel::PublicKey{}] = 17;
    CounterDisk disk;
    disk.now = [] { return TimePoint(); };
    disk.read = [&] { return Result<StoredCounters, InputError>(stored); };
    disk.update = [](StoredCounters, std::uint64_t, bool) -> Result<StoredCounters, InputError> {
        return tl::unexpected(InputError{"Read-only file system", "/disk/counters"});
    };
    const auto store = std::move(*FileCounterStore::open(disk));
    QCOMPARE(store->problem().text(), std::string("/disk/counters: Read-only file system"));
    QCOMPARE(store->lastSeen({}), std::uint64_t(17)); // old first messages stay refused
    QCOMPARE(store->next(), std::optional<std::uint64_t>(5000));
    disk.read = [] { return Result<StoredCounters, InputError>(tl::unexpected(InputError{"is damaged", "/disk/counters"})); };
    disk.isMissing = [] { return false; };
    QVERIFY(!FileCounterStore::open(disk)); // never from the beginning
}

void CounterFileTest::fileThatCannotBeCreatedIsMadeLater()
{
    const std::string path = m_folder.path("not_yet");
    std::atomic<bool> full = true;
    CounterDisk disk = counterDisk(path);
    disk.update = [&full, update = disk.update](StoredCounters ours, std::uint64_t reserve, bool create) {
        return full ? Result<StoredCounters, InputError>(tl::unexpected(InputError{"No space left on device", "counters"}))
                    : update(std::move(ours), reserve, create);
    };
    const auto opened = FileCounterStore::open(disk);
    QVERIFY(opened);
    QCOMPARE((*opened)->problem().text(), std::string("counters: No space left on device"));
    QCOMPARE((*opened)->next(), std::optional<std::uint64_t>(1));
    full = false;
    QVERIFY((*opened)->remember({}, 9)); // tries again at once
    QVERIFY((*opened)->waitUntilStored().message.empty());
    const auto stored = StoredCounters::parse(test::readText(path), path);
    QVERIFY(stored && stored->next > 1);
    QCOMPARE(stored->seen.at({}), std::uint64_t(9));
}

SKYSEAL_TEST_APPLESS(CounterFileTest)
#include "counter_file_test.moc"
