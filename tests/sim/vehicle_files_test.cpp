// The files of a vehicle: the memory card and its limits, the flight logs, and the packed parameter file in both directions.
#include "tests/sim/ftp_requester.h"
#include "tests/support/test_runner.h"

#include "core/sim/packed_parameters.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <bit>
#include <map>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimVehicleFilesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void storeIsBounded();
    void cardSurvivesAReboot();
    void flightLogsAreFiles();
    void parameterFile();
    void partOfTheParameterFile();
    void parameterUpload();
    void packedParametersRoundTrip();
    void randomParameterFiles();
};

namespace {

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

void SimVehicleFilesTest::storeIsBounded()
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

void SimVehicleFilesTest::cardSurvivesAReboot()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
    QVERIFY(ftp.upload("/file", someBytes(500)));
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    QVERIFY(*ftp.download("/file") == someBytes(500));
}

void SimVehicleFilesTest::flightLogsAreFiles()
{
    TestStation station;
    station.run(6);
    FtpRequester ftp(station);
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

void SimVehicleFilesTest::parameterFile()
{
    TestStation station({}, 0.1, 2);
    station.run(1);
    FtpRequester ftp(station);
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

void SimVehicleFilesTest::partOfTheParameterFile()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
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

void SimVehicleFilesTest::parameterUpload()
{
    TestStation station;
    station.run(1);
    FtpRequester ftp(station);
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

void SimVehicleFilesTest::packedParametersRoundTrip()
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

void SimVehicleFilesTest::randomParameterFiles()
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

SKYSEAL_TEST_APPLESS(SimVehicleFilesTest)
#include "vehicle_files_test.moc"
