// MAVLink FTP with a vehicle: files go up and come down over a link that loses a third of all frames, each error has its NAK,
// and neither strange requests nor many of them make it grow.
#include "tests/sim/ftp_requester.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"
#include "core/sim/ftp_server.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

class SimFtpTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsFolders();
    void longListsComeInParts();
    void uploadAndDownload_data();
    void uploadAndDownload();
    void burstRead_data();
    void burstRead();
    void burstIsPacedAndCanBeEnded();
    void lostAnswersAreRepeated();
    void foldersAndNames();
    void errorsHaveTheirNaks_data();
    void errorsHaveTheirNaks();
    void malformedPaths_data();
    void malformedPaths();
    void sessionsAreBounded();
    void filesCanBeSwitchedOff();
    void randomRequests();
};

void SimFtpTest::listsFolders()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    QCOMPARE(ftp.list("/"), (std::vector<std::string>{"DAPM", "D@PARAM"}));
    QCOMPARE(ftp.list("/APM/"), (std::vector<std::string>{"DLOGS"}));
    QVERIFY(ftp.upload("/APM/a.txt", someBytes(700)));
    QCOMPARE(ftp.list("APM"), (std::vector<std::string>{"DLOGS", "Fa.txt\t700"}));
    QCOMPARE(ftp.list("@PARAM").size(), std::size_t(1));
    QVERIFY(ftp.list("@PARAM")[0].starts_with("Fparam.pck\t"));
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_LISTDIRECTORY, "/APM/LOGS"), int(MAV_FTP_ERR_EOF)); // it is empty
    QVERIFY(station.command(MAV_CMD_REQUEST_MESSAGE, {float(AutopilotVersion::kId)}) == MAV_RESULT_ACCEPTED);
    QVERIFY(station.last<AutopilotVersion>().capabilities & MAV_PROTOCOL_CAPABILITY_FTP);
}

void SimFtpTest::longListsComeInParts()
{
    TestStation station({}, 0.2, 3);
    station.run(1);
    FtpRequester ftp(station);
    std::vector<std::string> names;
    for (int i = 0; i < 30; ++i) {
        names.push_back("DA folder with quite a long name " + std::to_string(100 + i));
        QVERIFY(ftp.accepted(MAV_FTP_OPCODE_CREATEDIRECTORY, "/" + names.back().substr(1)));
    }
    auto all = ftp.list("/");
    QCOMPARE(all.size(), names.size() + 2);
    for (const auto &name : names)
        QCOMPARE(std::count(all.begin(), all.end(), name), 1);
}

void SimFtpTest::uploadAndDownload_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("size");
    for (const double loss : {0.0, 0.33}) {
        for (const int size : {0, 1, 238, 239, 240, 5000})
            QTest::addRow("%d bytes, loss %g", size, loss) << loss << size;
    }
}

void SimFtpTest::uploadAndDownload()
{
    QFETCH(double, loss);
    QFETCH(int, size);
    TestStation station({}, loss, 17);
    station.run(1);
    FtpRequester ftp(station);
    const Bytes bytes = someBytes(static_cast<std::size_t>(size));
    QVERIFY(ftp.upload("/file.bin", bytes));
    const auto back = ftp.download("/file.bin");
    QVERIFY(back);
    QVERIFY(*back == bytes);
    const FtpMessage reply = ftp.request(MAV_FTP_OPCODE_CALCFILECRC, "/file.bin");
    QCOMPARE(int(reply.size), 4);
    if (size == 0)
        QVERIFY(reply.data[0] == 0 && reply.data[3] == 0);

    // Without truncation the rest stays, with it the file begins anew.
    if (size == 5000) {
        QVERIFY(ftp.upload("/file.bin", someBytes(10, 2), MAV_FTP_OPCODE_OPENFILEWO));
        QCOMPARE(ftp.download("/file.bin")->size(), std::size_t(5000));
        QVERIFY(ftp.upload("/file.bin", someBytes(10, 2)));
        QCOMPARE(ftp.download("/file.bin")->size(), std::size_t(10));
    }
}

void SimFtpTest::burstRead_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("piece");
    QTest::newRow("whole messages") << 0.0 << 0;
    QTest::newRow("small pieces") << 0.0 << 100;
    QTest::newRow("loss") << 0.2 << 239;
}

