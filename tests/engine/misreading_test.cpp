// An observer's frame does not turn into another message when bytes are lost: no frame starts inside it, however many bytes are
// missing at the front; one lost byte anywhere makes no other message; and no request for information becomes a command.
#include "core/engine/common/misreading.h"
#include "core/engine/agent/observer_rules.h"
#include "core/engine/common/question_rules.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>
#include <bit>
#include <random>
#include <set>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr std::uint64_t kMisreadingSeed = 20261121;
constexpr std::uint16_t kSetInterval = mavlink::MAV_CMD_SET_MESSAGE_INTERVAL; // 511, permitted at some rates
/// All messages that an observer may send.
const std::set<std::uint32_t> kKinds{20, 21, 40, 43, 47, 51, 66, 75, 76, 111, 320, 321};

const mavlink::MessageInfo &infoOf(std::uint32_t id)
{
    return *mavlink::Dialect::builtin().find(id);
}

Bytes written(std::uint32_t id, ByteView payload, mavlink::FrameWriter &writer)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const mavlink::MessageInfo &info = infoOf(id);
    const ByteView frame = writer.write(id, info.crcExtra, info.minLength, payload, buffer);
    return Bytes(frame.begin(), frame.end());
}

mavlink::Frame read(const Bytes &bytes)
{
    const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
    if (!frame)
        qFatal("no frame");
    return *frame;
}

bool passes(const Bytes &bytes)
{
    const mavlink::Frame frame = read(bytes);
    return observerMaySend(frame, false) && !mayBeMisread(frame);
}

/// Ids of all frames in a stream.
std::vector<std::uint32_t> kindsIn(ByteView stream)
{
    std::vector<std::uint32_t> out;
    mavlink::StreamParser parser(mavlink::Dialect::builtin());
    const auto note = [&](const mavlink::ScanItem &item) {
        if (item.frame)
            out.push_back(item.frame->messageId());
    };
    parser.feed(stream, note);
    parser.finish(note);
    return out;
}

/// A permitted payload of this kind, with random content otherwise.
Bytes payloadFor(std::uint32_t id, std::mt19937_64 &random)
{
    Bytes out(infoOf(id).maxLength);
    for (auto &byte : out)
        byte = static_cast<std::uint8_t>(random());
    constexpr std::uint16_t kCommands[] = {410, kSetInterval, 512, 519, 520};
    const std::uint16_t command = kCommands[random() % std::size(kCommands)];
    const float second = command == kSetInterval ? float(1e6 / double(1 + random() % 10)) : float(random() % 256);
    if (id == mavlink::Timesync::kId) {
        std::fill_n(out.begin(), 8, std::uint8_t(0));
    } else if (id == mavlink::MissionAck::kId) {
        out[2] = 0;
    } else if (id == mavlink::RequestDataStream::kId) {
        out[0] = static_cast<std::uint8_t>(1 + random() % 10); // Hz
        out[1] = 0;
        out[5] = 1;
    } else if (id == mavlink::CommandLong::kId) {
        Bytes tail(out.end() - 3, out.end());
        std::array<std::uint8_t, mavlink::CommandLong::kMaxLength> plain;
        mavlink::CommandLong{.target_system = tail[0],
                             .target_component = tail[1],
                             .command = command,
                             .confirmation = tail[2],
                             .param1 = float(random() % 0x1000000),
                             .param2 = second}
            .encode(plain);
        out.assign(plain.begin(), plain.end());
    } else if (id == mavlink::CommandInt::kId) {
        Bytes tail(out.end() - 5, out.end());
        std::array<std::uint8_t, mavlink::CommandInt::kMaxLength> plain;
        mavlink::CommandInt{.target_system = tail[0],
                            .target_component = tail[1],
                            .frame = tail[2],
                            .command = command,
                            .current = tail[3],
                            .autocontinue = tail[4],
                            .param1 = float(random() % 0x1000000),
                            .param2 = second}
            .encode(plain);
        out.assign(plain.begin(), plain.end());
    } else {
        for (const mavlink::FieldInfo &field : infoOf(id).fields) {
            for (std::size_t i = 0; field.type == mavlink::FieldType::Char && i < field.size(); ++i)
                out[field.offset + i] = static_cast<std::uint8_t>(0x20 + out[field.offset + i] % 0x5f);
        }
    }
    return out;
}

