// Recordings are written, damaged and read again, in portions of any size.
#include "tests/log/recordings.h"
#include "tests/support/test_runner.h"

#include "core/log/log_reader.h"
#include "core/log/log_summary.h"
#include "core/log/tlog_writer.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <sstream>

using namespace skyseal;
using namespace skyseal::tlog;
using skyseal::mavlink::Dialect;
using skyseal::mavlink::FrameFault;

namespace {

/// A stream that returns at most `portion` bytes at a time, as a pipe does.
class Portions : public std::streambuf
{
public:
    Portions(std::string content, std::size_t portion) : m_content(std::move(content)), m_portion(portion) {}

protected:
    int_type underflow() override
    {
        const std::size_t count = std::min(m_portion, m_content.size() - m_at);
        if (count == 0)
            return traits_type::eof();
        char *begin = m_content.data() + m_at;
        m_at += count;
        setg(begin, begin, begin + count);
        return traits_type::to_int_type(*begin);
    }

private:
    std::string m_content;
    std::size_t m_portion;
    std::size_t m_at = 0;
};

struct Reading
{
    std::vector<std::uint32_t> numbers;
    std::vector<std::optional<WallTime>> times;
    std::vector<std::pair<FrameFault, std::uint64_t>> bad;
    std::uint64_t covered = 0;
    LogFormat format{};
};

Reading readAll(const std::string &content, std::size_t portion = 1 << 20, LogFormat format = LogFormat::Auto)
{
    Portions portions(content, portion);
    std::istream input(&portions);
    LogReader reader(input, Dialect::builtin(), format);
    Reading out;
    while (const auto item = reader.next()) {
        // Items are contiguous and do not overlap, except for a damaged timestamp in front of a valid frame.
        if (item->offset < out.covered || item->offset - out.covered >= kTimeLength)
            throw std::runtime_error("a hole or an overlap at " + std::to_string(item->offset));
        out.covered = item->offset + item->length;
        if (item->frame) {
            out.numbers.push_back(numberOf(*item->frame));
            out.times.push_back(item->time);
        } else {
            out.bad.emplace_back(item->fault, item->offset);
        }
    }
    out.format = reader.format();
    return out;
}

std::string tlogOf(std::uint32_t count)
{
    std::string out;
    for (std::uint32_t i = 0; i < count; ++i)
        out += entry(kNoon + std::chrono::milliseconds(20 * i), heartbeat(i));
    return out;
}

} // namespace

class LogReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatWasWritten();
    void formatIsDetected();
    void everyPortionSizeGivesTheSame();
    void everyTruncatedEndIsReported();
    void damageAffectsOnlyItsFrames();
    void longDamageIsOneSpot();
    void unknownMessagesAreKeptWhole();
    void anyBytesAreRead();
    void summaryCounts();
    void clockThatWasSetIsNoLength_data();
    void clockThatWasSetIsNoLength();
};

void LogReaderTest::readsWhatWasWritten()
{
    std::string file;
    TlogWriter writer([&file](ByteView bytes) {
        file += asText(bytes);
        return true;
    });
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::string frame = heartbeat(i);
        QVERIFY(writer.write(kNoon + std::chrono::microseconds(i), asBytes(frame)));
    }
    QCOMPARE(writer.entries(), std::uint64_t(3));
    QCOMPARE(writer.bytes(), std::uint64_t(file.size()));
    QCOMPARE(file.substr(0, 8), std::string("\x00\x06\x0a\x24\x18\x1e\x40\x00", 8)); // big-endian microseconds
    const Reading reading = readAll(file);
    QCOMPARE(reading.format, LogFormat::Tlog);
    QCOMPARE(reading.numbers, (std::vector<std::uint32_t>{0, 1, 2}));
    QVERIFY(reading.bad.empty());
    QVERIFY(reading.times[2] == kNoon + std::chrono::microseconds(2));
}

