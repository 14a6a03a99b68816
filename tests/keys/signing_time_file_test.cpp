// The stored time of signatures: kept over restarts, never lesser, and no trouble of the disk holds the signer up.
#include "core/keys/signing_time_file.h"
#include "tests/keys/temporary_folder.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <atomic>
#include <mutex>
#include <vector>

using namespace skyseal;
using namespace skyseal::keys;
using namespace skyseal::test;

class SigningTimeFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void timeIsKeptOverRestarts();
    void lesserTimesAreNotStored();
    void wrongFilesAreRefused_data();
    void wrongFilesAreRefused();
    void othersMayNotChangeIt();
    void failingDiskIsReportedAndHoldsNothingUp();

private:
    TemporaryFolder m_folder;
};

void SigningTimeFileTest::timeIsKeptOverRestarts()
{
    const std::string path = m_folder.path("kept");
    {
        const auto file = SigningTimeFile::open(path);
        QVERIFY(file && (*file)->storedAtStart() == 0);
        (*file)->store(1234567);
    }
    QCOMPARE(readText(path), std::string("skyseal-signing-time-v1\n1234567\n"));
    QCOMPARE(int(modeOf(path)), 0600);
    const auto again = SigningTimeFile::open(path);
    QVERIFY(again);
    QCOMPARE((*again)->storedAtStart(), std::uint64_t(1234567));
    QVERIFY((*again)->problem().empty());
}

void SigningTimeFileTest::lesserTimesAreNotStored()
{
    std::vector<std::uint64_t> written; // used by the other thread until the file is closed
    {
        SigningTimeFile file(
            10,
            [&written](std::uint64_t time) -> Result<void, InputError> {
                written.push_back(time);
                return {};
            },
            "file");
        file.store(9);
        file.store(10);
        file.store(20);
        file.store(15);
    }
    QCOMPARE(written, std::vector<std::uint64_t>{20});
}

void SigningTimeFileTest::wrongFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("header only") << QByteArray("skyseal-signing-time-v1\n");
    QTest::newRow("another header") << QByteArray("skyseal-counters-v1\n5\n");
    QTest::newRow("cut short") << QByteArray("skyseal-signing-time-v1\n12345");
    QTest::newRow("no number") << QByteArray("skyseal-signing-time-v1\nfive\n");
    QTest::newRow("negative") << QByteArray("skyseal-signing-time-v1\n-5\n");
    QTest::newRow("more behind it") << QByteArray("skyseal-signing-time-v1\n5\n6\n");
    QTest::newRow("beyond 48 bits") << QByteArray("skyseal-signing-time-v1\n281474976710656\n");
}

void SigningTimeFileTest::wrongFilesAreRefused()
{
    QFETCH(QByteArray, content);
    const std::string path = m_folder.write("wrong", content.toStdString());
    const auto file = SigningTimeFile::open(path);
    QVERIFY(!file);
    QCOMPARE(file.error().source, path);
    QCOMPARE(readText(path), content.toStdString());
}

void SigningTimeFileTest::othersMayNotChangeIt()
{
    QVERIFY(SigningTimeFile::open(m_folder.write("open", "skyseal-signing-time-v1\n5\n", 0644)));
    QVERIFY(!SigningTimeFile::open(m_folder.write("open", "skyseal-signing-time-v1\n5\n", 0666)));
}

void SigningTimeFileTest::failingDiskIsReportedAndHoldsNothingUp()
{
    std::atomic<bool> entered = false;
    std::mutex disk;
    disk.lock(); // does not answer
    SigningTimeFile file(
        0,
        [&](std::uint64_t) -> Result<void, InputError> {
            entered = true;
            const std::lock_guard lock(disk);
            return tl::unexpected(InputError{"no space is left", "file"});
        },
        "file");
    file.store(1); // these return although the disk does not answer
    EVENTUALLY(entered.load());
    file.store(2);
    QVERIFY(file.problem().empty());
    disk.unlock();
    EVENTUALLY_EQUAL(file.problem(), std::string("file: no space is left"));
}

SKYSEAL_TEST_APPLESS(SigningTimeFileTest)
#include "signing_time_file_test.moc"