void SimFtpTest::burstRead()
{
    QFETCH(double, loss);
    QFETCH(int, piece);
    TestStation station({}, loss, 23);
    station.run(1);
    FtpRequester ftp(station);
    ftp.session = 9;
    const Bytes bytes = someBytes(7000);
    QVERIFY(ftp.upload("/big", bytes));
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_OPENFILERO, "/big").opcode), int(MAV_FTP_OPCODE_ACK));
    Bytes got(bytes.size());
    std::vector<bool> have(bytes.size());
    std::size_t gap = 0;
    bool ended = false;
    for (int tries = 0; tries < 60 && gap < bytes.size(); ++tries) {
        station.forget();
        const FtpMessage request = ftp.made(MAV_FTP_OPCODE_BURSTREADFILE, {}, static_cast<std::uint32_t>(gap), piece);
        ftp.sendRaw(request);
        station.run(1.5);
        std::uint16_t expected = static_cast<std::uint16_t>(request.sequence + 1);
        for (const auto &received : station.all<FileTransferProtocol>()) {
            const FtpMessage part = FtpMessage::decode(received.payload);
            QCOMPARE(int(part.session), 9);
            if (loss == 0)
                QCOMPARE(part.sequence, expected++);
            if (part.opcode == MAV_FTP_OPCODE_NAK) {
                QCOMPARE(int(part.data[0]), int(MAV_FTP_ERR_EOF));
                QVERIFY(part.burstComplete);
                ended = true;
                continue;
            }
            QVERIFY(part.size <= (piece == 0 ? 239 : piece));
            QVERIFY(part.offset + part.size <= bytes.size());
            std::copy(part.content().begin(), part.content().end(), got.begin() + part.offset);
            std::fill_n(have.begin() + part.offset, part.size, true);
        }
        gap = static_cast<std::size_t>(std::find(have.begin(), have.end(), false) - have.begin());
    }
    QCOMPARE(gap, bytes.size());
    QVERIFY(got == bytes);
    QVERIFY(ended);
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_TERMINATESESSION).opcode), int(MAV_FTP_OPCODE_ACK));
}

void SimFtpTest::burstIsPacedAndCanBeEnded()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    QVERIFY(ftp.upload("/big", someBytes(50000)));
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_OPENFILERO, "/big").opcode), int(MAV_FTP_OPCODE_ACK));
    ftp.sendRaw(ftp.made(MAV_FTP_OPCODE_BURSTREADFILE));
    station.forget();
    station.run(1);
    QVERIFY2(std::abs(int(station.count<FileTransferProtocol>()) - 100) <= 2,
             qPrintable(QString::number(station.count<FileTransferProtocol>()))); // one each 10 ms
    QVERIFY(station.count<mavlink::Heartbeat>() >= 1);
    ftp.sendRaw(ftp.made(MAV_FTP_OPCODE_RESETSESSION));
    station.forget();
    station.run(1);
    QCOMPARE(station.count<FileTransferProtocol>(), std::size_t(0));
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_READFILE, ""), int(MAV_FTP_ERR_FILENOTFOUND));
}

void SimFtpTest::lostAnswersAreRepeated()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    const auto twice = [&](const FtpMessage &request) {
        station.forget();
        ftp.sendRaw(request);
        ftp.sendRaw(request);
        const auto replies = station.all<FileTransferProtocol>();
        return replies.size() == 2 && replies[0].payload == replies[1].payload ? FtpMessage::decode(replies[0].payload)
                                                                               : FtpMessage{};
    };
    // Each would fail if it were executed again.
    QCOMPARE(int(twice(ftp.made(MAV_FTP_OPCODE_CREATEDIRECTORY, asBytes("/new"))).opcode), int(MAV_FTP_OPCODE_ACK));
    QCOMPARE(int(twice(ftp.made(MAV_FTP_OPCODE_RENAME, asBytes(std::string_view("/new\0/old", 9)))).opcode),
             int(MAV_FTP_OPCODE_ACK));
    QCOMPARE(int(twice(ftp.made(MAV_FTP_OPCODE_REMOVEDIRECTORY, asBytes("/old"))).opcode), int(MAV_FTP_OPCODE_ACK));
    QCOMPARE(int(twice(ftp.made(MAV_FTP_OPCODE_CREATEFILE, asBytes("/file"))).opcode), int(MAV_FTP_OPCODE_ACK));
    QCOMPARE(int(twice(ftp.made(MAV_FTP_OPCODE_TERMINATESESSION)).opcode), int(MAV_FTP_OPCODE_ACK));

    // Another station with the same numbers gets an answer of its own.
    const FtpMessage request = ftp.made(MAV_FTP_OPCODE_REMOVEFILE, asBytes("/file"));
    ftp.sendRaw(request);
    station.writer = FrameWriter(200, 190);
    station.forget();
    ftp.sendRaw(request);
    QCOMPARE(int(FtpMessage::decode(station.last<FileTransferProtocol>().payload).opcode), int(MAV_FTP_OPCODE_NAK));
    QCOMPARE(int(station.last<FileTransferProtocol>().target_system), 200);
}

