// The work of the frame scanner is bounded for any content, counted in bytes that go through the CRC, and it finds exactly the
// frames that a scanner without that bound finds.
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

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
};

Item itemOf(const ScanItem &item)
{
    return {item.offset, item.bytes.size(), item.frame.has_value(), item.frame ? FrameFault{} : item.fault};
}

Scanned scanned(ByteView bytes)
{
    Scanned out;
    FrameScanner scanner(bytes, Dialect::builtin());
    while (const auto item = scanner.next())
        out.items.push_back(itemOf(*item));
    out.crcBytes = scanner.crcBytes();
    return out;
}

std::uint64_t workOfStream(ByteView bytes, std::size_t piece)
{
    StreamParser parser(Dialect::builtin());
    for (ByteView rest = bytes; !rest.empty(); rest = rest.subspan(std::min(piece, rest.size())))
        parser.feed(rest.first(std::min(piece, rest.size())), [](const ScanItem &) {});
    return parser.crcBytes();
}

/// The bound of a datagram, and of a whole stream: each byte at most once, plus one range (OverlappingCrc).
std::uint64_t boundFor(std::size_t bytes)
{
    static_assert(OverlappingCrc::kLongestRange == 264);
    return bytes + OverlappingCrc::kLongestRange;
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

Bytes randomBytes(std::size_t size, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Bytes out(size);
    for (std::uint8_t &byte : out)
        byte = static_cast<std::uint8_t>(random());
    return out;
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
    Bytes nested = validFrames(kSize);
    for (std::size_t i = 0; i < nested.size(); i += 3)
        nested[i] = kMagic1;
    row("heads nested in frames", nested);
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

void ScanWorkTest::everyPeriodOfTwoBytes()
{
    Bytes bytes(560);
    for (unsigned period = 0; period < 65536; ++period) {
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i % 2 ? period >> 8 : period);
        const std::uint64_t work = scanned(bytes).crcBytes;
        QVERIFY2(work <= boundFor(bytes.size()), std::to_string(period).c_str());
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
        RC_ASSERT(scanned(bytes).items == PlainScanner(bytes).items());
    }));
}

SKYSEAL_TEST_APPLESS(ScanWorkTest)
#include "scan_work_test.moc"
