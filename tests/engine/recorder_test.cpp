// The recorder: what it writes can be read back, a crash loses at most the last second, and a failing disk stops nothing.
#include "core/engine/station/recorder.h"
#include "core/base/hex.h"
#include "core/engine/station/link_event_file.h"
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

tlog::LinkEvent switched(int number, const std::string &suite)
{
    return {tlog::LinkEvent::Kind::Switched, timeOf(number), suite, "air-1"};
}

/// Of the only recording in the folder.
tlog::LinkEvents eventsIn(const QString &folder)
{
    const QStringList files = QDir(folder).entryList({QStringLiteral("*.tlog")}, QDir::Files);
    return files.size() == 1 ? tlog::linkEventsOf((folder + QLatin1Char('/') + files[0]).toStdString()) : tlog::LinkEvents();
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
    void suitesAreNotedBesideIt();
    void nextRecordingBeginsWithTheSuitesInUse();
    void notesAreBounded();
    void suitesWithoutFramesLeaveNoFile();
    void suitesThatCannotBeWrittenStopNothing();

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
    std::optional<RecordingSnapshot> problem; // before a frame
    QVERIFY(test::eventually([&] { return (problem = recorder.takeProblem()).has_value(); }));
    QVERIFY(problem->file.find("/dev/null/flights") == 0);
    QCOMPARE(problem->problem.text(), std::string("cannot be created: Not a directory"));
    for (int i = 0; i < 2; ++i)
        recorder.record(timeOf(i), kFrame);
    EVENTUALLY_EQUAL(recorder.snapshot().dropped, std::uint64_t(2));
    QVERIFY(!recorder.takeProblem()); // reported once
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
    QCOMPARE(problem->problem.text(), std::string("less than 1099511627776 MiB are free there"));
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
        _exit(problem->problem.text().starts_with("cannot be written") ? 0 : 1);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    QVERIFY(QDir(m_folder->path()).entryList(QDir::Files).isEmpty());
}

void RecorderTest::suitesAreNotedBesideIt()
{
    {
        Recorder recorder(m_folder->path().toStdString());
        recorder.record(timeOf(0), kFrame);
        EVENTUALLY_EQUAL(recorder.snapshot().frames, std::uint64_t(1));
        recorder.note(switched(1, "aes-256-gcm"));
        recorder.note(switched(2, "chacha20-poly1305"));
        recorder.record(timeOf(3), kFrame);
    }
    const tlog::LinkEvents noted = eventsIn(m_folder->path());
    QCOMPARE(noted.unreadable, std::uint64_t(0));
    QCOMPARE(noted.events, (std::vector{switched(1, "aes-256-gcm"), switched(2, "chacha20-poly1305")}));
    QCOMPARE(summaryOf(m_folder->path()).frames, std::uint64_t(2));
    QVERIFY(summaryOf(m_folder->path()).isSound()); // a plain .tlog
    const QFileInfoList files = QDir(m_folder->path()).entryInfoList({QStringLiteral("*.events")}, QDir::Files);
    QVERIFY(!(files.at(0).permissions() & (QFile::ReadGroup | QFile::ReadOther)));
}

void RecorderTest::nextRecordingBeginsWithTheSuitesInUse()
{
    const std::string first = m_folder->filePath(QStringLiteral("1.tlog")).toStdString(),
                      second = m_folder->filePath(QStringLiteral("2.tlog")).toStdString();
    std::ofstream(tlog::linkEventsFile(second)) << "of a recording that was deleted\n";
    LinkEventFile file;
    QVERIFY(file.add({switched(-20, "aes-256-gcm"), switched(-10, "chacha20-poly1305")})); // before any recording
    file.begin(first);
    QVERIFY(file.add({}));
    QVERIFY(file.add({switched(5, "aes-256-ctr")}));
    file.begin(second);
    QVERIFY(file.add({switched(8, "aes-256-gcm")}));
    file.end();
    QVERIFY(file.add({switched(9, "rc4")}));
    const auto inUse = [](int number, const std::string &suite) {
        tlog::LinkEvent out = switched(number, suite);
        out.kind = tlog::LinkEvent::Kind::Sealed;
        return out;
    };
    QCOMPARE(tlog::linkEventsOf(first).events, (std::vector{inUse(-10, "chacha20-poly1305"), switched(5, "aes-256-ctr")}));
    QCOMPARE(tlog::linkEventsOf(second).events, (std::vector{inUse(5, "aes-256-ctr"), switched(8, "aes-256-gcm")}));
    QCOMPARE(tlog::linkEventsOf(first).unreadable + tlog::linkEventsOf(second).unreadable, std::uint64_t(0));
}

void RecorderTest::notesAreBounded()
{
    const std::string recording = m_folder->filePath(QStringLiteral("1.tlog")).toStdString();
    LinkEventFile file;
    file.begin(recording);
    QVERIFY(file.add(std::vector(tlog::LinkEvents::kMost + 100, switched(0, "rc4"))));
    file.end();
    QCOMPARE(tlog::linkEventsOf(recording).events.size(), tlog::LinkEvents::kMost);
    QCOMPARE(tlog::linkEventsOf(recording).unreadable, std::uint64_t(0)); // all that was written is read
}

void RecorderTest::suitesWithoutFramesLeaveNoFile()
{
    {
        Recorder recorder(m_folder->path().toStdString());
        recorder.note(switched(0, "aes-256-gcm"));
    }
    QVERIFY(QDir(m_folder->path()).entryList(QDir::Files).isEmpty());
}

void RecorderTest::suitesThatCannotBeWrittenStopNothing()
{
    Recorder recorder(m_folder->path().toStdString());
    recorder.record(timeOf(0), kFrame);
    EVENTUALLY_EQUAL(recorder.snapshot().frames, std::uint64_t(1));
    const std::string events = tlog::linkEventsFile(recorder.snapshot().file);
    QVERIFY(QDir().mkpath(QString::fromStdString(events))); // a folder is in the way
    recorder.note(switched(1, "aes-256-gcm"));
    std::optional<RecordingSnapshot> problem;
    QVERIFY(test::eventually([&] { return (problem = recorder.takeProblem()).has_value(); }));
    QCOMPARE(problem->file, events);
    recorder.note(switched(2, "aes-256-gcm"));
    recorder.record(timeOf(3), kFrame);
    EVENTUALLY_EQUAL(recorder.snapshot().frames, std::uint64_t(2));
    QVERIFY(recorder.snapshot().problem.empty());
    QVERIFY(!recorder.takeProblem()); // reported once
}

SKYSEAL_TEST(RecorderTest)
#include "recorder_test.moc"
