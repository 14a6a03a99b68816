// Downloads that are broken off and go on: the journal of what has arrived, files by MAVLink FTP, and logs.
#include "core/vehicle/ftp_client.h"
#include "core/vehicle/log_client.h"
#include "ftp_peer.h"
#include "kept_sink.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class KeptPartTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void journalIsReadUpToItsLastWholePiece();
    void otherFilesAreNoJournal_data();
    void otherFilesAreNoJournal();
    void fileGoesOn_data();
    void fileGoesOn();
    void completeFileIsOnlyChecked();
    void changedFileIsNotGluedToItsOldHalf_data();
    void changedFileIsNotGluedToItsOldHalf();
    void fileWithoutAChecksumStartsAnew();
    void partRemainsIfTheChecksumDoesNotArrive();
    void virtualFileIsNotKept();
};

namespace {

constexpr std::size_t kKeptFile = 100'000;

/// Reads /a until the link is lost after `time`; returns the journal of what has arrived.
std::shared_ptr<JournalSink> brokenOff(FtpPeer &peer, double loss, Duration time)
{
    Harness h = Harness::copter();
    LossyLink link(h, peer, loss, 7);
    auto sink = std::make_shared<JournalSink>();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::ReadFile{"/a", nullptr, sink});
    link.run(time, [] { return false; });
    return sink;
}

} // namespace

