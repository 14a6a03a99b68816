// The exact output of `decode`.
#include "tests/log/recordings.h"
#include "tests/support/test_runner.h"

#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/log/decode.h"
#include "core/mavlink/signing.h"

#include <QtTest/QTest>

#include <sstream>

using namespace skyseal;
using namespace skyseal::tlog;
using skyseal::mavlink::Dialect;

namespace {

std::vector<std::string> linesOf(const std::string &content, DecodeOptions options = {})
{
    std::istringstream input(content);
    std::vector<std::string> lines;
    decode(input, Dialect::builtin(), options, [&lines](std::string_view line) {
        lines.emplace_back(line);
        return true;
    });
    return lines;
}

Key32 keyOf(std::uint8_t first)
{
    Key32 key;
    key.mutableView()[0] = first;
    return key;
}

std::string signedHeartbeat(const Key32 &key)
{
    mavlink::FrameSigner signer(key.clone(), 3, 1000);
    mavlink::FrameWriter writer(1, 1);
    writer.setSigner(&signer);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return std::string(asText(writer.write(mavlink::Heartbeat(), buffer)));
}

} // namespace

class DecodeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void jsonOfAMessage();
    void badSpotsAreListedBetweenGoodFrames();
    void timesOfARecording();
    void signaturesAreCheckedWithAKey();
    void specialValues();
    void plainText();
    void stopsWhenTheSinkFails();
};

void DecodeTest::jsonOfAMessage()
{
    const auto lines = linesOf(heartbeat(7), {.json = true});
    QCOMPARE(lines.size(), std::size_t(1));
    QCOMPARE(lines[0],
             std::string(R"({"event":"message","id":0,"name":"HEARTBEAT","version":2,"sysid":1,"compid":1,"seq":0,)"
                         R"("signed":false,"fields":{"type":2,"autopilot":0,"base_mode":0,"custom_mode":7,)"
                         R"("system_status":0,"mavlink_version":3}})"));
}

void DecodeTest::badSpotsAreListedBetweenGoodFrames()
{
    std::string wrong = heartbeat(2);
    wrong[10] ^= 0x40;
    const std::string cut = heartbeat(4).substr(0, 15);
    const auto lines = linesOf("junk" + heartbeat(1) + wrong + heartbeat(3) + cut, {.json = true});
    QCOMPARE(lines.size(), std::size_t(5));
    QCOMPARE(lines[0], std::string(R"({"event":"bad","reason":"garbage","offset":0,"length":4})"));
    QVERIFY(lines[1].find(R"("custom_mode":1,)") != std::string::npos);
    QCOMPARE(lines[2], std::string(R"({"event":"bad","reason":"bad_crc","offset":25,"length":21})"));
    QVERIFY(lines[3].find(R"("custom_mode":3,)") != std::string::npos);
    QCOMPARE(lines[4], std::string(R"({"event":"bad","reason":"truncated","offset":67,"length":15})"));
}

void DecodeTest::timesOfARecording()
{
    const auto lines = linesOf(entry(kNoon, heartbeat(1)), {.json = true});
    QVERIFY(lines[0].ends_with(R"("mavlink_version":3},"time_usec":"1700000000000000"})"));
    QVERIFY(linesOf(entry(kNoon, heartbeat(1)))[0].starts_with("2023-11-14T22:13:20.000000Z 1/1 HEARTBEAT "));
}

void DecodeTest::signaturesAreCheckedWithAKey()
{
    const Key32 right = keyOf(1), wrong = keyOf(2);
    const std::string content = signedHeartbeat(right) + heartbeat(1);
    QVERIFY(linesOf(content, {.json = true})[0].find(R"("signed":true,)") != std::string::npos);
    QVERIFY(linesOf(content, {.json = true, .signingKey = &right})[0].starts_with(R"({"event":"message")"));
    const auto refused = linesOf(content, {.json = true, .signingKey = &wrong});
    QCOMPARE(refused[0], std::string(R"({"event":"bad","reason":"bad_signature","offset":0,"length":34})"));
    QVERIFY(refused[1].starts_with(R"({"event":"message")"));
}

void DecodeTest::specialValues()
{
    mavlink::FrameWriter writer(1, 1);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::ParamValue parameter;
    mavlink::setText(parameter.param_id, "A\xff\xc3\xa9");
    parameter.param_value = -0.0f;
    std::string content(asText(writer.write(parameter, buffer)));
    mavlink::LocalPositionNed position;
    position.x = std::bit_cast<float>(0xffc00001u);
    position.y = -std::numeric_limits<float>::infinity();
    position.z = std::numeric_limits<float>::denorm_min();
    content += asText(writer.write(position, buffer));
    mavlink::SystemTime time;
    time.time_unix_usec = ~std::uint64_t(0);
    content += asText(writer.write(time, buffer));
    const auto lines = linesOf(content, {.json = true});
    QVERIFY(lines[0].find("\"param_id\":\"A\xef\xbf\xbd\xc3\xa9\",\"param_value\":-0.0,") != std::string::npos);
    QVERIFY(lines[0].ends_with(R"(},"text_bytes":{"param_id":"41ffc3a9"}})"));
    QVERIFY(lines[1].find(R"("x":"NaN","y":"-Infinity","z":1e-45,)") != std::string::npos);
    QVERIFY(lines[1].ends_with(R"(},"nan_bits":{"x":{"0":"ffc00001"}}})"));
    QVERIFY(lines[2].find(R"("time_unix_usec":"18446744073709551615",)") != std::string::npos);
}

void DecodeTest::plainText()
{
    mavlink::FrameWriter writer(9, 1);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::Heartbeat message;
    message.type = mavlink::MAV_TYPE_QUADROTOR;
    message.base_mode = mavlink::MAV_MODE_FLAG_SAFETY_ARMED | mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    message.system_status = 200;
    QCOMPARE(
        linesOf(std::string(asText(writer.write(message, buffer))))[0],
        std::string("9/1 HEARTBEAT type=MAV_TYPE_QUADROTOR autopilot=MAV_AUTOPILOT_GENERIC "
                    "base_mode=MAV_MODE_FLAG_CUSTOM_MODE_ENABLED|MAV_MODE_FLAG_SAFETY_ARMED custom_mode=0 system_status=200 "
                    "mavlink_version=3"));
    mavlink::Statustext text;
    mavlink::setText(text.text, "say \"hi\"\n");
    const std::string line = linesOf(std::string(asText(writer.write(text, buffer))))[0];
    QVERIFY(line.find("text=\"say \\\"hi\\\"\\x0a\"") != std::string::npos);
    QCOMPARE(linesOf("??")[0], std::string("bad: garbage at byte 0, 2 bytes"));
}

void DecodeTest::stopsWhenTheSinkFails()
{
    std::istringstream input(heartbeat(1) + heartbeat(2));
    const auto counts = decode(input, Dialect::builtin(), {}, [](std::string_view) { return false; });
    QCOMPARE(counts.messages, std::uint64_t(1));
}

SKYSEAL_TEST_APPLESS(DecodeTest)
#include "decode_test.moc"
