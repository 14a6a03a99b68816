// Events of PX4: arming check reports become reasons, other events texts unless PX4 sends the text as well.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/mavlink/px4_mode.h"
#include "core/vehicle/autopilot_events.h"

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

// As PX4 1.19 sends them: the summaries, and a failure that keeps from arming in the mode Offboard alone.
constexpr std::uint32_t kReportBegins = 27825120, kReportEnds = 18691879, kNoOffboardSignal = 28241790;
constexpr std::uint8_t kProtocol = 0x88, kError = 0x33, kWarning = 0x44, kInfo = 0x66;
constexpr std::uint32_t kOffboardOnly = 1u << 14, kAllModes = 0xffffffff;

/// A PX4 on the ground whose checks do not pass, and the events that it sends.
struct Px4 : Harness
{
    Px4() : Harness(Harness::px4())
    {
        beat(mavlink::kPx4AutoLoiter);
        checks(true);
        checks(false);
        sent();
    }

    void beat(std::uint32_t mode) { feed(heartbeat(mode, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4)); }

    void checks(bool pass)
    {
        feed(mavlink::SysStatus{.onboard_control_sensors_health = pass ? std::uint32_t(mavlink::MAV_SYS_STATUS_PREARM_CHECK)
                                                                       : 0});
    }

    mavlink::Event event(std::uint32_t id, std::uint8_t levels, std::uint32_t modes = 0)
    {
        mavlink::Event out{.id = id, .sequence = ++sequence, .log_levels = levels};
        std::memcpy(out.arguments.data(), &modes, sizeof modes);
        return out;
    }

    void report(const std::vector<mavlink::Event> &failures)
    {
        feed(event(kReportBegins, kProtocol));
        for (mavlink::Event one : failures) {
            one.sequence = ++sequence;
            feed(one);
        }
        feed(event(kReportEnds, kProtocol));
    }

    std::vector<std::string> reasons() const { return vehicle.state(now).preArmReasons; }

    std::vector<std::string> textsUntil(TimePoint end)
    {
        runUntil(end);
        std::vector<std::string> out;
        while (const auto text = poll<TextReceived>())
            out.push_back(text->text.text);
        return out;
    }

    std::uint16_t sequence = 65533; // the numbers wrap
};

using Texts = std::vector<std::string>;

} // namespace

class AutopilotEventsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void failuresOfTheModeAreReasons();
    void passedChecksHaveNoReasons();
    void nextReportReplacesTheLast();
    void repeatedEventsCountOnce();
    void textsThatAreEventsAreSaidOnce();
    void eventWithoutTextIsNamed();
    void floodIsBounded();
};

void AutopilotEventsTest::failuresOfTheModeAreReasons()
{
    Px4 h;
    h.report({h.event(kNoOffboardSignal, kError, kOffboardOnly), h.event(17231145, kWarning, kAllModes),
              h.event(17154777, kInfo, 1u << 3)});
    QCOMPARE(h.reasons(), Texts());
    h.beat(mavlink::kPx4Offboard);
    QCOMPARE(h.reasons(), Texts{"event 11464574 of the autopilot (error)"});
    h.beat(mavlink::kPx4AutoMission);
    QCOMPARE(h.reasons(), Texts{"event 377561 of the autopilot (info)"});
    h.beat(mavlink::px4Mode(20)); // PX4 does not say which bit is that of a mode without a number
    QCOMPARE(int(h.reasons().size()), 2);
    QVERIFY(h.textsUntil(at(200)).empty());
}

void AutopilotEventsTest::passedChecksHaveNoReasons()
{
    Px4 h;
    h.report({h.event(kNoOffboardSignal, kError, kAllModes)});
    QCOMPARE(int(h.reasons().size()), 1);
    h.checks(true);
    QVERIFY(h.reasons().empty());
    h.checks(false);
    QCOMPARE(int(h.reasons().size()), 1);
}

void AutopilotEventsTest::nextReportReplacesTheLast()
{
    Px4 h;
    h.report({h.event(kNoOffboardSignal, kError, kAllModes)});
    h.feed(h.event(kReportBegins, kProtocol));
    h.feed(h.event(17231145, kError, kAllModes));
    QCOMPARE(h.reasons(), Texts{"event 11464574 of the autopilot (error)"}); // the next one is not whole yet
    h.feed(h.event(kReportEnds, kProtocol));
    QCOMPARE(h.reasons(), Texts{"event 453929 of the autopilot (error)"});
    h.report({});
    QVERIFY(h.reasons().empty());
}

void AutopilotEventsTest::repeatedEventsCountOnce()
{
    Px4 h;
    const mavlink::Event begins = h.event(kReportBegins, kProtocol), failure = h.event(kNoOffboardSignal, kError, kAllModes),
                         ends = h.event(kReportEnds, kProtocol);
    for (const mavlink::Event &one : {begins, failure, begins, failure, failure, ends, ends})
        h.feed(one);
    QCOMPARE(int(h.reasons().size()), 1);
    h.sequence = 0; // the autopilot has started again
    h.report({});
    QVERIFY(h.reasons().empty());
}

void AutopilotEventsTest::textsThatAreEventsAreSaidOnce()
{
    Px4 h;
    h.feed(h.event(17000001, kWarning));
    h.feed(statusText("Low battery level\t", mavlink::MAV_SEVERITY_WARNING));
    QCOMPARE(h.textsUntil(at(105)), Texts{"Low battery level"});
    h.feed(statusText("Critical battery level\t", mavlink::MAV_SEVERITY_CRITICAL)); // the event comes after its text
    h.feed(h.event(17000002, 0x22));
    QCOMPARE(h.textsUntil(at(110)), Texts{"Critical battery level"});
    QVERIFY(h.textsUntil(at(120)).empty());
}

void AutopilotEventsTest::eventWithoutTextIsNamed()
{
    Px4 h;
    h.feed(h.event(17000001, kError));
    h.feed(h.event(17000002, kInfo)); // a number says nothing that is worth the pilot's time
    h.feed(h.event(17000003, 0x08));  // none for people
    h.feed(statusText("of another severity\t", mavlink::MAV_SEVERITY_INFO));
    QCOMPARE(h.textsUntil(h.now + AutopilotEvents::kTextDelay / 2), Texts{"of another severity"});
    QCOMPARE(h.textsUntil(at(110)), Texts{"event 222785 of the autopilot (error)"});
}

void AutopilotEventsTest::floodIsBounded()
{
    Px4 h;
    h.feed(h.event(kReportBegins, kProtocol));
    for (int i = 0; i < 1000; ++i)
        h.feed(h.event(17000001 + std::uint32_t(i), kError, kAllModes));
    h.feed(h.event(kReportEnds, kProtocol));
    QCOMPARE(h.reasons().size(), AutopilotEvents::kMost);
    for (int i = 0; i < 1000; ++i)
        h.feed(h.event(17000001 + std::uint32_t(i), kError));
    QCOMPARE(h.textsUntil(at(110)).size(), AutopilotEvents::kMost);
}

SKYSEAL_TEST_APPLESS(AutopilotEventsTest)
#include "autopilot_events_test.moc"
