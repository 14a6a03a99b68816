// The option --serve: forms, defaults, and errors that name the invalid part.
#include "core/engine/gateway/serve_config.h"
#include "core/link/address_text.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/message_ids.h"
#include "core/mavlink/messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

class ServeConfigTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clientsMayOnlyReadByDefault();
    void listensOnLoopbackUnlessAnAddressIsGiven();
    void optionsMayHaveLists();
    void rightsOpenClasses();
    void missionItemsThatCommandNeedTheRightToCommand();
    void clientsComeFromTheNetworkAlone();
    void errorsNameTheInvalidPart_data();
    void errorsNameTheInvalidPart();
};

namespace {

/// A frame of a message without fields that matter, or of one that is in no dialect.
struct FrameOf
{
    explicit FrameOf(std::uint32_t messageId)
    {
        bytes = {mavlink::kMagic2,
                 0,
                 0,
                 0,
                 0,
                 255,
                 190,
                 static_cast<std::uint8_t>(messageId),
                 static_cast<std::uint8_t>(messageId >> 8),
                 static_cast<std::uint8_t>(messageId >> 16),
                 0,
                 0};
        item.bytes = bytes;
        item.fault = mavlink::FrameFault::UnknownMessage;
    }
    template<typename Message> explicit FrameOf(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView written = mavlink::FrameWriter(255, 190).write(message, buffer);
        bytes.assign(written.begin(), written.end());
        item.bytes = bytes;
        item.frame = *mavlink::readFrame(bytes, mavlink::Dialect::builtin());
    }
    FrameOf(const FrameOf &) = delete;

    Bytes bytes;
    mavlink::ScanItem item;
};

bool mayWrite(const WriteRights &rights, std::uint32_t messageId)
{
    return rights.mayWrite(FrameOf(messageId).item);
}

} // namespace

void ServeConfigTest::clientsMayOnlyReadByDefault()
{
    const auto config = ServeConfig::parse("udpin:14550");
    QVERIFY(config);
    QVERIFY(!config->write.any());
    QCOMPARE(config->write.toText(), std::string("none"));
    QCOMPARE(config->name, std::string("udpin:127.0.0.1:14550"));
    for (const unsigned id : {1u, 254u, 255u})
        QVERIFY(config->maySpeakAs(static_cast<std::uint8_t>(id)));
}

void ServeConfigTest::listensOnLoopbackUnlessAnAddressIsGiven()
{
    for (const char *own : {"udpin:14550", "tcpin:5760", "udpout:127.0.0.1:14550", "udpin:[::1]:14550", "tcpin:localhost:5760"})
        QVERIFY2(!ServeConfig::parse(own)->isOpenToOthers(), own);
    for (const char *open : {"udpin:0.0.0.0:14550", "tcpin:192.168.1.2:5760", "udpout:10.0.0.9:14550", "udpin:[::]:14550"})
        QVERIFY2(ServeConfig::parse(open)->isOpenToOthers(), open);
}

void ServeConfigTest::optionsMayHaveLists()
{
    const auto config = ServeConfig::parse("tcpin:5760,write=mission,param,name=Planner,sysid=250,251,from=10.1.0.0/16");
    QVERIFY2(config, config ? "" : config.error().text().c_str());
    QCOMPARE(config->write.toText(), std::string("mission,param"));
    QCOMPARE(config->name, std::string("Planner"));
    QVERIFY(config->maySpeakAs(250) && config->maySpeakAs(251) && !config->maySpeakAs(255));
    QCOMPARE(config->from->second, 16);
}

void ServeConfigTest::rightsOpenClasses()
{
    using namespace mavlink;
    const auto rights = WriteRights::parse("param,rc");
    QVERIFY(rights && rights->any());
    QVERIFY(mayWrite(*rights, MAVLINK_MSG_ID_PARAM_SET) && mayWrite(*rights, MAVLINK_MSG_ID_RC_CHANNELS_OVERRIDE));
    for (const std::uint32_t closed :
         {std::uint32_t(MAVLINK_MSG_ID_COMMAND_LONG), std::uint32_t(MAVLINK_MSG_ID_MISSION_COUNT),
          std::uint32_t(MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL), std::uint32_t(MAVLINK_MSG_ID_SERIAL_CONTROL), 16'000'000u})
        QVERIFY(!mayWrite(*rights, closed));
    for (const std::uint32_t any : {std::uint32_t(MAVLINK_MSG_ID_SERIAL_CONTROL), 16'000'000u})
        QVERIFY(mayWrite(WriteRights::all(), any));
    for (const char *text : {"none", "all", "mission,param,command,ftp,rc", "ftp"})
        QCOMPARE(WriteRights::parse(text)->toText(), std::string(text));
}

