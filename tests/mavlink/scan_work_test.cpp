// The work of the frame scanner is bounded for any content, counted in bytes that go through the CRC, and it finds exactly the
// frames that a scanner without that bound finds. What strangers send besides frames costs at most twice as much as random
// bytes.
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

struct Item
{
    std::size_t offset = 0, size = 0;
    bool isFrame = false;
    FrameFault fault{};

    bool operator==(const Item &) const = default;
};

/// The rules of FrameScanner over a whole buffer, with a CRC of its own for each frame that seems to begin.
class PlainScanner
{
public:
    explicit PlainScanner(ByteView buffer) : m_buffer(buffer) {}

    std::vector<Item> items()
    {
        std::vector<Item> out;
        for (std::size_t at = 0; at < m_buffer.size(); at += out.back().size) {
            const auto frame = read(at);
            out.push_back(frame ? Item{at, frame->bytes().size(), true, {}} : damaged(at, frame.error()));
        }
        return out;
    }
    std::uint64_t crcBytes() const { return m_crcBytes; }

private:
    Result<Frame, FrameError> read(std::size_t at)
    {
        const auto frame = readFrame(m_buffer.subspan(at), Dialect::builtin());
        const bool checked = frame || frame.error().fault == FrameFault::BadCrc
            || frame.error().fault == FrameFault::UnknownIncompatFlags;
        if (checked)
            m_crcBytes += (m_buffer[at] == kMagic2 ? 9u : 5u) + m_buffer[at + 1];
        return frame;
    }

    Item damaged(std::size_t at, const FrameError &error)
    {
        std::size_t end = at + error.length;
        FrameFault fault = error.fault;
        switch (fault) {
        case FrameFault::UnknownIncompatFlags: break;
        case FrameFault::UnknownMessage:
            if (end != m_buffer.size() && !isMagic(m_buffer[end])) {
                fault = FrameFault::Garbage;
                end = nextMagic(at + 1);
            } else if (const std::size_t inner = nextFrame(at + 1, end); inner != end) {
                fault = FrameFault::Garbage;
                end = inner;
            }
            break;
        case FrameFault::BadCrc: end = nextFrame(at + 1, end); break;
        case FrameFault::Truncated: end = nextFrame(at + 1, m_buffer.size()); break;
        default: end = nextMagic(at + 1);
        }
        return {at, end - at, false, fault};
    }

    std::size_t nextFrame(std::size_t from, std::size_t limit)
    {
        while (from < limit && !(isMagic(m_buffer[from]) && read(from)))
            ++from;
        return from;
    }

    std::size_t nextMagic(std::size_t from) const
    {
        while (from < m_buffer.size() && !isMagic(m_buffer[from]))
            ++from;
        return from;
    }

    ByteView m_buffer;
    std::uint64_t m_crcBytes = 0;
};

struct Scanned
{
    std::vector<Item> items;
    std::uint64_t crcBytes = 0;
    std::size_t passedOver = 0;

    std::size_t frames() const
    {
        return static_cast<std::size_t>(std::ranges::count_if(items, [](const Item &item) { return item.isFrame; }));
    }
};

Item itemOf(const ScanItem &item)
{
    return {item.offset, item.bytes.size(), item.frame.has_value(), item.frame ? FrameFault{} : item.fault};
}

Bytes randomBytes(std::size_t size, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Bytes out(size);
    for (std::uint8_t &byte : out)
        byte = static_cast<std::uint8_t>(random());
    return out;
}

Scanned scanned(ByteView bytes, WastedWork limit = WastedWork::Unlimited)
{
    Scanned out;
    FrameScanner scanner(bytes, Dialect::builtin(), BufferEnd::Final, limit);
    while (const auto item = scanner.next())
        out.items.push_back(itemOf(*item));
    out.crcBytes = scanner.crcBytes();
    out.passedOver = scanner.passedOver();
    return out;
}

Scanned scannedStream(ByteView bytes, std::size_t piece, WastedWork limit = WastedWork::OfStream)
{
    Scanned out;
    StreamParser parser(Dialect::builtin(), limit);
    for (ByteView rest = bytes; !rest.empty(); rest = rest.subspan(std::min(piece, rest.size())))
        parser.feed(rest.first(std::min(piece, rest.size())), [&](const ScanItem &item) { out.items.push_back(itemOf(item)); });
    out.crcBytes = parser.crcBytes();
    out.passedOver = parser.passedOver();
    return out;
}

std::uint64_t workOfStream(ByteView bytes, std::size_t piece)
{
    return scannedStream(bytes, piece, WastedWork::Unlimited).crcBytes;
}

