// Replay of recordings that the test writes: every frame in order, at the recorded pace, and errors for unreadable files.
#include "core/log/tlog_writer.h"
#include "tests/link/block_recorder.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <fstream>

using namespace skyseal;
using namespace skyseal::link;
using namespace skyseal::test;

class TlogLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void playsEveryFrameInOrder();
    void keepsTheRecordedPace();
    void playsAgainAfterTheEnd();
    void damageIsSkipped();
    void clockThatWasSetIsNotWaitedFor_data();
    void clockThatWasSetIsNotWaitedFor();
    void fileWithoutFramesFails();
    void unreadableFilesAreReported();

private:
    std::string record(int frames, std::chrono::milliseconds every, std::string_view damage = {});
    QTemporaryDir m_folder;
    int m_files = 0;
};

/// A MAVLink 1 HEARTBEAT; the checksum is CRC-16/MCRF4XX over header, payload and the message's extra byte, 50.
static Bytes heartbeat(std::uint8_t sequence)
{
    Bytes out{0xfe, 9, sequence, 1, 1, 0, 0, 0, 0, 0, 2, 3, 81, 3, 3};
    std::uint16_t crc = 0xffff;
    Bytes covered(out.begin() + 1, out.end());
    covered.push_back(50);
    for (const std::uint8_t byte : covered) {
        crc = static_cast<std::uint16_t>(crc ^ byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>(crc & 1 ? crc >> 1 ^ 0x8408 : crc >> 1);
    }
    out.push_back(static_cast<std::uint8_t>(crc));
    out.push_back(static_cast<std::uint8_t>(crc >> 8));
    return out;
}

std::string TlogLinkTest::record(int frames, std::chrono::milliseconds every, std::string_view damage)
{
    const std::string path = m_folder.filePath(QStringLiteral("%1.tlog").arg(m_files++)).toStdString();
    std::ofstream file(path, std::ios::binary);
    tlog::TlogWriter writer([&](ByteView entry) {
        file << asText(entry);
        return file.good();
    });
    WallTime time{std::chrono::seconds(1'700'000'000)};
    for (int i = 0; i < frames; ++i, time += every) {
        writer.write(time, heartbeat(static_cast<std::uint8_t>(i)));
        if (i == frames / 2)
            file << damage;
    }
    return path;
}

void TlogLinkTest::playsEveryFrameInOrder()
{
    LinkOptions fast;
    fast.replayFactor = 0;
    BlockRecorder recorder;
    const auto link = openLink("tlog:" + record(1000, std::chrono::seconds(1)), recorder, fast, LinkId{9});
    QCOMPARE(link->state(), LinkState::Connected);
    QVERIFY(recorder.blocks.empty());
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    QCOMPARE(link->error().code, LinkErrorCode::EndOfFile);
    QCOMPARE(recorder.blocks.size(), std::size_t(1000));
    for (int i = 0; i < 1000; ++i) {
        QCOMPARE(recorder.blocks[std::size_t(i)].bytes, heartbeat(static_cast<std::uint8_t>(i)));
        QCOMPARE(recorder.blocks[std::size_t(i)].path, (Path{LinkId{9}, {}}));
    }
    link->send({}, asBytes("into the void"));
    QCOMPARE(link->counters().txDropped, std::uint64_t(1));
    QCOMPARE(link->counters().rxErrors, std::uint64_t(0));
}

void TlogLinkTest::keepsTheRecordedPace()
{
    LinkOptions fourfold;
    fourfold.replayFactor = 4;
    BlockRecorder recorder;
    QElapsedTimer clock;
    clock.start();
    // 21 frames over 2 s, four times as fast.
    const auto link = openLink("tlog:" + record(21, std::chrono::milliseconds(100)), recorder, fourfold);
    qint64 lastEarly = 0;
    recorder.onReceived = [&](Link &) {
        const auto expected = qint64(recorder.blocks.size() - 1) * 25;
        if (clock.elapsed() < expected)
            ++lastEarly;
    };
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    QCOMPARE(recorder.blocks.size(), std::size_t(21));
    QCOMPARE(lastEarly, qint64(0));
    QVERIFY(clock.elapsed() >= 500);
}

void TlogLinkTest::playsAgainAfterTheEnd()
{
    LinkOptions fast;
    fast.replayFactor = 0;
    BlockRecorder recorder;
    const auto link = openLink("tlog:" + record(5, std::chrono::seconds(1)), recorder, fast);
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    link->open();
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    QCOMPARE(recorder.blocks.size(), std::size_t(10));
    recorder.onReceived = [](Link &playing) { playing.close(); };
    link->open();
    EVENTUALLY_EQUAL(link->state(), LinkState::Closed);
}

void TlogLinkTest::damageIsSkipped()
{
    LinkOptions fast;
    fast.replayFactor = 0;
    BlockRecorder recorder;
    const auto link = openLink("tlog:" + record(20, std::chrono::seconds(1), "not a frame at all"), recorder, fast);
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    QCOMPARE(recorder.blocks.size(), std::size_t(20));
    QVERIFY(link->counters().rxErrors > 0);
}

void TlogLinkTest::clockThatWasSetIsNotWaitedFor_data()
{
    QTest::addColumn<qint64>("step");
    QTest::newRow("back by an hour") << qint64(-3600);
    QTest::newRow("forward by an hour") << qint64(3600);
    QTest::newRow("forward by 50 years") << qint64(50) * 365 * 86400;
}

void TlogLinkTest::clockThatWasSetIsNotWaitedFor()
{
    QFETCH(qint64, step);
    const std::string path = m_folder.filePath(QStringLiteral("set.tlog")).toStdString();
    {
        std::ofstream file(path, std::ios::binary);
        tlog::TlogWriter writer([&](ByteView entry) {
            file << asText(entry);
            return file.good();
        });
        WallTime time{std::chrono::seconds(1'700'000'000)};
        for (int i = 0; i < 20; ++i, time += std::chrono::milliseconds(100)) {
            if (i == 10)
                time += std::chrono::seconds(step);
            writer.write(time, heartbeat(static_cast<std::uint8_t>(i)));
        }
    }
    LinkOptions tenfold;
    tenfold.replayFactor = 10;
    BlockRecorder recorder;
    const auto link = openLink("tlog:" + path, recorder, tenfold);
    EVENTUALLY_EQUAL(link->state(), LinkState::Ended);
    QCOMPARE(recorder.blocks.size(), std::size_t(20));
}

void TlogLinkTest::fileWithoutFramesFails()
{
    const std::string path = m_folder.filePath(QStringLiteral("letter.tlog")).toStdString();
    std::ofstream(path, std::ios::binary) << "this is a letter, not a recording of a flight";
    BlockRecorder recorder;
    const auto link = openLink("tlog:" + path, recorder);
    EVENTUALLY_EQUAL(link->state(), LinkState::Failed);
    QCOMPARE(link->error().sentence(), "cannot read " + path + ": it contains no MAVLink frame");
    QVERIFY(recorder.blocks.empty());
}

void TlogLinkTest::unreadableFilesAreReported()
{
    BlockRecorder recorder;
    const auto missing = openLink("tlog:/no/such/file.tlog", recorder);
    QCOMPARE(missing->state(), LinkState::Failed);
    QCOMPARE(missing->error().sentence(), std::string("cannot read /no/such/file.tlog: No such file or directory"));
    const auto folder = openLink("tlog:" + m_folder.path().toStdString(), recorder);
    QCOMPARE(folder->state(), LinkState::Failed);
    QCOMPARE(folder->error().code, LinkErrorCode::FileUnreadable);
}

SKYSEAL_TEST(TlogLinkTest)
#include "tlog_link_test.moc"
