// A file on its way from or to the vehicle, and the requests for its chunks, without any message.
#include "core/vehicle/chunk_requests.h"
#include "core/vehicle/file_transfer.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

class FileTransferTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sizeOfVirtualFileIsAnEstimate();
    void sizesAreBounded();
    void fileMayEndSooner();
    void checksums();
    void resultHasTheContentOnce();
    void answersBelongToRequests();
};

void FileTransferTest::sizeOfVirtualFileIsAnEstimate()
{
    FileTransfer real({}, FileAction::Read, "/log.bin"), made({}, FileAction::Read, "@PARAM/param.pck");
    QVERIFY(real.announce(1000));
    QVERIFY(!real.isEstimate());
    QCOMPARE(real.chunks(), std::size_t(5));
    QVERIFY(made.announce(1000));
    QVERIFY(made.isEstimate());
    QCOMPARE(made.size(), FileTransfer::kLeastRoom + 4000);
    QCOMPARE(made.announcedSize(), std::size_t(1000));
    QVERIFY(made.announce(0xFFFFFFFF));
    QCOMPARE(made.size(), FileTransfer::kMostBytes);
}

void FileTransferTest::sizesAreBounded()
{
    FileTransfer file({}, FileAction::Read, "/log.bin");
    QVERIFY(file.announce(FileTransfer::kMostBytes));
    QVERIFY(!file.announce(FileTransfer::kMostBytes + 1));
    QVERIFY(!FileTransfer({}, FileAction::Write, "/a").setSource(nullptr));
    FileTransfer folder({}, FileAction::List, "/");
    QVERIFY(folder.addEntries({{}, FileTransfer::kMostEntries}));
    QVERIFY(!folder.addEntries({{}, 1}));
}

void FileTransferTest::fileMayEndSooner()
{
    FileTransfer file({}, FileAction::Read, "@SYS/tasks.txt");
    QVERIFY(file.announce(10));
    file.store(0, Bytes(FileTransfer::kChunk, 1));
    QVERIFY(!file.endAt(FileTransfer::kChunk - 1)); // more has arrived
    QVERIFY(file.endAt(FileTransfer::kChunk));
    QVERIFY(!file.isEstimate());
    QCOMPARE(file.size(), FileTransfer::kChunk);
    QCOMPARE(file.announcedSize(), FileTransfer::kChunk);
}

void FileTransferTest::checksums()
{
    FileTransfer file({}, FileAction::Write, "/a");
    QVERIFY(file.setSource(std::make_shared<const Bytes>(Bytes{1, 2, 3})));
    QVERIFY(file.verify(std::nullopt));
    QVERIFY(!file.takeResult(true).verified);
    QVERIFY(file.setSource(std::make_shared<const Bytes>(Bytes{1, 2, 3})));
    QVERIFY(!file.verify(mavlink::ftpChecksum(Bytes{1, 2, 4})));
    QVERIFY(file.verify(mavlink::ftpChecksum(Bytes{1, 2, 3})));
    QVERIFY(file.takeResult(true).verified);
}

void FileTransferTest::resultHasTheContentOnce()
{
    FileTransfer file(RequestId{7}, FileAction::Read, "/a");
    QVERIFY(file.announce(3));
    file.store(0, Bytes{1, 2, 3});
    const FileResult result = file.takeResult(true);
    QCOMPARE(result.id, RequestId{7});
    QCOMPARE(*result.content, (Bytes{1, 2, 3}));
    QCOMPARE(file.end(), std::size_t(0));
    QVERIFY(!file.takeResult(false).content);
}

void FileTransferTest::answersBelongToRequests()
{
    ChunkRequests requests;
    QVERIFY(!requests.answeredBy(1)); // no request was sent
    requests.sent(0xFFFF, 5);
    QCOMPARE(requests.answeredBy(0), std::optional<std::size_t>(5));
    requests.sent(10, 6);
    requests.sent(static_cast<std::uint16_t>(10 + ChunkRequests::kKept), 7);
    QVERIFY(!requests.answeredBy(11)); // too old
    QCOMPARE(requests.answeredBy(static_cast<std::uint16_t>(11 + ChunkRequests::kKept)), std::optional<std::size_t>(7));
    requests.clear();
    QVERIFY(!requests.answeredBy(0));
}

SKYSEAL_TEST_APPLESS(FileTransferTest)
#include "file_transfer_test.moc"
