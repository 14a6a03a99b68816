// A real sweep beside which another program begins to use the processor: the runs from then on say so, in their rows and on the
// first page of the report. Judged by the CPU time that the other program got, and by the runs before it began.
#include "core/metrics/process_usage.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QTemporaryDir>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr std::size_t kHogRuns = 10, kRunsBefore = 3; ///< the hog begins after so many
constexpr double kOthersMay = 10;                     ///< percent of a core that others may use without a warning
constexpr double kHasRoom = 50;                       ///< with more, the machine has no core left for a hog

/// Takes all the CPU time that it gets.
class Hog
{
public:
    Hog()
    {
        m_process.start(QStringLiteral("sh"), {QStringLiteral("-c"), QStringLiteral("while :; do :; done")});
        m_started = m_process.waitForStarted(kDeadlineMs);
        m_clock.start();
    }
    ~Hog()
    {
        m_process.kill();
        m_process.waitForFinished(kDeadlineMs);
    }
    bool started() const { return m_started; }
    /// Percent of a core since it started.
    double load() const
    {
        const auto used = metrics::processCpuTime(m_process.processId());
        return used ? 100 * seconds(*used) / (static_cast<double>(m_clock.nsecsElapsed()) / 1e9) : 0;
    }

private:
    QProcess m_process;
    QElapsedTimer m_clock;
    bool m_started = false;
};

double otherCpu(const QJsonValue &run)
{
    return run[QLatin1String("values")][QLatin1String("other_cpu")].toDouble();
}

QString warningIn(const QJsonValue &run)
{
    for (const QJsonValue text : run[QLatin1String("disturbances")].toArray()) {
        if (text.toString().startsWith(QLatin1String("other programs used ")))
            return text.toString();
    }
    return {};
}

} // namespace

class DisturbedSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hogIsWarnedOf();
};

void DisturbedSweepTest::hogIsWarnedOf()
{
    QTemporaryDir folder;
    Program sweep(QStringLiteral("skyseal-cli"),
                  words("sweep --launches 1 --repeats 10 --seconds 0.5 --warm-up 0.1 --suites none --load natural --no-noise "
                        "--json --out")
                      << folder.path());
    for (std::size_t before = 0; before < kRunsBefore; ++before)
        QVERIFY2(!sweep.waitFor(QStringLiteral("run")).isEmpty(), sweep.errors().constData());
    double hogs = 0;
    std::size_t first = 0; // run that began after the hog
    {
        const Hog hog;
        QVERIFY(hog.started());
        first = sweep.events(QStringLiteral("begin")).size() + 1; // one may have begun a moment ago
        while (sweep.events(QStringLiteral("run")).size() < kHogRuns && !sweep.waitFor(QStringLiteral("run")).isEmpty())
            hogs = hog.load();
    }
    QVERIFY2(sweep.waitForExit() == 0, sweep.errors().constData());
    const std::vector<QJsonObject> runs = sweep.events(QStringLiteral("run"));
    QCOMPARE(runs.size(), kHogRuns);
    QVERIFY(first < runs.size());
    QVERIFY(hogs > 0);
    double others = 0, count = 0;
    for (std::size_t i = first; i < runs.size(); ++i, ++count) {
        others += otherCpu(runs[i]);
        // Ten per cent of a core are the threshold: with a hog, or on a machine that gives a hog no more, it is passed.
        QVERIFY2(!warningIn(runs[i]).isEmpty(), QJsonDocument(runs[i]).toJson().constData());
    }
    others /= count;
    qInfo("the hog got %.0f %% of a core, the runs name %.0f %% for other programs", hogs, others);
    QVERIFY(others > 0.5 * hogs); // it is among them
    double before = 0;
    for (std::size_t i = 0; i < kRunsBefore; ++i) {
        before += otherCpu(runs[i]) / kRunsBefore;
        QCOMPARE(warningIn(runs[i]).isEmpty(), !(otherCpu(runs[i]) > kOthersMay));
    }
    qInfo("before it began, other programs used %.0f %%", before);
    if (before < kHasRoom) // otherwise the hog took the time of others
        QVERIFY2(others - before > 0.5 * hogs, "the hog made no difference");

    QFile file(folder.filePath(QStringLiteral("report.html")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString page = QString::fromUtf8(file.readAll());
    const QString top = page.left(page.indexOf(QLatin1String("<h2>")));
    QVERIFY2(top.contains(QLatin1String(" of 10 runs were disturbed"))
                 && top.contains(QLatin1String("other programs used up to ")),
             qPrintable(top.right(2000)));
    const QString rows = page.mid(page.indexOf(QLatin1String("<h2>Every run")));
    QVERIFY(rows.contains(warningIn(runs.back()).toHtmlEscaped()));
}

SKYSEAL_TEST(DisturbedSweepTest)
#include "disturbed_sweep_test.moc"
