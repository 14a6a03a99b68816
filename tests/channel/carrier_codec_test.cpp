// The codecs of the carriers: COBS against the examples of its paper and an independent encoder, messages in parts, and the
// effect of noise on the following messages.
#include "core/base/hex.h"
#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"
#include "tests/support/test_runner.h"

#include <rapidcheck.h>

#include <QtTest/QTest>

#include <random>

using namespace skyseal;
using namespace skyseal::channel;
using namespace std::chrono_literals;

namespace {

Bytes written(ByteView message)
{
    Bytes out(kMaxCobs);
    out.resize(writeCobs(message, out));
    return out;
}

/// The algorithm of the paper, block by block, without the final zero.
Bytes paperCobs(ByteView message)
{
    Bytes out;
    std::size_t at = 0;
    for (bool more = true; more;) {
        std::size_t end = at;
        while (end < message.size() && end - at < 254 && message[end] != 0)
            ++end;
        out.push_back(static_cast<std::uint8_t>(end - at + 1));
        const ByteView block = message.subspan(at, end - at);
        out.insert(out.end(), block.begin(), block.end());
        const bool full = end - at == 254;
        more = full ? end < message.size() : end < message.size() && message[end] == 0;
        at = full ? end : end + 1;
    }
    return out;
}

std::vector<Bytes> read(CobsReader &reader, ByteView line)
{
    std::vector<Bytes> out;
    reader.feed(line, [&](MutableByteView message) { out.emplace_back(message.begin(), message.end()); });
    return out;
}

/// Of a record's first byte, with zeros as often as in real ones or much more often.
rc::Gen<Bytes> messages(std::size_t least, std::size_t most)
{
    return rc::gen::exec([=] {
        const auto size = *rc::gen::inRange(least, most + 1);
        const auto zeros = *rc::gen::element(0, 1, 60, 256);
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        Bytes out(size);
        for (auto &byte : out)
            byte = static_cast<std::uint8_t>(static_cast<int>(random() % 256) < zeros ? 0 : random() % 255 + 1);
        out[0] = 0x54;
        return out;
    });
}

std::vector<Bytes> partsOf(ByteView message, std::uint16_t set)
{
    std::vector<Bytes> out;
    writeParts(message, set, [&](ByteView payload) { out.emplace_back(payload.begin(), payload.end()); });
    return out;
}

bool same(const std::optional<MutableByteView> &got, const Bytes &wanted)
{
    return got && Bytes(got->begin(), got->end()) == wanted;
}

} // namespace

class CarrierCodecTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cobsExamples();
    void cobsMatchesThePaper();
    void cobsSurvivesAnyCut();
    void cobsResynchronises();
    void cobsIsBounded();
    void cobsDropsDamagedFrames();
    void handshakesBeginWithAZero();
    void shortMessagesAreOnePayload();
    void longMessagesInAnyOrder();
    void lostPartsCostOneMessage();
    void wrongPartsAreIgnored();
    void shortMessagesInPartsAreIgnored();
    void messageNumbersWrap();
    void sendersAreEvicted();
};

void CarrierCodecTest::cobsExamples()
{
    // From Cheshire and Baker 1999, section III, and the borders of a block.
    QCOMPARE(toHex(written(fromHex("54").value())), std::string("025400"));
    QCOMPARE(toHex(written(fromHex("4500002c4c79000040064f37").value())),
             std::string("02450104") + "2c4c79" + "0105" + "40064f37" + "00");
    QCOMPARE(toHex(written(fromHex("0000").value())), std::string("01010100"));
    const Bytes full(254, 0x54);
    QCOMPARE(written(full).size(), full.size() + 2);
    QCOMPARE(written(Bytes(255, 0x54)).size(), std::size_t(255 + 3));
    QVERIFY(written({}).empty());
    QVERIFY(written(Bytes(kMaxDatagram + 1, 0x54)).empty());
    Bytes narrow(3);
    QCOMPARE(writeCobs(fromHex("5400").value(), narrow), std::size_t(0));
}

void CarrierCodecTest::cobsMatchesThePaper()
{
    QVERIFY(rc::check([] {
        const Bytes message = *messages(1, kMaxDatagram);
        Bytes wanted = paperCobs(message);
        wanted.push_back(0);
        RC_ASSERT(written(message) == wanted);
        RC_ASSERT(wanted.size() <= kMaxCobs);
        CobsReader reader;
        RC_ASSERT(read(reader, wanted) == std::vector<Bytes>{message});
        RC_ASSERT(reader.damaged() == 0u);
    }));
}

