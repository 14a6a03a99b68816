// Any message, any bytes, any damage, any portions.
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/payload_builder.h"
#include "core/mavlink/stream_parser.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <algorithm>
#include <vector>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

struct Written
{
    Bytes bytes;
    const MessageInfo *info = nullptr;
};

/// Any built-in message with any contents, as version 2 or, where it can be, 1.
Written anyFrame(bool alsoVersion1 = true)
{
    const auto messages = Dialect::builtin().messages();
    const MessageInfo &info = messages[*rc::gen::inRange<std::size_t>(0, messages.size())];
    Bytes payload = *rc::gen::container<Bytes>(
        info.maxLength, rc::gen::weightedElement<std::uint8_t>({{4, 0}, {1, 1}, {1, 0xfd}, {1, 0xfe}, {1, 0xff}, {1, 0x40}}));
    const int version = alsoVersion1 && info.id < 256 && *rc::gen::arbitrary<bool>() ? 1 : 2;
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = writeFrame(buffer, version, *rc::gen::arbitrary<std::uint8_t>(), 1, 1, info.id, info.crcExtra,
                                  info.minLength, payload);
    return {{frame.begin(), frame.end()}, &info};
}

/// What the scanner finds: valid frames and damaged regions, which must cover the bytes without a hole.
std::vector<ScanItem> itemsIn(ByteView bytes)
{
    std::vector<ScanItem> items;
    std::size_t covered = 0;
    FrameScanner scanner(bytes, Dialect::builtin());
    while (const auto item = scanner.next()) {
        RC_ASSERT(item->offset == covered && !item->bytes.empty());
        covered += item->bytes.size();
        items.push_back(*item);
    }
    RC_ASSERT(covered == bytes.size());
    return items;
}

std::vector<Bytes> framesIn(ByteView bytes)
{
    std::vector<Bytes> frames;
    for (const ScanItem &item : itemsIn(bytes)) {
        if (item.frame)
            frames.emplace_back(item.bytes.begin(), item.bytes.end());
    }
    return frames;
}

/// Whether noise is a frame by chance: with a valid checksum, as one of 65,536 headers has.
bool checksumIsValid(ByteView bytes)
{
    const auto frame = readFrame(bytes, Dialect::builtin());
    return frame || frame.error().fault == FrameFault::UnknownIncompatFlags;
}

Bytes anyNoise()
{
    return *rc::gen::container<Bytes>(rc::gen::weightedOneOf<std::uint8_t>(
        {{4, rc::gen::arbitrary<std::uint8_t>()}, {1, rc::gen::element<std::uint8_t>(0xfd, 0xfe, 0, 9)}}));
}

} // namespace

class FramePropertyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anyMessageRoundTripsFieldByField();
    void anyBytesAreCovered();
    void garbageBetweenFramesLosesNone();
    void everySplitGivesTheSameFrames();
    void shortAndLongPayloadsAreRead();
};

void FramePropertyTest::anyMessageRoundTripsFieldByField()
{
    QVERIFY(rc::check("decoded field by field and encoded again, the bytes are the same", [] {
        const Written written = anyFrame();
        const auto frame = readFrame(written.bytes, Dialect::builtin());
        RC_ASSERT(frame.has_value());
        RC_ASSERT(&frame->info() == written.info);
        PayloadBuilder builder(*written.info);
        for (const FieldInfo &field : written.info->fields) {
            for (std::size_t i = 0; i < field.elements(); ++i)
                RC_ASSERT(builder.set(field, i, fieldValue(frame->payload(), field, i)));
            RC_ASSERT(!builder.set(field, field.elements(), FieldValue::fromBits(field.type, 0)));
        }
        std::array<std::uint8_t, kMaxFrameLength> buffer;
        const auto again = writeFrame(buffer, frame->version(), frame->sequence(), 1, 1, frame->messageId(),
                                      written.info->crcExtra, written.info->minLength, builder.payload());
        RC_ASSERT(Bytes(again.begin(), again.end()) == written.bytes);
    }));
}

void FramePropertyTest::anyBytesAreCovered()
{
    QVERIFY(rc::check("any bytes are scanned to their end without a hole", [] { framesIn(anyNoise()); }));
}

