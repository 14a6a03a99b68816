// Changes of the list of peers take effect where the system notifies of them, where it cannot, and where its notifications
// never arrive, as on a network file system.
#include "app/common/peers_watch.h"
#include "tests/app/inotify_double.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::app;
using namespace skyseal::test;

namespace {

Result<keys::UsablePeers, InputError> readNothing()
{
    return keys::UsablePeers{};
}

} // namespace

class PeersWatchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { inotifyIs = Inotify::Works; }
    void changeWithoutNotification_data();
    void changeWithoutNotification();
    void halfWrittenFileIsNotRead();
    void recoveryIsReported();
    void changeBetweenReadingAndWatching();
    void failedReadIsRetried();
    void hangingDiskStopsNothing();
    void eventsForPeopleAndScripts();
};

static void write(const QString &path, const QByteArray &content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(content);
}

void PeersWatchTest::changeWithoutNotification_data()
{
    QTest::addColumn<int>("inotify");
    QTest::addColumn<bool>("replaced");
    QTest::newRow("notified, changed in place") << int(Inotify::Works) << false;
    QTest::newRow("notified, replaced") << int(Inotify::Works) << true;
    QTest::newRow("no watches left, changed in place") << int(Inotify::UsedUp) << false;
    QTest::newRow("no watches left, replaced") << int(Inotify::UsedUp) << true;
    QTest::newRow("silent, changed in place") << int(Inotify::Silent) << false;
    QTest::newRow("silent, replaced") << int(Inotify::Silent) << true;
}

void PeersWatchTest::changeWithoutNotification()
{
    QFETCH(int, inotify);
    QFETCH(bool, replaced);
    inotifyIs = static_cast<Inotify>(inotify);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    write(path, "one");
    int loads = 0, failures = 0;
    PeersWatch watch(path.toStdString(), readNothing, [&](const auto &) { ++loads; });
    QObject::connect(&watch, &PeersWatch::notificationFailed, &watch, [&](bool failed) { failures += failed ? 1 : 100; });
    if (inotifyIs == Inotify::UsedUp)
        EVENTUALLY(failures > 0);
    EVENTUALLY_EQUAL(loads, 1);
    if (replaced) {
        write(path + QStringLiteral(".new"), "two");
        QCOMPARE(::rename((path + QStringLiteral(".new")).toLocal8Bit().constData(), path.toLocal8Bit().constData()), 0);
    } else {
        write(path, "two");
    }
    EVENTUALLY_EQUAL(loads, 2);
    QCOMPARE(failures, inotifyIs == Inotify::UsedUp ? 1 : 0); // once, not each second
}

/// Between the two steps of an editor the file is an empty list, which would end every session.
void PeersWatchTest::halfWrittenFileIsNotRead()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    std::atomic<int> empty = 0, read = 0;
    const auto readFile = [&]() -> Result<keys::UsablePeers, InputError> {
        ++(QFileInfo(path).size() == 0 ? empty : read);
        return keys::UsablePeers{};
    };
    std::atomic<int> now = 0; // ms
    std::atomic<int> looks = 0;
    const auto clock = [&] {
        ++looks;
        return std::chrono::steady_clock::time_point(std::chrono::milliseconds(now));
    };
    write(path, "one");
    PeersWatch watch(
        path.toStdString(), readFile, [](const auto &) {}, clock);
    EVENTUALLY(read == 1);
    write(path, "");
    const int before = looks;
    EVENTUALLY(looks > before); // found empty
    now = 900;
    const int later = looks;
    EVENTUALLY(looks > later + 3);
    QCOMPARE(empty.load(), 0);
    write(path, "two");
    const int written = looks;
    EVENTUALLY(looks > written + 1);
    now = 1'800;
    EVENTUALLY(read == 2);
    QCOMPARE(empty.load(), 0);
    // A file that stays empty is an empty list.
    write(path, "");
    const int emptied = looks;
    EVENTUALLY(looks > emptied);
    QCOMPARE(empty.load(), 0);
    now = 2'801;
    EVENTUALLY(empty == 1);
}

