// The index of recordings that the test writes: length, gaps, vehicles, modes and times armed, and what damage leaves of them.
#include "core/log/log_index.h"
#include "tests/log/recordings.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <atomic>
#include <sstream>

using namespace skyseal;
using namespace skyseal::tlog;
using namespace std::chrono_literals;

namespace {

/// A HEARTBEAT of an ArduPilot copter.
std::string beat(std::uint32_t mode, bool armed, std::uint8_t systemId = 1, std::uint8_t componentId = 1,
                 std::uint8_t type = mavlink::MAV_TYPE_QUADROTOR, std::uint8_t autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA)
{
    mavlink::FrameWriter writer(systemId, componentId);
    mavlink::Heartbeat message;
    message.custom_mode = mode;
    message.type = type;
    message.autopilot = autopilot;
    message.base_mode = mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    if (armed)
        message.base_mode |= mavlink::MAV_MODE_FLAG_SAFETY_ARMED;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return std::string(std::string(asText(writer.write(message, buffer))));
}

LogIndex indexOfText(const std::string &content)
{
    std::istringstream input(content);
    return indexOf(input);
}

/// One heartbeat a second.
std::string flight(int seconds)
{
    std::string out;
    for (int i = 0; i < seconds; ++i)
        out += entry(kNoon + std::chrono::seconds(i), beat(i < 20 ? 0 : 4, i >= 5 && i < 40));
    return out;
}

} // namespace

class LogIndexTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lineHasAnEnd()
    {
        // Each pair of entries steps a day forward, and a damaged time back.
        LogTime line;
        Duration last{};
        for (int i = 0; i < 300'000; ++i) {
            const Duration at = line.note(kNoon + (i % 2 ? 24h : 0h));
            QVERIFY(at >= last && at <= LogTime::kLongest);
            last = at;
        }
        QCOMPARE(last, Duration(LogTime::kLongest));
    }

    void stopEndsDamageWithoutEnd()
    {
        std::istringstream input(flight(3) + std::string(10'000'000, '\0') + flight(3));
        std::atomic<bool> stopped = true;
        LogIndexer indexer(input);
        indexer.endWhen(stopped);
        QVERIFY(indexer.read(1000));
        QCOMPARE(input.tellg(), std::streampos(0)); // nothing more is read
    }

    void flightHasLengthModesAndTimesArmed()
    {
        const LogIndex index = indexOfText(flight(61));
        QCOMPARE(index.first, std::optional(kNoon));
        QCOMPARE(index.length, Duration(60s));
        QCOMPARE(index.frames, std::uint64_t(61));
        QCOMPARE(index.vehicles, std::vector<std::uint8_t>{1});
        QCOMPARE(index.modes.size(), std::size_t(2));
        QCOMPARE(index.modes[0].at, Duration(0s));
        QCOMPARE(index.modes[1].at, Duration(20s));
        QCOMPARE(index.modes[1].customMode, std::uint32_t(4));
        QCOMPARE(index.armed.size(), std::size_t(1));
        QCOMPARE(index.armed[0].span.from, Duration(5s));
        QCOMPARE(index.armed[0].span.to, Duration(40s));
        QVERIFY(index.gaps.empty());
        QCOMPARE(index.damaged + index.omitted, std::uint64_t(0));
    }

    void autopilotIsFoundWhoeverSpeaksFirst()
    {
        const std::string companion = beat(0, false, 1, 191, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_GENERIC);
        std::string content;
        for (int i = 0; i < 10; ++i) {
            content += entry(kNoon + std::chrono::seconds(i), companion);
            if (i >= 2)
                content += entry(kNoon + std::chrono::seconds(i), beat(5, i >= 4));
        }
        const LogIndex index = indexOfText(content);
        QCOMPARE(index.vehicles, std::vector<std::uint8_t>{1});
        QCOMPARE(index.modes.back().at, Duration(2s));
        QCOMPARE(index.modes.back().customMode, std::uint32_t(5));
        QCOMPARE(index.armed.size(), std::size_t(1));
        QCOMPARE(index.armed[0].span.from, Duration(4s));
        QCOMPARE(index.armed[0].span.to, Duration(9s));
    }

    void highLatencyStandsForAHeartbeat()
    {
        mavlink::FrameWriter writer(7, 1);
        mavlink::HighLatency2 message;
        message.type = mavlink::MAV_TYPE_FIXED_WING;
        message.autopilot = mavlink::MAV_AUTOPILOT_PX4;
        message.custom_mode = 0x0404;
        message.throttle = 60;
        std::string content;
        for (int i = 0; i < 3; ++i) {
            std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
            content += entry(kNoon + std::chrono::seconds(5 * i), std::string(asText(writer.write(message, buffer))));
        }
        const LogIndex index = indexOfText(content);
        QCOMPARE(index.vehicles, std::vector<std::uint8_t>{7});
        QCOMPARE(index.modes.size(), std::size_t(1));
        QCOMPARE(index.modes[0].customMode, std::uint32_t(0x04040000));
        QCOMPARE(index.armed.size(), std::size_t(1));
    }

    void stillArmedAtTheEnd()
    {
        const LogIndex index = indexOfText(flight(31));
        QCOMPARE(index.armed.size(), std::size_t(1));
        QCOMPARE(index.armed[0].span.to, Duration(30s));
    }

    /// Of the limit of a lost link: what is just as long is none.
    void longSilenceIsAGap()
    {
        const std::string frame = beat(0, false);
        const LogIndex index = indexOfText(entry(kNoon, frame) + entry(kNoon + 3500ms, frame) + entry(kNoon + 7001ms, frame));
        QCOMPARE(index.gaps.size(), std::size_t(1));
        QCOMPARE(index.gaps[0].from, Duration(3500ms));
        QCOMPARE(index.gaps[0].to, Duration(7001ms));
    }

    void clockThatIsSetTakesNoTime()
    {
        const std::string frame = beat(0, false);
        const LogIndex index = indexOfText(entry(kNoon, frame) + entry(kNoon - 1h, frame) + entry(kNoon - 1h + 2s, frame)
                                           + entry(kNoon + 1000h, frame) + entry(kNoon + 1000h + 1s, frame));
        QCOMPARE(index.length, Duration(3s));
        QVERIFY(index.gaps.empty());
        QCOMPARE(index.first, std::optional(kNoon));
    }

    void othersAreNoVehicles()
    {
        using namespace mavlink;
        const std::string content = entry(kNoon, beat(9, true, 255, 190, MAV_TYPE_GCS, MAV_AUTOPILOT_INVALID))
            + entry(kNoon, beat(3, false, 7, 1)) + entry(kNoon, beat(5, true, 7, 100, MAV_TYPE_CAMERA, MAV_AUTOPILOT_INVALID))
            + entry(kNoon, beat(3, true, 2, 1));
        const LogIndex index = indexOfText(content);
        QCOMPARE(index.vehicles, (std::vector<std::uint8_t>{7, 2}));
        QCOMPARE(index.modes.size(), std::size_t(2));
        QCOMPARE(index.armed.size(), std::size_t(1));
        QCOMPARE(index.armed[0].systemId, std::uint8_t(2));
    }

    void armingIsNoChangeOfMode()
    {
        QCOMPARE(indexOfText(entry(kNoon, beat(0, false)) + entry(kNoon + 1s, beat(0, true))).modes.size(), std::size_t(1));
    }

    void damageIsCountedAndSkipped()
    {
        const std::string content = flight(30) + "no frame, and nothing like one" + entry(kNoon + 30s, beat(4, true));
        const LogIndex index = indexOfText(content);
        QCOMPARE(index.frames, std::uint64_t(31));
        QCOMPARE(index.damaged, std::uint64_t(1));
        QCOMPARE(index.length, Duration(30s));
    }

    void listsAreBounded()
    {
        std::string content;
        for (std::uint32_t i = 0; i < LogIndex::kListed + 100; ++i)
            content += entry(kNoon + std::chrono::seconds(i), beat(i % 2, false));
        const LogIndex index = indexOfText(content);
        QCOMPARE(index.modes.size(), LogIndex::kListed);
        QCOMPARE(index.omitted, std::uint64_t(100));
    }

    void suitesStandAtTheirTime()
    {
        LinkEvents events;
        const std::pair<std::chrono::milliseconds, std::string> switches[] = {
            {-5s, "aes-256-gcm"}, {10s, "chacha20"}, {10500ms, "rc4"}, {90s, "aes-256-ctr"}};
        for (const auto &[offset, suite] : switches)
            events.events.push_back({LinkEvent::Kind::Switched, kNoon + offset, suite, "air-1"});
        events.unreadable = 3;
        std::istringstream input(flight(61));
        const LogIndex index = indexOf(input, events);
        QCOMPARE(index.suites.size(), std::size_t(4));
        QCOMPARE(index.suites[0].at, Duration(0s)); // older than the recording
        QCOMPARE(index.suites[1].at, Duration(10s));
        QCOMPARE(index.suites[2].at, Duration(11s));
        QCOMPARE(index.suites[2].event.suite, std::string("rc4"));
        QCOMPARE(index.suites[3].at, Duration(60s)); // after its end
        QCOMPARE(index.unreadableEvents, std::uint64_t(3));
        QCOMPARE(index.frames, std::uint64_t(61));
        QVERIFY(indexOfText(flight(61)).suites.empty());
    }

    /// Half a minute after the clock was set back by an hour, and not before the step, at which its time has passed already.
    void suiteStandsBehindAClockThatWasSetBack()
    {
        std::string content;
        for (int i = 0; i < 60; ++i)
            content += entry(kNoon + std::chrono::seconds(i) - (i < 10 ? 0h : 1h), beat(0, false));
        LinkEvents events;
        events.events.push_back({LinkEvent::Kind::Sealed, kNoon, "aes-256-gcm", "air-1"});
        events.events.push_back({LinkEvent::Kind::Switched, kNoon + 40s - 1h, "chacha20", "air-1"});
        std::istringstream input(content);
        const LogIndex index = indexOf(input, events);
        QCOMPARE(index.suites.size(), std::size_t(2));
        QCOMPARE(index.suites[0].at, Duration(0s));
        QCOMPARE(index.suites[1].at, Duration(39s)); // the second in which the clock was set is not known
    }

    void protectionIsThatOfThePosition()
    {
        LogIndex index;
        const auto note = [&](Duration at, LinkEvent::Kind kind, const char *suite, const char *peer) {
            index.suites.push_back({at, {kind, kNoon, suite, peer}});
        };
        const auto at = [&](Duration position, std::uint8_t systemId) {
            std::string out;
            for (const LinkEvent &event : protectionAt(index, position, systemId))
                out += (out.empty() ? "" : ", ") + event.suite + " " + event.peer;
            return out;
        };
        QCOMPARE(at(10s, 1), std::string());
        note(5s, LinkEvent::Kind::Sealed, "chacha20-poly1305", "air-1");
        note(20s, LinkEvent::Kind::Switched, "aes-256-gcm", "air-1");
        note(30s, LinkEvent::Kind::Plain, "none", "2");
        QCOMPARE(at(4s, 1), std::string());
        QCOMPARE(at(5s, 1), std::string("chacha20-poly1305 air-1"));
        QCOMPARE(at(25s, 1), std::string("aes-256-gcm air-1"));
        QCOMPARE(at(40s, 1), std::string("aes-256-gcm air-1"));
        QCOMPARE(at(40s, 2), std::string("none 2"));
        note(50s, LinkEvent::Kind::Sealed, "rc4", "air-2"); // whose vehicles are not noted
        QCOMPARE(at(60s, 1), std::string("aes-256-gcm air-1, rc4 air-2"));
        QCOMPARE(at(60s, 2), std::string("rc4 air-2"));
    }

    void suitesOfAFileWithoutTimesStandAtItsEnd()
    {
        LinkEvents events;
        events.events.push_back({LinkEvent::Kind::Sealed, kNoon, "aes-256-gcm", {}});
        std::istringstream input(beat(0, false) + beat(0, false));
        const LogIndex index = indexOf(input, events);
        QCOMPARE(index.suites.size(), std::size_t(1));
        QCOMPARE(index.suites[0].at, index.length);
    }

    void emptyFileHasNoTime()
    {
        const LogIndex index = indexOfText({});
        QVERIFY(!index.first);
        QCOMPARE(index.length, Duration(0s));
    }

    void portionsMakeNoDifference()
    {
        QVERIFY(rc::check("an index that was read in portions is the index", [] {
            const std::string content = flight(60) + "damage" + entry(kNoon + 90s, beat(5, true));
            const LogIndex whole = indexOfText(content);
            std::istringstream input(content);
            LogIndexer indexer(input);
            while (!indexer.read(*rc::gen::inRange<std::size_t>(1, 20))) {}
            const LogIndex index = indexer.take();
            RC_ASSERT(index.length == whole.length && index.frames == whole.frames && index.damaged == whole.damaged);
            RC_ASSERT(index.modes.size() == whole.modes.size() && index.gaps.size() == whole.gaps.size());
            RC_ASSERT(index.armed.size() == whole.armed.size());
        }));
    }
};

SKYSEAL_TEST_APPLESS(LogIndexTest)
#include "log_index_test.moc"