void LogReaderTest::formatIsDetected()
{
    const std::string raw = heartbeat(1) + heartbeat(2) + heartbeat(3);
    QCOMPARE(readAll(raw).format, LogFormat::Raw);
    QCOMPARE(readAll("Init ArduCopter\n" + raw).format, LogFormat::Raw);
    QCOMPARE(readAll("Init ArduCopter\n" + raw).numbers.size(), std::size_t(3));
    QCOMPARE(readAll(tlogOf(3)).format, LogFormat::Tlog);
    QCOMPARE(readAll(tlogOf(4).substr(11)).format, LogFormat::Tlog);
    QCOMPARE(readAll(tlogOf(1)).format, LogFormat::Tlog);
    QVERIFY(readAll("").numbers.empty());
    QCOMPARE(readAll("no MAVLink here").bad.size(), std::size_t(1));
}

void LogReaderTest::everyPortionSizeGivesTheSame()
{
    for (const std::string &content :
         {tlogOf(40), "noise" + heartbeat(1) + "\xfe\xff more \xfd" + heartbeat(2) + heartbeat(3)}) {
        const Reading whole = readAll(content);
        for (const std::size_t portion : {1u, 2u, 7u, 29u, 64u, 333u}) {
            const Reading parts = readAll(content, portion);
            QCOMPARE(parts.numbers, whole.numbers);
            QVERIFY(parts.times == whole.times);
            QCOMPARE(parts.covered, whole.covered);
        }
    }
}

void LogReaderTest::everyTruncatedEndIsReported()
{
    const std::string content = tlogOf(3);
    const std::size_t each = content.size() / 3;
    for (std::size_t length = each; length < content.size(); ++length) {
        const Reading reading = readAll(content.substr(0, length));
        QCOMPARE(reading.numbers.size(), length / each);
        QCOMPARE(reading.bad.size(), std::size_t(length % each != 0));
        if (!reading.bad.empty())
            QVERIFY(reading.bad.front() == std::pair(FrameFault::Truncated, std::uint64_t(length / each * each)));
    }
}

void LogReaderTest::damageAffectsOnlyItsFrames()
{
    QVERIFY(rc::check("every entry that the damage does not touch is read", [] {
        const auto count = *rc::gen::inRange<std::uint32_t>(4, 30);
        const bool timed = *rc::gen::arbitrary<bool>();
        std::string content;
        std::vector<std::size_t> begins;
        for (std::uint32_t i = 0; i < count; ++i) {
            begins.push_back(content.size());
            content += timed ? entry(kNoon + std::chrono::milliseconds(i), heartbeat(i)) : heartbeat(i);
        }
        begins.push_back(content.size());
        const auto at = *rc::gen::inRange<std::size_t>(0, content.size());
        const auto removed = *rc::gen::inRange<std::size_t>(0, std::min<std::size_t>(100, content.size() - at));
        const auto noise = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
        std::string damaged = content;
        damaged.replace(at, removed, noise);

        const Reading reading = readAll(damaged, *rc::gen::inRange<std::size_t>(1, 500),
                                        timed ? LogFormat::Tlog : LogFormat::Raw);
        for (std::uint32_t i = 0; i < count; ++i) {
            const bool untouched = begins[i + 1] <= at || begins[i] >= at + removed;
            const auto seen = std::count(reading.numbers.begin(), reading.numbers.end(), i);
            RC_ASSERT(!untouched || seen == 1);
        }
    }));
}