void SimFtpTest::foldersAndNames()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_CREATEDIRECTORY, "/scripts"));
    QVERIFY(ftp.upload("/scripts/a.lua", someBytes(300)));
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_TRUNCATEFILE, "/scripts/a.lua", 100));
    QCOMPARE(ftp.list("/scripts"), (std::vector<std::string>{"Fa.lua\t100"}));
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_RENAME, std::string_view("/scripts/a.lua\0/b.lua\0", 22))); // an end is no harm
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_REMOVEDIRECTORY, std::string_view("/scripts\0", 9)));
    QCOMPARE(ftp.list("/"), (std::vector<std::string>{"DAPM", "Fb.lua\t100", "D@PARAM"}));
    const Bytes whole = someBytes(300);
    QVERIFY(*ftp.download("b.lua") == Bytes(whole.begin(), whole.begin() + 100));
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_REMOVEFILE, "/b.lua"));
    QCOMPARE(ftp.list("/"), (std::vector<std::string>{"DAPM", "D@PARAM"}));

    // The checksum that pymavlink computes of "123456789": CRC-32 that begins with 0 and is not inverted.
    QVERIFY(ftp.upload("/check", asBytes("123456789")));
    const FtpMessage reply = ftp.request(MAV_FTP_OPCODE_CALCFILECRC, "/check");
    ByteReader crc(reply.content());
    QCOMPARE(crc.u32(), 0x2dfd2d88u);
}

void SimFtpTest::errorsHaveTheirNaks_data()
{
    QTest::addColumn<int>("opcode");
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<int>("error");
    QTest::addColumn<int>("number");
    const int none = 0, invalid = 22, notDirectory = 20, isDirectory = 21, notEmpty = 39, noSpace = 28;
    const int withNumber = MAV_FTP_ERR_FAILERRNO, missing = MAV_FTP_ERR_FILENOTFOUND, exists = MAV_FTP_ERR_FILEEXISTS,
              isProtected = MAV_FTP_ERR_FILEPROTECTED, malformed = MAV_FTP_ERR_INVALIDDATASIZE;
    const auto row = [](const char *name, int opcode, const QByteArray &path, int error, int number) {
        QTest::newRow(name) << opcode << path << error << number;
    };
    row("list nothing", MAV_FTP_OPCODE_LISTDIRECTORY, "/no", missing, none);
    row("list a file", MAV_FTP_OPCODE_LISTDIRECTORY, "/file", withNumber, notDirectory);
    row("open nothing", MAV_FTP_OPCODE_OPENFILERO, "/no", missing, none);
    row("open a folder", MAV_FTP_OPCODE_OPENFILERO, "/APM", withNumber, isDirectory);
    row("create in nothing", MAV_FTP_OPCODE_CREATEFILE, "/no/file", missing, none);
    row("create in a file", MAV_FTP_OPCODE_CREATEFILE, "/file/x", withNumber, notDirectory);
    row("create among the logs", MAV_FTP_OPCODE_CREATEFILE, "/APM/LOGS/1.BIN", isProtected, none);
    row("create a parameter", MAV_FTP_OPCODE_CREATEFILE, "@PARAM/other", isProtected, none);
    row("write a folder", MAV_FTP_OPCODE_OPENFILEWO, "/folder", withNumber, isDirectory);
    row("read without a file", MAV_FTP_OPCODE_READFILE, "x", missing, none);
    row("burst without a file", MAV_FTP_OPCODE_BURSTREADFILE, "x", missing, none);
    row("write without a file", MAV_FTP_OPCODE_WRITEFILE, "x", missing, none);
    row("remove nothing", MAV_FTP_OPCODE_REMOVEFILE, "/no", missing, none);
    row("remove a folder as a file", MAV_FTP_OPCODE_REMOVEFILE, "/folder", withNumber, isDirectory);
    row("remove a file as a folder", MAV_FTP_OPCODE_REMOVEDIRECTORY, "/file", withNumber, notDirectory);
    row("remove a full folder", MAV_FTP_OPCODE_REMOVEDIRECTORY, "/folder", withNumber, notEmpty);
    row("remove the root", MAV_FTP_OPCODE_REMOVEDIRECTORY, "/", isProtected, none);
    row("remove the logs", MAV_FTP_OPCODE_REMOVEDIRECTORY, "/APM/LOGS", isProtected, none);
    row("make a folder again", MAV_FTP_OPCODE_CREATEDIRECTORY, "/folder", exists, none);
    row("make the logs again", MAV_FTP_OPCODE_CREATEDIRECTORY, "/APM/LOGS", exists, none);
    row("rename nothing", MAV_FTP_OPCODE_RENAME, QByteArray("/no\0/x", 6), missing, none);
    row("rename onto a file", MAV_FTP_OPCODE_RENAME, QByteArray("/folder/in\0/file", 16), exists, none);
    row("rename a full folder", MAV_FTP_OPCODE_RENAME, QByteArray("/folder\0/x", 10), withNumber, notEmpty);
    row("rename to nothing", MAV_FTP_OPCODE_RENAME, "/file", malformed, none);
    row("truncate nothing", MAV_FTP_OPCODE_TRUNCATEFILE, "/no", missing, none);
    row("truncate to too much", MAV_FTP_OPCODE_TRUNCATEFILE, "/file", withNumber, noSpace);
    row("checksum of nothing", MAV_FTP_OPCODE_CALCFILECRC, "/no", missing, none);
    row("up and out", MAV_FTP_OPCODE_OPENFILERO, "/APM/../file", withNumber, invalid);
    row("unknown", 77, "/", MAV_FTP_ERR_UNKNOWNCOMMAND, none);
}