void FramePropertyTest::garbageBetweenFramesLosesNone()
{
    QVERIFY(rc::check("no frame is lost to what stands before it", [] {
        Bytes stream;
        std::vector<std::pair<std::size_t, Bytes>> sent; // with the offset of each
        const auto count = *rc::gen::inRange(1, 8);
        for (int i = 0; i < count; ++i) {
            const Bytes noise = anyNoise();
            stream.insert(stream.end(), noise.begin(), noise.end());
            if (*rc::gen::inRange(0, 3) == 0) { // a frame damaged somewhere
                Bytes broken = anyFrame().bytes;
                broken[*rc::gen::inRange<std::size_t>(0, broken.size())] ^= *rc::gen::nonZero<std::uint8_t>();
                stream.insert(stream.end(), broken.begin(), broken.end());
            }
            sent.emplace_back(stream.size(), anyFrame().bytes);
            stream.insert(stream.end(), sent.back().second.begin(), sent.back().second.end());
        }
        const std::vector<ScanItem> items = itemsIn(stream);
        for (const auto &[offset, frame] : sent) {
            const auto item = std::ranges::find_if(
                items, [at = offset](const ScanItem &one) { return one.offset + one.bytes.size() > at; });
            if (item->offset == offset)
                RC_ASSERT(item->frame && Bytes(item->bytes.begin(), item->bytes.end()) == frame);
            else
                RC_ASSERT(checksumIsValid(item->bytes)); // noise that reaches into the frame
        }
    }));
}

void FramePropertyTest::everySplitGivesTheSameFrames()
{
    QVERIFY(rc::check("portions do not matter", [] {
        Bytes stream;
        const auto count = *rc::gen::inRange(1, 6);
        for (int i = 0; i < count; ++i) {
            const Bytes noise = *rc::gen::inRange(0, 2) ? anyNoise() : Bytes();
            stream.insert(stream.end(), noise.begin(), noise.end());
            const Bytes frame = anyFrame().bytes;
            stream.insert(stream.end(), frame.begin(), frame.end());
        }
        std::vector<Bytes> seen;
        std::size_t covered = 0;
        const auto note = [&](const ScanItem &item) {
            RC_ASSERT(item.offset == covered);
            covered += item.bytes.size();
            if (item.frame)
                seen.emplace_back(item.bytes.begin(), item.bytes.end());
        };
        StreamParser parser(Dialect::builtin());
        for (ByteView rest = stream; !rest.empty();) {
            const ByteView piece = rest.first(std::min(rest.size(), *rc::gen::inRange<std::size_t>(1, 60)));
            parser.feed(piece, note);
            rest = rest.subspan(piece.size());
        }
        parser.finish(note);
        RC_ASSERT(covered == stream.size());
        RC_ASSERT(seen == framesIn(stream));
    }));
}

void FramePropertyTest::shortAndLongPayloadsAreRead()
{
    QVERIFY(rc::check("a payload of any length is a valid frame; what it lacks reads as zero", [] {
        const auto messages = Dialect::builtin().messages();
        const MessageInfo &info = messages[*rc::gen::inRange<std::size_t>(0, messages.size())];
        const Bytes payload = *rc::gen::container<Bytes>(*rc::gen::inRange<std::size_t>(0, 256),
                                                         rc::gen::nonZero<std::uint8_t>());
        std::array<std::uint8_t, kMaxFrameLength> buffer;
        const auto bytes = writeFrame(buffer, 2, 0, 1, 1, info.id, info.crcExtra, info.minLength, payload);
        const auto frame = readFrame(bytes, Dialect::builtin());
        RC_ASSERT(frame && frame->payload().size() == payload.size());
        for (const FieldInfo &field : info.fields) {
            if (field.offset >= payload.size())
                RC_ASSERT(fieldValue(frame->payload(), field, 0).bits() == 0u);
        }
        if (info.targetSystemOffset >= 0 && static_cast<std::size_t>(info.targetSystemOffset) >= payload.size())
            RC_ASSERT(frame->targetSystem() == 0);
    }));
}

SKYSEAL_TEST_APPLESS(FramePropertyTest)
#include "frame_property_test.moc"
