// What a measurement costs the thread that it measures: perf's samples of the I/O thread of a sweep's station, under the
// natural load and while its only run is measured. It is a share of one thread's CPU time, so that other work of the machine
// does not matter. The CPU clock is sampled, since virtual machines seldom have counters of cycles.
#include "tests/support/eventually.h"
#include "tests/support/perf_stacks.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal::test;

namespace {

constexpr double kMost = 0.02;
constexpr int kRunSeconds = 60;
/// The run ends some time before the thread does, and began a minute earlier.
constexpr double kAfterRun = 5, kWithinRun = 50;
constexpr int kLeastOfMeter = 300;

} // namespace

class MeterShareTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meterIsNoPartOfTheMeasurement();
    void defaultRunsAreMeteredAlike();
};

void MeterShareTest::meterIsNoPartOfTheMeasurement()
{
    static const QRegularExpression kMeter(
        QStringLiteral("StationCore::(publishSnapshot|takeSnapshot|requestProbe)|buildSnapshot|makeProbe|residentBytes|"
                       "MetricsSampler|ProcessMeter|OutputQueue::put"));
    static const QRegularExpression kProbe(QStringLiteral("makeProbe|StationCore::requestProbe"));
    QTemporaryDir folder;
    const QString data = folder.filePath(QStringLiteral("perf.data"));
    if (const QString problem = perfProblem(data); !problem.isEmpty())
        QSKIP(qPrintable(problem));
    QProcess sweep;
    sweep.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"),
                words("sweep --launches 1 --load natural --suites chacha20-poly1305 --repeats 1 --no-noise --json --seconds")
                    << QString::number(kRunSeconds));
    QVERIFY(sweep.waitForStarted());
    EVENTUALLY(ioThreadOf(sweep.processId()) != 0);
    QProcess perf;
    perf.start(QStringLiteral("perf"),
               words("record -q -e cpu-clock -F 9999 --call-graph dwarf,4096 -o")
                   << data << QStringLiteral("-t") << QString::number(ioThreadOf(sweep.processId())));
    QVERIFY(perf.waitForStarted());
    QVERIFY(sweep.waitForFinished(kRunSeconds * 1000 + 2 * kDeadlineMs));
    const QByteArray out = sweep.readAllStandardOutput();
    QVERIFY2(sweep.exitCode() == 0, sweep.readAllStandardError().constData());
    if (!perf.waitForFinished(kDeadlineMs)) {
        perf.terminate();
        QVERIFY(perf.waitForFinished(kDeadlineMs));
    }
    const RunResult script = runToItsEnd(QStringLiteral("perf"), words("script --no-inline -F tid,time,ip,sym -i") << data, {},
                                         300000);
    QVERIFY2(script.status == 0, script.err.constData());
    const std::vector<PerfStack> stacks = perfStacks(script.out);
    QVERIFY(!stacks.empty());
    const double end = stacks.back().time - kAfterRun;
    int all = 0, meter = 0, outside = 0, probes = 0;
    for (const PerfStack &stack : stacks) {
        const bool isMeter = kMeter.match(stack.functions).hasMatch();
        if (stack.time < end - kWithinRun || stack.time > end) {
            outside += isMeter;
            probes += kProbe.match(stack.functions).hasMatch();
            continue;
        }
        ++all;
        meter += isMeter;
    }
    QJsonObject run;
    for (const QByteArray &line : out.split('\n')) {
        if (const QJsonObject event = QJsonDocument::fromJson(line).object();
            event[QLatin1String("event")] == QLatin1String("run"))
            run = event;
    }
    const double own = run[QLatin1String("values")][QLatin1String("meter_cpu")].toDouble(100);
    qInfo("perf finds %.2f %% of the I/O thread's CPU time in the meter (%d of %d samples), %d samples of it before and after, "
          "%d of these in probes; meter_cpu is %.2f %%",
          100.0 * meter / all, meter, all, outside, probes, own);
    QVERIFY2(all >= kLeastOfMeter, qPrintable(QStringLiteral("only %1 samples").arg(all)));
    QVERIFY2(outside > 0, "the functions of the meter are not found by their names");
    QVERIFY(meter < kMost * all);
    QVERIFY(own < 100 * kMost);
}

/// Runs of the default length, in which a reading weighs twelve times as much: as little in plain MAVLink as sealed.
void MeterShareTest::defaultRunsAreMeteredAlike()
{
    const RunResult sweep = runToItsEnd(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"),
                                        words("sweep --launches 1 --load natural --suites none,chacha20-poly1305 --repeats 4 "
                                              "--no-noise --json"),
                                        {}, 300000);
    QVERIFY2(sweep.status == 0, sweep.err.constData());
    double plain = 0, sealed = 0;
    int runs = 0;
    for (const QByteArray &line : sweep.out.split('\n')) {
        const QJsonObject run = QJsonDocument::fromJson(line).object();
        if (run[QLatin1String("event")] != QLatin1String("run"))
            continue;
        const double meter = run[QLatin1String("values")][QLatin1String("meter_cpu")].toDouble(100);
        QVERIFY2(meter < 100 * kMost, line.constData());
        QCOMPARE(run[QLatin1String("values")][QLatin1String("readings")].toDouble(), 1.0);
        (run[QLatin1String("suite")] == QLatin1String("none") ? plain : sealed) += meter / 4;
        ++runs;
    }
    QCOMPARE(runs, 8);
    qInfo("meter_cpu is %.2f %% in plain MAVLink and %.2f %% sealed", plain, sealed);
    QVERIFY(std::abs(plain - sealed) < 0.5);
}

SKYSEAL_TEST(MeterShareTest)
#include "meter_share_test.moc"
