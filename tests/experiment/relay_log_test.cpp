// What the log of a relay says about a run: the newest sums are read also from a log that is being written or was cut off, and
// stand beside the measured loss in the unit that the link numbers.
#include "core/experiment/relay_comparison.h"
#include "core/experiment/relay_log.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::experiment;

namespace {

QByteArray drop(const char *direction, int datagrams, int records, int frames)
{
    return QStringLiteral(R"({"event":"drop","t":1,"direction":"%1","sequence":7,"bytes":50,"reason":"loss",)"
                          R"("so_far":{"datagrams":%2,"records":%3,"frames":%4}})")
               .arg(QLatin1String(direction))
               .arg(datagrams)
               .arg(records)
               .arg(frames)
               .toUtf8()
        + '\n';
}

const QByteArray kStats = "{\"event\":\"stats\",\"t\":2,\"forward\":{\"dropped\":99},\"backward\":{\"dropped\":98}}\n";

bool append(const QString &path, const QByteArray &content)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly | QIODevice::Append) && file.write(content) == content.size();
}

/// A run of that suite, in which the station counted 900 and 80 lost, and the relay dropped 82 records and 77 frames.
Results resultsOf(crypto::SuiteId suite)
{
    Results out;
    out.plan.arms = {{suite}};
    out.plan.conditions = {*parseCondition("loss=0.1")};
    Sample sample;
    sample.values[Metric::Loss] = 0.1;
    sample.begin.relay = {{10, 20, 30}, {}};
    sample.end.relay = {{50, 102, 107}, {}};
    sample.begin.rx.good = sample.begin.mavlink.taken = 100;
    sample.end.rx.good = sample.end.mavlink.taken = 1000;
    sample.begin.rx.lost = sample.begin.mavlink.lost = 5;
    sample.end.rx.lost = sample.end.mavlink.lost = 85;
    out.samples = {sample};
    return out;
}

} // namespace

class RelayLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newestSumsCount();
    void largeLogIsCutOff();
    void lossIsComparedInTheUnitOfTheLink();
    void nothingIsComparedWithoutARelay();
};

void RelayLogTest::newestSumsCount()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("relay.log"));
    RelayLog log(path);
    log.begin();
    QCOMPARE(log.read().toStation.datagrams, std::uint64_t(0));
    QVERIFY(append(path, drop("forward", 1, 2, 0) + drop("backward", 1, 1, 0) + drop("forward", 2, 3, 4) + kStats));
    QCOMPARE(log.read().toStation.datagrams, std::uint64_t(2));
    QCOMPARE(log.read().toStation.records, std::uint64_t(3));
    QCOMPARE(log.read().toStation.frames, std::uint64_t(4));
    QCOMPARE(log.read().toAgent.records, std::uint64_t(1));
    const QByteArray next = drop("backward", 2, 2, 0);
    QVERIFY(append(path, next.left(next.size() / 2)));
    QCOMPARE(log.read().toAgent.records, std::uint64_t(1)); // the line is not complete
    QVERIFY(append(path, next.mid(next.size() / 2)));
    QCOMPARE(log.read().toAgent.records, std::uint64_t(2));
    log.begin();
    QCOMPARE(log.read().toAgent.records, std::uint64_t(0)); // another relay
}

void RelayLogTest::largeLogIsCutOff()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("relay.log"));
    RelayLog log(path);
    log.begin();
    const QByteArray line = drop("forward", 5, 6, 7);
    QVERIFY(append(path, line.repeated(RelayLog::kMostBytes / line.size() + 1)));
    QCOMPARE(log.read().toStation.records, std::uint64_t(6));
    QCOMPARE(QFile(path).size(), qint64(0));
    QCOMPARE(log.read().toStation.records, std::uint64_t(6));
    QVERIFY(append(path, drop("forward", 6, 8, 7)));
    QCOMPARE(log.read().toStation.records, std::uint64_t(8));
}

void RelayLogTest::lossIsComparedInTheUnitOfTheLink()
{
    const Results sealed = resultsOf(crypto::SuiteId::ChaCha20Poly1305), clear = resultsOf(crypto::SuiteId::None);
    const auto records = comparedWithRelay(sealed.plan, sealed.samples[0]),
               frames = comparedWithRelay(clear.plan, clear.samples[0]);
    QVERIFY(records && frames);
    QCOMPARE(records->unit, std::string_view("records"));
    QCOMPARE(frames->unit, std::string_view("frames"));
    for (const auto &[compared, dropped, difference] : {std::tuple(*records, 82, -2), std::tuple(*frames, 77, 3)}) {
        QCOMPARE(compared.received, std::uint64_t(900));
        QCOMPARE(compared.lost, std::int64_t(80));
        QCOMPARE(compared.dropped, std::int64_t(dropped));
        QCOMPARE(compared.difference(), std::int64_t(difference));
    }
    const std::string table = relayTable(sealed);
    QVERIFY2(table.find("<td>records</td><td>900</td><td>80</td><td>82</td><td>-2</td>") != table.npos, table.c_str());
    QVERIFY(table.find("damages") == table.npos);
}

void RelayLogTest::nothingIsComparedWithoutARelay()
{
    Results results = resultsOf(crypto::SuiteId::None);
    results.samples[0].values[Metric::Loss] = std::numeric_limits<double>::quiet_NaN(); // not counted by sequence numbers
    QVERIFY(!comparedWithRelay(results.plan, results.samples[0]));
    results = resultsOf(crypto::SuiteId::Aes256Gcm);
    results.samples[0].end.relay.reset();
    QVERIFY(!comparedWithRelay(results.plan, results.samples[0]));
    QVERIFY(relayTable(results).empty());
}

SKYSEAL_TEST(RelayLogTest)
#include "relay_log_test.moc"
