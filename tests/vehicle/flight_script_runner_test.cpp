// Running a script against hand-made states and answers: what is asked when, and how each step is reported.
#include "core/vehicle/flight_script_runner.h"
#include "tests/support/test_runner.h"

#include "vehicle_harness.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class FlightScriptRunnerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsStepByStep();
    void refusedStepEndsTheScript();
    void waitTimesOutWithTheValue();
    void waitsForItsVehicle();
    void givesUpOnAVehicleThatNeverComes();
    void oldStatesAreNotBelieved();
    void sleepsAndWritesParameters();
    void answersToOthersAreIgnored();
    void noAnswerAtAll();
};

namespace {

struct Run
{
    explicit Run(std::string_view script) : runner(*parseFlightScript(script)) { states.reserve(8); }

    void advance(double s)
    {
        std::vector<const VehicleState *> views;
        for (const VehicleState &state : states)
            views.push_back(&state);
        runner.advance(at(s), views);
    }

    VehicleState &add(std::uint8_t id)
    {
        states.push_back({});
        states.back().systemId = id;
        return states.back();
    }

    /// Takes the request that must be there and answers it.
    ScriptRequest answer(CommandOutcome outcome, std::string reason = {})
    {
        const auto request = runner.pollRequest();
        if (!request)
            throw std::runtime_error("no request");
        runner.requestSent(RequestId{++lastId});
        runner.handleResult(CommandResult{RequestId{lastId}, request->systemId, outcome, 0, std::move(reason)});
        return *request;
    }

    FlightScriptRunner runner;
    std::vector<VehicleState> states;
    std::uint32_t lastId = 0;
};

} // namespace

void FlightScriptRunnerTest::runsStepByStep()
{
    Run run("mode GUIDED; arm; wait alt_rel>=9.5 60");
    auto &state = run.add(3);
    run.advance(0);
    QCOMPARE(std::get<SetMode>(std::get<VehicleCommand>(run.answer(CommandOutcome::Accepted).request)).mode,
             std::string("GUIDED"));
    const auto first = run.runner.pollReport();
    QVERIFY(first);
    QCOMPARE(first->systemId, std::uint8_t(3));
    QCOMPARE(first->number, std::size_t(1));
    QCOMPARE(first->step, std::string("mode GUIDED"));
    QCOMPARE(first->result, StepResult::Accepted);
    QCOMPARE(stepResultName(first->result), std::string_view("accepted"));
    QVERIFY(!run.runner.pollRequest()); // the next step begins with the next look
    run.advance(0.1);
    QVERIFY(std::holds_alternative<Arm>(std::get<VehicleCommand>(run.answer(CommandOutcome::Accepted).request)));
    run.runner.pollReport();
    run.advance(1);
    run.advance(2);
    QVERIFY(!run.runner.pollReport());
    state.altitudeRelative = 9.6;
    run.advance(3);
    const auto last = run.runner.pollReport();
    QVERIFY(last);
    QCOMPARE(last->result, StepResult::Reached);
    QCOMPARE(last->reason, std::string("alt_rel is 9.6"));
    QVERIFY(run.runner.finished() && !run.runner.failed());
}

void FlightScriptRunnerTest::refusedStepEndsTheScript()
{
    Run run("arm; land");
    run.add(1);
    run.advance(0);
    run.answer(CommandOutcome::Refused, "failed: PreArm: no");
    const auto report = run.runner.pollReport();
    QCOMPARE(report->result, StepResult::Refused);
    QCOMPARE(report->reason, std::string("failed: PreArm: no"));
    run.advance(1);
    QVERIFY(!run.runner.pollRequest());
    QVERIFY(run.runner.finished() && run.runner.failed());
}

void FlightScriptRunnerTest::waitTimesOutWithTheValue()
{
    Run run("wait alt_rel>=9.5 5; land");
    run.add(1).altitudeRelative = 3.25;
    run.advance(10);
    run.advance(14.9);
    QVERIFY(!run.runner.finished());
    run.advance(15);
    const auto report = run.runner.pollReport();
    QVERIFY(report);
    QCOMPARE(stepResultName(report->result), std::string_view("timeout"));
    QCOMPARE(report->reason, std::string("alt_rel is 3.25"));
    QVERIFY(run.runner.failed());
}

