// The account of a relay: the contents of datagrams that are visible without keys, the sums of what was dropped or duplicated,
// and the JSON lines of skyseal-cli impair.
#include "core/engine/headless/relay_report.h"
#include "core/channel/inline_frame.h"
#include "core/channel/record.h"
#include "core/mavlink/frame.h"
#include "tests/support/joined.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using test::joined;
using link::Impairer;
using std::chrono::milliseconds;
using Frame = DatagramContents::Frame;

namespace {

/// Checksums and payloads are zeros: the account reads headers only.
Bytes frame1(std::uint8_t sequence, std::uint8_t component)
{
    Bytes out{mavlink::kMagic1, 9, sequence, 1, component, 0};
    out.resize(6 + 9 + 2);
    return out;
}

Bytes frame2(std::uint8_t sequence, std::uint8_t flags)
{
    Bytes out{mavlink::kMagic2, 3, flags, 0, sequence, 1, 1, 0, 0, 0};
    out.resize(10 + 3 + 2 + (flags ? mavlink::kSignatureLength : 0));
    return out;
}

Bytes sealedInPlace(std::uint8_t sequence, std::uint8_t epoch, std::uint32_t counter)
{
    Bytes out = frame2(sequence, channel::kInlineFlags);
    const std::size_t trailer = out.size() - channel::kInlineTrailer;
    out[trailer] = epoch;
    for (std::size_t i = 0; i < 4; ++i)
        out[trailer + 1 + i] = static_cast<std::uint8_t>(counter >> (8 * i));
    return out;
}

} // namespace

class RelayReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recordsShowTheirHeader();
    void framesAreFollowedToTheEnd();
    void readingStopsAtTheFirstByteThatBeginsNoFrame();
    void framesSealedInPlaceAreUnits();
    void droppedAndDuplicatedAreSummed();
    void jsonHasItsFields();
};

void RelayReportTest::recordsShowTheirHeader()
{
    Bytes record(40);
    const channel::RecordHeader header{channel::DatagramKind::Record, 2, channel::ConnectionId{0x1234}, 77};
    header.write(std::span(record).first(header.length()));
    const DatagramContents contents = contentsOf(record);
    QCOMPARE(contents.connection, std::optional<std::uint16_t>(0x1234));
    QCOMPARE(contents.epoch, std::optional<std::uint8_t>(2));
    QCOMPARE(contents.counters, std::vector<std::uint32_t>{77});
    QCOMPARE(contents.sealedUnits(), std::uint64_t(1));
    QVERIFY(contents.frames.empty());
}

void RelayReportTest::framesAreFollowedToTheEnd()
{
    const DatagramContents contents = contentsOf(joined({frame1(7, 200), frame2(8, 0), frame2(9, mavlink::kFlagSigned)}));
    QCOMPARE(contents.frames, (std::vector<Frame>{{1, 200, 7, false}, {1, 1, 8, false}, {1, 1, 9, false}}));
    QCOMPARE(contents.clearFrames(), std::uint64_t(3));
    QCOMPARE(contents.sealedUnits(), std::uint64_t(0));
    QVERIFY(!contents.connection && !contents.epoch);
}

void RelayReportTest::readingStopsAtTheFirstByteThatBeginsNoFrame()
{
    QVERIFY(contentsOf({}).frames.empty());
    QCOMPARE(contentsOf(joined({frame2(1, 0), Bytes{0}, frame2(2, 0)})).frames.size(), std::size_t(1));
    Bytes truncated = joined({frame2(1, 0), frame2(2, 0)});
    truncated.pop_back();
    QCOMPARE(contentsOf(truncated).frames.size(), std::size_t(1));
}

void RelayReportTest::framesSealedInPlaceAreUnits()
{
    const DatagramContents contents = contentsOf(joined({sealedInPlace(3, 0x41, 0x00010203), frame2(4, 0)}));
    QCOMPARE(contents.frames, (std::vector<Frame>{{1, 1, 3, true}, {1, 1, 4, false}}));
    QCOMPARE(contents.counters, std::vector<std::uint32_t>{0x00010203});
    QCOMPARE(contents.epoch, std::optional<std::uint8_t>(1));
    QCOMPARE(contents.sealedUnits(), std::uint64_t(1));
    QCOMPARE(contents.clearFrames(), std::uint64_t(1));
}

void RelayReportTest::droppedAndDuplicatedAreSummed()
{
    const DatagramContents contents = contentsOf(joined({sealedInPlace(3, 0, 5), frame2(4, 0), frame2(5, 0)}));
    RelayLosses losses;
    impair::Treatment verdict;
    losses.add(verdict, contents);
    QCOMPARE(losses.droppedRecords + losses.droppedFrames + losses.duplicatedRecords + losses.duplicatedFrames,
             std::uint64_t(0));
    verdict.duplicated = true;
    losses.add(verdict, contents);
    verdict.fate = impair::Treatment::Fate::QueueFull;
    losses.add(verdict, contents);
    verdict.fate = impair::Treatment::Fate::Lost;
    losses.add(verdict, contents);
    QCOMPARE(losses.duplicatedRecords, std::uint64_t(1));
    QCOMPARE(losses.duplicatedFrames, std::uint64_t(2));
    QCOMPARE(losses.droppedDatagrams, std::uint64_t(2));
    QCOMPARE(losses.droppedRecords, std::uint64_t(2));
    QCOMPARE(losses.droppedFrames, std::uint64_t(4));
}

void RelayReportTest::jsonHasItsFields()
{
    const Impairer relay(*link::LinkUrl::parse("udpin:127.0.0.1:0"), *link::LinkUrl::parse("udpout:127.0.0.1:9"), {});
    RelayAccount account;
    account[static_cast<std::size_t>(Impairer::Direction::Backward)].droppedFrames = 3;
    const std::string stats = statsJson("summary", relay, account, milliseconds(1500));
    QCOMPARE(stats.substr(0, 49), std::string(R"({"event":"summary","t":1.5,"forward":{"offered":0)"));
    QVERIFY(stats.find(R"("dropped_frames":3)") > stats.find(R"("backward")"));
    impair::Treatment verdict;
    verdict.sequence = 7;
    verdict.bytes = 50;
    verdict.fate = impair::Treatment::Fate::Lost;
    RelayLosses soFar;
    soFar.droppedDatagrams = 4;
    soFar.droppedRecords = 2;
    soFar.droppedFrames = 9;
    QCOMPARE(dropJson(Impairer::Direction::Backward, milliseconds(250), verdict, soFar),
             std::string(R"({"event":"drop","t":0.25,"direction":"backward","sequence":7,"bytes":50,"reason":"loss",)"
                         R"("so_far":{"datagrams":4,"records":2,"frames":9}})"));
    const std::string arrival = arrivalJson(Impairer::Direction::Forward, {}, verdict, contentsOf(sealedInPlace(3, 1, 9)));
    QVERIFY2(arrival.ends_with(R"("counters":[9],"epoch":1,"frames":[[1,1,3]]})"), arrival.c_str());
}

SKYSEAL_TEST(RelayReportTest)
#include "relay_report_test.moc"
