// MAVLink FTP with a vehicle: files go up and come down over a link that loses a third of all frames, each error has its NAK,
// and neither strange requests nor many of them make it grow.
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/base/byte_reader.h"
#include "core/mavlink/enums.h"
#include "core/sim/ftp_server.h"
#include "core/sim/packed_parameters.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <bit>
#include <map>

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
    void storeIsBounded();
    void cardSurvivesAReboot();
    void flightLogsAreFiles();
    void parameterFile();
    void partOfTheParameterFile();
    void parameterUpload();
    void packedParametersRoundTrip();
    void randomParameterFiles();
    void randomRequests();
};

namespace {

/// The station's side: one request at a time, repeated until it is answered.
class FtpClient
{
public:
    explicit FtpClient(TestStation &station) : m_station(station) {}

    /// The answer; opcode 0 if none came in twenty attempts.
    FtpMessage request(std::uint8_t opcode, ByteView data = {}, std::uint32_t offset = 0, int size = -1)
    {
        FtpMessage message = made(opcode, data, offset, size);
        for (int tries = 0; tries < 20; ++tries) {
            m_station.forget();
            sendRaw(message);
            m_station.run(0.1);
            for (const auto &received : m_station.all<FileTransferProtocol>()) {
                const FtpMessage reply = FtpMessage::decode(received.payload);
                if (reply.sequence == static_cast<std::uint16_t>(message.sequence + 1) && reply.requestOpcode == opcode)
                    return reply;
            }
        }
        return {};
    }
    FtpMessage request(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        return request(opcode, asBytes(path), offset);
    }
    bool accepted(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        return request(opcode, path, offset).opcode == MAV_FTP_OPCODE_ACK;
    }
    /// The error of a refused request; -1 if it was not refused.
    int error(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        const FtpMessage reply = request(opcode, path, offset);
        return reply.opcode == MAV_FTP_OPCODE_NAK && reply.size >= 1 ? reply.data[0] : -1;
    }

    FtpMessage made(std::uint8_t opcode, ByteView data = {}, std::uint32_t offset = 0, int size = -1)
    {
        FtpMessage message;
        message.sequence = m_sequence++;
        message.session = session;
        message.opcode = opcode;
        message.offset = offset;
        message.append(data);
        if (size >= 0)
            message.size = static_cast<std::uint8_t>(size);
        return message;
    }
    void sendRaw(const FtpMessage &message)
    {
        FileTransferProtocol out;
        out.target_system = 1;
        out.target_component = 1;
        out.payload = message.encode();
        out.payload[4] = message.size; // also one that is too large
        m_station.send(out);
    }

    bool upload(std::string_view path, ByteView bytes, std::uint8_t opcode = MAV_FTP_OPCODE_CREATEFILE)
    {
        if (!accepted(opcode, path))
            return false;
        for (std::size_t at = 0; at < bytes.size(); at += FtpMessage::kMostData) {
            const ByteView part = bytes.subspan(at, std::min(FtpMessage::kMostData, bytes.size() - at));
            if (request(MAV_FTP_OPCODE_WRITEFILE, part, static_cast<std::uint32_t>(at)).opcode != MAV_FTP_OPCODE_ACK)
                return false;
        }
        return request(MAV_FTP_OPCODE_TERMINATESESSION).opcode == MAV_FTP_OPCODE_ACK;
    }
    std::optional<Bytes> download(std::string_view path)
    {
        const FtpMessage opened = request(MAV_FTP_OPCODE_OPENFILERO, path);
        if (opened.opcode != MAV_FTP_OPCODE_ACK || opened.size != 4)
            return std::nullopt;
        Bytes out;
        for (;;) {
            const FtpMessage part = request(MAV_FTP_OPCODE_READFILE, {}, static_cast<std::uint32_t>(out.size()), 239);
            if (part.opcode == MAV_FTP_OPCODE_NAK && part.data[0] == MAV_FTP_ERR_EOF)
                break;
            if (part.opcode != MAV_FTP_OPCODE_ACK || part.offset != out.size())
                return std::nullopt;
            out.insert(out.end(), part.content().begin(), part.content().end());
        }
        request(MAV_FTP_OPCODE_TERMINATESESSION);
        ByteReader size(ByteView(opened.data).first(4));
        return size.u32() == out.size() ? std::optional(out) : std::nullopt;
    }
    /// All entries of a folder, as they are sent.
    std::vector<std::string> list(std::string_view path)
    {
        std::vector<std::string> out;
        for (;;) {
            const FtpMessage reply = request(MAV_FTP_OPCODE_LISTDIRECTORY, path, static_cast<std::uint32_t>(out.size()));
            if (reply.opcode != MAV_FTP_OPCODE_ACK)
                return out;
            std::string_view text = asText(reply.content());
            for (std::size_t end; (end = text.find('\0')) != std::string_view::npos; text.remove_prefix(end + 1))
                out.emplace_back(text.substr(0, end));
            if (!text.empty())
                return {"an entry without an end"};
        }
    }

