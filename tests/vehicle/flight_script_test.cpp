// The language of flight scripts: what it means, what its errors say, and that no text whatever makes it stumble.
#include "core/vehicle/flight_script.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::vehicle;

class FlightScriptTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsAWholeFlight();
    void readsEveryVerb();
    void spacesAndCaseDoNotMatter();
    void errorsNameStepColumnAndExpectation_data();
    void errorsNameStepColumnAndExpectation();
    void conditionsCompare_data();
    void conditionsCompare();
    void everyFieldCanBeWrittenAndWaitedFor();
    void unknownValuesAreNull();
    void anyTextIsReadOrRefused();
    void stepsRoundTrip();
};

namespace {

template<typename T> const T &command(const FlightStep &step)
{
    return std::get<T>(std::get<VehicleCommand>(step.action));
}

FlightStep only(std::string_view script)
{
    auto steps = parseFlightScript(script);
    if (!steps || steps->size() != 1)
        throw std::runtime_error(steps ? "not one step" : steps.error().text());
    return steps->front();
}

} // namespace

void FlightScriptTest::readsAWholeFlight()
{
    const auto steps = parseFlightScript("mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60; 2: land; wait armed==0 90;");
    QVERIFY(steps);
    QCOMPARE(steps->size(), std::size_t(6));
    QCOMPARE(command<SetMode>((*steps)[0]).mode, std::string("GUIDED"));
    QVERIFY(!command<Arm>((*steps)[1]).force);
    QCOMPARE(command<TakeOff>((*steps)[2]).altitude, 10.);
    const auto &wait = std::get<WaitUntil>((*steps)[3].action);
    QCOMPARE(wait.field, findStateField("alt_rel"));
    QCOMPARE(wait.comparison, ComparisonOperator::AtLeast);
    QCOMPARE(wait.number, 9.5);
    QCOMPARE(wait.timeout, Duration(std::chrono::seconds(60)));
    QCOMPARE((*steps)[4].systemId, std::optional<std::uint8_t>(2));
    QCOMPARE((*steps)[4].text, std::string("land"));
    QCOMPARE((*steps)[4].column, std::size_t(56));
    QVERIFY(!(*steps)[5].systemId);
}

void FlightScriptTest::readsEveryVerb()
{
    QVERIFY(command<Arm>(only("arm force")).force);
    QVERIFY(command<Disarm>(only("disarm force")).force);
    (void)command<Land>(only("land"));
    (void)command<ReturnToLaunch>(only("rtl"));
    (void)command<StartMission>(only("start"));
    (void)command<Reboot>(only("reboot"));
    const auto &place = command<GoTo>(only("goto -35.36 149.16 20"));
    QCOMPARE(place.longitude, 149.16);
    QCOMPARE(command<ChangeAltitude>(only("altitude 25")).altitudeRelative, 25.);
    (void)command<Loiter>(only("pause"));
    (void)command<Loiter>(only("loiter"));
    QCOMPARE(command<PointAt>(only("roi -35.36 149.16")).altitudeRelative, 0.);
    QCOMPARE(command<PointAt>(only("roi -35.36 149.16 -3")).altitudeRelative, -3.);
    (void)command<StopPointing>(only("roi NONE"));
    QCOMPARE(command<SetHome>(only("sethome -35.36 149.16")).latitude, -35.36);
    QCOMPARE(command<ChangeSpeed>(only("speed 4.5")).metresPerSecond, 4.5);
    QCOMPARE(command<SetCurrentMissionItem>(only("item 3")).index, std::uint16_t(3));
    const auto raw = only("command 183 1 1500");
    QCOMPARE(command<RawCommand>(raw).parameters[1], 1500.f);
    QCOMPARE(std::get<Sleep>(only("sleep 0.5").action).time, Duration(std::chrono::milliseconds(500)));
    const auto write = only("param WPNAV_SPEED 750");
    QCOMPARE(std::get<WriteParameter>(write.action).name, std::string("WPNAV_SPEED"));
    QCOMPARE(std::get<WriteParameter>(write.action).value, 750.);
    QCOMPARE(std::get<WaitUntil>(only("wait mode==RTL").action).timeout, Duration(std::chrono::seconds(60)));
}

void FlightScriptTest::spacesAndCaseDoNotMatter()
{
    const auto spaced = only("  12 :  WAIT Alt_Rel  >=  9.5   60  ");
    const auto dense = only("12:wait alt_rel>=9.5 60");
    QCOMPARE(toText(spaced), toText(dense));
    QVERIFY(only("Arm FORCE").action.index() == 0);
    QCOMPARE(std::get<WaitUntil>(only("wait armed == false").action).number, 0.);
    QCOMPARE(command<TakeOff>(only("takeoff +10")).altitude, 10.);
}

