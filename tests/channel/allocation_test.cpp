// The packet path allocates nothing: sealing, opening and refusing are counted against operator new.
#include "attack.h"
#include "core/crypto/init_crypto.h"
#include "inline_pair.h"

#include <atomic>
#include <cstdlib>
#include <new>

using namespace skyseal;
using namespace skyseal::test;

namespace {

std::atomic<std::size_t> allocations = 0; // QtTest has a thread of its own

} // namespace

void *operator new(std::size_t size)
{
    ++allocations;
    if (void *memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

class AllocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void countsAtAll();
    void sealAndOpen_data() { everySuite(); }
    void sealAndOpen();
    void sealAndOpenInline_data() { everyInlineSuite(); }
    void sealAndOpenInline();
};

void AllocationTest::countsAtAll()
{
    const std::size_t before = allocations;
    const auto something = std::make_unique<int>(1);
    QVERIFY(something && allocations == before + 1);
}

void AllocationTest::sealAndOpen()
{
    QFETCH(int, suite);
    auto pair = pairUnder(static_cast<SuiteId>(suite));
    Endpoint &air = *pair->air().endpoint;
    Endpoint &ground = *pair->ground().endpoint;
    const SessionId session = pair->air().session();
    const Path from = pair->pathOf(Air);
    const Bytes frame(64, 0xfd);
    Bytes record(frame.size() + kMaxRecordOverhead), forged = record;
    std::size_t opened = 0, refused = 0;

    const std::size_t before = allocations;
    for (int i = 0; i < 1000; ++i) {
        const auto size = air.seal(pair->now, session, frame, record);
        std::copy(record.begin(), record.end(), forged.begin());
        forged[3] ^= 0x55;
        refused += !ground.handleDatagram(pair->now, from, MutableByteView(forged).first(*size));
        opened += ground.handleDatagram(pair->now, from, MutableByteView(record).first(*size)).has_value();
        refused += !ground.handleDatagram(pair->now, from, MutableByteView(record).first(*size));
    }
    const std::size_t after = allocations;
    QCOMPARE(opened, std::size_t(1000));
    QCOMPARE(refused, std::size_t(2000));
    QVERIFY2(after - before <= 1, qPrintable(QString::number(after - before))); // The one alarm may need a place to wait.
}

void AllocationTest::sealAndOpenInline()
{
    QFETCH(int, suite);
    auto pair = inlinePair(static_cast<SuiteId>(suite));
    Endpoint &air = *pair->air().endpoint;
    Endpoint &ground = *pair->ground().endpoint;
    const SessionId session = pair->air().session();
    const Path from = pair->pathOf(Air);
    const Bytes frame = numberedFrame(1, 64);
    Bytes sealed(frame.size() + kMaxRecordOverhead), forged = sealed;
    std::size_t opened = 0, refused = 0;

    const std::size_t before = allocations;
    for (int i = 0; i < 1000; ++i) {
        const auto size = air.sealInline(pair->now, session, frame, sealed);
        std::copy(sealed.begin(), sealed.end(), forged.begin());
        forged[*size - 1] ^= 0x55;
        refused += !ground.handleInlineFrame(pair->now, from, MutableByteView(forged).first(*size));
        const auto delivery = ground.handleInlineFrame(pair->now, from, MutableByteView(sealed).first(*size));
        opened += delivery && std::equal(delivery->frames.begin(), delivery->frames.end(), frame.begin(), frame.end());
    }
    const std::size_t after = allocations;
    QCOMPARE(opened, std::size_t(1000));
    QCOMPARE(refused, std::size_t(1000));
    QVERIFY2(after - before <= 1, qPrintable(QString::number(after - before)));
}

QTEST_GUILESS_MAIN(AllocationTest)
#include "allocation_test.moc"
