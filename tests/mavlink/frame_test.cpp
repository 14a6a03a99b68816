// Frames written and read, trimmed, damaged and found again between garbage.
#include "core/base/hex.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <vector>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

Bytes heartbeat(std::uint8_t customMode = 4)
{
    FrameWriter writer(7, 1);
    Heartbeat message;
    message.type = MAV_TYPE_QUADROTOR;
    message.custom_mode = customMode;
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = writer.write(message, buffer);
    return {frame.begin(), frame.end()};
}

void append(Bytes &to, const Bytes &more)
{
    to.insert(to.end(), more.begin(), more.end());
}

} // namespace

class FrameTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void typedMessageRoundTrips();
    void trailingZerosAreTrimmedToOneByte();
    void everySingleBitFlipIsRefused();
    void unknownIncompatFlagIsSkippedWhole();
    void garbageHidesNoFrame();
    void everySplitOfAStreamGivesTheSame();
};

void FrameTest::typedMessageRoundTrips()
{
    const Bytes bytes = heartbeat(9);
    const auto frame = readFrame(bytes, Dialect::builtin());
    QVERIFY(frame.has_value());
    QCOMPARE(frame->messageId(), Heartbeat::kId);
    QCOMPARE(frame->systemId(), std::uint8_t(7));
    const Heartbeat read = Heartbeat::decode(frame->payload());
    QCOMPARE(read.custom_mode, 9u);
    QCOMPARE(read.type, std::uint8_t(MAV_TYPE_QUADROTOR));
    QCOMPARE(read.mavlink_version, std::uint8_t(3));
}

void FrameTest::trailingZerosAreTrimmedToOneByte()
{
    FrameWriter writer(1, 1);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = writer.write(SystemTime{}, buffer);
    QCOMPARE(frame.size(), std::size_t(13));
    const auto read = readFrame(frame, Dialect::builtin());
    QVERIFY(read.has_value());
    QCOMPARE(SystemTime::decode(read->payload()).time_boot_ms, 0u);
    QCOMPARE(SystemTime::decode({}).time_boot_ms, 0u);
}

void FrameTest::everySingleBitFlipIsRefused()
{
    const Bytes good = heartbeat();
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
        Bytes bad = good;
        bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1 << bit % 8));
        QVERIFY2(!readFrame(bad, Dialect::builtin()), qPrintable(QString::number(bit)));
    }
}

void FrameTest::unknownIncompatFlagIsSkippedWhole()
{
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    std::array<std::uint8_t, Heartbeat::kMaxLength> payload{};
    const auto odd = writeFrame(buffer, 2, 0, 1, 1, Heartbeat::kId, Heartbeat::kCrcExtra, Heartbeat::kMinLength, payload, 0x80);
    Bytes stream(odd.begin(), odd.end());
    append(stream, heartbeat());
    FrameScanner scanner(stream, Dialect::builtin());
    const auto first = scanner.next();
    QVERIFY(!first->frame && first->fault == FrameFault::UnknownIncompatFlags);
    QVERIFY(scanner.next()->frame.has_value());
    QVERIFY(!scanner.next());
}

void FrameTest::garbageHidesNoFrame()
{
    // A false start that claims 255 bytes, an unknown message that claims the next frame's bytes, and noise.
    Bytes stream = heartbeat(1);
    append(stream, *fromHex("fdff0000"));
    append(stream, heartbeat(2));
    append(stream, *fromHex("fd1000000000ffffff00"));
    append(stream, heartbeat(3));
    append(stream, *fromHex("0011fe"));
    append(stream, heartbeat(4));
    std::vector<std::uint32_t> seen;
    FrameScanner scanner(stream, Dialect::builtin());
    std::size_t covered = 0;
    while (const auto item = scanner.next()) {
        QCOMPARE(item->offset, covered);
        covered += item->bytes.size();
        if (item->frame)
            seen.push_back(Heartbeat::decode(item->frame->payload()).custom_mode);
    }
    QCOMPARE(covered, stream.size());
    QCOMPARE(seen, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

void FrameTest::everySplitOfAStreamGivesTheSame()
{
    Bytes stream = *fromHex("0d0a496e6974");
    for (std::uint8_t i = 0; i < 5; ++i)
        append(stream, heartbeat(i));
    for (std::size_t split = 0; split <= stream.size(); ++split) {
        StreamParser parser(Dialect::builtin());
        std::size_t frames = 0, bytes = 0;
        const auto count = [&](const ScanItem &item) {
            QCOMPARE(item.offset, bytes);
            bytes += item.bytes.size();
            frames += item.frame.has_value();
        };
        parser.feed(ByteView(stream).first(split), count);
        parser.feed(ByteView(stream).subspan(split), count);
        parser.finish(count);
        QCOMPARE(frames, std::size_t(5));
        QCOMPARE(bytes, stream.size());
    }
}

SKYSEAL_TEST_APPLESS(FrameTest)
#include "frame_test.moc"