/// Calls `check(frame)` with this number of permitted frames of each kind.
template<typename Check> void forPassing(int each, Check check)
{
    std::mt19937_64 random(kMisreadingSeed);
    for (const std::uint32_t id : kKinds) {
        int passed = 0, made = 0;
        for (; passed < each; ++made) {
            QVERIFY2(made < each * 50, qPrintable(QString::number(id)));
            mavlink::FrameWriter writer(static_cast<std::uint8_t>(2 + random() % 250), static_cast<std::uint8_t>(random()));
            for (auto skip = random() % 256; skip > 0; --skip)
                written(21, Bytes(2, 1), writer);
            const Bytes frame = written(id, payloadFor(id, random), writer);
            if (!passes(frame))
                continue;
            ++passed;
            check(frame);
        }
    }
}

} // namespace

class MisreadingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(kMisreadingSeed)); }
    void anyNumberOfMissingFirstBytes();
    void nestedFramesAreRefused_data();
    void nestedFramesAreRefused();
    void frameNestedOverTwoFrames();
    void oneLostByteMakesNoOtherMessage();
    void lostBytesDoNotMakeACommand();
    void requestsAdjacentToACommandAreRefused_data();
    void requestsAdjacentToACommandAreRefused();
    void unusualFormsAreRefused();
    void usualRequestsPass();
    void fewSystemIdsAreRefused();
};

void MisreadingTest::anyNumberOfMissingFirstBytes()
{
    mavlink::FrameWriter pilot(255, 190);
    const Bytes next = written(0, Bytes(9, 3), pilot);
    Bytes before;
    forPassing(200, [&](const Bytes &frame) {
        const std::uint32_t kind = read(frame).messageId();
        for (std::size_t lost = 1; lost < before.size(); ++lost) {
            Bytes stream(before.begin() + static_cast<std::ptrdiff_t>(lost), before.end());
            stream.insert(stream.end(), frame.begin(), frame.end());
            stream.insert(stream.end(), next.begin(), next.end());
            QCOMPARE(kindsIn(stream), (std::vector<std::uint32_t>{kind, 0}));
        }
        before = frame;
    });
}

void MisreadingTest::nestedFramesAreRefused_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("version");
    for (const std::uint32_t id : kKinds) {
        for (const int version : {1, 2})
            QTest::addRow("MAVLink %d within %s", version, infoOf(id).name.data()) << int(id) << version;
    }
}

void MisreadingTest::nestedFramesAreRefused()
{
    QFETCH(int, kind);
    QFETCH(int, version);
    const std::uint32_t id = static_cast<std::uint32_t>(kind);
    // A real command that arms by force, behind what the message has; and the shortest frame that there is, within it.
    mavlink::FrameWriter inner(255, 190, version);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView nested = inner.write(mavlink::CommandLong{.target_system = 1,
                                                             .target_component = 1,
                                                             .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM,
                                                             .param1 = 1,
                                                             .param2 = 21196},
                                        buffer);
    std::mt19937_64 random(kMisreadingSeed);
    Bytes payload = payloadFor(id, random);
    payload.insert(payload.end(), nested.begin(), nested.end());
    mavlink::FrameWriter outer(255, 190);
    const Bytes frame = written(id, payload, outer);
    const auto first = kindsIn(ByteView(frame).subspan(1));
    QVERIFY(std::find(first.begin(), first.end(), mavlink::CommandLong::kId) != first.end()); // it is a real one
    QVERIFY(!observerMaySend(read(frame), false));
    QVERIFY(mayBeMisread(read(frame)));

    std::array<std::uint8_t, mavlink::kMaxFrameLength> small;
    const ByteView shortest = mavlink::writeFrame(
        small, version, 7, 255, 190, mavlink::MissionClearAll::kId, mavlink::MissionClearAll::kCrcExtra,
        version == 1 ? 0 : mavlink::MissionClearAll::kMinLength, version == 1 ? ByteView() : Bytes(2));
    payload = payloadFor(id, random);
    const std::size_t room = std::min(payload.size(), shortest.size());
    std::copy_n(shortest.begin(), room, payload.end() - static_cast<std::ptrdiff_t>(room));
    QVERIFY(mayBeMisread(read(written(id, payload, outer))) || !observerMaySend(read(written(id, payload, outer)), false));
}