void SimFtpTest::errorsHaveTheirNaks()
{
    QFETCH(int, opcode);
    QFETCH(QByteArray, path);
    QFETCH(int, error);
    QFETCH(int, number);
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    QVERIFY(ftp.upload("/file", someBytes(10)));
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_CREATEDIRECTORY, "/folder"));
    QVERIFY(ftp.upload("/folder/in", someBytes(10)));
    const FtpMessage reply = ftp.request(static_cast<std::uint8_t>(opcode), path.toStdString(), 0xfffffff0);
    QCOMPARE(int(reply.opcode), int(MAV_FTP_OPCODE_NAK));
    QCOMPARE(int(reply.data[0]), error);
    QCOMPARE(int(reply.size), number == 0 ? 1 : 2);
    QCOMPARE(int(reply.data[1]), number);
    QCOMPARE(ftp.list("/").size(), std::size_t(4)); // nothing changed
    QCOMPARE(ftp.download("/file")->size(), std::size_t(10));
}

void SimFtpTest::malformedPaths_data()
{
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<int>("size");
    QTest::newRow("empty") << QByteArray() << 0;
    QTest::newRow("only an end") << QByteArray("\0", 1) << 1;
    QTest::newRow("something behind the end") << QByteArray("/file\0xx", 8) << 8;
    QTest::newRow("size is too large") << QByteArray("/file") << 7;
    QTest::newRow("size beyond the payload") << QByteArray("/file") << 240;
    QTest::newRow("size of all ones") << QByteArray("/file") << 255;
}

void SimFtpTest::malformedPaths()
{
    QFETCH(QByteArray, data);
    QFETCH(int, size);
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    const std::string bytes = data.toStdString();
    for (const int opcode : {3, 4, 6, 8, 9, 10, 11, 12, 13, 14}) {
        const FtpMessage reply = ftp.request(static_cast<std::uint8_t>(opcode), asBytes(bytes), 0, size);
        QCOMPARE(int(reply.opcode), int(MAV_FTP_OPCODE_NAK));
        if (opcode != MAV_FTP_OPCODE_RENAME) // which takes what is behind the end as another path
            QCOMPARE(int(reply.data[0]), int(MAV_FTP_ERR_INVALIDDATASIZE));
    }
    QCOMPARE(ftp.list("/").size(), std::size_t(2));
}

