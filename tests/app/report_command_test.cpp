// skyseal-cli report over several folders: each is called by a name of its own, whatever its folder is called.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/sweep_files.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <random>

using namespace skyseal;
using namespace skyseal::app;

class ReportCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("PATH", ""); } // nothing is to be drawn

    void equalNamesAreToldApart();
    void copyIsRefused();

private:
    static experiment::Results sweepOf(unsigned seed);
};

experiment::Results ReportCommandTest::sweepOf(unsigned seed)
{
    experiment::Results out;
    out.plan.arms = {{crypto::SuiteId::None}, {crypto::SuiteId::ChaCha20}};
    out.plan.launches = 3;
    out.plan.repeats = 1;
    out.plan.seed = seed;
    out.setting = {{"time", "2026-01-01T00:00:00Z"}, {"commit", "abc"}, {"message_mix", "one"}};
    out.complete = true;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(1000, 5);
    for (const experiment::Run &run : experiment::schedule(out.plan)) {
        experiment::Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(out.samples.size());
        sample.seconds = 1;
        sample.values[experiment::Metric::CpuPerFrame] = noise(random);
        out.samples.push_back(sample);
    }
    return out;
}

void ReportCommandTest::equalNamesAreToldApart()
{
    QTemporaryDir folder;
    QStringList arguments;
    unsigned seed = 0;
    for (const char *name : {"desk/out", "board/out", "board/other"}) {
        arguments << folder.filePath(QLatin1String(name));
        QVERIFY(QDir().mkpath(arguments.back()));
        QVERIFY(writeSweepFiles(arguments.back(), sweepOf(++seed), {}).written);
    }
    const QString out = folder.filePath(QStringLiteral("joined"));
    QCOMPARE(runReport(arguments + QStringList{QStringLiteral("--out"), out}), int(kDone));
    QFile table(out + QStringLiteral("/pooled.csv"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    const QByteArray lines = table.readAll();
    for (const char *label : {"\"desk/out\"", "\"board/out\"", "\"board/other\""})
        QVERIFY2(lines.contains(label), lines.constData());
    QVERIFY(QFile::exists(out + QStringLiteral("/pooled-columns.csv")));
}

void ReportCommandTest::copyIsRefused()
{
    QTemporaryDir folder;
    QStringList arguments;
    for (const char *name : {"one", "two"}) {
        arguments << folder.filePath(QLatin1String(name));
        QVERIFY(QDir().mkpath(arguments.back()));
        QVERIFY(writeSweepFiles(arguments.back(), sweepOf(7), {}).written);
    }
    const QString out = folder.filePath(QStringLiteral("joined"));
    QCOMPARE(runReport(arguments + QStringList{QStringLiteral("--out"), out}), int(kNotReached));
    QVERIFY(!QFile::exists(out));
}

SKYSEAL_TEST(ReportCommandTest)
#include "report_command_test.moc"