void CarrierCodecTest::cobsSurvivesAnyCut()
{
    QVERIFY(rc::check([] {
        Bytes line;
        std::vector<Bytes> wanted;
        for (int i = 0; i < 5; ++i) {
            wanted.push_back(*messages(1, 400));
            const Bytes frame = written(wanted.back());
            line.insert(line.end(), frame.begin(), frame.end());
        }
        CobsReader reader;
        std::vector<Bytes> got;
        for (ByteView rest = line; !rest.empty();) {
            const auto piece = rest.first(*rc::gen::inRange<std::size_t>(1, rest.size() + 1));
            for (Bytes &message : read(reader, piece))
                got.push_back(std::move(message));
            rest = rest.subspan(piece.size());
        }
        RC_ASSERT(got == wanted);
    }));
}

void CarrierCodecTest::cobsResynchronises()
{
    QVERIFY(rc::check([] {
        CobsReader reader;
        Bytes line = *rc::gen::arbitrary<Bytes>();
        const Bytes first = *messages(1, 300), second = *messages(1, 300);
        for (const Bytes &message : {first, second}) {
            const Bytes frame = written(message);
            line.insert(line.end(), frame.begin(), frame.end());
        }
        // Noise may destroy the message that follows it, and no other.
        const auto got = read(reader, line);
        RC_ASSERT(!got.empty() && got.back() == second);
    }));
}

void CarrierCodecTest::cobsIsBounded()
{
    CobsReader reader;
    QVERIFY(read(reader, Bytes(100000, 0xff)).empty());
    QVERIFY(read(reader, Bytes(100000, 0x01)).empty());
    const Bytes message(kMaxDatagram, 0x54);
    Bytes line = {0};
    const Bytes frame = written(message);
    line.insert(line.end(), frame.begin(), frame.end());
    QCOMPARE(read(reader, line), (std::vector<Bytes>{message}));
    QCOMPARE(reader.damaged(), std::uint64_t(1));
    // One byte more than a message may have.
    Bytes tooLong = paperCobs(Bytes(kMaxDatagram + 1, 0x54));
    tooLong.push_back(0);
    QVERIFY(read(reader, tooLong).empty());
    Bytes endsInZeros = paperCobs(Bytes(kMaxDatagram + 1, 0));
    endsInZeros.push_back(0);
    QVERIFY(read(reader, endsInZeros).empty());
    QCOMPARE(read(reader, frame), (std::vector<Bytes>{message}));
}

void CarrierCodecTest::cobsDropsDamagedFrames()
{
    QVERIFY(rc::check([] {
        const Bytes message = *messages(2, 300);
        Bytes frame = written(message);
        const auto at = *rc::gen::inRange<std::size_t>(0, frame.size());
        frame[at] ^= static_cast<std::uint8_t>(*rc::gen::inRange(1, 256));
        CobsReader reader;
        for (const Bytes &got : read(reader, frame))
            RC_ASSERT(got != message);
    }));
}

void CarrierCodecTest::handshakesBeginWithAZero()
{
    CobsReader reader;
    QVERIFY(read(reader, Bytes(50, 0x31)).empty()); // a boot message that no zero ended
    const Bytes announcement(127, 0x58);
    QCOMPARE(read(reader, written(announcement)), (std::vector<Bytes>{announcement}));
}

void CarrierCodecTest::shortMessagesAreOnePayload()
{
    for (std::size_t size = 1; size <= kTunnelPayload; ++size) {
        const Bytes message(size, 0x50);
        QCOMPARE(partsOf(message, 7), (std::vector<Bytes>{message}));
        TunnelReader reader;
        QVERIFY(same(reader.take(TimePoint{1s}, {}, message), message));
    }
    QVERIFY(!writeParts({}, 1, [](ByteView) {}));
    QVERIFY(!writeParts(Bytes(kMaxTunnelled + 1, 0x50), 1, [](ByteView) {}));
}

void CarrierCodecTest::longMessagesInAnyOrder()
{
    QVERIFY(rc::check([] {
        const Bytes message = *messages(kTunnelPayload + 1, kMaxTunnelled);
        auto parts = partsOf(message, *rc::gen::arbitrary<std::uint16_t>());
        RC_ASSERT(parts.size() == (message.size() + kPartData - 1) / kPartData && parts.size() <= kMaxParts);
        for (const Bytes &part : parts)
            RC_ASSERT(part.size() <= kTunnelPayload && !isOurs(part[0]) && part[0] < 0xfd);
        const Bytes again = parts[*rc::gen::inRange<std::size_t>(0, parts.size())];
        parts.push_back(again);
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        std::shuffle(parts.begin(), parts.end(), random);
        TunnelReader reader;
        int whole = 0;
        for (const Bytes &part : parts) {
            if (const auto got = reader.take(TimePoint{1s}, {}, part)) {
                ++whole;
                RC_ASSERT(same(got, message));
            }
        }
        RC_ASSERT(whole == 1);
    }));
}