void PeersWatchTest::recoveryIsReported()
{
    inotifyIs = Inotify::UsedUp;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    write(path, "one");
    PeersWatch watch(path.toStdString(), readNothing, [](const auto &) {});
    std::vector<bool> reports;
    QObject::connect(&watch, &PeersWatch::notificationFailed, &watch, [&](bool failed) { reports.push_back(failed); });
    EVENTUALLY(reports.size() == 1);
    inotifyIs = Inotify::Works;
    write(path, "two"); // watched again at the next change, or a minute later
    EVENTUALLY(reports.size() == 2);
    QCOMPARE(reports, (std::vector<bool>{true, false}));
}

/// Between the first reading of the list and the watch a program may wait for seconds, for example for a lock.
void PeersWatchTest::changeBetweenReadingAndWatching()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    const auto content = [&path] {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    write(path, "pilot and thief");
    QByteArray inForce = content();
    write(path, "pilot");
    const PeersWatch watch(path.toStdString(), readNothing, [&](const auto &) { inForce = content(); });
    EVENTUALLY_EQUAL(inForce, QByteArray("pilot"));
}

void PeersWatchTest::failedReadIsRetried()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    write(path, "one");
    std::atomic<bool> fails = false;
    std::atomic<int> failed = 0;
    int refused = 0, reloaded = 0, applied = 0;
    const auto read = [&]() -> Result<keys::UsablePeers, InputError> {
        if (!fails)
            return keys::UsablePeers{};
        ++failed;
        return tl::unexpected(InputError{"the disk does not answer", {}});
    };
    PeersWatch watch(path.toStdString(), read, [&](const auto &) { ++applied; });
    QObject::connect(&watch, &PeersWatch::refused, &watch, [&] { ++refused; });
    QObject::connect(&watch, &PeersWatch::reloaded, &watch, [&] { ++reloaded; });
    EVENTUALLY_EQUAL(applied, 1);
    fails = true;
    write(path, "two");
    EVENTUALLY(failed >= 3);
    QCOMPARE(refused, 1); // once, not each second
    QCOMPARE(reloaded, 0);
    fails = false;
    EVENTUALLY(reloaded == 1);
    QCOMPARE(applied, 2);
}

/// Neither the event loop nor the end of the program waits for a disk that hangs, and the user is told.
void PeersWatchTest::hangingDiskStopsNothing()
{
    struct Hang
    {
        std::mutex mutex;
        std::condition_variable over;
        bool hangs = true;
    };
    const auto hang = std::make_shared<Hang>();
    const auto read = [hang]() -> Result<keys::UsablePeers, InputError> {
        std::unique_lock lock(hang->mutex);
        hang->over.wait(lock, [&] { return !hang->hangs; });
        return keys::UsablePeers{};
    };
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    write(path, "one");
    int applied = 0;
    Reason problem;
    auto watch = std::make_unique<PeersWatch>(path.toStdString(), read, [&](const auto &) { ++applied; });
    QObject::connect(watch.get(), &PeersWatch::refused, watch.get(), [&](const Reason &why) { problem = why; });
    EVENTUALLY(!problem.empty());
    QVERIFY2(problem.text().ends_with("peers: the disk does not answer"), problem.text().c_str());
    const std::string marked = problem.text(
        [](const Sentence &sentence) { return "<" + std::string(sentence.english()) + ">"; });
    QVERIFY2(marked.ends_with("<the disk does not answer>>"), marked.c_str()); // the window translates it
    watch.reset();
    QCOMPARE(applied, 0);
    {
        const std::lock_guard lock(hang->mutex);
        hang->hangs = false;
    }
    hang->over.notify_all();
}

void PeersWatchTest::eventsForPeopleAndScripts()
{
    QCOMPARE(peersWatchEvent(true), std::string(R"({"event":"peers_watch","notified":false})"));
    QVERIFY(peersWatchText(true).find("once a second") != std::string::npos);
    QVERIFY(peersWatchText(false) != peersWatchText(true));
}

SKYSEAL_TEST(PeersWatchTest)
#include "peers_watch_test.moc"