/// What random bytes cost in the mean: the measure of what other bytes may cost.
double workOfRandomDatagrams(std::size_t size)
{
    constexpr std::uint32_t kSeeds = 200;
    std::uint64_t out = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
        out += scanned(randomBytes(size, seed)).crcBytes;
    return static_cast<double>(out) / kSeeds;
}

/// The bound of a datagram, and of a whole stream: each byte at most once, plus one range (OverlappingCrc).
std::uint64_t boundFor(std::size_t bytes)
{
    static_assert(OverlappingCrc::kLongestRange == 264);
    return bytes + OverlappingCrc::kLongestRange;
}

/// The limit of a datagram for what is no frame.
std::uint64_t limitFor(std::size_t bytes)
{
    return 2 * OverlappingCrc::kLongestRange + bytes / 4 + (bytes > 1472 ? (bytes - 1472) / 8 : 0);
}

Bytes repeated(const Bytes &period, std::size_t size)
{
    Bytes out(size);
    for (std::size_t i = 0; i < size; ++i)
        out[i] = period[i % period.size()];
    return out;
}

/// Heads of frames of a known message that claim `length` bytes of payload, one after the other.
Bytes heads(std::uint8_t magic, std::uint8_t length, std::size_t size)
{
    return repeated(magic == kMagic1 ? Bytes{magic, length, 0, 1, 1, 30} : Bytes{magic, length, 0, 0, 0, 1, 1, 30, 0, 0}, size);
}

Bytes validFrames(std::size_t size)
{
    FrameWriter writer(1, 1);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    Bytes out;
    while (out.size() < size) {
        const ByteView frame = writer.write(Attitude{.roll = 1, .pitch = 2, .yawspeed = 3}, buffer);
        out.insert(out.end(), frame.begin(), frame.end());
    }
    out.resize(size);
    return out;
}

Bytes nestedHeads(std::size_t size)
{
    Bytes out = validFrames(size);
    for (std::size_t i = 0; i < out.size(); i += 3)
        out[i] = kMagic1;
    return out;
}

/// Bytes among which many frames seem to begin, and some do.
Bytes anyHostileBytes()
{
    Bytes out;
    const int parts = *rc::gen::inRange(1, 8);
    for (int i = 0; i < parts; ++i) {
        const auto magic = *rc::gen::element(kMagic1, kMagic2);
        const auto size = *rc::gen::inRange<std::size_t>(0, 400);
        Bytes part;
        switch (*rc::gen::inRange(0, 4)) {
        case 0: part = Bytes(size, magic); break;
        case 1: part = heads(magic, *rc::gen::arbitrary<std::uint8_t>(), size); break;
        case 2:
            part = *rc::gen::container<Bytes>(
                size,
                rc::gen::weightedOneOf<std::uint8_t>({{4, rc::gen::arbitrary<std::uint8_t>()},
                                                      {2, rc::gen::element(kMagic1, kMagic2)},
                                                      {2, rc::gen::element<std::uint8_t>(0, 1, 30)}}));
            break;
        default: part = validFrames(size);
        }
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
}

} // namespace

class ScanWorkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachByteOnceThroughTheCrcPlus264_data();
    void eachByteOnceThroughTheCrcPlus264();
    void boundIsThatOfValidFrames();
    void junkCostsAtMostTwiceRandomBytes_data();
    void junkCostsAtMostTwiceRandomBytes();
    void framesAmongNoiseAreFound();
    void frameAfterADamagedOneIsFound();
    void everyPeriodOfTwoBytes();
    void anyBytesAreBounded();
    void findsTheSameAsAPlainScanner();
};