void FlightScriptTest::errorsNameStepColumnAndExpectation_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("column");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *script, int column, const char *message) {
        QTest::newRow(script) << QByteArray(script) << column << QByteArray(message);
    };
    row("", 0, "the script has no steps");
    row(" ; ;", 0, "the script has no steps");
    row("arm; fly", 6, "step 2: expected one of mode, arm,");
    row("arm; takeoff ten", 14, "step 2: expected an altitude in metres above home, over 0 and up to 10000, found 'ten'");
    row("takeoff", 8, "found the end of the step");
    row("takeoff 0", 9, "found '0'");
    row("takeoff nan", 9, "found 'nan'");
    row("takeoff 1e999", 9, "found '1e999'");
    row("mode", 5, "step 1: expected a mode's name");
    row("arm now", 5, "step 1: expected 'force' or the end of the step, found 'now'");
    row("land now", 6, "step 1: expected the end of the step, found 'now'");
    row("goto 91 0 0", 6, "a latitude in degrees, -90 to 90, found '91'");
    row("goto 9 0", 9, "an altitude");
    row("wait", 5, "a field's name (sysid, mode, armed");
    row("wait speed>3", 6, "a field's name");
    row("wait alt_rel", 13, "one of >= <= > < == !=");
    row("wait alt_rel=3", 13, "one of >= <= > < == !=, found '=3'");
    row("wait alt_rel>=high", 15, "a number to compare alt_rel with, found 'high'");
    row("wait mode>3", 10, "== or !=, since mode is a text, found '>'");
    row("wait alt_rel>=3 soon", 17, "a time-out in seconds");
    row("0: arm", 1, "a system ID from 1 to 255 before the colon");
    row("300: arm", 1, "a system ID from 1 to 255 before the colon");
    row("sleep -1", 7, "a time in seconds");
    row("param A_NAME_THAT_IS_TOO_LONG 1", 7, "up to 16 characters");
    row("item 70000", 6, "0 to 65535");
}

void FlightScriptTest::errorsNameStepColumnAndExpectation()
{
    QFETCH(QByteArray, script);
    QFETCH(int, column);
    QFETCH(QByteArray, message);
    const auto steps = parseFlightScript(script.toStdString());
    QVERIFY(!steps);
    QVERIFY2(steps.error().message.text().find(message.toStdString()) != std::string::npos,
             steps.error().message.text().c_str());
    QCOMPARE(int(steps.error().column), column);
}

void FlightScriptTest::conditionsCompare_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<bool>("expected");
    const std::pair<const char *, bool> rows[] = {
        {"wait alt_rel>=10", true}, {"wait alt_rel>10", false},  {"wait alt_rel<=10", true},    {"wait alt_rel<10", false},
        {"wait alt_rel==10", true}, {"wait alt_rel!=10", false}, {"wait mode==rtl", true},      {"wait mode!=RTL", false},
        {"wait armed==1", true},    {"wait armed!=true", false}, {"wait ekf_ok==1", true},      {"wait climb<1", false},
        {"wait climb!=1", false},   {"wait gps_fix>=3", true},   {"wait satellites>=0", false}, {"wait sysid==7", true}};
    for (const auto &[script, expected] : rows)
        QTest::newRow(script) << QByteArray(script) << expected;
}

void FlightScriptTest::conditionsCompare()
{
    VehicleState state; // climb and satellites are not known and so fulfil nothing
    state.systemId = 7;
    state.altitudeRelative = 10;
    state.mode = "RTL";
    state.armed = true;
    state.ekfOk = true;
    state.gpsFix = 3;
    QFETCH(QByteArray, script);
    QFETCH(bool, expected);
    const auto step = only(script.toStdString());
    QCOMPARE(std::get<WaitUntil>(step.action).fulfilledBy(state), expected);
}

void FlightScriptTest::everyFieldCanBeWrittenAndWaitedFor()
{
    const char *promised[] = {
        "sysid",  "mode",          "armed",        "roll",      "pitch",           "yaw",          "lat",
        "lon",    "alt_rel",       "ground_speed", "battery_v", "battery_percent", "gps_fix",      "satellites",
        "ekf_ok", "heartbeat_age", "climb",        "heading",   "mission_current", "distance_home"};
    for (const char *name : promised)
        QVERIFY2(findStateField(name), name);
    VehicleState state;
    state.systemId = 1;
    state.mode = "AUTO";
    state.armed = true;
    state.ekfOk = false;
    state.gpsFix = 6;
    state.roll = -0.0;
    state.batteries = {{.id = 1, .function = mavlink::MAV_BATTERY_FUNCTION_PAYLOAD, .voltage = 12.5, .percent = 40}};
    JsonWriter json;
    json.beginObject();
    writeStateFields(json, state);
    json.endObject();
    const auto has = [&](const char *text) { return json.text().find(text) != std::string::npos; };
    QVERIFY2(has("{\"sysid\":1,\"mode\":\"AUTO\",\"armed\":true,\"roll\":-0"), json.text().c_str());
    QVERIFY(has("\"ekf_ok\":0,"));
    QVERIFY(has("\"gps_fix\":6,"));
    QVERIFY(has("\"batteries\":[{\"id\":1,\"function\":4,\"v\":12.5,\"a\":null,\"percent\":40}]}"));
    for (const StateField &field : stateFields()) {
        QVERIFY(has(("\"" + std::string(field.name) + "\":").c_str()));
        QVERIFY(parseFlightScript("wait " + std::string(field.name) + (field.kind == StateField::Kind::Text ? "==x" : "==1")));
    }
}

