// The bytes of a log that is read: pieces, missing runs, and a log that is shorter than it was listed.
#include "core/vehicle/log_content.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

constexpr std::size_t kChunk = LogContent::kChunk;

QList<QPair<int, int>> missing(const LogContent &log, std::size_t most = 48)
{
    QList<QPair<int, int>> out;
    for (const LogContent::Run &run : log.missing(most))
        out.append({static_cast<int>(run.first), static_cast<int>(run.end)});
    return out;
}

} // namespace

class LogContentTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsOfMissingChunks();
    void piecesFollow();
    void logMayEndSooner();
};

void LogContentTest::runsOfMissingChunks()
{
    LogContent log(10 * kChunk);
    QCOMPARE(missing(log), (QList<QPair<int, int>>{{0, 10}}));
    const Bytes chunk(kChunk, 1);
    for (const std::size_t index : {0u, 3u, 7u})
        QVERIFY(log.store(index, chunk));
    QVERIFY(!log.store(3, chunk));
    QVERIFY(!log.store(10, chunk));
    QCOMPARE(missing(log), (QList<QPair<int, int>>{{1, 3}, {4, 7}, {8, 10}}));
    QCOMPARE(missing(log, 2), (QList<QPair<int, int>>{{1, 3}, {4, 7}}));
    QCOMPARE(log.missingFrom(2)->first, std::size_t(2));
    QCOMPARE(log.missingFrom(2)->end, std::size_t(3));
    QCOMPARE(log.missingFrom(3)->first, std::size_t(4));
    QVERIFY(!log.missingFrom(10));
    QCOMPARE(log.received(), 3 * kChunk);
}

void LogContentTest::piecesFollow()
{
    LogContent log(LogContent::kPiece * kChunk + 1);
    QVERIFY(!log.isInPiece(LogContent::kPiece));
    for (std::size_t i = 0; i < LogContent::kPiece; ++i)
        QVERIFY(log.store(i, Bytes(kChunk, 1)));
    QVERIFY(log.isPieceComplete());
    QVERIFY(log.beginNextPiece());
    QCOMPARE(log.pieceOffset(), LogContent::kPiece * kChunk);
    QVERIFY(!log.isPieceComplete());
    QVERIFY(log.store(LogContent::kPiece, Bytes(kChunk, 2))); // of which one byte belongs to the log
    QVERIFY(log.isPieceComplete());
    QVERIFY(!log.beginNextPiece());
    const Bytes all = log.take();
    QCOMPARE(all.size(), LogContent::kPiece * kChunk + 1);
    QCOMPARE(all.back(), std::uint8_t(2));
}

void LogContentTest::logMayEndSooner()
{
    LogContent log(5 * kChunk);
    QVERIFY(log.store(2, Bytes(kChunk, 1)));
    QVERIFY(!log.endAt(2 * kChunk)); // more has arrived
    QVERIFY(log.endAt(3 * kChunk));
    QCOMPARE(log.size(), 3 * kChunk);
    QCOMPARE(missing(log), (QList<QPair<int, int>>{{0, 2}}));
}

SKYSEAL_TEST_APPLESS(LogContentTest)
#include "log_content_test.moc"
