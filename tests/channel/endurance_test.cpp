// An attacker who has time: ten million records and ten thousand handshakes leave the memory as it was.
#include "attack.h"
#include "core/crypto/init_crypto.h"

#include <cstdio>

#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;

class EnduranceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void tenMillionRecords();
    void tenThousandHandshakes();
};

namespace {

std::size_t residentBytes()
{
    unsigned long size = 0, resident = 0;
    std::FILE *file = std::fopen("/proc/self/statm", "r");
    if (!file || std::fscanf(file, "%lu %lu", &size, &resident) != 2)
        qFatal("no /proc/self/statm");
    std::fclose(file);
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

constexpr std::size_t kNoise = 256 * 1024; ///< what an allocator may keep for itself

int countOr(const char *variable, int usual)
{
    const int asked = qEnvironmentVariableIntValue(variable);
    return asked > 0 ? asked : usual;
}

} // namespace

void EnduranceTest::tenMillionRecords()
{
    const int records = countOr("SKYSEAL_RECORDS", 10'000'000);
    PairOptions options = attackOptions();
    options.timing.rekeyAfterRecords = 1u << 18; // some forty epochs
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const Bytes frame(40, 0xfd);
    Bytes record(frame.size() + kMaxRecordOverhead);
    std::uint64_t delivered = 0;
    std::size_t before = 0;
    for (int i = 0; i < records; ++i) {
        const Side from = i & 1 ? Ground : Air;
        const auto size = pair.ends[from].endpoint->seal(pair.now, pair.ends[from].session(), frame, record);
        QVERIFY(size);
        const Path path = pair.pathOf(from);
        delivered += pair.ends[from == Air ? Ground : Air]
                         .endpoint->handleDatagram(pair.now, path, MutableByteView(record).first(*size))
                         .has_value();
        if (i % 1000 == 0) {
            pair.run(10ms);
            pair.ground().events.clear();
            pair.air().events.clear();
        }
        if (i == records / 10)
            before = residentBytes();
    }
    const std::size_t after = residentBytes();
    qInfo("%d records, epoch %u, resident %zu kB, then %zu kB", records,
          static_cast<unsigned>(pair.air().endpoint->sessionInfo(pair.air().session())->epoch), before / 1024, after / 1024);
    QCOMPARE(delivered, static_cast<std::uint64_t>(records));
    QVERIFY(after <= before + kNoise);
}

void EnduranceTest::tenThousandHandshakes()
{
    const int handshakes = countOr("SKYSEAL_HANDSHAKES", 10'000);
    Pair pair(attackOptions());
    std::size_t before = 0;
    for (int i = 0; i < handshakes; ++i) {
        QVERIFY(pair.run(6s, [&] { return pair.ground().up() && pair.air().all<SessionUp>().size() == 1; }));
        for (auto &end : pair.ends)
            end.events.clear();
        pair.kill(Ground);
        pair.start(Ground);
        if (i == handshakes / 10)
            before = residentBytes();
    }
    const std::size_t after = residentBytes();
    qInfo("%d handshakes, resident %zu kB, then %zu kB", handshakes, before / 1024, after / 1024);
    QVERIFY(after <= before + kNoise);
}

QTEST_GUILESS_MAIN(EnduranceTest)
#include "endurance_test.moc"
