// A file of the first version of sweep.json, in the form that its programs wrote (the values are made up): its report can be
// made, and says what is unknown; nothing is invented.
#include "core/experiment/analysis.h"
#include "core/experiment/claims.h"
#include "core/experiment/html_report.h"
#include "core/experiment/sweep_csv.h"
#include "core/experiment/sweep_json.h"
#include "core/experiment/sweep_reader.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;

class OlderSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void firstVersionIsReadable();
    void programReportsIt();
};

namespace {

std::string pageOfSweep(const Results &results)
{
    const auto figures = figuresOf(results);
    const std::vector<Verdict> none;
    return htmlReport({results, figures, none, paperClaims(results)});
}

QByteArray jsonOfSweep(const Results &results)
{
    return QByteArray::fromStdString(sweepJson(results, {}));
}

QByteArray firstVersion()
{
    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/data/sweeps/version1.json"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void OlderSweepTest::firstVersionIsReadable()
{
    const QByteArray old = firstVersion();
    const auto read = readSweep(old);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->schemaVersion, 1u);
    const Results &results = read->results;
    QCOMPARE(results.plan.launches, 1u);
    QCOMPARE(results.samples.size(), std::size_t(12));
    QCOMPARE(read->expectations, std::vector<std::string>{"cpu_per_frame(rc4)<=3*cpu_per_frame(none)"});
    const std::string page = pageOfSweep(results);
    for (const char *part : {"was recorded in version 1", "whether a run carried its load",
                             "Its counters of records are unknown", "Not recorded, and therefore empty: ", "context_bytes",
                             "steal", "has two sources", "the switch to the suite failed", "rc4"})
        QVERIFY2(page.find(part) != std::string::npos, part);
    // The values are those of the file, and what it does not hold is not a number.
    const QJsonArray inFile = QJsonDocument::fromJson(old).object()[QLatin1String("samples")].toArray();
    for (qsizetype i = 0; i < inFile.size(); ++i) {
        const Sample &sample = results.samples[std::size_t(i)];
        const QJsonValue cost = inFile[i][QLatin1String("values")][QLatin1String("cpu_per_frame")];
        if (cost.isDouble())
            QCOMPARE(sample.values[Metric::CpuPerFrame], cost.toDouble());
        QVERIFY(std::isnan(sample.values[Metric::OtherCpu]) && std::isnan(sample.values[Metric::MeterCpu]));
        QVERIFY(!sample.isJudged && !sample.isCounted);
    }
    const Cell chacha{0, 0, 2};
    QCOMPARE(summaryOf(results, chacha, Metric::RecordLoss).max, 0.0);
    QCOMPARE(summaryOf(results, chacha, Metric::RecordLoss).high(), 1.0); // of an unknown number of records
    QVERIFY(summaryOf(results, chacha, Metric::Loss).high() < 0.01);
    // Written again, it invents nothing, and says the same.
    const QByteArray again = jsonOfSweep(results);
    const QJsonObject report = QJsonDocument::fromJson(again).object();
    QCOMPARE(report[QLatin1String("unknown")].toArray().size(), qsizetype(results.unknown.size()));
    for (const QJsonValue sample : report[QLatin1String("samples")].toArray()) {
        for (const char *key : {"valid", "attempts", "disturbances", "counted", "relay"})
            QVERIFY2(sample[QLatin1String(key)].isUndefined(), key);
    }
    const auto second = readSweep(again);
    QVERIFY2(second, second ? "" : second.error().text().c_str());
    QCOMPARE(jsonOfSweep(second->results), again);
    QCOMPARE(pageOfSweep(second->results), page);
    const QByteArray csv = QByteArray::fromStdString(sweepCsv(results));
    QVERIFY(!csv.split('\n')[1].contains(",1,1,,,,")); // neither valid nor attempts
}

void OlderSweepTest::programReportsIt()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(firstVersion()) > 0);
    file.close();
    const QString out = folder.filePath(QStringLiteral("out"));
    const test::RunResult report = test::runProgram("skyseal-cli",
                                                    {QStringLiteral("report"), folder.path(), QStringLiteral("--out"), out});
    QVERIFY2(report.status == 0, report.err.constData());
    QFile page(out + QStringLiteral("/report.html"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    QVERIFY(page.readAll().contains("This sweep was recorded in version 1 of the file."));
}

SKYSEAL_TEST(OlderSweepTest)
#include "older_sweep_test.moc"