    std::uint8_t session = 0;

private:
    TestStation &m_station;
    std::uint16_t m_sequence = 65530; // wraps
};

Bytes someBytes(std::size_t size, std::uint64_t seed = 1)
{
    Noise dice(seed, 4);
    Bytes out(size);
    for (auto &byte : out)
        byte = static_cast<std::uint8_t>(dice.next());
    return out;
}

/// The parameters in a packed file by a reader that knows the format only; empty if it is damaged.
std::map<std::string, float> readPacked(ByteView file)
{
    ByteReader in(file);
    const auto magic = in.u16();
    const auto count = in.u16();
    in.u16();
    if (magic != 0x671b && magic != 0x671c)
        return {};
    std::map<std::string, float> out;
    std::string name;
    for (int i = 0; i < count; ++i) {
        const std::uint8_t type = in.u8(), lengths = in.u8();
        name = name.substr(0, lengths & 15) + std::string(asText(in.bytes((lengths >> 4) + 1u)));
        for (int k = 0; k <= type >> 4; ++k) { // the default follows the value
            const auto value = [&]() -> float {
                switch (type & 15) {
                case 1: return in.littleEndian<std::int8_t>();
                case 2: return in.littleEndian<std::int16_t>();
                case 3: return static_cast<float>(in.littleEndian<std::int32_t>());
                default: return std::bit_cast<float>(in.u32());
                }
            }();
            out[k == 0 ? name : name + " default"] = value;
        }
    }
    return in.ok() && in.atEnd() ? out : std::map<std::string, float>{};
}

} // namespace

void SimFtpTest::listsFolders()
{
    TestStation station;
    station.run(1);
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
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
    FtpClient ftp(station);
    const std::string bytes = data.toStdString();
    for (const int opcode : {3, 4, 6, 8, 9, 10, 11, 12, 13, 14}) {
        const FtpMessage reply = ftp.request(static_cast<std::uint8_t>(opcode), asBytes(bytes), 0, size);
        QCOMPARE(int(reply.opcode), int(MAV_FTP_OPCODE_NAK));
        if (opcode != MAV_FTP_OPCODE_RENAME) // which takes what is behind the end as another path
            QCOMPARE(int(reply.data[0]), int(MAV_FTP_ERR_INVALIDDATASIZE));
    }
    QCOMPARE(ftp.list("/").size(), std::size_t(2));
}

