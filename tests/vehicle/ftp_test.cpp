// MAVLink FTP against a small server, clean and through a radio that drops and reorders, and against hostile answers.
#include "core/vehicle/ftp_client.h"
#include "core/vehicle/ftp_listing.h"
#include "ftp_peer.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::vehicle;

class FtpTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void checksumIsThatOfTheProtocol();
    void folderIsListedInParts();
    void fileIsReadAndChecked();
    void sizeOfMadeUpFileIsAnEstimate();
    void sequenceNumbersOfTheProgramBeforeAreNotRepeated();
    void pathsNameASession();
    void requestsWithoutASessionMakeRoom();
    void vehicleWithoutBurstsOrChecksums();
    void differentChecksumIsAFailure();
    void fileIsWrittenAndRemoved();
    void missingFileIsAFailure();
    void fullVehicleIsReset();
    void silentVehicleIsGivenUp();
    void transferIsCancelled();
    void oneTransferAtATime();
    void everythingArrivesThroughABadRadio_data();
    void everythingArrivesThroughABadRadio();
    void lossCostsLittleTime_data();
    void lossCostsLittleTime();
    void endlessFolderIsBounded();
    void giantFileIsRefused();
    void farChunkIsNotKept();
    void lateChunksOfACancelledTransfer_data();
    void lateChunksOfACancelledTransfer();
    void anyAnswersAreBounded();
};

namespace {

mavlink::FileTransferProtocol toUs(const FtpMessage &answer)
{
    mavlink::FileTransferProtocol out;
    out.target_system = 255;
    out.target_component = 190;
    out.payload = answer.encode();
    return out;
}

/// The request that was sent last, or first, and an answer to it.
std::pair<FtpMessage, FtpMessage> sentAndAnswer(Harness &h, bool first = false)
{
    const auto sent = h.sentOf<mavlink::FileTransferProtocol>();
    const FtpMessage request = sent.empty() ? FtpMessage() : FtpMessage::decode((first ? sent.front() : sent.back()).payload);
    FtpMessage answer;
    answer.sequence = static_cast<std::uint16_t>(request.sequence + 1);
    answer.session = request.session;
    answer.opcode = mavlink::MAV_FTP_OPCODE_ACK;
    answer.requested = request.opcode;
    answer.offset = request.offset;
    return {request, answer};
}

} // namespace

void FtpTest::checksumIsThatOfTheProtocol()
{
    // CRC-32 with the initial value 0 and no final inversion ("CRC-32/JAMCRC" begins with ones).
    QCOMPARE(mavlink::ftpChecksum(asBytes("123456789")), 0x2DFD2D88u);
    QCOMPARE(mavlink::ftpChecksum(asBytes("56789"), mavlink::ftpChecksum(asBytes("1234"))), 0x2DFD2D88u);
}

void FtpTest::folderIsListedInParts()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    for (int i = 0; i < 10; ++i)
        peer.files["log" + std::to_string(i) + ".bin"] = noise(static_cast<std::size_t>(i));
    LossyLink link(h, peer, 0, 1);
    const FileResult result = resultOf<FileResult>(h, link, ListFolder{"/APM/LOGS"});
    QVERIFY2(result.ok, result.reason.text().c_str());
    QCOMPARE(result.entries->size(), std::size_t(10));
    QCOMPARE((*result.entries)[9], (RemoteFile{"log9.bin", 9, false}));
    const FtpListing parsed = parseListing(asBytes(std::string_view("Dfolder\0S\0Fa\x1b[2Jb\t12\0Fx", 23)));
    QCOMPARE(parsed.count, 4u); // the skipped one counts as an offset
    QCOMPARE(parsed.entries.size(), std::size_t(3));
    QVERIFY(parsed.entries[0].isFolder && parsed.entries[0].name == "folder");
    QCOMPARE(parsed.entries[1].name, std::string("a?[2Jb")); // cannot steer a terminal
    QCOMPARE(parsed.entries[2].size, 0u);
}

void FtpTest::fileIsReadAndChecked()
{
    for (const std::size_t size : {std::size_t(0), std::size_t(1), FtpClient::kChunk - 1, FtpClient::kChunk,
                                   FtpClient::kChunk * 100, FtpClient::kChunk * 250 + 7}) {
        Harness h = Harness::copter();
        FtpPeer peer;
        peer.files["/log.bin"] = noise(size);
        LossyLink link(h, peer, 0, 1);
        const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/log.bin"});
        QVERIFY2(result.ok && result.verified, result.reason.text().c_str());
        QCOMPARE(*result.content, peer.files["/log.bin"]);
        QCOMPARE(peer.sessions, 0);
    }
}