void FlightScriptTest::unknownValuesAreNull()
{
    JsonWriter json;
    json.beginObject();
    writeStateFields(json, VehicleState{});
    json.endObject();
    for (const char *name : {"lat", "alt_rel", "battery_v", "gps_fix", "satellites", "ekf_ok", "heartbeat_age"})
        QVERIFY2(json.text().find("\"" + std::string(name) + "\":null") != std::string::npos, name);
}

void FlightScriptTest::anyTextIsReadOrRefused()
{
    // Random bytes, and random sequences of the language's own words, which get further in.
    QVERIFY(rc::check("any bytes", [](const std::string &text) {
        const auto steps = parseFlightScript(text);
        if (!steps)
            RC_ASSERT(!steps.error().message.empty());
    }));
    QVERIFY(rc::check("any words", [] {
        const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
            "mode", "arm", "wait", "alt_rel", ">=", "==", ";", ":", "1", "-3.5", "force", "goto", "mode==", "param", "sleep",
            "1e9", "3:", " ", "command", "lat<", "\t", "é", "takeoff"));
        std::string script;
        for (const std::string &word : words)
            script += word + (*rc::gen::arbitrary<bool>() ? " " : "");
        const auto steps = parseFlightScript(script);
        if (!steps)
            RC_ASSERT(steps.error().column <= script.size() + 1);
        else
            RC_ASSERT(!steps->empty());
    }));
}

void FlightScriptTest::stepsRoundTrip()
{
    QVERIFY(rc::check("toText and back", [] {
        const auto milli = rc::gen::map(rc::gen::inRange(-80000, 80001), [](int n) { return n / 1000.0; });
        const auto positive = rc::gen::map(rc::gen::inRange(1, 1000000), [](int n) { return n / 1000.0; });
        const auto actions = *rc::gen::inRange(0, 16);
        FlightStep step;
        if (*rc::gen::arbitrary<bool>())
            step.systemId = *rc::gen::inRange<std::uint8_t>(1, 255);
        switch (actions) {
        case 0: step.action = VehicleCommand(Arm{*rc::gen::arbitrary<bool>()}); break;
        case 1: step.action = VehicleCommand(Disarm{*rc::gen::arbitrary<bool>()}); break;
        case 2:
            step.action = VehicleCommand(
                TakeOff{*rc::gen::map(rc::gen::inRange(1, 9999), [](int n) { return n / 7.0 + 0.01; })});
            break;
        case 3: step.action = VehicleCommand(GoTo{*milli, *milli, *milli}); break;
        case 4: step.action = VehicleCommand(SetMode{*rc::gen::element<std::string>("RTL", "MODE(17)", "x")}); break;
        case 5: step.action = VehicleCommand(SetCurrentMissionItem{*rc::gen::arbitrary<std::uint16_t>()}); break;
        case 6: step.action = Sleep{std::chrono::milliseconds(*rc::gen::inRange(0, 86400000))}; break;
        case 7: step.action = WriteParameter{"WPNAV_SPEED", *milli}; break;
        case 8:
            step.action = VehicleCommand(
                RawCommand{*rc::gen::arbitrary<std::uint16_t>(), {1, 2.5f, static_cast<float>(*milli)}});
            break;
        case 9: step.action = VehicleCommand(ChangeSpeed{*positive}); break;
        case 10: step.action = VehicleCommand(ChangeAltitude{*positive}); break;
        case 11: step.action = VehicleCommand(PointAt{*milli, *milli, *milli}); break;
        case 12: step.action = VehicleCommand(StopPointing{}); break;
        case 13: step.action = VehicleCommand(SetHome{*milli, *milli}); break;
        default: {
            const auto &field = stateFields()[*rc::gen::inRange<std::size_t>(0, stateFields().size())];
            WaitUntil wait;
            wait.field = &field;
            const bool isText = field.kind == StateField::Kind::Text;
            wait.comparison = isText
                ? ComparisonOperator::NotEqual
                : *rc::gen::element(ComparisonOperator::AtLeast, ComparisonOperator::Less, ComparisonOperator::Equal);
            wait.text = isText ? "LAND" : "";
            wait.number = isText ? 0 : *milli;
            wait.timeout = std::chrono::milliseconds(*rc::gen::inRange(0, 86400000));
            step.action = wait;
        }
        }
        const std::string text = toText(step);
        const auto again = parseFlightScript(text);
        RC_LOG() << text;
        RC_ASSERT(again);
        RC_ASSERT(again->size() == 1u);
        RC_ASSERT(toText(again->front()) == text);
        RC_ASSERT(again->front().action.index() == step.action.index());
    }));
}

SKYSEAL_TEST_APPLESS(FlightScriptTest)
#include "flight_script_test.moc"
