// The share of the I/O thread's CPU time that a sweep reports for the suite, against what perf finds in the same run.
//
// Compared are two shares of one thread: cpu_suite / cpu of the sweep's only run (time inside Endpoint's four functions that
// seal and open, clocked around each call, over the thread's CPU time), and the share of perf's samples of that thread whose
// stack holds one of these functions, cipher libraries included. perf samples the thread's CPU clock, since virtual machines
// seldom have counters of cycles. The rate is one at which the thread seldom sleeps: where it sleeps after each record, perf's
// samples miss the kernel's part of going to sleep and waking, and the shares differ by a third. 3,000 samples with a share of
// a seventh are exact to some 5 % of it; the limit is 15 %.
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

constexpr double kTolerance = 0.15;
constexpr int kLeastSamples = 1500;

struct Attribution
{
    int all = 0, suite = 0; ///< samples
    double share() const { return static_cast<double>(suite) / all; }
};

Attribution attributed(const QByteArray &script)
{
    static const QRegularExpression kSuite(
        QStringLiteral("channel::Endpoint::(handleDatagram|handleInlineFrame|seal|sealInline|State::handleRecord)\\b"));
    Attribution out;
    for (const PerfStack &stack : perfStacks(script)) {
        ++out.all;
        out.suite += kSuite.match(stack.functions).hasMatch();
    }
    return out;
}

/// The measurement of the only run of a sweep.
QJsonObject runIn(const QByteArray &out)
{
    for (const QByteArray &line : out.split('\n')) {
        if (const QJsonObject object = QJsonDocument::fromJson(line).object();
            object[QLatin1String("event")] == QLatin1String("run"))
            return object[QLatin1String("values")].toObject();
    }
    return {};
}

} // namespace

class CpuShareTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void suitesShareIsWhatPerfFinds_data();
    void suitesShareIsWhatPerfFinds();
};

void CpuShareTest::suitesShareIsWhatPerfFinds_data()
{
    QTest::addColumn<QString>("suite");
    QTest::newRow("chacha20-poly1305") << QStringLiteral("chacha20-poly1305");
    QTest::newRow("aes-256-gcm") << QStringLiteral("aes-256-gcm");
    QTest::newRow("rc4") << QStringLiteral("rc4");
}

void CpuShareTest::suitesShareIsWhatPerfFinds()
{
    SKYSEAL_REQUIRES("perf");
    QFETCH(QString, suite);
    QTemporaryDir folder;
    const QString data = folder.filePath(QStringLiteral("perf.data"));
    QProcess sweep;
    sweep.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"),
                words("sweep --launches 1 --pps 20000 --seconds 15 --repeats 1 --no-noise --json --suites") << suite);
    QVERIFY(sweep.waitForStarted(kDeadlineMs));
    EVENTUALLY(ioThreadOf(sweep.processId()) != 0);
    // Its user and its kernel time, as the thread's own clock counts both.
    QProcess perf;
    perf.start(QStringLiteral("perf"),
               words("record -q -e cpu-clock -F 1999 --call-graph dwarf,8192 -o")
                   << data << QStringLiteral("-t") << QString::number(ioThreadOf(sweep.processId())));
    QVERIFY(perf.waitForStarted(kDeadlineMs));
    QVERIFY(sweep.waitForFinished(2 * kDeadlineMs));
    QCOMPARE(sweep.exitCode(), 0);
    if (!perf.waitForFinished(kDeadlineMs)) {
        perf.terminate();
        QVERIFY(perf.waitForFinished(kDeadlineMs));
    }
    const QJsonObject values = runIn(sweep.readAllStandardOutput());
    const double measured = values[QLatin1String("cpu_suite")].toDouble() / values[QLatin1String("cpu")].toDouble();
    const RunResult script = runToItsEnd(QStringLiteral("perf"), words("script --no-inline -F tid,ip,sym -i") << data, {},
                                         300000);
    QVERIFY2(script.status == 0, script.err.constData());
    const Attribution found = attributed(script.out);
    qInfo("%s: measured %.2f %% of the I/O thread's CPU time, perf %.2f %% (%d of %d samples), ratio %.3f", qPrintable(suite),
          100 * measured, 100 * found.share(), found.suite, found.all, measured / found.share());
    QVERIFY2(found.all >= kLeastSamples, qPrintable(QStringLiteral("only %1 samples").arg(found.all)));
    QVERIFY(std::abs(measured / found.share() - 1) <= kTolerance);
}

SKYSEAL_TEST(CpuShareTest)
#include "cpu_share_test.moc"
