// What a measurement costs the thread that it measures: perf's samples of the I/O thread of a sweep's station, under the
// natural load and in runs of the default length, from the first probe of each run to its last, both included. It is a share of
// one thread's CPU time, so that other work of the machine does not matter. The CPU clock is sampled, since virtual machines
// seldom have counters of cycles.
#include "tests/support/eventually.h"
#include "tests/support/perf_stacks.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal::test;

namespace {

constexpr double kMost = 0.02;
constexpr double kRunSeconds = 5, kProbeSeconds = 0.3;   ///< a probe's samples lie closer together than two probes
constexpr int kMeteredRuns = 16, kLeastMeteredRuns = 12; ///< perf may miss a probe, and with it the run
constexpr int kLeastMeterSamples = 5000;
constexpr int kSweepMs = 300'000;

/// Samples in the functions of the meter, and in those of probes among them.
struct Share
{
    int all = 0, meter = 0, probes = 0, runs = 0;
};

bool matches(const QRegularExpression &functions, const PerfStack &stack)
{
    return functions.match(stack.functions).hasMatch();
}

/// The runs are the times between two probes that are as far from each other as a run is long. What lies between runs, when
/// the station publishes its state, is not measured.
Share shareInRuns(const std::vector<PerfStack> &stacks)
{
    static const QRegularExpression kMeter(
        QStringLiteral("StationCore::(publishSnapshot|takeSnapshot|requestProbe|requestCosts)|buildSnapshot|makeProbe|"
                       "residentBytes|MetricsSampler|ProcessMeter|OutputQueue::put"));
    static const QRegularExpression kProbe(QStringLiteral("makeProbe|StationCore::requestProbe"));
    std::vector<std::pair<double, double>> probes; ///< first and last sample of each
    std::vector<std::pair<bool, bool>> kinds;      ///< of each sample: of the meter, of a probe
    for (const PerfStack &stack : stacks) {
        kinds.emplace_back(matches(kMeter, stack), matches(kProbe, stack));
        if (!kinds.back().second)
            continue;
        if (probes.empty() || stack.time > probes.back().second + kProbeSeconds)
            probes.emplace_back(stack.time, stack.time);
        probes.back().second = stack.time;
    }
    Share out;
    for (std::size_t i = 1; i < probes.size(); ++i) {
        const auto &[begin, beginEnd] = probes[i - 1];
        const auto &[endBegin, end] = probes[i];
        if (std::abs(endBegin - beginEnd - kRunSeconds) > kProbeSeconds)
            continue;
        ++out.runs;
        for (std::size_t sample = 0; sample < stacks.size(); ++sample) {
            if (stacks[sample].time < begin || stacks[sample].time > end)
                continue;
            ++out.all;
            out.meter += kinds[sample].first;
            out.probes += kinds[sample].second;
        }
    }
    return out;
}

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
    SKYSEAL_REQUIRES("perf");
    QTemporaryDir folder;
    const QString data = folder.filePath(QStringLiteral("perf.data"));
    QProcess sweep;
    sweep.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"),
                words("sweep --launches 1 --load natural --suites chacha20-poly1305 --no-noise --json --seconds")
                    << QString::number(kRunSeconds) << QStringLiteral("--repeats") << QString::number(kMeteredRuns));
    QVERIFY(sweep.waitForStarted(kDeadlineMs));
    EVENTUALLY(ioThreadOf(sweep.processId()) != 0);
    QProcess perf;
    perf.start(QStringLiteral("perf"),
               words("record -q -e cpu-clock -F 9999 --call-graph dwarf,4096 -o")
                   << data << QStringLiteral("-t") << QString::number(ioThreadOf(sweep.processId())));
    QVERIFY(perf.waitForStarted(kDeadlineMs));
    QVERIFY(sweep.waitForFinished(kSweepMs));
    const QByteArray out = sweep.readAllStandardOutput();
    QVERIFY2(sweep.exitCode() == 0, sweep.readAllStandardError().constData());
    if (!perf.waitForFinished(kDeadlineMs)) {
        perf.terminate();
        QVERIFY(perf.waitForFinished(kDeadlineMs));
    }
    const RunResult script = runToItsEnd(QStringLiteral("perf"), words("script --no-inline -F tid,time,ip,sym -i") << data, {},
                                         kSweepMs);
    QVERIFY2(script.status == 0, script.err.constData());
    const std::vector<PerfStack> stacks = perfStacks(script.out);
    QVERIFY(!stacks.empty());
    const Share share = shareInRuns(stacks);
    double own = 0;
    for (const QByteArray &line : out.split('\n')) {
        if (const QJsonObject event = QJsonDocument::fromJson(line).object();
            event[QLatin1String("event")] == QLatin1String("run"))
            own = std::max(own, event[QLatin1String("values")][QLatin1String("meter_cpu")].toDouble(100));
    }
    qInfo("perf finds %.2f %% of the I/O thread's CPU time of %d runs in the meter (%d of %d samples, %d of these in probes); "
          "meter_cpu is %.2f %% at most",
          100.0 * share.meter / share.all, share.runs, share.meter, share.all, share.probes, own);
    QVERIFY2(share.runs >= kLeastMeteredRuns, "the probes of the runs are not found");
    QVERIFY2(share.all >= kLeastMeterSamples, qPrintable(QStringLiteral("only %1 samples").arg(share.all)));
    QVERIFY(share.probes >= 2 * share.runs);
    QVERIFY(share.meter < kMost * share.all);
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