void FlightScriptRunnerTest::waitsForItsVehicle()
{
    Run run("2: arm; land");
    run.add(1);
    run.advance(0);
    QVERIFY(!run.runner.pollRequest());
    run.add(2);
    run.advance(29);
    QCOMPARE(run.answer(CommandOutcome::Accepted).systemId, std::uint8_t(2));
    run.advance(30);
    QCOMPARE(run.answer(CommandOutcome::Accepted).systemId, std::uint8_t(1)); // no prefix: the first one that was met
}

void FlightScriptRunnerTest::givesUpOnAVehicleThatNeverComes()
{
    Run run("arm");
    run.advance(100);
    run.advance(129.9);
    QVERIFY(!run.runner.finished());
    run.advance(130);
    const auto report = run.runner.pollReport();
    QVERIFY(report && run.runner.failed());
    QCOMPARE(report->systemId, std::uint8_t(0));
    QCOMPARE(report->result, StepResult::TimedOut);
}

void FlightScriptRunnerTest::oldStatesAreNotBelieved()
{
    Run run("arm; wait armed==0 90");
    auto &state = run.add(1); // still the state from before arming
    run.advance(0);
    run.answer(CommandOutcome::Accepted);
    run.runner.pollReport();
    run.advance(0.01);
    QVERIFY(!run.runner.pollReport());
    state.armed = true;
    run.advance(0.3);
    QVERIFY(!run.runner.pollReport());
    state.armed = false;
    run.advance(40);
    QCOMPARE(run.runner.pollReport()->result, StepResult::Reached);
}

void FlightScriptRunnerTest::sleepsAndWritesParameters()
{
    Run run("sleep 2; param WPNAV_SPEED 750; sleep 0");
    run.add(1);
    run.advance(0);
    run.advance(1.9);
    QVERIFY(!run.runner.pollRequest());
    run.advance(2);
    const auto request = run.runner.pollRequest();
    QVERIFY(request);
    QCOMPARE(std::get<WriteParameter>(request->request).value, 750.);
    run.runner.requestSent(RequestId{7});
    run.runner.handleResult(ParameterResult{RequestId{6}, 1, {"WPNAV_SPEED", 750}, true});
    QVERIFY(run.runner.pollReport() && !run.runner.pollReport()); // only the sleep's
    run.runner.handleResult(ParameterResult{RequestId{7}, 1, {"WPNAV_SPEED", 750}, true});
    QCOMPARE(run.runner.pollReport()->result, StepResult::Accepted);
    run.advance(3);
    QVERIFY(run.runner.finished());
}

void FlightScriptRunnerTest::answersToOthersAreIgnored()
{
    Run run("arm; arm");
    run.add(1);
    run.advance(0);
    QVERIFY(run.runner.pollRequest());
    run.runner.requestSent(RequestId{50});
    run.runner.handleResult(CommandResult{RequestId{49}, 1, CommandOutcome::Refused, 4, {}});
    QVERIFY(!run.runner.pollReport());
    run.runner.handleResult(CommandResult{RequestId{50}, 1, CommandOutcome::Accepted, 0, {}});
    QVERIFY(run.runner.pollReport());
    run.advance(1);
    QVERIFY(run.runner.pollRequest());
    run.runner.handleResult(CommandResult{RequestId{50}, 1, CommandOutcome::Refused, 4, {}}); // late, and not of this step
    QVERIFY(!run.runner.failed());
}

void FlightScriptRunnerTest::noAnswerAtAll()
{
    Run run("arm");
    run.add(1);
    run.advance(0);
    run.runner.pollRequest();
    run.runner.requestSent(RequestId{1});
    run.advance(59.9);
    QVERIFY(!run.runner.finished());
    run.advance(60);
    QCOMPARE(run.runner.pollReport()->reason, std::string("no answer"));
}

SKYSEAL_TEST_APPLESS(FlightScriptRunnerTest)
#include "flight_script_runner_test.moc"