void MisreadingTest::frameNestedOverTwoFrames()
{
    // One frame that begins in the time of a TIMESYNC, and whose payload and checksum are the next TIMESYNC's head and time:
    // neither holds a whole one, and a search for whole ones in each would let both through.
    mavlink::FrameWriter writer(255, 190);
    std::array<std::uint8_t, 18> payload{};
    const auto timesync = [&](const std::array<std::uint8_t, 8> &time) {
        std::copy(time.begin(), time.end(), payload.begin() + 8);
        return written(mavlink::Timesync::kId, ByteView(payload).first(16), writer);
    };
    // MAVLink 1, and after its first two bytes: sequence, system, component, message; the payload is the first frame's
    // checksum and the second one's first 18 bytes (head and tc1); its checksum is two bytes of the second's time.
    const Bytes first = timesync({0xfe, 22, 0, 255, 190, mavlink::CommandLong::kId, 1, 1});
    const Bytes plain = timesync({1, 2, 3, 4, 5, 6, 7, 8});
    QCOMPARE(first.size(), std::size_t(28));
    Bytes stream = first;
    stream.insert(stream.end(), plain.begin(), plain.end());
    const std::size_t nested = 18, end = nested + 6 + 22;
    bool found = false;
    for (unsigned guess = 0; guess < 65536 && !found; ++guess) {
        Bytes tried = stream;
        tried[end] = static_cast<std::uint8_t>(guess);
        tried[end + 1] = static_cast<std::uint8_t>(guess >> 8);
        found = mavlink::readFrame(ByteView(tried).subspan(nested), mavlink::Dialect::builtin()).has_value();
    }
    QVERIFY(found); // so an attacker only needs to choose that time
    QVERIFY(!passes(first));
    QVERIFY(passes(plain));
}

void MisreadingTest::oneLostByteMakesNoOtherMessage()
{
    // Judged by the header, whatever the checksum, which a sender can choose. Vehicles send these messages, and no autopilot
    // acts on them: HEARTBEAT, SYS_STATUS, LOCAL_POSITION_NED_COV, RC_CHANNELS.
    const std::set<std::uint32_t> harmless{0, 1, 64, 65};
    forPassing(2000, [&](const Bytes &frame) {
        for (std::size_t lost = 1; lost < frame.size(); ++lost) {
            Bytes left = frame;
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(lost));
            const bool unknownFormat = (left[2] & ~mavlink::kFlagSigned) != 0;
            const std::uint32_t id = left[7] | left[8] << 8 | static_cast<std::uint32_t>(left[9]) << 16;
            QVERIFY2(unknownFormat || harmless.contains(id) || kKinds.contains(id) || !mavlink::Dialect::builtin().find(id),
                     qPrintable(QStringLiteral("%1 without byte %2 is %3").arg(read(frame).messageId()).arg(lost).arg(id)));
        }
    });
}

void MisreadingTest::lostBytesDoNotMakeACommand()
{
    const mavlink::EnumInfo *commands = mavlink::Dialect::builtin().enumeration("MAV_CMD");
    forPassing(500, [&](const Bytes &frame) {
        const std::uint32_t kind = read(frame).messageId();
        if (kind != mavlink::CommandLong::kId && kind != mavlink::CommandInt::kId)
            return;
        // One byte is lost, or any two, wherever they stood: of the number, before it or behind it.
        const auto check = [&](const Bytes &left, std::size_t first, std::size_t second) {
            if (left.size() < 40)
                return;
            const auto command = static_cast<std::uint16_t>(left[38] | left[39] << 8);
            const bool isRateAsJudged = command == kSetInterval && std::equal(left.begin(), left.begin() + 39, frame.begin());
            QVERIFY2(commands->nameOf(command).empty() || isQuestion(command) || isRateAsJudged,
                     qPrintable(QStringLiteral("%1 without bytes %2, %3").arg(command).arg(first).arg(second)));
        };
        for (std::size_t first = 1; first < frame.size(); ++first) {
            Bytes left = frame;
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(first));
            check(left, first, first);
            for (std::size_t second = first; second < left.size(); ++second) {
                Bytes less = left;
                less.erase(less.begin() + static_cast<std::ptrdiff_t>(second));
                check(less, first, second + 1);
            }
        }
    });
}

