// A sweep's files in a folder that is not empty: an older sweep's pictures go, and nothing that is somebody else's.
#include "app/common/sweep_files.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;

namespace {

experiment::Results oneRun()
{
    experiment::Results out;
    out.plan.arms = {{crypto::SuiteId::ChaCha20Poly1305}};
    out.plan.repeats = 1;
    experiment::Sample sample;
    sample.seconds = 1;
    sample.values[experiment::Metric::Packets] = 62;
    out.samples.push_back(sample);
    out.complete = true;
    return out;
}

} // namespace

class SweepFilesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("PATH", ""); } // nothing is to be drawn

    void onlyWhatASweepLeftIsRemoved_data()
    {
        QTest::addColumn<QByteArray>("sweep"); // sweep.json that stands there; empty = none
        QTest::addColumn<bool>("ours");
        QTest::newRow("no sweep") << QByteArray() << false;
        QTest::newRow("another's sweep.json") << QByteArray("{\"schema\": \"chimney-sweep\"}") << false;
        QTest::newRow("no JSON") << QByteArray("skyseal-sweep") << false;
        QTest::newRow("older sweep") << QByteArray("{\"schema\": \"skyseal-sweep\", \"schema_version\": 1}") << true;
    }

    void onlyWhatASweepLeftIsRemoved()
    {
        QFETCH(QByteArray, sweep);
        QFETCH(bool, ours);
        const QTemporaryDir folder;
        const auto names = [](const char *line) { return QString::fromLatin1(line).split(QLatin1Char(' ')); };
        const QStringList figures = names("figures/switch-natural-3.svg figures/loss-saturated.png report.pdf");
        const QStringList others = names("figures/own.png figures/packets.svg figures/packets-natural-draft.svg "
                                         "figures/weight-natural.svg figures/loss-heavy.svg figures/loss-natural.txt "
                                         "loss-natural.svg");
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("figures")));
        for (const QString &name : figures + others)
            QVERIFY(QFile(folder.filePath(name)).open(QIODevice::WriteOnly));
        if (!sweep.isEmpty()) {
            QFile file(folder.filePath(QStringLiteral("sweep.json")));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(sweep) == sweep.size());
        }
        const SweepFiles files = writeSweepFiles(folder.path(), oneRun(), {});
        QVERIFY2(files.written, files.problem.text().c_str());
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("figures/packets-natural.svg"))));
        for (const QString &name : figures)
            QVERIFY2(QFile::exists(folder.filePath(name)) != ours, qPrintable(name));
        for (const QString &name : others)
            QVERIFY2(QFile::exists(folder.filePath(name)), qPrintable(name));
    }

    void fullDiskKeepsTheOldFiles()
    {
        const QTemporaryDir folder;
        const auto write = [&folder] { return writeSweepFiles(folder.path(), oneRun(), {}); };
        const auto contents = [&folder] {
            QFile file(folder.filePath(QStringLiteral("sweep.json")));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QVERIFY(write().written);
        const QByteArray old = contents();
        QVERIFY(!old.isEmpty());
        const SweepFiles failed = [&write] {
            const test::FileSizeLimit limit(10);
            return write();
        }();
        QVERIFY(!failed.written);
        QVERIFY2(QByteArray::fromStdString(failed.problem.text()).endsWith("sweep.json: cannot be written: File too large"),
                 failed.problem.text().c_str());
        QCOMPARE(contents(), old);
    }
};

SKYSEAL_TEST(SweepFilesTest)
#include "sweep_files_test.moc"