void FtpTest::sizeOfMadeUpFileIsAnEstimate()
{
    for (const std::size_t size : {FtpClient::kChunk * 60, FtpClient::kChunk * 60 + 11, std::size_t(1), std::size_t(0)}) {
        for (const std::uint32_t announced : {0u, 2000u, 100'000u, 1u << 20}) {
            for (const bool knowsBursts : {true, false}) {
                Harness h = Harness::copter();
                FtpPeer peer;
                peer.knowsBursts = knowsBursts;
                peer.announced = announced;
                peer.files["@PARAM/param.pck"] = noise(size);
                LossyLink link(h, peer, 0.1, 3);
                const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"@PARAM/param.pck"});
                QVERIFY2(result.ok && !result.verified, result.reason.text().c_str());
                QCOMPARE(*result.content, peer.files["@PARAM/param.pck"]);
            }
        }
    }
}

void FtpTest::sequenceNumbersOfTheProgramBeforeAreNotRepeated()
{
    FtpPeer peer; // which answers the number of the request before with the answer to that
    peer.files["/a"] = peer.files["/b"] = noise(10);
    for (const char *path : {"/a", "/b"}) {
        Harness h = Harness::copter();
        h.now = at(path[1] == 'a' ? 100 : 103); // another process
        LossyLink link(h, peer, 0, 1);
        const FileResult removed = resultOf<FileResult>(h, link, vehicle::RemoveFile{path});
        QVERIFY2(removed.ok, removed.reason.text().c_str());
        QVERIFY(!peer.files.contains(path));
    }
}

void FtpTest::pathsNameASession()
{
    Harness h = Harness::copter();
    for (const Request &request :
         {Request(ListFolder{"/"}), Request(vehicle::ReadFile{"/a"}), Request(vehicle::RemoveFile{"/a"})}) {
        h.vehicle.perform(h.now, RequestId{1}, request);
        auto [sent, answer] = sentAndAnswer(h);
        QVERIFY(sent.session != 0);
        answer.refuse(mavlink::MAV_FTP_ERR_FILENOTFOUND);
        h.feed(toUs(answer));
        QVERIFY(!h.poll<FileResult>()->ok);
    }
}

void FtpTest::requestsWithoutASessionMakeRoom()
{
    for (const Request &request :
         {Request(ListFolder{"/"}), Request(vehicle::ReadFile{"/a"}), Request(vehicle::RemoveFile{"/a"})}) {
        Harness h = Harness::copter();
        FtpPeer peer;
        peer.files["/a"] = noise(500);
        peer.busy = 1;
        LossyLink link(h, peer, 0, 1);
        const FileResult result = resultOf<FileResult>(h, link, request);
        QVERIFY2(result.ok, result.reason.text().c_str());
        QCOMPARE(peer.resets, 1);
    }
}

void FtpTest::vehicleWithoutBurstsOrChecksums()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    peer.knowsBursts = peer.knowsChecksums = false;
    peer.files["/a"] = noise(50'000);
    LossyLink link(h, peer, 0.1, 1);
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"});
    QVERIFY2(result.ok && !result.verified, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.files["/a"]);
}

void FtpTest::differentChecksumIsAFailure()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    peer.spoilsChecksums = true;
    peer.files["/a"] = noise(500);
    LossyLink link(h, peer, 0, 1);
    const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"});
    QVERIFY(!result.ok && !result.content);
    QCOMPARE(result.reason.text(), std::string("the checksums of both ends differ"));
}

void FtpTest::fileIsWrittenAndRemoved()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    LossyLink link(h, peer, 0.1, 2);
    for (const std::size_t size : {std::size_t(0), std::size_t(1000), FtpClient::kChunk * 60}) {
        const auto content = std::make_shared<const Bytes>(noise(size));
        const FileResult written = resultOf<FileResult>(h, link, vehicle::WriteFile{"/script.lua", content});
        QVERIFY2(written.ok && written.verified, written.reason.text().c_str());
        QCOMPARE(peer.files["/script.lua"], *content);
    }
    const FileResult removed = resultOf<FileResult>(h, link, vehicle::RemoveFile{"/script.lua"});
    QVERIFY2(removed.ok, removed.reason.text().c_str());
    QVERIFY(peer.files.empty());
}

