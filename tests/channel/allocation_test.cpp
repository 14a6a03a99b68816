// The packet path does not allocate: sealing, opening and refusing are counted by a replaced operator new. Datagrams of
// unknown senders leave no state behind.
#include "core/channel/endpoint.h"
#include "every_suite.h"
#include "core/crypto/init_crypto.h"
#include "first_message_flood.h"
#include "inline_pair.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

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
    void unknownSendersLeaveNoState();
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
    QVERIFY2(after - before <= 1, qPrintable(QString::number(after - before))); // the alarm may extend its queue
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

void AllocationTest::unknownSendersLeaveNoState()
{
    // First messages from a hundred thousand addresses, with and without a valid mac1: no state is kept for any of them.
    Pair pair(attackOptions());
    pair.kill(Ground);
    pair.run(1s);
    const Mac1 mac(pair.air().publicKey());
    SeededRandom random(kAttackSeed);
    const auto flood = [&](std::uint32_t from, std::uint32_t to) {
        FirstMessage message;
        for (std::uint32_t i = from; i < to; ++i) {
            random.fill(message);
            message[0] = firstByte(HandshakeMessage::First);
            if (i & 1)
                mac.sign(message);
            pair.air().handleDatagram(pair.now, addressNumber(i), message);
            while (pair.air().pollTransmit()) {}
            while (pair.air().endpoint->pollEvent()) {}
            if (i % kFloodPerMillisecond == 0)
                pair.run(1ms);
        }
        pair.air().events.clear();
    };
    flood(0, 20'000);
    const std::size_t kept = allocations - released;
    flood(20'000, 120'000);
    const std::size_t after = allocations - released;
    qInfo("kept %zu, then %zu", kept, after);
    QVERIFY(after <= kept + 8); // queues that grew
}

SKYSEAL_TEST(AllocationTest)
#include "allocation_test.moc"
