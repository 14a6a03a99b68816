// The modes that a vehicle names itself: how they are requested, shown, asked for and waited for.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/mavlink/px4_mode.h"
#include "core/vehicle/flight_script.h"
#include "core/vehicle/mode_list.h"

#include <set>

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

mavlink::AvailableModes mode(std::uint8_t index, std::uint8_t count, std::uint32_t number, std::string_view name,
                             std::uint32_t properties = 0, std::uint8_t standard = 0)
{
    mavlink::AvailableModes out;
    out.number_modes = count;
    out.mode_index = index;
    out.custom_mode = number;
    out.properties = properties;
    out.standard_mode = standard;
    mavlink::setText(out.mode_name, name);
    return out;
}

/// A PX4 that streams by itself, and has said what it is.
struct Px4 : Harness
{
    Px4()
    {
        beat(mavlink::kPx4AutoLoiter);
        feed(mavlink::AutopilotVersion{});
        sent();
    }

    void beat(std::uint32_t number) { feed(heartbeat(number, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4)); }

    /// The indexes that are requested until `end`, each with its time; 0 stands for all.
    std::vector<int> requestsUntil(TimePoint end)
    {
        std::vector<int> out;
        while (const auto request = nextSent<mavlink::CommandLong>(end)) {
            if (request->second.command == mavlink::MAV_CMD_REQUEST_MESSAGE
                && request->second.param1 == float(mavlink::AvailableModes::kId))
                out.push_back(int(request->second.param2));
        }
        now = end;
        return out;
    }

    std::string modeNow() const { return vehicle.current().mode; }
};

} // namespace

class ModeListTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allModesOfPx4HaveNames();
    void vehicleNamesItsModes();
    void missingModesAreRequestedAgain();
    void changedListIsRequestedAgain();
    void vehicleWithoutTheProtocolIsLeftAlone();
    void slowLinkIsNotAsked();
    void modesOfOneNameAreToldApart();
    void standardModesMayComeWithoutAName();
    void wrongListsChangeNothing();
    void bothNamesAreUnderstood();
};

void ModeListTest::allModesOfPx4HaveNames()
{
    const VehicleKind kind{mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4};
    std::set<std::string> names;
    int modes = 0;
    const auto take = [&](std::uint32_t main, std::uint32_t sub) {
        const std::string name = modeName(kind, mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, mavlink::px4Mode(main, sub));
        QVERIFY2(!name.starts_with("MODE("), name.c_str());
        names.insert(name);
        ++modes;
    };
    for (const std::uint32_t main : {1u, 2u, 3u, 5u, 6u, 7u, 8u, 10u, 11u})
        take(main, 0);
    take(3, 1); // Orbit
    take(3, 2); // Position slow
    for (std::uint32_t sub = 1; sub <= 18; ++sub) {
        if (sub != 7) // reserved
            take(4, sub);
    }
    QCOMPARE(int(names.size()), modes);
    QCOMPARE(modeName(kind, 1, mavlink::px4Mode(3, 1)), std::string("ORBIT"));
    QCOMPARE(modeName(kind, 1, mavlink::px4Mode(4, 18)), std::string("EXTERNAL8"));
    QVERIFY(modeName(kind, 1, mavlink::px4Mode(4, 19)) != modeName(kind, 1, mavlink::px4Mode(4, 20)));
}

void ModeListTest::vehicleNamesItsModes()
{
    Px4 h;
    QCOMPARE(h.modeNow(), std::string("LOITER"));
    h.now = at(101);
    h.beat(mavlink::kPx4AutoLoiter);
    QCOMPARE(h.requestsUntil(at(101)), std::vector<int>{0});
    h.feed(mode(1, 3, mavlink::kPx4AutoLoiter, "Hold"));
    QCOMPARE(h.modeNow(), std::string("LOITER")); // not before the list is whole
    h.feed(mode(2, 3, mavlink::kPx4External1, "Survey of roofs"));
    h.feed(mode(3, 3, mavlink::kPx4Termination, "Termination", mavlink::MAV_MODE_PROPERTY_NOT_USER_SELECTABLE));
    QCOMPARE(h.modeNow(), std::string("Hold"));
    QCOMPARE(h.vehicle.current().modes, (std::vector<std::string>{"Hold", "Survey of roofs"}));
    h.beat(mavlink::kPx4External1);
    QCOMPARE(h.modeNow(), std::string("Survey of roofs"));
    h.beat(mavlink::kPx4Orbit); // not in the list
    QCOMPARE(h.modeNow(), std::string("ORBIT"));
    QVERIFY(h.requestsUntil(at(200)).empty());
}

void ModeListTest::missingModesAreRequestedAgain()
{
    Px4 h;
    h.beat(mavlink::kPx4AutoLoiter);
    h.feed(mode(1, 4, mavlink::kPx4AutoLoiter, "Hold"));
    h.feed(mode(3, 4, mavlink::kPx4AutoRtl, "Return"));
    h.sent();
    QCOMPARE(h.requestsUntil(h.now + ModeList::kSilence), std::vector<int>{2});
    h.feed(mode(2, 4, mavlink::kPx4AutoLand, "Land"));
    QCOMPARE(h.requestsUntil(h.now + ModeList::kSilence), std::vector<int>{4});
    h.feed(mode(4, 4, mavlink::kPx4Manual, "Manual"));
    QCOMPARE(h.modeNow(), std::string("Hold"));
}