void SimFtpTest::filesCanBeSwitchedOff()
{
    TestStation station;
    station.run(1);
    station.vehicle.autopilot().parameters().set("BRD_OPTIONS", 2);
    FtpRequester ftp(station);
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_LISTDIRECTORY, "/").opcode), int(MAV_FTP_OPCODE_NONE)); // no answer, as ArduPilot
    QVERIFY(station.count<Statustext>() > 0);
    station.vehicle.autopilot().parameters().set("BRD_OPTIONS", 1);
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_LISTDIRECTORY, "/"));
}

void SimFtpTest::sessionsAreBounded()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    for (int i = 0; i < 4; ++i) {
        ftp.session = static_cast<std::uint8_t>(i);
        QVERIFY(ftp.accepted(MAV_FTP_OPCODE_CREATEFILE, "/file" + std::to_string(i)));
        QCOMPARE(ftp.error(MAV_FTP_OPCODE_CREATEFILE, "/other"), int(MAV_FTP_ERR_FAIL)); // one file a session
    }
    ftp.session = 100;
    const FtpMessage fifth = ftp.made(MAV_FTP_OPCODE_OPENFILERO, asBytes("/file0"));
    const auto answer = [&] {
        ftp.sendRaw(fifth);
        return FtpMessage::decode(station.last<FileTransferProtocol>().payload);
    };
    QCOMPARE(int(answer().data[0]), int(MAV_FTP_ERR_NOSESSIONSAVAILABLE));
    station.run(3.5);                                        // the oldest has not been used for three seconds
    QCOMPARE(int(answer().opcode), int(MAV_FTP_OPCODE_ACK)); // the same request: its refusal is not repeated
    ftp.session = 0;
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_WRITEFILE, "x"), int(MAV_FTP_ERR_FILENOTFOUND));
    ftp.session = 1;
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_WRITEFILE, "x"));
    station.run(21);
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_WRITEFILE, "x"), int(MAV_FTP_ERR_FILENOTFOUND)); // abandoned
}

void SimFtpTest::randomRequests()
{
    QVERIFY(rc::check("any requests are answered within the limits", [] {
        Noise dice(*rc::gen::arbitrary<std::uint64_t>(), 3);
        Autopilot autopilot({});
        FileStore card;
        FlightLogs logs;
        logs.begin(1);
        logs.append(someBytes(1000));
        FrameQueue outbox(1);
        VehicleFiles files(card, logs, autopilot);
        FtpServer server(files, outbox);
        TimePoint now{};
        constexpr std::string_view kPaths[] = {"/a", "/a/b", "/", "/APM/LOGS/00000001.BIN", "@PARAM/param.pck", "/..", "a\0b"};
        for (int i = 0; i < 300; ++i) {
            FtpMessage request;
            request.sequence = static_cast<std::uint16_t>(dice.next() % 5);
            request.session = static_cast<std::uint8_t>(dice.next() % 6);
            request.opcode = static_cast<std::uint8_t>(dice.next() % 17);
            request.offset = static_cast<std::uint32_t>(dice.next() % 3 ? dice.next() % 2000 : dice.next());
            const std::string_view path = kPaths[dice.next() % std::size(kPaths)];
            request.append(dice.next() % 4 ? asBytes(path) : ByteView(someBytes(dice.next() % 239, dice.next())));
            if (dice.next() % 8 == 0)
                request.size = static_cast<std::uint8_t>(dice.next());
            now += std::chrono::milliseconds(dice.next() % 8 ? dice.next() % 50 : dice.next() % 25000);
            server.handle(now, {static_cast<std::uint8_t>(dice.next() % 7), 190, 2}, request);
            server.handleDeadline(now);
            for (ByteView bytes = outbox.poll(); !bytes.empty(); bytes = outbox.poll()) {
                const auto frame = readFrame(bytes, Dialect::builtin());
                RC_ASSERT(frame.has_value());
                const FtpMessage reply = FtpMessage::decode(FileTransferProtocol::decode(frame->payload()).payload);
                RC_ASSERT(reply.size <= FtpMessage::kMostData);
                RC_ASSERT(reply.opcode == MAV_FTP_OPCODE_ACK || reply.opcode == MAV_FTP_OPCODE_NAK);
                RC_ASSERT(reply.opcode == MAV_FTP_OPCODE_ACK || reply.size >= 1);
            }
            RC_ASSERT(server.openSessions() <= FtpServer::kSessions);
            RC_ASSERT(card.bytes() <= FileStore::kMostBytes && card.nodes() <= FileStore::kMostNodes);
        }
    }));
}

SKYSEAL_TEST_APPLESS(SimFtpTest)
#include "ftp_test.moc"
