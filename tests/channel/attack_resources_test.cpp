// Attacks over a long time: memory does not grow with the number of records and handshakes. A hundred thousand records and
// a thousand handshakes here; ten million and ten thousand with the label slow.
#include "attack.h"
#include "core/crypto/init_crypto.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <cstdio>

#include <malloc.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;

class AttackResourcesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void records();
    void handshakes();
};

#ifdef __SANITIZE_ADDRESS__
extern "C" std::size_t __sanitizer_get_current_allocated_bytes(); // of its allocator_interface.h, which GCC does not install
#endif

namespace {

struct Memory
{
    std::size_t allocated = 0; ///< bytes that are allocated and not freed
    std::size_t resident = 0;  ///< bytes
};

Memory memoryNow()
{
    unsigned long size = 0, resident = 0;
    std::FILE *file = std::fopen("/proc/self/statm", "r");
    if (!file || std::fscanf(file, "%lu %lu", &size, &resident) != 2)
        qFatal("no /proc/self/statm");
    std::fclose(file);
    Memory now{0, resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))};
#ifdef __SANITIZE_ADDRESS__
    now.allocated = __sanitizer_get_current_allocated_bytes();
#else
    const struct mallinfo2 info = ::mallinfo2();
    now.allocated = info.uordblks + info.hblkhd;
#endif
    return now;
}

/// Allocated memory varies by the queues of the simulation only; resident memory, where it is meaningful, by the reserve of the
/// allocator. A sanitizer delays the release of freed memory.
bool isAsBefore(const Memory &before, const Memory &now)
{
    qInfo("allocated %zu bytes, then %zu; resident %zu kB, then %zu kB", before.allocated, now.allocated,
          before.resident / 1024, now.resident / 1024);
    constexpr std::size_t kQueues = 16 * 1024;
#ifdef __SANITIZE_ADDRESS__
    constexpr std::size_t kAllocators = SIZE_MAX / 2;
#else
    constexpr std::size_t kAllocators = 256 * 1024;
#endif
    return now.allocated <= before.allocated + kQueues && now.resident <= before.resident + kAllocators;
}

int countOr(const char *variable, int usual)
{
    const int asked = qEnvironmentVariableIntValue(variable);
    return asked > 0 ? asked : usual;
}

} // namespace

void AttackResourcesTest::records()
{
    const int records = countOr("SKYSEAL_RECORDS", 100'000);
    PairOptions options = attackOptions();
    options.timing.rekeyAfterRecords = static_cast<std::uint32_t>(records / 200); // dozens of epochs
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const Bytes frame(40, 0xfd);
    Bytes record(frame.size() + kMaxRecordOverhead);
    std::uint64_t delivered = 0;
    Memory before;
    for (int i = 0; i < records; ++i) {
        const Side from = i & 1 ? Ground : Air;
        const auto size = pair.ends[from].seal(pair.now, frame, record);
        QVERIFY(size);
        const Path path = pair.pathOf(from);
        delivered += pair.ends[from == Air ? Ground : Air]
                         .handleDatagram(pair.now, path, MutableByteView(record).first(*size))
                         .has_value();
        if (i % std::max(records / 1000, 1) == 0) { // time for the control records
            pair.run(25ms);
            pair.ground().events.clear();
            pair.air().events.clear();
        }
        if (i == records / 4)
            before = memoryNow();
    }
    const Memory after = memoryNow();
    QCOMPARE(delivered, static_cast<std::uint64_t>(records));
    qInfo("epoch %u", static_cast<unsigned>(pair.air().sessionInfo()->epoch));
    HOLDS(isAsBefore(before, after), "memory is what it was");
}

void AttackResourcesTest::handshakes()
{
    const int handshakes = countOr("SKYSEAL_HANDSHAKES", 1'000);
    Pair pair(attackOptions());
    Memory before;
    for (int i = 0; i < handshakes; ++i) {
        QVERIFY(pair.run(6s, [&] { return pair.ground().up() && pair.air().all<SessionUp>().size() == 1; }));
        for (auto &end : pair.ends)
            end.events.clear();
        pair.kill(Ground);
        pair.start(Ground);
        if (i == handshakes / 4)
            before = memoryNow();
    }
    HOLDS(isAsBefore(before, memoryNow()), "memory is what it was");
}

SKYSEAL_TEST(AttackResourcesTest)
#include "attack_resources_test.moc"
