// Frames that begin in one datagram and end in a later one: what is delivered, how often, and at which cost for strangers.
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <random>
#include <set>

using namespace skyseal;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

namespace {

Path pathOf(std::uint16_t port)
{
    return {LinkId{1}, {{10}, port}};
}

/// Frames of one component, of many lengths, and with bytes in them that could begin a frame.
class FrameSource
{
public:
    explicit FrameSource(std::uint8_t system = 1) : m_writer(system, 1) {}

    Bytes frames(int count)
    {
        Bytes out;
        for (int i = 0; i < count; ++i, ++m_number) {
            Statustext text{.severity = 6};
            for (std::size_t k = 0; k < m_number % text.text.size(); ++k)
                text.text[k] = static_cast<char>(k % 7 ? 'a' : k % 2 ? kMagic1 : kMagic2);
            std::array<std::uint8_t, kMaxFrameLength> buffer;
            const ByteView frame = m_number % 3
                ? m_writer.write(text, buffer)
                : m_writer.write(FileTransferProtocol{.target_system = 9, .payload = {kMagic2, 200, 1}}, buffer);
            out.insert(out.end(), frame.begin(), frame.end());
        }
        return out;
    }

private:
    FrameWriter m_writer;
    unsigned m_number = 0;
};

struct Receiver
{
    void take(const Path &from, ByteView bytes)
    {
        intake.takeDatagram(now, from, bytes, [this](const ScanItem &item) {
            frames += item.frame.has_value();
            damaged += isDamagedFrame(item);
        });
        now += 1ms;
    }

    FrameIntake intake{Dialect::builtin()};
    TimePoint now{100s};
    int frames = 0, damaged = 0;
};

} // namespace

class CutFramesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void streamOfEachSize();
    void cutAnywhere();
    void sendersAreStreamsOfTheirOwn();
    void lostDatagramCostsItsFrames();
    void wholeFrameAfterACutOneIsNotDelayed();
    void strangersTakeNoPlaceInUse();
    void bytesThatAreNoFramesAreKeptSeldom();
};

void CutFramesTest::streamOfEachSize()
{
    for (std::size_t size = 1; size <= 300; size += size < 20 ? 1 : 7) {
        Receiver receiver;
        const Bytes stream = FrameSource().frames(200);
        for (std::size_t at = 0; at < stream.size(); at += size)
            receiver.take(pathOf(1), ByteView(stream).subspan(at, std::min(size, stream.size() - at)));
        QVERIFY2(
            receiver.frames == 200 && receiver.damaged == 0,
            qPrintable(QStringLiteral("%1 bytes: %2 frames, %3 damaged").arg(size).arg(receiver.frames).arg(receiver.damaged)));
    }
}

void CutFramesTest::cutAnywhere()
{
    const bool holds = rc::check("every frame of a stream arrives once, wherever it is cut", [] {
        const auto pieces = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 600));
        Receiver receiver;
        const Bytes stream = FrameSource().frames(60);
        std::size_t at = 0;
        for (const std::size_t piece : pieces) {
            const std::size_t size = std::min(piece, stream.size() - at);
            if (size > 0)
                receiver.take(pathOf(1), ByteView(stream).subspan(at, size));
            at += size;
        }
        if (at < stream.size())
            receiver.take(pathOf(1), ByteView(stream).subspan(at));
        RC_ASSERT(receiver.frames == 60);
        RC_ASSERT(receiver.damaged == 0);
    });
    QVERIFY(holds);
}

void CutFramesTest::sendersAreStreamsOfTheirOwn()
{
    Receiver receiver;
    const Bytes first = FrameSource(1).frames(100), second = FrameSource(2).frames(100);
    for (std::size_t at = 0; at < std::max(first.size(), second.size()); at += 33) {
        for (const auto &[port, stream] : {std::pair(1, &first), std::pair(2, &second)}) {
            if (at < stream->size())
                receiver.take(pathOf(std::uint16_t(port)),
                              ByteView(*stream).subspan(at, std::min<std::size_t>(33, stream->size() - at)));
        }
    }
    QCOMPARE(receiver.frames, 200);
    QCOMPARE(receiver.damaged, 0);
}

void CutFramesTest::lostDatagramCostsItsFrames()
{
    Receiver receiver;
    const Bytes stream = FrameSource().frames(1000);
    constexpr std::size_t kSize = 64;
    int lost = 0, datagrams = 0;
    for (std::size_t at = 0; at < stream.size(); at += kSize) {
        if (++datagrams % 50 == 0)
            ++lost;
        else
            receiver.take(pathOf(1), ByteView(stream).subspan(at, std::min(kSize, stream.size() - at)));
    }
    QVERIFY(lost > 5);
    // In a lost datagram are the ends of at most four frames of these lengths, and the beginning of one. One more may be lost
    // by the search for the next beginning.
    QVERIFY2(receiver.frames >= 1000 - 6 * lost, qPrintable(QString::number(receiver.frames)));
}

/// A damaged length at the end of a datagram must not keep the frames of the next ones back.
void CutFramesTest::wholeFrameAfterACutOneIsNotDelayed()
{
    Receiver receiver;
    const Bytes cut{kMagic2, 255, 0, 0, 1, 1, 1, 0, 0, 0, 5, 5, 5};
    for (int i = 1; i <= 50; ++i) {
        receiver.take(pathOf(1), cut);
        receiver.take(pathOf(1), FrameSource().frames(1));
        QCOMPARE(receiver.frames, i);
    }
    QCOMPARE(receiver.damaged, 50); // each is reported, at once or with the next datagram
}

void CutFramesTest::strangersTakeNoPlaceInUse()
{
    Receiver receiver;
    std::mt19937 random(3);
    const Bytes stream = FrameSource().frames(300);
    Bytes cut(100, kMagic2);
    for (std::size_t at = 0; at < stream.size(); at += 64) {
        receiver.take(pathOf(1), ByteView(stream).subspan(at, std::min<std::size_t>(64, stream.size() - at)));
        for (int i = 0; at > 640 && i < 500; ++i) { // once its first frames were completed
            Path stranger = pathOf(static_cast<std::uint16_t>(random()));
            stranger.remote.ip[15] = static_cast<std::uint8_t>(random() | 1);
            receiver.take(stranger, cut);
        }
    }
    QCOMPARE(receiver.frames, 300);
}

/// Bytes of which nothing is a frame are searched again with the next datagram; but less and less often.
void CutFramesTest::bytesThatAreNoFramesAreKeptSeldom()
{
    FrameIntake intake(Dialect::builtin());
    const Bytes garbage(600, kMagic2);
    int kept = 0;
    for (int i = 0; i < 1000; ++i) {
        kept += intake.takeDatagram(TimePoint{100s}, pathOf(1), garbage, [](const ScanItem &) {});
    }
    QVERIFY2(kept < 50, qPrintable(QString::number(kept)));
}

SKYSEAL_TEST_APPLESS(CutFramesTest)
#include "cut_frames_test.moc"