void LogReaderTest::longDamageIsOneSpot()
{
    for (const LogFormat format : {LogFormat::Raw, LogFormat::Tlog}) {
        const auto one = [format](std::uint32_t i) {
            return format == LogFormat::Tlog ? entry(kNoon, heartbeat(i)) : heartbeat(i);
        };
        const Reading reading = readAll(one(1) + std::string(300'000, 'x') + one(2), 10'000);
        QCOMPARE(reading.format, format);
        QCOMPARE(reading.numbers, (std::vector<std::uint32_t>{1, 2}));
        QCOMPARE(reading.bad.size(), std::size_t(1));
    }
}

void LogReaderTest::unknownMessagesAreKeptWhole()
{
    const std::string strange("\xfd\x03\x00\x00\x00\x01\x01\x00\xff\xff"
                              "abc"
                              "\x12\x34",
                              15);
    const std::string content = entry(kNoon, heartbeat(1)) + entry(kNoon, strange) + entry(kNoon, heartbeat(2));
    std::istringstream input(content);
    LogReader reader(input, Dialect::builtin());
    QVERIFY(reader.next()->frame);
    const auto item = reader.next();
    QVERIFY(!item->frame && item->fault == FrameFault::UnknownMessage && item->time == kNoon);
    QCOMPARE(std::string(asText(item->bytes)), strange);
    QVERIFY(reader.next()->frame);
    QVERIFY(!reader.next());
}

void LogReaderTest::anyBytesAreRead()
{
    QVERIFY(rc::check("any bytes are covered without a hole", [] {
        const auto content = *rc::gen::container<std::string>(
            rc::gen::weightedOneOf<char>({{3, rc::gen::arbitrary<char>()}, {1, rc::gen::element('\xfd', '\xfe', '\x00')}}));
        for (const LogFormat format : {LogFormat::Raw, LogFormat::Tlog})
            RC_ASSERT(readAll(content, 13, format).covered == content.size());
    }));
}

void LogReaderTest::summaryCounts()
{
    std::string content = tlogOf(10);
    content += entry(kNoon + std::chrono::seconds(60), heartbeat(10, 2));
    content += entry(kNoon + std::chrono::seconds(30), heartbeat(11, 2));
    content[2 * (content.size() / 12) + 20] ^= 1;
    std::istringstream input(content);
    const LogSummary summary = summarize(input, Dialect::builtin());
    QCOMPARE(summary.frames, std::uint64_t(11));
    QCOMPARE(summary.badSpots, std::uint64_t(1));
    QCOMPARE(summary.listedSpots.front().fault, FrameFault::BadCrc);
    QCOMPARE(summary.pauses, std::uint64_t(1));
    QCOMPARE(summary.backwardSteps, std::uint64_t(1));
    QVERIFY(!summary.isSound());
    QCOMPARE(summary.byMessage.at("HEARTBEAT"), std::uint64_t(11));
    QCOMPARE(summary.bySender.at({2, 1}), std::uint64_t(2));
    QCOMPARE(utcText(*summary.first), std::string("2023-11-14T22:13:20.000000Z"));
    QVERIFY(*summary.last == kNoon + std::chrono::seconds(30));
    JsonWriter json;
    json.beginObject();
    writeSummaryFields(json, summary);
    json.endObject();
    QVERIFY(json.text().find(R"("frames":11,)") != std::string::npos);
}

void LogReaderTest::clockThatWasSetIsNoLength_data()
{
    QTest::addColumn<qint64>("step");
    QTest::addColumn<int>("backward");
    QTest::addColumn<int>("forward");
    QTest::newRow("back") << qint64(-3600) << 1 << 0;
    QTest::newRow("forward") << qint64(50) * 365 * 86400 << 0 << 1;
}

void LogReaderTest::clockThatWasSetIsNoLength()
{
    QFETCH(qint64, step);
    QFETCH(int, backward);
    QFETCH(int, forward);
    std::string content;
    for (int i = 0; i < 20; ++i)
        content += entry(kNoon + std::chrono::seconds(i + (i < 10 ? 0 : step)), heartbeat(static_cast<std::uint32_t>(i)));
    std::istringstream input(content);
    const LogSummary summary = summarize(input, Dialect::builtin());
    QCOMPARE(summary.frames, std::uint64_t(20));
    QCOMPARE(summary.length, Duration(std::chrono::seconds(18))); // the second in which the clock was set is not known
    QCOMPARE(int(summary.backwardSteps), backward);
    QCOMPARE(int(summary.forwardSteps), forward);
    QCOMPARE(summary.pauses, std::uint64_t(0));
    QVERIFY(*summary.first == kNoon && *summary.last == kNoon + std::chrono::seconds(19 + step));
    QCOMPARE(summary.listedGaps.size(), std::size_t(1));
    QCOMPARE(summary.isSound(), forward == 1);
}

SKYSEAL_TEST_APPLESS(LogReaderTest)
#include "log_reader_test.moc"
