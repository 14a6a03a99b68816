// The benchmark of the suites: every record opens, the figures are in a believable order, the memory is that of a context.
#include "core/channel/sealed.h"
#include "core/crypto/init_crypto.h"
#include "core/experiment/cipher_bench.h"
#include "core/experiment/record_pair.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

class BenchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void everySuiteHasAPair();
    void costsMakeSense();
    void memoryDoesNotDependOnWhatWasFreedBefore_data();
    void memoryDoesNotDependOnWhatWasFreedBefore();
    void noPairForPlain();
};

void BenchTest::everySuiteHasAPair()
{
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (!info.authenticated || !crypto::suiteAvailable(info.id))
            continue;
        const auto pair = RecordPair::create(info.id);
        QVERIFY2(pair, std::string(info.name).c_str());
        const Bytes frame(28, 0xFD);
        Bytes record(100);
        const std::size_t size = pair->seal(frame, record);
        QVERIFY(size > frame.size() && size <= frame.size() + channel::kMaxRecordOverhead);
        QVERIFY(pair->open(MutableByteView(record).first(size)));
        QVERIFY(!pair->open(MutableByteView(record).first(size))); // once only
    }
}

void BenchTest::costsMakeSense()
{
    const SuiteCosts costs = benchSuite(crypto::SuiteId::Aes256Ctr, {16, 1000});
    QVERIFY(!costs.failed);
    QCOMPARE(costs.sizes.size(), std::size_t(2));
    for (const SizeCosts &size : costs.sizes) {
        for (const StepCosts *step : {&size.seal, &size.open}) {
            QVERIFY(step->cipher.best > 5 && step->cipher.best < step->bare.best);
            QVERIFY(step->record.best > step->cipher.best); // by HMAC-SHA-256: far, whatever else the machine does
            for (const CallCost &cost : {step->cipher, step->bare, step->suite, step->record})
                QVERIFY(cost.best <= cost.median && cost.median < 1e6);
        }
    }
    QVERIFY(costs.sizes[1].seal.record.best > costs.sizes[0].seal.record.best);
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // whose heap tells nothing
    QVERIFY(costs.contextBytes && *costs.contextBytes > 100 && *costs.contextBytes < 20000);
    QVERIFY(costs.sessionBytes && *costs.sessionBytes > *costs.contextBytes);
#endif
    for (const std::string &line : benchEvents(costs, true)) {
        const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(line));
        QCOMPARE(json[QLatin1String("suite")].toString(), QStringLiteral("aes-256-ctr"));
        QVERIFY(json[QLatin1String("open")][QLatin1String("record")][QLatin1String("best_ns")].toDouble() > 0);
    }
}

void BenchTest::memoryDoesNotDependOnWhatWasFreedBefore_data()
{
    QTest::addColumn<int>("id");
    for (const SuiteId id : {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Aes256Cbc, SuiteId::Rc4}) {
        if (crypto::suiteAvailable(id))
            QTest::newRow(std::string(crypto::suiteInfo(id).name).c_str()) << static_cast<int>(id);
    }
}

void BenchTest::memoryDoesNotDependOnWhatWasFreedBefore()
{
    QFETCH(int, id);
    const auto suite = static_cast<SuiteId>(id);
    // Held ones, connected one by one: what many more sessions take of the heap.
    constexpr std::size_t kMany = 48, kFirst = 16;
    std::vector<RecordPair> pairs(kMany);
    std::size_t before = 0;
    for (std::size_t i = 0; i < kMany; ++i) {
        if (i == kFirst)
            before = heapInUse().value_or(0);
        QVERIFY(pairs[i].connect(suite));
    }
    const double truth = static_cast<double>(heapInUse().value_or(0) - before) / (2 * (kMany - kFirst));
    for (int round = 0; round < 3; ++round) {
        // glibc keeps freed blocks for the next who asks, and counts them as in use all the time.
        std::vector<Bytes> blocks;
        for (std::size_t size = 16; size <= 1040; size += 16)
            blocks.insert(blocks.end(), 7, Bytes(size));
        blocks.clear();
        const double session = sessionBytes(suite).value_or(0), context = contextBytes(suite).value_or(0);
        qInfo("%s: %.0f bytes a session, of many %.0f; a context %.0f", QTest::currentDataTag(), session, truth, context);
        QVERIFY(std::abs(session / truth - 1) < 0.05);
        QVERIFY(session > 2 * context); // one for each direction at least
    }
}

void BenchTest::noPairForPlain()
{
    QVERIFY(!RecordPair::create(crypto::SuiteId::None));
}

SKYSEAL_TEST_APPLESS(BenchTest)
#include "bench_test.moc"