void FtpTest::missingFileIsAFailure()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    LossyLink link(h, peer, 0, 2);
    QCOMPARE(resultOf<FileResult>(h, link, vehicle::ReadFile{"/none"}).reason.text(), std::string("no such file or folder"));
    QCOMPARE(resultOf<FileResult>(h, link, vehicle::RemoveFile{"/none"}).reason.text(), std::string("no such file or folder"));
    QVERIFY(!resultOf<FileResult>(h, link, vehicle::ReadFile{""}).ok);
    QVERIFY(!resultOf<FileResult>(h, link, vehicle::ReadFile{std::string(239, 'a')}).ok);
}

void FtpTest::fullVehicleIsReset()
{
    Harness h = Harness::copter();
    FtpPeer peer;
    peer.files["/a"] = noise(500);
    peer.busy = 1;
    LossyLink link(h, peer, 0, 1);
    QVERIFY(resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"}).ok);
    QCOMPARE(peer.resets, 1);
    peer.busy = 5; // once only: other stations have their files open
    QCOMPARE(resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"}).reason.text(),
             std::string("too many files are open on the vehicle"));
    QCOMPARE(peer.resets, 2);
}

void FtpTest::silentVehicleIsGivenUp()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::RemoveFile{"/a"});
    h.runUntil(h.now + std::chrono::seconds(60));
    const auto requests = h.sentOf<mavlink::FileTransferProtocol>();
    QCOMPARE(requests.size(), std::size_t(14));
    for (const auto &request : requests)
        QCOMPARE(FtpMessage::decode(request.payload).sequence, FtpMessage::decode(requests[0].payload).sequence);
    const auto result = h.poll<FileResult>();
    QVERIFY(result && !result->ok && result->changeUnanswered);
    QCOMPARE(result->reason.text(), std::string("no answer to 14 attempts"));
}

void FtpTest::transferIsCancelled()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::ReadFile{"/a"});
    auto [request, answer] = sentAndAnswer(h);
    answer.session = 3;
    answer.appendNumber(100'000);
    h.feed(toUs(answer));
    QCOMPARE(h.vehicle.state(h.now).transfers.at(0).total, std::uint64_t(100'000));
    h.sent();
    h.vehicle.perform(h.now, RequestId{2}, CancelTransfer{RequestId{1}});
    const auto [last, unused] = sentAndAnswer(h);
    QCOMPARE(int(last.opcode), int(mavlink::MAV_FTP_OPCODE_TERMINATESESSION));
    QCOMPARE(last.session, std::uint8_t(3));
    const auto result = h.poll<FileResult>();
    QVERIFY(result && !result->ok && result->id == RequestId{1} && result->reason.text() == "cancelled");
    h.runUntil(h.now + std::chrono::seconds(60));
    QVERIFY(h.sentOf<mavlink::FileTransferProtocol>().empty());
}

void FtpTest::oneTransferAtATime()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::ReadFile{"/a"});
    h.vehicle.perform(h.now, RequestId{2}, ListFolder{"/"});
    const auto result = h.poll<FileResult>();
    QVERIFY(result && result->id == RequestId{2} && result->reason.text() == "another file transfer is under way");
}

void FtpTest::everythingArrivesThroughABadRadio_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 10; ++seed) {
        for (const double loss : {0.05, 0.25})
            QTest::addRow("loss %.2f, seed %d", loss, seed) << loss << seed;
    }
}

void FtpTest::everythingArrivesThroughABadRadio()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    Harness h = Harness::copter();
    FtpPeer peer;
    peer.files["/a"] = noise(120'000, static_cast<unsigned>(seed));
    LossyLink link(h, peer, loss, static_cast<unsigned>(seed));
    const FileResult read = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"});
    QVERIFY2(read.ok, read.reason.text().c_str());
    QCOMPARE(*read.content, peer.files["/a"]);
    const FileResult written = resultOf<FileResult>(h, link, vehicle::WriteFile{"/b", read.content});
    QVERIFY2(written.ok, written.reason.text().c_str());
    QCOMPARE(peer.files["/b"], peer.files["/a"]);
    QCOMPARE(resultOf<FileResult>(h, link, ListFolder{"/"}).entries->size(), std::size_t(2));
    QVERIFY(resultOf<FileResult>(h, link, vehicle::RemoveFile{"/a"}).ok);
    QVERIFY(!peer.files.contains("/a"));
}