void SimFtpTest::sessionsAreBounded()
{
    TestStation station;
    station.run(1);
    FtpClient ftp(station);
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

void SimFtpTest::storeIsBounded()
{
    FileStore store;
    int made = 0;
    while (store.create("f" + std::to_string(made), true))
        ++made;
    QCOMPARE(std::size_t(made), FileStore::kMostNodes);
    QVERIFY(store.create("f0", true)); // one that is there
    QVERIFY(store.truncate("f0", FileStore::kMostBytes));
    QVERIFY(!store.write("f1", 0, someBytes(1)));
    QVERIFY(!store.truncate("f1", 1));
    QVERIFY(!store.truncate("f0", FileStore::kMostBytes + 1));
    QVERIFY(!store.write("f0", 0xffffffff, someBytes(200)));
    QVERIFY(store.write("f0", FileStore::kMostBytes - 5, someBytes(5)));
    QCOMPARE(store.bytes(), FileStore::kMostBytes);
    QVERIFY(store.remove("f0"));
    QCOMPARE(store.bytes(), std::size_t(0));
    QVERIFY(store.write("f1", 100, someBytes(5))); // the gap is zeros
    QCOMPARE((*store.read("f1"))[99], std::uint8_t(0));
    QCOMPARE(store.read("f1")->size(), std::size_t(105));
    QVERIFY(!FileStore::normalised(std::string(201, 'a')));
    QVERIFY(!FileStore::normalised("a\tb"));
    QCOMPARE(*FileStore::normalised("//a/./b//"), std::string("a/b"));
}

void SimFtpTest::cardSurvivesAReboot()
{
    TestStation station;
    station.run(1);
    FtpClient ftp(station);
    QVERIFY(ftp.upload("/file", someBytes(500)));
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    QVERIFY(*ftp.download("/file") == someBytes(500));
}

void SimFtpTest::flightLogsAreFiles()
{
    TestStation station;
    station.run(6);
    FtpClient ftp(station);
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
        station.run(1);
        QCOMPARE(ftp.error(MAV_FTP_OPCODE_REMOVEFILE, "/APM/LOGS/0000000" + std::to_string(i + 1) + ".BIN"),
                 int(MAV_FTP_ERR_FILEPROTECTED)); // it is being written
        QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_ACCEPTED));
        station.run(1);
    }
    const auto names = ftp.list("/APM/LOGS");
    QCOMPARE(names.size(), std::size_t(3));
    QVERIFY(names[0].starts_with("F00000001.BIN\t"));
    QVERIFY(names[1].starts_with("F00000002.BIN\t"));
    QCOMPARE(names[2], std::string("FLASTLOG.TXT\t2"));
    const auto log = ftp.download("/APM/LOGS/00000002.BIN");
    QVERIFY(log);
    QCOMPARE("F00000002.BIN\t" + std::to_string(log->size()), names[1]);
    QVERIFY((*log)[0] == 0xa3 && (*log)[1] == 0x95 && (*log)[2] == 128);
    QCOMPARE(std::string(asText(*ftp.download("/APM/LOGS/LASTLOG.TXT"))), std::string("2\n"));
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_REMOVEFILE, "/APM/LOGS/00000001.BIN"));
    QCOMPARE(ftp.list("/APM/LOGS").size(), std::size_t(2));
}

void SimFtpTest::parameterFile()
{
    TestStation station({}, 0.1, 2);
    station.run(1);
    FtpClient ftp(station);
    station.vehicle.autopilot().parameters().set("RTL_ALT", 1234);
    const auto file = ftp.download("@PARAM/param.pck");
    QVERIFY(file);
    const auto values = readPacked(*file);
    const Parameters &parameters = station.vehicle.autopilot().parameters();
    QCOMPARE(values.size(), parameters.count());
    for (std::size_t i = 0; i < parameters.count(); ++i)
        QCOMPARE(values.at(parameters.info(i).name), parameters.value(i));
    QVERIFY2(file->size() < parameters.count() * 12, qPrintable(QString::number(file->size()))); // names are shortened
    const auto defaults = readPacked(*ftp.download("@PARAM/param.pck?withdefaults=1"));
    QCOMPARE(defaults.size(), parameters.count() + 1); // of the one that was changed
    QCOMPARE(defaults.at("RTL_ALT default"), 1500.f);
}

void SimFtpTest::partOfTheParameterFile()
{
    TestStation station;
    station.run(1);
    FtpClient ftp(station);
    const Parameters &parameters = station.vehicle.autopilot().parameters();
    const auto file = ftp.download("@PARAM/param.pck?start=10&count=5");
    const auto values = readPacked(*file);
    QCOMPARE(values.size(), std::size_t(5));
    QCOMPARE(values.at(parameters.info(14).name), parameters.value(14));
    ByteReader header(*file);
    header.u32();
    QCOMPARE(std::size_t(header.u16()), parameters.count());
    QCOMPARE(readPacked(*ftp.download("@PARAM/param.pck?start=" + std::to_string(parameters.count() - 1))).size(),
             std::size_t(1));
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_OPENFILERO, "@PARAM/param.pck?start=60000"), int(MAV_FTP_ERR_FAILERRNO));
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_OPENFILERO, "@PARAM/param.pck?start=-1"), int(MAV_FTP_ERR_FAILERRNO));
    QCOMPARE(ftp.error(MAV_FTP_OPCODE_OPENFILERO, "@PARAM/param.pck?count=65536"), int(MAV_FTP_ERR_FAILERRNO));
}