void MisreadingTest::requestsAdjacentToACommandAreRefused_data()
{
    QTest::addColumn<int>("question");
    QTest::addColumn<int>("target");
    QTest::addColumn<int>("lost");
    QTest::addColumn<int>("command");
    QTest::newRow("two bytes before it: COMPONENT_ARM_DISARM") << 512 << 0x90 << 0 << 400;
    QTest::newRow("its high byte: CAN_FORWARD") << 512 << 125 << 39 << 32000;
    QTest::newRow("its high byte: FLASH_BOOTLOADER") << 410 << 166 << 39 << 42650;
    QTest::newRow("its high byte: another of the autopilot's own") << 519 << 166 << 39 << 42503;
    QTest::newRow("two bytes before it: a rate of another message") << 512 << 0xff << 0 << int(kSetInterval);
}

void MisreadingTest::requestsAdjacentToACommandAreRefused()
{
    QFETCH(int, question);
    QFETCH(int, target);
    QFETCH(int, lost);
    QFETCH(int, command);
    mavlink::FrameWriter writer(255, 190);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = writer.write(mavlink::CommandLong{.target_system = static_cast<std::uint8_t>(target),
                                                             .target_component = 1,
                                                             .command = static_cast<std::uint16_t>(question),
                                                             .confirmation = 1,
                                                             .param1 = 1},
                                        buffer);
    const Bytes bytes(frame.begin(), frame.end());
    Bytes left = bytes;
    if (lost > 0)
        left.erase(left.begin() + lost);
    else
        left.erase(left.begin() + 10, left.begin() + 12);
    QCOMPARE(left[38] | left[39] << 8, command);
    QVERIFY(!mavlink::Dialect::builtin().enumeration("MAV_CMD")->nameOf(static_cast<std::uint32_t>(command)).empty());
    QVERIFY(observerMaySend(read(bytes), false));
    QVERIFY(mayBeMisread(read(bytes)));
}

void MisreadingTest::unusualFormsAreRefused()
{
    mavlink::FrameWriter old(255, 190, 1), writer(255, 190);
    const Bytes payload(infoOf(mavlink::MissionRequestList::kId).maxLength, 1);
    QVERIFY(passes(written(mavlink::MissionRequestList::kId, payload, writer)));
    QVERIFY(!passes(written(mavlink::MissionRequestList::kId, payload, old)));
    Bytes longer = payload;
    longer.push_back(1);
    QVERIFY(!passes(written(mavlink::MissionRequestList::kId, longer, writer)));
    mavlink::ParamRequestRead named{.target_system = 1, .target_component = 1, .param_index = -1};
    const auto frameOf = [&] {
        std::array<std::uint8_t, mavlink::ParamRequestRead::kMaxLength> bytes;
        named.encode(bytes);
        return written(mavlink::ParamRequestRead::kId, bytes, writer);
    };
    mavlink::setText(named.param_id, "WPNAV_SPEED");
    QVERIFY(passes(frameOf()));
    mavlink::setText(named.param_id, "WPNAV\x01SPEED");
    QVERIFY(!passes(frameOf()));
    mavlink::setText(named.param_id, "WPNAV");
    named.param_id[10] = 'X';
    QVERIFY(!passes(frameOf()));
}