void FtpTest::lossCostsLittleTime_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<double>("most"); // seconds without loss
    QTest::newRow("download of 500 kB") << int(FileAction::Read) << 3.;
    // In a window of 8 writes: 2093 chunks of 239 bytes take 262 round trips of 50 ms.
    QTest::newRow("upload of 500 kB") << int(FileAction::Write) << 14.;
    // One request after the other, each for the next entries: 100 of them, and one that finds the end.
    QTest::newRow("list of 300 files, 3 at a time") << int(FileAction::List) << 6.;
}

void FtpTest::lossCostsLittleTime()
{
    QFETCH(int, action);
    QFETCH(double, most);
    const auto content = std::make_shared<const Bytes>(noise(500'000));
    const auto timeOf = [&](double loss, unsigned seed) {
        Harness h = Harness::copter();
        FtpPeer peer;
        LossyLink link(h, peer, loss, seed, std::chrono::milliseconds(25));
        const TimePoint begin = h.now;
        bool done = false;
        switch (static_cast<FileAction>(action)) {
        case FileAction::Read: {
            peer.files["/a"] = *content;
            const FileResult result = resultOf<FileResult>(h, link, vehicle::ReadFile{"/a"});
            done = result.ok && *result.content == *content;
            break;
        }
        case FileAction::Write:
            done = resultOf<FileResult>(h, link, vehicle::WriteFile{"/a", content}).ok && peer.files["/a"] == *content;
            break;
        case FileAction::List: {
            for (int i = 0; i < 300; ++i)
                peer.files["log" + std::to_string(i)] = {};
            const FileResult result = resultOf<FileResult>(h, link, ListFolder{"/"});
            done = result.ok && result.entries->size() == 300;
            break;
        }
        case FileAction::Remove: break;
        }
        return done ? seconds(h.now - begin) : 600.;
    };
    const double clean = timeOf(0, 1);
    QVERIFY2(clean < most, std::to_string(clean).c_str());
    verifyCostOfLoss(timeOf, clean);
}

void FtpTest::endlessFolderIsBounded()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ListFolder{"/"});
    for (int part = 0; part < 10'000; ++part) {
        if (const auto result = h.poll<FileResult>()) {
            QVERIFY(!result->ok);
            QCOMPARE(result->reason.text(), std::string("the folder has more than 10000 entries"));
            return;
        }
        auto [request, answer] = sentAndAnswer(h);
        std::string names;
        for (int i = 0; i < 100; ++i)
            names += std::string("S\0", 2); // skipped entries count as well
        answer.append(asBytes(names));
        h.feed(toUs(answer));
    }
    QFAIL("an endless folder was read without end");
}

void FtpTest::giantFileIsRefused()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::ReadFile{"/a"});
    auto [request, answer] = sentAndAnswer(h);
    answer.appendNumber(0xFFFFFFFF);
    h.feed(toUs(answer));
    QCOMPARE(h.poll<FileResult>()->reason.text(), std::string("the file is larger than 268435456 bytes"));
}

void FtpTest::farChunkIsNotKept()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, vehicle::ReadFile{"/a"});
    auto [open, opened] = sentAndAnswer(h);
    opened.appendNumber(static_cast<std::uint32_t>(FileTransfer::kMostBytes));
    h.feed(toUs(opened));
    auto [request, answer] = sentAndAnswer(h);
    QCOMPARE(int(request.opcode), int(mavlink::MAV_FTP_OPCODE_BURSTREADFILE));
    answer.append(noise(FtpClient::kChunk));
    answer.offset = static_cast<std::uint32_t>(1'000'000 * FtpClient::kChunk); // would need memory for all before it
    h.feed(toUs(answer));
    QCOMPARE(h.vehicle.state(h.now).transfers.at(0).done, std::uint64_t(0));
    answer.offset = 0;
    h.feed(toUs(answer));
    QCOMPARE(h.vehicle.state(h.now).transfers.at(0).done, std::uint64_t(FtpClient::kChunk));
}

void FtpTest::lateChunksOfACancelledTransfer_data()
{
    QTest::addColumn<bool>("inBursts");
    QTest::newRow("in bursts") << true;
    QTest::newRow("one by one") << false;
}