void ScanWorkTest::eachByteOnceThroughTheCrcPlus264_data()
{
    QTest::addColumn<QByteArray>("bytes");
    constexpr std::size_t kSize = 2048;
    const auto row = [](const char *name, const Bytes &bytes) {
        QTest::newRow(name) << QByteArray(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    row("all 0xFE", Bytes(kSize, kMagic1));
    row("all 0xFD", Bytes(kSize, kMagic2));
    row("heads of version 1, longest", heads(kMagic1, 255, kSize));
    row("heads of version 2, longest", heads(kMagic2, 255, kSize));
    row("heads of version 1, empty", heads(kMagic1, 0, kSize));
    row("half frames", repeated(validFrames(20), kSize));
    row("heads nested in frames", nestedHeads(kSize));
    row("an unknown message around each frame",
        repeated(
            [] {
                Bytes out{kMagic2, 255, 0, 0, 0, 1, 1, 0xff, 0xff, 0xff};
                const Bytes frame = validFrames(12);
                out.insert(out.end(), frame.begin(), frame.end());
                return out;
            }(),
            kSize));
    row("random", randomBytes(kSize, 1));
    row("valid frames", validFrames(kSize));
}

void ScanWorkTest::eachByteOnceThroughTheCrcPlus264()
{
    QFETCH(QByteArray, bytes);
    const ByteView view(reinterpret_cast<const std::uint8_t *>(bytes.constData()), static_cast<std::size_t>(bytes.size()));
    const std::uint64_t asDatagram = scanned(view).crcBytes;
    QVERIFY2(asDatagram <= boundFor(view.size()), std::to_string(asDatagram).c_str());
    for (const std::size_t piece : {1, 2, 17, 280, 1460}) {
        const std::uint64_t asStream = workOfStream(view, piece);
        QVERIFY2(asStream <= boundFor(view.size()), std::to_string(asStream).c_str());
    }
}

/// The bound over that of random bytes cannot be lower: each byte of a valid frame goes through the CRC once, while few of the
/// random ones seem to begin a frame.
void ScanWorkTest::boundIsThatOfValidFrames()
{
    constexpr std::size_t kSize = 2048;
    constexpr std::uint32_t kSeeds = 200;
    std::uint64_t random = 0, randomStream = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        random += scanned(randomBytes(kSize, seed)).crcBytes;
        randomStream += workOfStream(randomBytes(kSize, seed), 280);
    }
    const Bytes valid = validFrames(kSize);
    const std::uint64_t ofValid = scanned(valid).crcBytes, ofValidStream = workOfStream(valid, 280);
    qInfo("%zu bytes through the CRC: datagrams %llu random, %llu valid; streams %llu random, %llu valid", kSize,
          static_cast<unsigned long long>(random / kSeeds), static_cast<unsigned long long>(ofValid),
          static_cast<unsigned long long>(randomStream / kSeeds), static_cast<unsigned long long>(ofValidStream));
    // All bytes but the start bytes and checksums.
    QVERIFY(ofValid > kSize * 9 / 10 && ofValid <= kSize);
    QVERIFY(ofValidStream > kSize * 9 / 10 && ofValidStream <= kSize);
    QVERIFY(random / kSeeds < kSize / 2 && randomStream / kSeeds < kSize / 2);
    // The bound is not met by chance: a scanner that computes each checksum anew exceeds it a hundred times.
    const Bytes worst(kSize, kMagic1);
    PlainScanner anew(worst);
    anew.items();
    QVERIFY(anew.crcBytes() > 100 * boundFor(kSize));
}

void ScanWorkTest::junkCostsAtMostTwiceRandomBytes_data()
{
    QTest::addColumn<QByteArray>("period");
    const auto row = [](const char *name, const Bytes &bytes) {
        QTest::newRow(name) << QByteArray(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    row("all 0xFE", Bytes(1, kMagic1));
    row("all 0xFD", Bytes(1, kMagic2));
    row("heads of version 1, longest", heads(kMagic1, 255, 6));
    row("heads of version 2, longest", heads(kMagic2, 255, 10));
    row("half frames", validFrames(20));
    row("heads nested in frames", nestedHeads(40));
    Bytes damaged = validFrames(40);
    damaged[20] ^= 1;
    row("damaged frames", damaged);
    Bytes longest(269, 0x55);
    std::ranges::copy(Bytes{kMagic2, 255, 0, 0, 0, 1, 1, 110, 0, 0}, longest.begin());
    row("damaged frames of the greatest length", longest);
}

/// Of datagrams from the longest of Ethernet on, and of a long stream: the reserve for the first frames counts less, the longer
/// it is. Of shorter datagrams, each byte goes through the CRC once, plus one range, or a quarter and the reserve.
void ScanWorkTest::junkCostsAtMostTwiceRandomBytes()
{
    QFETCH(QByteArray, period);
    const Bytes bytes(period.begin(), period.end());
    for (const std::size_t size : {1472, 2048, 9000, 65507}) {
        static std::map<std::size_t, double> random;
        if (!random.contains(size))
            random[size] = workOfRandomDatagrams(size);
        const std::uint64_t work = scanned(repeated(bytes, size), WastedWork::OfDatagram).crcBytes;
        qInfo("of %zu bytes %llu, random %.1f", size, static_cast<unsigned long long>(work), random[size]);
        HOLDS(static_cast<double>(work) <= 2 * random[size], "junk costs at most twice as much as random bytes");
    }
    for (std::size_t size = 1; size < 1472; ++size) {
        const std::uint64_t work = scanned(repeated(bytes, size), WastedWork::OfDatagram).crcBytes;
        QVERIFY2(work <= boundFor(size) && work <= limitFor(size), std::to_string(size).c_str());
    }
    constexpr std::size_t kStream = 1 << 18;
    static const auto randomStream = static_cast<double>(workOfStream(randomBytes(kStream, 1), 280));
    const std::uint64_t asStream = scannedStream(repeated(bytes, kStream), 280).crcBytes;
    qInfo("of %zu in a stream %llu, random %.1f", kStream, static_cast<unsigned long long>(asStream), randomStream);
    HOLDS(static_cast<double>(asStream) <= 2 * randomStream, "junk costs at most twice as much as random bytes");
}

/// A line on which one byte in a hundred is wrong damages a third of the frames: all others are found.
void ScanWorkTest::framesAmongNoiseAreFound()
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        Bytes line = validFrames(100'000);
        for (std::uint8_t &byte : line)
            byte = random() % 100 == 0 ? static_cast<std::uint8_t>(random()) : byte;
        for (std::size_t at = 0; at < line.size(); at += 5000) // and bursts of noise alone
            std::ranges::copy(randomBytes(300, seed + static_cast<std::uint32_t>(at)),
                              line.begin() + static_cast<std::ptrdiff_t>(at));
        const Scanned found = scannedStream(line, 280);
        QCOMPARE(found.passedOver, std::size_t(0));
        QVERIFY(found.frames() > 1200 && found.frames() < 2000);
        QCOMPARE(found.frames(), scannedStream(line, 280, WastedWork::Unlimited).frames());
    }
}

/// Whatever the lengths of the damaged frame and of the next one are, in a datagram and at the beginning of a stream.
void ScanWorkTest::frameAfterADamagedOneIsFound()
{
    FrameWriter writer(1, 1);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    for (std::size_t next = 1; next <= 251; next += 10) {
        FileTransferProtocol message;
        std::fill_n(message.payload.begin(), next, 7);
        const ByteView frame = writer.write(message, buffer);
        for (std::size_t damaged = 10; damaged <= 267; ++damaged) {
            Bytes bytes(damaged, 0x33);
            std::ranges::copy(Bytes{kMagic2, 255, 0, 0, 0, 1, 1, 110, 0, 0}, bytes.begin());
            bytes.insert(bytes.end(), frame.begin(), frame.end());
            QCOMPARE(scanned(bytes, WastedWork::OfDatagram).frames(), std::size_t(1));
            bytes.resize(bytes.size() + kMaxFrameLength, 0x33); // until the claimed length has arrived
            QCOMPARE(scannedStream(bytes, 17).frames(), std::size_t(1));
        }
    }
}

void ScanWorkTest::everyPeriodOfTwoBytes()
{
    Bytes bytes(560);
    for (unsigned period = 0; period < 65536; ++period) {
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i % 2 ? period >> 8 : period);
        const std::uint64_t work = scanned(bytes).crcBytes;
        QVERIFY2(work <= boundFor(bytes.size()), std::to_string(period).c_str());
        const Scanned limited = scanned(bytes, WastedWork::OfDatagram);
        QVERIFY2(limited.frames() > 0 || limited.crcBytes <= limitFor(bytes.size()), std::to_string(period).c_str());
    }
}

void ScanWorkTest::anyBytesAreBounded()
{
    QVERIFY(rc::check("each byte goes through the CRC once", [] {
        const Bytes bytes = anyHostileBytes();
        RC_ASSERT(scanned(bytes).crcBytes <= boundFor(bytes.size()));
        RC_ASSERT(workOfStream(bytes, *rc::gen::inRange<std::size_t>(1, 300)) <= boundFor(bytes.size()));
    }));
}

void ScanWorkTest::findsTheSameAsAPlainScanner()
{
    QVERIFY(rc::check("the same frames and the same damage", [] {
        const Bytes bytes = anyHostileBytes();
        const auto all = PlainScanner(bytes).items();
        RC_ASSERT(scanned(bytes).items == all);
        const Scanned limited = scanned(bytes, WastedWork::OfDatagram);
        RC_ASSERT(limited.passedOver > 0 || limited.items == all);
        std::uint64_t inFrames = 0;
        for (const Item &item : limited.items)
            inFrames += item.isFrame ? item.size : 0;
        RC_ASSERT(limited.crcBytes <= inFrames + limitFor(bytes.size()));
    }));
}

SKYSEAL_TEST_APPLESS(ScanWorkTest)
#include "scan_work_test.moc"