void ModeListTest::changedListIsRequestedAgain()
{
    Px4 h;
    h.beat(mavlink::kPx4AutoLoiter);
    h.feed(mavlink::AvailableModesMonitor{.seq = 5});
    QCOMPARE(h.requestsUntil(h.now), std::vector<int>{0});
    h.feed(mode(1, 1, mavlink::kPx4AutoLoiter, "Hold"));
    h.feed(mavlink::AvailableModesMonitor{.seq = 5});
    QVERIFY(h.requestsUntil(h.now).empty());
    h.feed(mavlink::AvailableModesMonitor{.seq = 6});
    QCOMPARE(h.requestsUntil(h.now), std::vector<int>{0});
    h.feed(mode(1, 1, mavlink::kPx4AutoLoiter, "Stay"));
    QCOMPARE(h.modeNow(), std::string("Stay"));
}

void ModeListTest::vehicleWithoutTheProtocolIsLeftAlone()
{
    Px4 h;
    h.beat(mavlink::kPx4AutoLoiter);
    QCOMPARE(h.requestsUntil(at(1000)), std::vector<int>(ModeList::kAttempts, 0));
    h.beat(mavlink::kPx4AutoLoiter);
    QVERIFY(h.requestsUntil(at(2000)).empty());
    QCOMPARE(h.modeNow(), std::string("LOITER"));
    Px4 refusing;
    refusing.beat(mavlink::kPx4AutoLoiter);
    QCOMPARE(refusing.requestsUntil(refusing.now), std::vector<int>{0});
    refusing.ack(mavlink::MAV_CMD_REQUEST_MESSAGE, mavlink::MAV_RESULT_UNSUPPORTED);
    QVERIFY(refusing.requestsUntil(at(1000)).empty());
}

void ModeListTest::slowLinkIsNotAsked()
{
    Px4 h;
    h.vehicle.setStreams(h.now, StreamProfile::LowBandwidth, 0);
    h.beat(mavlink::kPx4AutoLoiter);
    QVERIFY(h.requestsUntil(at(1000)).empty());
}

void ModeListTest::modesOfOneNameAreToldApart()
{
    Px4 h;
    h.feed(mode(1, 5, mavlink::kPx4External1, "Land"));
    h.feed(mode(2, 5, mavlink::kPx4AutoLand, "Land"));
    h.feed(mode(3, 5, mavlink::px4Mode(4, 12), "Survey"));
    h.feed(mode(4, 5, mavlink::px4Mode(4, 13), "Survey"));
    h.feed(mode(5, 5, mavlink::px4Mode(4, 14), "Orbit")); // a name that PX4 has for another one
    const auto names = h.vehicle.current().modes;
    QCOMPARE(names.size(), std::size_t(5));
    QCOMPARE(std::set<std::string>(names.begin(), names.end()).size(), std::size_t(5));
    for (const std::string &name : names)
        QVERIFY2(modeNumber({mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4}, name, h.vehicle.current().ownModes),
                 name.c_str());
    const auto nameOf = [&](std::uint32_t number) { return modeName({}, 1, number, h.vehicle.current().ownModes); };
    QCOMPARE(nameOf(mavlink::kPx4AutoLand), std::string("Land"));
    QCOMPARE(nameOf(mavlink::kPx4External1), "Land (" + std::to_string(mavlink::kPx4External1) + ")");
    QCOMPARE(nameOf(mavlink::px4Mode(4, 12)), std::string("Survey"));
    QVERIFY(nameOf(mavlink::px4Mode(4, 14)) != "Orbit");
}

void ModeListTest::standardModesMayComeWithoutAName()
{
    Px4 h;
    h.feed(mode(1, 3, mavlink::kPx4AutoRtl, "", 0, mavlink::MAV_STANDARD_MODE_SAFE_RECOVERY));
    h.feed(mode(2, 3, mavlink::px4Mode(20), "", 0, mavlink::MAV_STANDARD_MODE_CRUISE)); // in no table
    h.feed(mode(3, 3, mavlink::px4Mode(21), ""));
    QCOMPARE(h.vehicle.current().modes,
             (std::vector<std::string>{"CRUISE", "MODE(" + std::to_string(mavlink::px4Mode(21)) + ")", "RTL"}));
}

void ModeListTest::wrongListsChangeNothing()
{
    Px4 h;
    h.feed(mode(0, 1, mavlink::kPx4AutoLoiter, "zero"));
    h.feed(mode(2, 1, mavlink::kPx4AutoLoiter, "beyond"));
    h.feed(mode(1, 0, mavlink::kPx4AutoLoiter, "of none"));
    QCOMPARE(h.modeNow(), std::string("LOITER"));
}

void ModeListTest::bothNamesAreUnderstood()
{
    Px4 h;
    h.feed(mode(1, 1, mavlink::kPx4PositionSlow, "Position Slow"));
    for (const char *name : {"position_slow", "Position Slow", "POSITION_SLOW"}) {
        h.vehicle.perform(h.now, RequestId{1}, VehicleCommand(vehicle::SetMode{name}));
        const auto sent = h.sentOf<mavlink::CommandLong>();
        QVERIFY2(sent.size() == 1 && sent[0].param2 == 3 && sent[0].param3 == 2, name);
        h.ack(mavlink::MAV_CMD_DO_SET_MODE, mavlink::MAV_RESULT_ACCEPTED);
    }
    const auto fulfils = [&](const char *condition) { return parseCondition(condition)->fulfilledBy(h.vehicle.current()); };
    h.feed(mode(1, 1, mavlink::kPx4AutoLoiter, "Hold"));
    QCOMPARE(h.modeNow(), std::string("Hold"));
    QVERIFY(fulfils("mode==Hold") && fulfils("mode==LOITER") && !fulfils("mode!=LOITER") && !fulfils("mode==LAND"));
}

SKYSEAL_TEST_APPLESS(ModeListTest)
#include "mode_list_test.moc"
