// The recorder: what it writes can be read back, a crash loses at most the last second, and a failing disk stops nothing.
#include "core/engine/station/recorder.h"
#include "core/base/hex.h"
#include "core/log/log_summary.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <csignal>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

const Bytes kFrame = *fromHex("fd090000010f1b000000221e0769f237925b0352fa");

WallTime timeOf(int number)
{
    return WallTime(std::chrono::seconds(1'700'000'000) + std::chrono::milliseconds(number));
}

tlog::LogSummary summaryOf(const QString &folder)
{
    const QStringList files = QDir(folder).entryList({QStringLiteral("*.tlog")}, QDir::Files);
    if (files.size() != 1)
        return {};
    std::ifstream file((folder + QLatin1Char('/') + files[0]).toStdString(), std::ios::binary);
    return tlog::summarize(file, mavlink::Dialect::builtin());
}

} // namespace

class RecorderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void writesWhatItWasGiven();
    void onlyTheOwnerReadsIt();
    void killedProcessLosesAtMostASecond();
    void fullBufferDropsAndCounts();
    void unwritableFolderIsReported();
    void emptyRecordingLeavesNoFile();
    void leavesSpaceFree();
    void failedWriteLeavesNoEmptyFile();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void RecorderTest::writesWhatItWasGiven()
{
    const QString folder = m_folder->filePath(QStringLiteral("made/by/it"));
    {
        Recorder recorder(folder.toStdString());
        for (int i = 0; i < 1000; ++i)
            recorder.record(timeOf(i), kFrame);
    }
    const tlog::LogSummary summary = summaryOf(folder);
    QVERIFY(summary.isSound());
    QCOMPARE(summary.frames, std::uint64_t(1000));
    QVERIFY(summary.first == timeOf(0));
    QVERIFY(summary.last == timeOf(999));
}

void RecorderTest::onlyTheOwnerReadsIt()
{
    const mode_t before = umask(0);
    {
        Recorder recorder(m_folder->path().toStdString());
        recorder.record(timeOf(0), kFrame);
    }
    umask(before);
    const QFileInfoList files = QDir(m_folder->path()).entryInfoList({QStringLiteral("*.tlog")}, QDir::Files);
    QCOMPARE(files.size(), 1);
    QVERIFY(!(files[0].permissions() & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther)));
}

void RecorderTest::killedProcessLosesAtMostASecond()
{
    const std::string folder = m_folder->path().toStdString();
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) {
        Recorder recorder(folder);
        for (int i = 0; i < 100; ++i)
            recorder.record(timeOf(i), kFrame);
        while (recorder.snapshot().frames < 100)
            std::this_thread::yield();
        for (int i = 100; i < 200; ++i)
            recorder.record(timeOf(i), kFrame);
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status));
    const tlog::LogSummary summary = summaryOf(m_folder->path());
    QVERIFY(summary.frames >= 100);
    QVERIFY(summary.isSound());
}

void RecorderTest::fullBufferDropsAndCounts()
{
    Recorder recorder(m_folder->path().toStdString(), 1000);
    for (int i = 0; i < 1000; ++i)
        recorder.record(timeOf(i), kFrame);
    const RecordingSnapshot at = recorder.snapshot();
    QVERIFY(at.dropped > 0);
    EVENTUALLY_EQUAL(recorder.snapshot().frames + recorder.snapshot().dropped, std::uint64_t(1000));
}

void RecorderTest::unwritableFolderIsReported()
{
    Recorder recorder("/dev/null/flights");
    recorder.record(timeOf(0), kFrame);
    std::optional<RecordingSnapshot> problem;
    QVERIFY(test::eventually([&] { return (problem = recorder.takeProblem()).has_value(); }));
    QVERIFY(problem->file.find("/dev/null/flights") == 0);
    QVERIFY(!problem->problem.empty());
    QVERIFY(!recorder.takeProblem()); // reported once
    recorder.record(timeOf(1), kFrame);
    EVENTUALLY_EQUAL(recorder.snapshot().dropped, std::uint64_t(2));
}

void RecorderTest::emptyRecordingLeavesNoFile()
{
    {
        Recorder recorder(m_folder->path().toStdString());
    }
    QVERIFY(QDir(m_folder->path()).entryList(QDir::Files).isEmpty());
}

void RecorderTest::leavesSpaceFree()
{
    const QString folder = m_folder->filePath(QStringLiteral("flights"));
    Recorder recorder(folder.toStdString(), 4096, std::uint64_t(1) << 60); // more than any disk has
    recorder.record(timeOf(0), kFrame);
    std::optional<RecordingSnapshot> problem;
    QVERIFY(test::eventually([&] { return (problem = recorder.takeProblem()).has_value(); }));
    QCOMPARE(problem->problem, std::string("less than 1099511627776 MiB are free there"));
    recorder.record(timeOf(1), kFrame);
    EVENTUALLY_EQUAL(recorder.snapshot().dropped, std::uint64_t(2));
    QVERIFY(!recorder.takeProblem()); // reported once
    QVERIFY(QDir(folder).entryList(QDir::Files).isEmpty());
}

void RecorderTest::failedWriteLeavesNoEmptyFile()
{
    const std::string folder = m_folder->path().toStdString();
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) { // its files can be created but not written
        signal(SIGXFSZ, SIG_IGN);
        const rlimit none{0, 0};
        setrlimit(RLIMIT_FSIZE, &none);
        Recorder recorder(folder, 4096, 0);
        recorder.record(timeOf(0), kFrame);
        std::optional<RecordingSnapshot> problem;
        while (!(problem = recorder.takeProblem()))
            std::this_thread::yield();
        _exit(problem->problem.starts_with("cannot be written") ? 0 : 1);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    QVERIFY(QDir(m_folder->path()).entryList(QDir::Files).isEmpty());
}

SKYSEAL_TEST(RecorderTest)
#include "recorder_test.moc"