void MisreadingTest::usualRequestsPass()
{
    // Times of a clock in nanoseconds: one in thirteen holds such a byte, with sequence and checksum.
    mavlink::FrameWriter writer(255, 190);
    std::mt19937_64 random(kMisreadingSeed);
    int passed = 0;
    constexpr int kTimes = 20000;
    for (int i = 0; i < kTimes; ++i) {
        std::array<std::uint8_t, mavlink::Timesync::kMaxLength> payload;
        mavlink::Timesync{.ts1 = static_cast<std::int64_t>(random() >> 1), .target_system = 1, .target_component = 1}.encode(
            payload);
        passed += passes(written(mavlink::Timesync::kId, payload, writer));
    }
    qInfo("%.1f percent of times pass", 100.0 * passed / kTimes);
    QVERIFY(passed > kTimes * 85 / 100);
    // Messages can be asked for, if need be by a few retries with other sequence numbers; but for those whose own number,
    // as a float, holds such a byte.
    std::size_t never = 0, tried = 0, dropped = 0;
    for (const mavlink::MessageInfo &info : mavlink::Dialect::builtin().messages()) {
        bool any = false;
        for (int attempt = 0; attempt < 5 && !any; ++attempt) {
            std::array<std::uint8_t, mavlink::CommandLong::kMaxLength> payload;
            mavlink::CommandLong{.target_system = 1,
                                 .target_component = 1,
                                 .command = 512,
                                 .confirmation = static_cast<std::uint8_t>(attempt),
                                 .param1 = float(info.id)}
                .encode(payload);
            any = passes(written(mavlink::CommandLong::kId, payload, writer));
            ++tried;
            dropped += !any;
        }
        const auto number = std::bit_cast<std::array<std::uint8_t, 4>>(float(info.id));
        const bool unsayable = std::any_of(number.begin(), number.end(),
                                           [](auto byte) { return byte == 0xfd || byte == 0xfe; });
        QVERIFY2(any != unsayable, info.name.data());
        never += unsayable;
        if (unsayable) { // not counted with those that are dropped by chance
            tried -= 5;
            dropped -= 5;
        }
    }
    const double share = static_cast<double>(dropped) / static_cast<double>(tried);
    qInfo("%.1f percent of questions for a message are dropped", 100 * share);
    QVERIFY(share < 0.05);
    qInfo("%zu messages cannot be asked for", never);
    QVERIFY(never < 10);
}

void MisreadingTest::fewSystemIdsAreRefused()
{
    // The system id forms a command together with the adjacent bytes, whatever the rest of the request.
    mavlink::FrameWriter writer(255, 190);
    const auto unaskable = [&](std::uint16_t question) {
        std::vector<unsigned> out;
        for (unsigned system = 1; system < 253; ++system) {
            bool any = false;
            for (unsigned attempt = 0; attempt < 8 && !any; ++attempt) {
                std::array<std::uint8_t, mavlink::CommandLong::kMaxLength> payload;
                mavlink::CommandLong{.target_system = static_cast<std::uint8_t>(system),
                                     .target_component = 1,
                                     .command = question,
                                     .confirmation = static_cast<std::uint8_t>(attempt),
                                     .param1 = 30,
                                     .param2 = question == kSetInterval ? 1e6f : 0}
                    .encode(payload);
                any = passes(written(mavlink::CommandLong::kId, payload, writer));
            }
            if (!any)
                out.push_back(system);
        }
        return out;
    };
    const std::vector<unsigned> message{4, 6, 44, 54, 55, 125, 144, 145, 149, 150, 164, 244};
    const std::vector<unsigned> home{4, 6, 44, 54, 55, 144, 145, 149, 150, 164, 166, 244};
    const std::vector<unsigned> capabilities{4, 6, 44, 54, 55, 144, 145, 149, 150, 164, 244};
    QCOMPARE(unaskable(mavlink::MAV_CMD_REQUEST_MESSAGE), message);
    QCOMPARE(unaskable(mavlink::MAV_CMD_GET_HOME_POSITION), home);
    QCOMPARE(unaskable(mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION), home);
    QCOMPARE(unaskable(mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES), capabilities);
    QCOMPARE(unaskable(kSetInterval), capabilities);
}

SKYSEAL_TEST_APPLESS(MisreadingTest)
#include "misreading_test.moc"