void ServeConfigTest::missionItemsThatCommandNeedTheRightToCommand()
{
    using namespace mavlink;
    const WriteRights mission = *WriteRights::parse("mission"), command = *WriteRights::parse("command");
    for (const int current : {0, 1, 2, 3, 255}) {
        const auto now = static_cast<std::uint8_t>(current);
        const bool commands = current >= 2;
        const FrameOf item(MissionItem{.target_system = 1, .command = MAV_CMD_NAV_WAYPOINT, .current = now});
        const FrameOf itemInt(MissionItemInt{.target_system = 1, .command = MAV_CMD_NAV_WAYPOINT, .current = now});
        for (const FrameOf *frame : {&item, &itemInt}) {
            QCOMPARE(mission.mayWrite(frame->item), !commands);
            QCOMPARE(command.mayWrite(frame->item), commands);
        }
    }
    // A vehicle on its mission flies to another item at once.
    const FrameOf setCurrent(MissionSetCurrent{.target_system = 1, .seq = 7});
    QVERIFY(!mission.mayWrite(setCurrent.item) && command.mayWrite(setCurrent.item));
}

void ServeConfigTest::clientsComeFromTheNetworkAlone()
{
    const auto config = ServeConfig::parse("udpin:0.0.0.0:14550,from=10.1.0.0/16");
    QVERIFY(config);
    QVERIFY(config->isFrom(*link::parseAddress("10.1.255.3:5000")));
    QVERIFY(!config->isFrom(*link::parseAddress("10.2.0.1:5000")));
    QVERIFY(!config->isFrom(*link::parseAddress("[::1]:5000")));
    QVERIFY(ServeConfig::parse("udpin:0.0.0.0:14550")->isFrom(*link::parseAddress("10.2.0.1:5000")));
    const auto one = ServeConfig::parse("udpin:0.0.0.0:14550,from=10.1.0.9"),
               six = ServeConfig::parse("udpin:[::]:1,from=fd00::/8");
    QVERIFY(one && one->isFrom(*link::parseAddress("10.1.0.9:5000")) && !one->isFrom(*link::parseAddress("10.1.0.8:5000")));
    QVERIFY(six && six->isFrom(*link::parseAddress("[fd00::9]:5000")) && !six->isFrom(*link::parseAddress("[fe00::9]:5000")));
}

void ServeConfigTest::errorsNameTheInvalidPart_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("named");
    const auto row = [](const char *name, const char *text, const char *named) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(named);
    };
    row("no URL", "", "link URL");
    row("nothing behind the comma", "udpin:14550,", "OPTION=VALUE");
    row("serial line", "serial:/dev/ttyUSB0:57600", "'serial'");
    row("recording", "tlog:/tmp/a.tlog", "'tlog'");
    row("port", "udpin:70000", "port");
    row("unknown option", "udpin:14550,reed=all", "'reed'");
    row("no value", "udpin:14550,all", "'all'");
    row("twice", "udpin:14550,write=all,write=none", "write is given twice");
    row("class", "udpin:14550,write=missions", "write='missions'");
    row("empty class", "udpin:14550,write=param,", "write=''");
    row("system 0", "udpin:14550,sysid=0", "sysid='0'");
    row("system 256", "udpin:14550,sysid=1,256", "sysid='256'");
    row("network", "udpin:14550,from=10.1.0.0/33", "from='10.1.0.0/33'");
    row("part of an address", "udpin:14550,from=10.1", "from='10.1': ADDRESS/PREFIX");
    row("no address", "udpin:14550,from=/8", "from='/8'");
    row("network of one host", "udpout:10.1.0.9:14550,from=10.1.0.0/16", "'udpout' serves the host of its URL alone");
    row("network of one server", "tcp:10.1.0.9:5760,write=all,from=10.1.0.0/16", "from= is for links that listen");
    row("name", "udpin:14550,name=\x1b[31m", "name='?[31m'");
}

void ServeConfigTest::errorsNameTheInvalidPart()
{
    QFETCH(QString, text);
    QFETCH(QString, named);
    const auto config = ServeConfig::parse(text.toStdString());
    QVERIFY(!config);
    const std::string said = config.error().text();
    QVERIFY2(QString::fromStdString(said).contains(named), said.c_str());
}

SKYSEAL_TEST_APPLESS(ServeConfigTest)
#include "serve_config_test.moc"