void SimFtpTest::parameterUpload()
{
    TestStation station;
    station.run(1);
    FtpClient ftp(station);
    Parameters wanted;
    wanted.set("RTL_ALT", 2200);
    wanted.set("WPNAV_SPEED", 800);
    Bytes file = packParameters(wanted, {});
    QVERIFY(!ftp.upload("@PARAM/param.pck", file)); // its header has the number of parameters, not its length
    QCOMPARE(station.vehicle.autopilot().parameters().value("RTL_ALT"), 1500.f);
    file[4] = static_cast<std::uint8_t>(file.size());
    file[5] = static_cast<std::uint8_t>(file.size() >> 8);
    QVERIFY(ftp.upload("@PARAM/param.pck", file));
    QCOMPARE(station.vehicle.autopilot().parameters().value("RTL_ALT"), 2200.f);
    QCOMPARE(station.vehicle.autopilot().parameters().value("WPNAV_SPEED"), 800.f);
    QVERIFY(ftp.accepted(MAV_FTP_OPCODE_CREATEFILE, "@PARAM/param.pck"));
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_WRITEFILE, asBytes("x"), 65535).opcode), int(MAV_FTP_OPCODE_NAK));
    QCOMPARE(int(ftp.request(MAV_FTP_OPCODE_WRITEFILE, asBytes("x"), 65534).opcode), int(MAV_FTP_OPCODE_ACK));
}

void SimFtpTest::packedParametersRoundTrip()
{
    QVERIFY(rc::check("what is packed is unpacked", [] {
        Parameters changed;
        for (int i = 0; i < 20; ++i) {
            const auto index = *rc::gen::inRange<std::size_t>(0, changed.count());
            const auto &info = changed.info(index);
            changed.set(index, *rc::gen::element(info.minimum, info.maximum, info.standard));
        }
        Bytes file = packParameters(changed, {});
        file[4] = static_cast<std::uint8_t>(file.size());
        file[5] = static_cast<std::uint8_t>(file.size() >> 8);
        Parameters read;
        RC_ASSERT(unpackParameters(file, read));
        for (std::size_t i = 0; i < changed.count(); ++i)
            RC_ASSERT(read.value(i) == changed.value(i));

        // A file that is cut changes nothing.
        Parameters untouched;
        const auto length = *rc::gen::inRange<std::size_t>(0, file.size());
        file.resize(length);
        if (length >= 6) {
            file[4] = static_cast<std::uint8_t>(length);
            file[5] = static_cast<std::uint8_t>(length >> 8);
        }
        RC_ASSERT(!unpackParameters(file, untouched));
        RC_ASSERT(untouched.revision() == 0u);
    }));
}

void SimFtpTest::randomParameterFiles()
{
    QVERIFY(rc::check("a damaged parameter file is read or refused, and its values stay within their limits", [] {
        Parameters parameters;
        Bytes file = packParameters(parameters, {});
        const auto changes = *rc::gen::inRange(1, 20);
        for (int i = 0; i < changes; ++i)
            file[*rc::gen::inRange<std::size_t>(2, file.size())] = *rc::gen::arbitrary<std::uint8_t>();
        file[4] = static_cast<std::uint8_t>(file.size());
        file[5] = static_cast<std::uint8_t>(file.size() >> 8);
        unpackParameters(file, parameters);
        for (std::size_t i = 0; i < parameters.count(); ++i) {
            const ParameterInfo &info = parameters.info(i);
            RC_ASSERT(parameters.value(i) >= info.minimum && parameters.value(i) <= info.maximum);
        }
    }));
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