void KeptPartTest::journalIsReadUpToItsLastWholePiece()
{
    JournalSink sink;
    sink.begin(1000, 1'700'000'000);
    const Bytes first = noise(239, 1), second = noise(100, 2);
    sink.append(239, first);
    const std::size_t whole = sink.journal.size();
    sink.append(900, second);
    const auto all = sink.kept();
    QVERIFY(all && all->source == "vehicle 1 file /a b" && all->size == 1000 && all->stamp == 1'700'000'000);
    QCOMPARE(all->pieces.size(), std::size_t(2));
    QVERIFY(std::ranges::equal(all->bytesOf(all->pieces[0]), first));
    QVERIFY(std::ranges::equal(all->bytesOf(all->pieces[1]), second));
    QCOMPARE(all->journalSize, sink.journal.size());
    for (std::size_t size = whole; size < sink.journal.size(); ++size) {
        const auto part = parsePart(ByteView(sink.journal).first(size));
        QVERIFY(part && part->pieces.size() == 1 && part->journalSize == whole);
    }
    for (std::size_t at = whole; at < sink.journal.size(); ++at) { // a damaged byte
        Bytes damaged = sink.journal;
        damaged[at] ^= 0x10;
        QCOMPARE(parsePart(damaged)->pieces.size(), std::size_t(1));
    }
    sink.journal.resize(sink.journal.size() + 500); // zeros, as after a power failure
    QCOMPARE(sink.kept()->pieces.size(), std::size_t(2));
    sink.begin(1000, 0);
    sink.append(950, second); // beyond the end
    QVERIFY(sink.kept()->pieces.empty());
}

void KeptPartTest::otherFilesAreNoJournal_data()
{
    QTest::addColumn<QByteArray>("content");
    for (const char *content : {"", "skyseal part 1 10 0 a", "a text\n", "skyseal part 2 10 0 a\n", "skyseal part 1 x 0 a\n",
                                "skyseal part 1 10 0\n", "skyseal part 1 99999999999 0 a\n", "skyseal part 1 4000000000 0 a\n"})
        QTest::newRow(content) << QByteArray(content);
}

void KeptPartTest::otherFilesAreNoJournal()
{
    QFETCH(QByteArray, content);
    QVERIFY(!parsePart(asBytes({content.constData(), static_cast<std::size_t>(content.size())})));
}

void KeptPartTest::fileGoesOn_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("milliseconds");
    for (const int time : {120, 200, 300}) {
        QTest::addRow("clean, %d ms", time) << 0. << time;
        QTest::addRow("a tenth lost, %d ms", time) << 0.1 << time;
    }
}

void KeptPartTest::fileGoesOn()
{
    QFETCH(double, loss);
    QFETCH(int, milliseconds);
    FtpPeer peer;
    peer.files["/a"] = noise(kKeptFile);
    const auto sink = brokenOff(peer, loss, std::chrono::milliseconds(milliseconds));
    sink->journal.resize(sink->journal.size() - 5); // killed while it wrote
    const auto kept = sink->kept();
    QVERIFY(kept && bytesIn(*kept) > 10'000 && bytesIn(*kept) < kKeptFile);
    sink->journal.resize(kept->journalSize);

    peer.bytesSent = 0;
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", kept, sink});
    QVERIFY2(result.ok && result.verified, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.files["/a"]);
    // Of the last 16 chunks each is requested twice.
    const std::size_t missing = kKeptFile - bytesIn(*kept), twice = 16 * FtpClient::kChunk;
    QVERIFY2(peer.bytesSent >= missing && peer.bytesSent <= missing + twice, std::to_string(peer.bytesSent).c_str());
    QCOMPARE(bytesIn(*sink->kept()), kKeptFile); // it would go on from here
}

void KeptPartTest::completeFileIsOnlyChecked()
{
    FtpPeer peer;
    peer.files["/a"] = noise(kKeptFile);
    const auto sink = brokenOff(peer, 0, std::chrono::seconds(5));
    QCOMPARE(bytesIn(*sink->kept()), kKeptFile);
    peer.bytesSent = 0;
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", sink->kept(), sink});
    QVERIFY2(result.ok && result.verified, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.files["/a"]);
    QCOMPARE(peer.bytesSent, std::size_t(0));
}

void KeptPartTest::changedFileIsNotGluedToItsOldHalf_data()
{
    QTest::addColumn<int>("size");
    QTest::newRow("same size") << int(kKeptFile);
    QTest::newRow("other size") << int(kKeptFile) - 1;
}

void KeptPartTest::changedFileIsNotGluedToItsOldHalf()
{
    QFETCH(int, size);
    FtpPeer peer;
    peer.files["/a"] = noise(kKeptFile, 1);
    const auto sink = brokenOff(peer, 0, std::chrono::milliseconds(200));
    peer.files["/a"] = noise(static_cast<std::size_t>(size), 2);
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    const FileResult glued = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", sink->kept(), sink});
    QVERIFY(!glued.ok && glued.unfit && !glued.content);
    const FileResult anew = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", nullptr, sink});
    QVERIFY2(anew.ok && anew.verified, anew.reason.text().c_str());
    QCOMPARE(*anew.content, peer.files["/a"]);
    QCOMPARE(bytesIn(*sink->kept()), static_cast<std::size_t>(size)); // nothing of the old one
}

void KeptPartTest::fileWithoutAChecksumStartsAnew()
{
    FtpPeer peer;
    peer.knowsChecksums = false;
    peer.files["/a"] = noise(kKeptFile);
    const auto sink = brokenOff(peer, 0, std::chrono::milliseconds(200));
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", sink->kept(), sink});
    QVERIFY(!result.ok && result.unfit);
    QVERIFY(resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", nullptr, sink}).ok);
}

void KeptPartTest::partRemainsIfTheChecksumDoesNotArrive()
{
    FtpPeer peer;
    peer.files["/a"] = noise(kKeptFile);
    const auto sink = brokenOff(peer, 0, std::chrono::seconds(5));
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    link.addOutage(h.now + std::chrono::milliseconds(60), h.now + std::chrono::hours(1)); // after it was opened
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a", sink->kept(), sink});
    QVERIFY(!result.ok && !result.unfit);
    QCOMPARE(bytesIn(*sink->kept()), kKeptFile);
}

void KeptPartTest::virtualFileIsNotKept()
{
    FtpPeer peer;
    peer.files["@PARAM/param.pck"] = noise(5000);
    Harness h = Harness::copter();
    LossyLink link(h, peer, 0, 1);
    const auto sink = std::make_shared<JournalSink>();
    sink->begin(5000, 0);
    sink->append(0, Bytes(FtpClient::kChunk, 1));
    const std::size_t before = sink->journal.size();
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"@PARAM/param.pck", sink->kept(), sink});
    QVERIFY2(result.ok, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.files["@PARAM/param.pck"]);
    QCOMPARE(sink->journal.size(), before);
}

SKYSEAL_TEST_APPLESS(KeptPartTest)
#include "kept_part_test.moc"