/// Sessions have the same number again and again, so that late answers of the former file look like those of the next one.
void FtpTest::lateChunksOfACancelledTransfer()
{
    QFETCH(bool, inBursts);
    Harness h = Harness::copter();
    constexpr std::size_t kSize = FtpClient::kChunk - 9;
    const Bytes former = noise(kSize, 1), wanted = noise(kSize, 2);
    FtpMessage late;
    for (const bool isFormer : {true, false}) {
        h.vehicle.perform(h.now, RequestId{isFormer ? 1u : 2u}, vehicle::ReadFile{"@a"}); // it has no checksum
        auto [open, opened] = sentAndAnswer(h);
        opened.session = 7;
        opened.appendNumber(kSize);
        h.feed(toUs(opened));
        auto [request, answer] = sentAndAnswer(h);
        QCOMPARE(int(request.opcode), int(mavlink::MAV_FTP_OPCODE_BURSTREADFILE));
        if (!inBursts) {
            answer.refuse(mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND);
            h.feed(toUs(answer));
            std::tie(request, answer) = sentAndAnswer(h, true); // the end is not known: further ones follow
            QCOMPARE(int(request.opcode), int(mavlink::MAV_FTP_OPCODE_READFILE));
        }
        if (isFormer) {
            late = answer;
            late.append(former);
            h.vehicle.perform(h.now, RequestId{3}, CancelTransfer{RequestId{1}});
            QVERIFY(!h.poll<FileResult>()->ok);
            h.sent();
        } else {
            h.feed(toUs(late));
            answer.append(wanted);
            h.feed(toUs(answer));
        }
    }
    auto [closing, closed] = sentAndAnswer(h);
    QCOMPARE(int(closing.opcode), int(mavlink::MAV_FTP_OPCODE_TERMINATESESSION));
    h.feed(toUs(closed));
    const auto result = h.poll<FileResult>();
    QVERIFY(result && result->ok);
    QVERIFY(*result->content == wanted);
}

void FtpTest::anyAnswersAreBounded()
{
    QVERIFY(rc::check("every request ends, and nothing is kept beyond the announced size", [] {
        Harness h = Harness::copter();
        const auto requests = *rc::gen::inRange(0, 4);
        const auto content = std::make_shared<const Bytes>(noise(2000));
        const Request request = requests == 0 ? Request(ListFolder{"/"})
            : requests == 1                   ? Request(vehicle::ReadFile{"/a"})
            : requests == 2                   ? Request(vehicle::WriteFile{"/a", content})
                                              : Request(vehicle::RemoveFile{"/a"});
        h.vehicle.perform(h.now, RequestId{1}, request);
        std::optional<FileResult> result;
        const TimePoint end = h.now + std::chrono::hours(1);
        auto [sent, answer] = sentAndAnswer(h);
        for (int i = 0; i < 200 && !result; ++i) {
            answer.opcode = *rc::gen::arbitrary<bool>() ? mavlink::MAV_FTP_OPCODE_ACK : mavlink::MAV_FTP_OPCODE_NAK;
            answer.size = *rc::gen::element<std::uint8_t>(0, 1, 4, 239, 255);
            answer.offset = static_cast<std::uint32_t>(*rc::gen::inRange(0, 10)) * 239u
                + static_cast<std::uint32_t>(*rc::gen::inRange(0, 2));
            answer.burstComplete = *rc::gen::arbitrary<bool>();
            answer.data[0] = *rc::gen::inRange<std::uint8_t>(0, 12);
            answer.data[1] = *rc::gen::inRange<std::uint8_t>(0, 12);
            answer.data[2] = answer.data[3] = 0;
            h.feed(toUs(answer));
            h.runUntil(h.now + std::chrono::milliseconds(*rc::gen::inRange(0, 700)));
            const auto next = sentAndAnswer(h);
            if (next.first.opcode != mavlink::MAV_FTP_OPCODE_NONE)
                answer = next.second;
            result = h.poll<FileResult>();
        }
        while (!result && h.now < end) {
            h.runUntil(h.now + std::chrono::seconds(1));
            h.sent();
            result = h.poll<FileResult>();
        }
        RC_ASSERT(result.has_value());
        RC_ASSERT((!result->content || result->content->size() <= 12u + 12u * 256u));
        RC_ASSERT(h.vehicle.state(h.now).transfers.empty());
    }));
}

SKYSEAL_TEST_APPLESS(FtpTest)
#include "ftp_test.moc"