void CarrierCodecTest::lostPartsCostOneMessage()
{
    const Bytes first(300, 0x50), second(300, 0x51);
    for (std::size_t lost = 0; lost < 3; ++lost) {
        TunnelReader reader;
        std::size_t index = 0;
        for (const Bytes &part : partsOf(first, 1)) {
            if (index++ != lost)
                QVERIFY(!reader.take(TimePoint{1s}, {}, part));
        }
        const auto parts = partsOf(second, 2);
        QVERIFY(!reader.take(TimePoint{1s}, {}, parts[0]));
        QVERIFY(!reader.take(TimePoint{1s}, {}, parts[1]));
        QVERIFY(same(reader.take(TimePoint{1s}, {}, parts[2]), second));
    }
}

void CarrierCodecTest::wrongPartsAreIgnored()
{
    const Bytes message(300, 0x50);
    const auto parts = partsOf(message, 1);
    const auto changed = [](Bytes part, std::uint8_t head, std::size_t size) {
        part[0] = head;
        part.resize(size);
        return part;
    };
    TunnelReader reader;
    const TimePoint now{1s};
    QVERIFY(!reader.take(now, {}, {}));
    QVERIFY(!reader.take(now, {}, Bytes(kTunnelPayload + 1, 0x50)));
    for (const Bytes &wrong : {
             changed(parts[0], 0x80, 100), // not full, not the last
             changed(parts[0], 0x82, 128), // a third that is not the last
             changed(parts[0], 0x83, 128), // a fourth
             changed(parts[0], 0x84, 128), // the only one
             changed(parts[0], 0x88, 128), changed(parts[0], 0xc0, 128), changed(parts[0], 0x00, 128),
             changed(parts[2], 0x86, kPartHead), // nothing in it
         })
        QVERIFY(!reader.take(now, {}, wrong));
    QVERIFY(!reader.take(now, {}, parts[2]));
    QVERIFY(!reader.take(now, {}, changed(parts[1], 0x85, 50))); // claims that the second is the last
    QVERIFY(!reader.take(now, {}, parts[0]));
    QVERIFY(same(reader.take(now, {}, parts[1]), message));
    QVERIFY(!reader.take(now, {}, parts[1]));
}

/// In parts, the zeros of an announcement would not count on the wire.
void CarrierCodecTest::shortMessagesInPartsAreIgnored()
{
    for (const std::size_t size : {kPartData + 1, kPaddedLength, kTunnelPayload, kTunnelPayload + 1}) {
        Bytes first{0x80, 7, 0}, second{0x85, 7, 0};
        first.resize(kPartHead + kPartData, 0x58);
        second.resize(kPartHead + size - kPartData, 0);
        TunnelReader reader;
        QVERIFY(!reader.take(TimePoint{1s}, {}, first));
        const auto got = reader.take(TimePoint{1s}, {}, second);
        QCOMPARE(got.has_value(), size > kTunnelPayload);
    }
}

void CarrierCodecTest::messageNumbersWrap()
{
    TunnelReader reader;
    const Bytes first(200, 0x50), second(200, 0x51);
    const auto old = partsOf(first, 9), fresh = partsOf(second, 9);
    QVERIFY(!reader.take(TimePoint{1s}, {}, old[0]));
    // 65,536 messages later: remaining parts of the old message are not joined with the new one.
    const TimePoint later = TimePoint{1s} + UnfinishedMessage::kKept;
    QVERIFY(!reader.take(later, {}, fresh[1]));
    QVERIFY(same(reader.take(later, {}, fresh[0]), second));
}

void CarrierCodecTest::sendersAreEvicted()
{
    TunnelReader reader;
    const Bytes message(200, 0x50);
    const auto parts = partsOf(message, 1);
    const auto path = [](std::size_t i) {
        return Path{LinkId{1}, {}, Carrier::Tunnel, {static_cast<std::uint8_t>(i + 1), 191}};
    };
    TimePoint now{1s};
    for (std::size_t i = 0; i <= TunnelReader::kSenders; ++i)
        QVERIFY(!reader.take(now += 1ms, path(i), parts[0]));
    QVERIFY(!reader.take(now, path(0), parts[1])); // was evicted and starts again
    for (std::size_t i = 2; i <= TunnelReader::kSenders; ++i)
        QVERIFY(same(reader.take(now, path(i), parts[1]), message));
    QVERIFY(same(reader.take(now, path(0), parts[0]), message));
}

SKYSEAL_TEST(CarrierCodecTest)
#include "carrier_codec_test.moc"
