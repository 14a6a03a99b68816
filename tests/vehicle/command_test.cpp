// Commands against a scripted vehicle: exact times of the retries, fallbacks for old firmware, and how each ending is
// worded.
#include "core/vehicle/commander.h"
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/mavlink/px4_mode.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class CommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void repeatsOnceASecondWithARisingConfirmation();
    void progressExtendsTheWait();
    void nothingIsSentAfterASleep_data();
    void nothingIsSentAfterASleep();
    void shortStallChangesNothing();
    void armingIsConfirmedByTheHeartbeat();
    void heartbeatProvesWhatALostAckDidNot();
    void refusedRepetitionOfATakeOffCountsForNothingInTheAir_data();
    void refusedRepetitionOfATakeOffCountsForNothingInTheAir();
    void refusedRepetitionWithoutItsEffectIsARefusal();
    void refusedRepetitionOfAnyCommandIsJudgedByItsEffect();
    void acknowledgedButNotDoneTimesOut();
    void reasonMayComeBeforeTheRefusal();
    void reasonMayComeAfterTheRefusal();
    void refusalWithoutAReasonDoesNotWaitLong();
    void modeFallsBackToTheOldMessage();
    void oldMessageMayBeAcknowledgedByItsId();
    void unknownModeNamesThoseThatExist();
    void takeOffStatesItsPreconditions();
    void takeOffPreparesPx4();
    void takeOffPreparesArduCopter();
    void missionIsStartedInSteps();
    void stepsThatFailAreNamed_data();
    void stepsThatFailAreNamed();
    void disarmingEndsAStart();
    void disarmingInTheAirTakesForce();
    void newerModeReplacesTheOneUnderWay();
    void disarmReplacesArm();
    void sameRawCommandsTakeTurns();
    void ackForAnotherStationIsIgnored();
    void goToFallsBackToATargetAndIsConfirmedByItsEcho();
    void goToWithoutAnEchoSaysSo();
    void landAndReturnAreModesOnArduPilot();
    void px4GetsCommandsAndMainModes();
    void missionItemIsConfirmedByMissionCurrent();
    void everyCommandEndsExactlyOnce();
};

namespace {
constexpr std::uint16_t kArm = mavlink::MAV_CMD_COMPONENT_ARM_DISARM, kSetMode = mavlink::MAV_CMD_DO_SET_MODE;
constexpr std::uint16_t kTakeOff = mavlink::MAV_CMD_NAV_TAKEOFF;
constexpr std::uint8_t kAccepted = 0, kDenied = 2, kUnsupported = 3, kFailed = 4, kInProgress = 5;

mavlink::ExtendedSysState extendedState(std::uint8_t landed)
{
    mavlink::ExtendedSysState out;
    out.landed_state = landed;
    return out;
}
} // namespace

void CommandTest::repeatsOnceASecondWithARisingConfirmation()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{7}, RawCommand{246, {1, 2, 3, 4, 5, 6, 7}});
    for (int attempt = 0; attempt < 5; ++attempt) {
        const auto sent = h.nextSent<mavlink::CommandLong>(at(200));
        QVERIFY(sent);
        QCOMPARE(sent->first, at(100 + attempt));
        QCOMPARE(int(sent->second.confirmation), attempt);
        QCOMPARE(sent->second.command, std::uint16_t(246));
        QCOMPARE(sent->second.param7, 7.f);
        QCOMPARE(sent->second.target_system, std::uint8_t(1));
    }
    h.runUntil(at(104.999));
    QVERIFY(!h.poll<CommandResult>());
    h.runUntil(at(105));
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QCOMPARE(result->id, RequestId{7});
    QCOMPARE(result->outcome, CommandOutcome::TimedOut);
    QCOMPARE(result->reason.text(), std::string("no answer to 5 attempts"));
    QVERIFY(result->changeUnanswered);
}

void CommandTest::nothingIsSentAfterASleep_data()
{
    QTest::addColumn<bool>("frameFirst");
    QTest::newRow("the deadline first") << false;
    QTest::newRow("an old acknowledgement first") << true;
}

void CommandTest::nothingIsSentAfterASleep()
{
    QFETCH(bool, frameFirst);
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
    h.vehicle.perform(h.now, RequestId{2}, RawCommand{246, {}});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
    h.now += std::chrono::hours(1);
    if (frameFirst)
        h.ack(kArm, kUnsupported);
    h.vehicle.handleDeadline(h.now);
    for (std::uint32_t id = 1; id <= 2; ++id) {
        const auto result = h.poll<CommandResult>();
        QVERIFY(result);
        QCOMPARE(result->id, RequestId{id});
        QCOMPARE(result->outcome, CommandOutcome::TimedOut);
        QCOMPARE(result->reason.text(),
                 std::string("no answer yet, and not sent again: this program was suspended for 3599 s"));
        QVERIFY(!result->changeUnanswered);
    }
    for (const TimePoint end = h.now + std::chrono::seconds(20); h.now < end; h.now += std::chrono::milliseconds(100)) {
        h.vehicle.handleDeadline(h.now);
        for (const mavlink::CommandLong &command : h.sentOf<mavlink::CommandLong>())
            QVERIFY(command.command != kArm && command.command != 246);
    }
    h.vehicle.perform(h.now, RequestId{3}, Arm{}); // a fresh order is sent
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
}

void CommandTest::shortStallChangesNothing()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
    h.now += std::chrono::milliseconds(3900); // 2.9 s after the deadline
    h.vehicle.handleDeadline(h.now);
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
    QVERIFY(!h.poll<CommandResult>());
}

void CommandTest::progressExtendsTheWait()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, RawCommand{241, {}});
    for (int i = 0; i < 3; ++i) {
        h.ack(241, kInProgress);
        h.runUntil(h.now + std::chrono::seconds(9));
        QVERIFY(!h.poll<CommandResult>());
    }
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1)); // not repeated while it is being done
    h.ack(241, kAccepted);
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::armingIsConfirmedByTheHeartbeat()
{
    Harness h = Harness::copter(4);
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.ack(kArm, kAccepted);
    QVERIFY(!h.poll<CommandResult>()); // until it is seen, too
    h.feed(heartbeat(4, false));
    QVERIFY(!h.poll<CommandResult>());
    h.feed(heartbeat(4, true));
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    QVERIFY(h.vehicle.current().armed);
}

void CommandTest::heartbeatProvesWhatALostAckDidNot()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{true});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).param2, 2989.f);
    h.feed(heartbeat(0, true));
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);

    // But a state that was there before proves nothing about this command.
    h.vehicle.perform(h.now, RequestId{2}, Arm{});
    h.feed(heartbeat(0, true));
    QVERIFY(!h.poll<CommandResult>());
}

void CommandTest::refusedRepetitionOfATakeOffCountsForNothingInTheAir_data()
{
    QTest::addColumn<bool>("climbsBefore");
    QTest::newRow("seen to climb before the refusal") << true;
    QTest::newRow("seen to climb after the refusal") << false;
}

/// The acknowledgement is lost, and a copter that climbs refuses the repetition.
void CommandTest::refusedRepetitionOfATakeOffCountsForNothingInTheAir()
{
    QFETCH(bool, climbsBefore);
    Harness h = Harness::copter(4, true);
    h.feed(extendedState(mavlink::MAV_LANDED_STATE_ON_GROUND));
    h.feed(heartbeat(4, true));
    QVERIFY(!h.vehicle.state(h.now).inAir);
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{10});
    h.sent();
    QVERIFY(h.nextSent<mavlink::CommandLong>(at(101)));
    const auto climb = [&] {
        h.feed(extendedState(mavlink::MAV_LANDED_STATE_TAKEOFF));
        mavlink::GlobalPositionInt position;
        position.relative_alt = 900;
        h.feed(position);
    };
    if (climbsBefore)
        climb();
    h.feed(statusText("Takeoff: already flying"));
    h.ack(kTakeOff, kFailed);
    if (!climbsBefore) {
        QVERIFY(!h.poll<CommandResult>());
        h.runUntil(h.now + std::chrono::milliseconds(900)); // longer than a reason takes
        climb();
        h.feed(heartbeat(4, true));
    }
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QVERIFY2(result->outcome == CommandOutcome::Accepted, result->reason.text().c_str());
    QCOMPARE(result->result, kAccepted);
    h.runUntil(h.now + std::chrono::seconds(10));
    QVERIFY(h.sentOf<mavlink::CommandLong>().empty());
    QVERIFY(!h.poll<CommandResult>());
}

/// On the ground it is a refusal, and so is that of the first transmission, whatever the vehicle does.
void CommandTest::refusedRepetitionWithoutItsEffectIsARefusal()
{
    Harness h = Harness::copter(4, true);
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{10});
    h.runUntil(at(101));
    h.ack(kTakeOff, kFailed);
    h.feed(statusText("Takeoff: wait for the estimator"));
    h.feed(heartbeat(4, true));
    h.runUntil(h.now + Commander::kConfirmTimeout);
    const auto repeated = h.poll<CommandResult>();
    QVERIFY(repeated);
    QCOMPARE(repeated->outcome, CommandOutcome::Refused);
    QCOMPARE(repeated->reason.text(), std::string("failed: Takeoff: wait for the estimator"));

    h.vehicle.perform(h.now, RequestId{2}, TakeOff{10});
    h.feed(extendedState(mavlink::MAV_LANDED_STATE_TAKEOFF));
    h.ack(kTakeOff, kFailed);
    h.runUntil(h.now + Commander::kReasonTimeout);
    const auto first = h.poll<CommandResult>();
    QVERIFY(first);
    QCOMPARE(first->outcome, CommandOutcome::Refused);

    // In the air already, the state says nothing about this command.
    h.feed(heartbeat(4, true));
    QVERIFY(h.vehicle.current().inAir);
    h.vehicle.perform(h.now, RequestId{3}, TakeOff{10});
    h.runUntil(h.now + std::chrono::seconds(1));
    h.ack(kTakeOff, kFailed);
    h.feed(heartbeat(4, true));
    h.runUntil(h.now + Commander::kReasonTimeout);
    const auto flying = h.poll<CommandResult>();
    QVERIFY(flying);
    QCOMPARE(flying->outcome, CommandOutcome::Refused);
}

void CommandTest::refusedRepetitionOfAnyCommandIsJudgedByItsEffect()
{
    const std::pair<VehicleCommand, mavlink::Heartbeat> commands[] = {
        {Arm{}, heartbeat(4, true)}, {Disarm{}, heartbeat(4, false)}, {SetMode{"LOITER"}, heartbeat(5, false)}};
    for (const auto &[command, effect] : commands) {
        Harness h = Harness::copter(4, std::holds_alternative<Disarm>(command));
        h.vehicle.perform(h.now, RequestId{1}, command);
        h.runUntil(at(101));
        h.ack(std::holds_alternative<SetMode>(command) ? kSetMode : kArm, kDenied);
        h.runUntil(at(101.9));
        QVERIFY(!h.poll<CommandResult>());
        h.feed(effect);
        const auto result = h.poll<CommandResult>();
        QVERIFY(result);
        QVERIFY2(result->outcome == CommandOutcome::Accepted, result->reason.text().c_str());
    }
}

void CommandTest::acknowledgedButNotDoneTimesOut()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.ack(kArm, kAccepted);
    for (int i = 0; i < 4; ++i) {
        h.runUntil(h.now + std::chrono::seconds(1));
        h.feed(heartbeat(0, false));
    }
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QCOMPARE(result->outcome, CommandOutcome::TimedOut);
    QCOMPARE(result->reason.text(), std::string("acknowledged, but the vehicle reports disarmed"));

    h.vehicle.perform(h.now, RequestId{2}, Arm{});
    h.ack(kArm, kAccepted);
    h.runUntil(h.now + std::chrono::seconds(4));
    const auto unseen = h.poll<CommandResult>();
    QVERIFY(unseen);
    QCOMPARE(unseen->outcome, CommandOutcome::Accepted);
    QCOMPARE(unseen->reason.text(), std::string("acknowledged; no heartbeat since"));
}

void CommandTest::reasonMayComeBeforeTheRefusal()
{
    Harness h = Harness::copter();
    h.feed(statusText("an older text"));
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.feed(statusText("PreArm: Compass not healthy"));
    h.feed(statusText("chatter", 6));
    h.ack(kArm, kFailed);
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QCOMPARE(result->outcome, CommandOutcome::Refused);
    QCOMPARE(result->result, kFailed);
    QCOMPARE(result->reason.text(), std::string("failed: PreArm: Compass not healthy"));
}

void CommandTest::reasonMayComeAfterTheRefusal()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.ack(kArm, kFailed);
    QVERIFY(!h.poll<CommandResult>());
    h.runUntil(at(100.3));
    h.feed(statusText("Arm: Throttle too high"));
    QCOMPARE(h.poll<CommandResult>()->reason.text(), std::string("failed: Arm: Throttle too high"));
}

void CommandTest::refusalWithoutAReasonDoesNotWaitLong()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.ack(kArm, kDenied);
    h.runUntil(at(100.7));
    QCOMPARE(h.poll<CommandResult>()->reason.text(), std::string("denied"));
}

void CommandTest::modeFallsBackToTheOldMessage()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, SetMode{"guided"});
    const auto command = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(command.size(), std::size_t(1));
    QCOMPARE(command[0].command, kSetMode);
    QCOMPARE(command[0].param1, 1.f);
    QCOMPARE(command[0].param2, 4.f);
    h.ack(kSetMode, kUnsupported);
    const auto message = h.sentOf<mavlink::SetMode>();
    QCOMPARE(message.size(), std::size_t(1));
    QCOMPARE(message[0].custom_mode, 4u);
    h.runUntil(at(102.5));
    QCOMPARE(h.sentOf<mavlink::SetMode>().size(), std::size_t(2));
    h.feed(heartbeat(4));
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    QCOMPARE(h.vehicle.current().mode, std::string("GUIDED"));
}

void CommandTest::oldMessageMayBeAcknowledgedByItsId()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, SetMode{"AUTO"});
    h.ack(kSetMode, kUnsupported);
    h.ack(mavlink::SetMode::kId, kFailed, 0);
    h.feed(statusText("Mode change to AUTO failed: missing mission", 4));
    QCOMPARE(h.poll<CommandResult>()->reason.text(), std::string("failed: Mode change to AUTO failed: missing mission"));
}

void CommandTest::unknownModeNamesThoseThatExist()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, SetMode{"WARP"});
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QCOMPARE(result->outcome, CommandOutcome::Refused);
    QVERIFY(result->reason.text().find("'WARP'") != std::string::npos);
    QVERIFY(result->reason.text().find("STABILIZE, ACRO, ALT_HOLD") != std::string::npos);
    QVERIFY(h.sent().empty());
}

void CommandTest::takeOffStatesItsPreconditions()
{
    Harness h = Harness::copter(0, false);
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{10});
    QCOMPARE(h.poll<CommandResult>()->reason.text(),
             std::string("nothing was sent: take-off needs the mode GUIDED, the vehicle is in STABILIZE"));
    h.feed(heartbeat(4, false));
    h.vehicle.perform(h.now, RequestId{2}, TakeOff{10});
    QCOMPARE(h.poll<CommandResult>()->reason.text(),
             std::string("nothing was sent: take-off needs an armed vehicle, it is disarmed"));
    h.feed(heartbeat(4, true));
    h.vehicle.perform(h.now, RequestId{3}, TakeOff{-1});
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Refused);
    QVERIFY(h.sent().empty());
    h.vehicle.perform(h.now, RequestId{4}, TakeOff{12.5});
    const auto sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_NAV_TAKEOFF));
    QCOMPARE(sent[0].param7, 12.5f);
    h.ack(mavlink::MAV_CMD_NAV_TAKEOFF, kAccepted);
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

/// PX4 would accept the take-off at once, and fly it when it is armed at some later time.
void CommandTest::takeOffPreparesPx4()
{
    Harness h = Harness::px4();
    const auto beat = [&](bool armed) {
        h.feed(heartbeat(mavlink::kPx4AutoLoiter, armed, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    };
    beat(false);
    h.feed(mavlink::HomePosition{.latitude = 474000000, .longitude = 85000000, .altitude = 488000});
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{9});
    QCOMPARE(h.poll<CommandResult>()->reason.text(),
             std::string("nothing was sent: take-off needs an armed vehicle, it is disarmed"));
    QVERIFY(h.sent().empty());

    h.vehicle.perform(h.now, RequestId{2}, TakeOff{.altitude = 9, .prepare = true});
    auto sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    QCOMPARE(sent[0].param1, 1.f);
    h.ack(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, kAccepted);
    QVERIFY(h.sent().empty()); // not before a heartbeat says so
    beat(true);
    sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_NAV_TAKEOFF));
    QCOMPARE(sent[0].param7, 497.f);
    QVERIFY(!h.poll<CommandResult>());
    h.ack(mavlink::MAV_CMD_NAV_TAKEOFF, kAccepted);
    const auto result = h.poll<CommandResult>();
    QVERIFY(result && result->outcome == CommandOutcome::Accepted);
    QCOMPARE(result->id, RequestId{2});
    h.runUntil(at(200));
    QVERIFY(!h.poll<CommandResult>());
    QVERIFY(h.sentOf<mavlink::CommandLong>().empty());
}

void CommandTest::takeOffPreparesArduCopter()
{
    Harness h = Harness::copter(mavlink::COPTER_MODE_LOITER, false);
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{.altitude = 10, .prepare = true});
    auto sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.at(0).command, kSetMode);
    QCOMPARE(sent.at(0).param2, float(mavlink::COPTER_MODE_GUIDED));
    h.ack(kSetMode, kAccepted);
    h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, false));
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true)); // its acknowledgement was lost
    sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_NAV_TAKEOFF));
    QCOMPARE(sent[0].param7, 10.f);
    h.ack(mavlink::MAV_CMD_NAV_TAKEOFF, kAccepted);
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    QVERIFY(!h.poll<CommandResult>());
}

void CommandTest::missionIsStartedInSteps()
{
    Harness px4 = Harness::px4();
    const auto beat = [&](std::uint32_t mode, bool armed) {
        px4.feed(heartbeat(mode, armed, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    };
    beat(mavlink::kPx4AutoLoiter, false);
    px4.vehicle.perform(px4.now, RequestId{1}, StartMission{.prepare = true});
    QCOMPARE(px4.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    beat(mavlink::kPx4AutoLoiter, true);
    const auto mode = px4.sentOf<mavlink::CommandLong>();
    QCOMPARE(mode.at(0).command, kSetMode);
    QCOMPARE(mode.at(0).param3, 4.f); // the sub mode of missions
    px4.ack(kSetMode, kAccepted);
    QCOMPARE(px4.poll<CommandResult>()->outcome, CommandOutcome::Accepted);

    Harness copter = Harness::copter(mavlink::COPTER_MODE_GUIDED, false);
    copter.vehicle.perform(copter.now, RequestId{1}, StartMission{.prepare = true});
    QCOMPARE(copter.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    copter.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true));
    QCOMPARE(copter.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_MISSION_START));
    copter.ack(mavlink::MAV_CMD_MISSION_START, kAccepted);
    QCOMPARE(copter.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::stepsThatFailAreNamed_data()
{
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("reason");
    QTest::newRow("mode") << "mode"
                          << "the mode GUIDED was not entered: failed: requires position";
    QTest::newRow("arming") << "arming"
                            << "the vehicle was not armed: failed: requires position";
    QTest::newRow("take-off") << "take-off"
                              << "failed: requires position; the vehicle is armed";
    QTest::newRow("arming without a heartbeat") << "silent"
                                                << "the vehicle was not armed: acknowledged; no heartbeat since";
    QTest::newRow("a mode that does not last")
        << "restless"
        << "the vehicle was not ready for it, and is in STABILIZE now; the vehicle is armed";
}

void CommandTest::stepsThatFailAreNamed()
{
    QFETCH(QString, where);
    Harness h = Harness::copter(0, false);
    h.vehicle.perform(h.now, RequestId{1}, TakeOff{.altitude = 10, .prepare = true});
    const auto refuse = [&](std::uint16_t command) {
        h.ack(command, kFailed);
        h.feed(statusText("requires position", 4));
    };
    if (where == QLatin1String("mode")) {
        refuse(kSetMode);
    } else {
        h.ack(kSetMode, kAccepted);
        h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, false));
        if (where == QLatin1String("arming")) {
            refuse(kArm);
        } else if (where == QLatin1String("silent")) {
            h.ack(kArm, kAccepted);
            h.runUntil(at(110));
        } else if (where == QLatin1String("restless")) {
            h.feed(heartbeat(0, true)); // someone else changed it
        } else {
            h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true));
            refuse(mavlink::MAV_CMD_NAV_TAKEOFF);
        }
    }
    const auto result = h.poll<CommandResult>();
    QVERIFY(result && result->outcome != CommandOutcome::Accepted);
    QTEST(QString::fromStdString(result->reason.text()), "reason");
    h.sent();
    h.runUntil(at(200));
    QVERIFY(h.sentOf<mavlink::CommandLong>().empty());
    QVERIFY(!h.poll<CommandResult>());
}

void CommandTest::disarmingEndsAStart()
{
    for (const bool armed : {false, true}) {
        Harness h = Harness::copter(mavlink::COPTER_MODE_GUIDED, armed);
        h.vehicle.perform(h.now, RequestId{1}, TakeOff{.altitude = 10, .prepare = true});
        h.vehicle.perform(h.now, RequestId{2}, Disarm{});
        const auto ended = h.poll<CommandResult>();
        QVERIFY(ended && ended->id == RequestId{1} && ended->outcome == CommandOutcome::Refused);
        h.sent();
        h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true));
        h.runUntil(at(101.5));
        for (const auto &command : h.sentOf<mavlink::CommandLong>())
            QVERIFY(command.command == mavlink::MAV_CMD_COMPONENT_ARM_DISARM && command.param1 == 0);
    }
}

void CommandTest::disarmingInTheAirTakesForce()
{
    Harness h = Harness::copter(mavlink::COPTER_MODE_GUIDED, true);
    h.feed(mavlink::ExtendedSysState{.vtol_state = 0, .landed_state = mavlink::MAV_LANDED_STATE_IN_AIR});
    h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true));
    h.vehicle.perform(h.now, RequestId{1}, Disarm{});
    QCOMPARE(h.poll<CommandResult>()->reason.text(),
             std::string("nothing was sent: the vehicle is in the air; only an emergency stop ends its motors"));
    QVERIFY(h.sent().empty());
    h.vehicle.perform(h.now, RequestId{2}, Disarm{.force = true});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    h.feed(mavlink::ExtendedSysState{.vtol_state = 0, .landed_state = mavlink::MAV_LANDED_STATE_ON_GROUND});
    h.feed(heartbeat(mavlink::COPTER_MODE_GUIDED, true));
    h.sent();
    h.vehicle.perform(h.now, RequestId{3}, Disarm{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));

    Harness rover = Harness::copter();
    rover.feed(heartbeat(mavlink::ROVER_MODE_HOLD, true, mavlink::MAV_TYPE_GROUND_ROVER));
    rover.feed(mavlink::ExtendedSysState{.vtol_state = 0, .landed_state = mavlink::MAV_LANDED_STATE_IN_AIR}); // it drives
    rover.feed(heartbeat(mavlink::ROVER_MODE_HOLD, true, mavlink::MAV_TYPE_GROUND_ROVER));
    rover.sent();
    rover.vehicle.perform(rover.now, RequestId{1}, Disarm{});
    QCOMPARE(rover.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
}

void CommandTest::newerModeReplacesTheOneUnderWay()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, SetMode{"LOITER"});
    h.runUntil(at(100.5));
    h.vehicle.perform(h.now, RequestId{2}, ReturnToLaunch{}); // in a hurry: does not wait for the first one to end
    const auto first = h.poll<CommandResult>();
    QVERIFY(first);
    QCOMPARE(first->id, RequestId{1});
    QCOMPARE(first->reason.text(), std::string("replaced by a newer command"));
    const auto sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(2));
    QCOMPARE(sent[1].param2, 6.f);

    // The acknowledgement is that of the first; the newer one was lost. It is asked again, since the mode says otherwise.
    h.ack(kSetMode, kAccepted);
    for (int i = 0; i < 4; ++i) {
        h.runUntil(h.now + std::chrono::seconds(1));
        h.feed(heartbeat(5));
    }
    QVERIFY(!h.poll<CommandResult>());
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).param2, 6.f);
    h.ack(kSetMode, kAccepted);
    h.feed(heartbeat(6));
    const auto second = h.poll<CommandResult>();
    QVERIFY(second);
    QCOMPARE(second->id, RequestId{2});
    QCOMPARE(second->outcome, CommandOutcome::Accepted);
}

void CommandTest::disarmReplacesArm()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, Arm{});
    h.vehicle.perform(h.now, RequestId{2}, Disarm{true});
    QCOMPARE(h.poll<CommandResult>()->id, RequestId{1});
    const auto sent = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(sent.size(), std::size_t(2));
    QCOMPARE(sent[1].param1, 0.f);
    QCOMPARE(sent[1].param2, 21196.f);
    h.ack(kArm, kAccepted);
    h.feed(heartbeat(0, false));
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::sameRawCommandsTakeTurns()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, RawCommand{183, {1, 1100}});
    h.vehicle.perform(h.now, RequestId{2}, RawCommand{183, {2, 1200}});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().size(), std::size_t(1));
    h.ack(183, kAccepted);
    QCOMPARE(h.poll<CommandResult>()->id, RequestId{1});
    const auto second = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(second.size(), std::size_t(1));
    QCOMPARE(second[0].param1, 2.f);
    h.ack(183, kAccepted);
    QCOMPARE(h.poll<CommandResult>()->id, RequestId{2});
}

void CommandTest::ackForAnotherStationIsIgnored()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, RawCommand{183, {}});
    h.ack(183, kFailed, 254);
    h.runUntil(at(100.9));
    QVERIFY(!h.poll<CommandResult>());
    h.ack(183, kAccepted, 0); // MAVLink 1 has no targets in it
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::goToFallsBackToATargetAndIsConfirmedByItsEcho()
{
    Harness h = Harness::copter(0, true);
    const GoTo place{-35.3625, 149.1655, 25};
    h.vehicle.perform(h.now, RequestId{1}, place);
    QCOMPARE(h.poll<CommandResult>()->reason.text(),
             std::string("nothing was sent: going to a location needs the mode GUIDED, the vehicle is in STABILIZE"));
    h.feed(heartbeat(4, true));
    h.vehicle.perform(h.now, RequestId{2}, place);
    const auto reposition = h.sentOf<mavlink::CommandInt>();
    QCOMPARE(reposition.size(), std::size_t(1));
    QCOMPARE(reposition[0].x, -353625000);
    QCOMPARE(reposition[0].z, 25.f);
    h.ack(mavlink::MAV_CMD_DO_REPOSITION, kUnsupported);
    const auto target = h.sentOf<mavlink::SetPositionTargetGlobalInt>();
    QCOMPARE(target.size(), std::size_t(1));
    QCOMPARE(target[0].lon_int, 1491655000);
    QCOMPARE(target[0].coordinate_frame, std::uint8_t(6));
    mavlink::PositionTargetGlobalInt echo;
    echo.lat_int = -353625003;
    echo.lon_int = 1491654998;
    h.feed(echo);
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::goToWithoutAnEchoSaysSo()
{
    Harness h = Harness::copter(4, true);
    h.vehicle.perform(h.now, RequestId{1}, GoTo{1, 2, 3});
    h.ack(mavlink::MAV_CMD_DO_REPOSITION, kUnsupported);
    h.runUntil(at(106));
    QCOMPARE(h.sentOf<mavlink::SetPositionTargetGlobalInt>().size(), std::size_t(5));
    const auto result = h.poll<CommandResult>();
    QVERIFY(result);
    QCOMPARE(result->reason.text(), std::string("sent 5 times; the vehicle does not confirm it"));
}

void CommandTest::landAndReturnAreModesOnArduPilot()
{
    Harness h = Harness::copter(4, true);
    h.vehicle.perform(h.now, RequestId{1}, Land{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).param2, 9.f);
    h.feed(heartbeat(9, true));
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    h.vehicle.perform(h.now, RequestId{2}, ReturnToLaunch{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).param2, 6.f);
}

void CommandTest::px4GetsCommandsAndMainModes()
{
    Harness h;
    h.feed(heartbeat(4u << 16 | 3u << 24, true, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    h.sent();
    QCOMPARE(h.vehicle.current().mode, std::string("LOITER"));
    h.vehicle.perform(h.now, RequestId{1}, SetMode{"MISSION"});
    const auto mode = h.sentOf<mavlink::CommandLong>();
    QCOMPARE(mode.at(0).param2, 4.f);
    QCOMPARE(mode.at(0).param3, 4.f);
    h.vehicle.perform(h.now, RequestId{2}, Land{});
    QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_NAV_LAND));
}

void CommandTest::missionItemIsConfirmedByMissionCurrent()
{
    Harness h = Harness::copter(3, true);
    h.vehicle.perform(h.now, RequestId{1}, SetCurrentMissionItem{3});
    QCOMPARE(h.sentOf<mavlink::MissionSetCurrent>().at(0).seq, std::uint16_t(3));
    mavlink::MissionCurrent current;
    current.seq = 2;
    h.feed(current);
    QVERIFY(!h.poll<CommandResult>());
    current.seq = 3;
    h.feed(current);
    QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
}

void CommandTest::everyCommandEndsExactlyOnce()
{
    Harness h = Harness::copter(4, true);
    const VehicleCommand all[] = {Arm{},
                                  Disarm{},
                                  TakeOff{},
                                  Land{},
                                  ReturnToLaunch{},
                                  SetMode{"AUTO"},
                                  GoTo{1, 1, 1},
                                  ChangeAltitude{5},
                                  Loiter{},
                                  PointAt{1, 1},
                                  StopPointing{},
                                  SetHome{1, 1},
                                  ChangeSpeed{5},
                                  SetCurrentMissionItem{1},
                                  StartMission{},
                                  Reboot{},
                                  RawCommand{1, {}},
                                  RawCommand{1, {}}};
    std::vector<int> ended(200);
    std::uint32_t id = 0;
    for (int round = 0; round < 5; ++round) {
        for (const VehicleCommand &command : all)
            h.vehicle.perform(h.now, RequestId{id++}, command);
    }
    h.runUntil(at(400));
    while (const auto result = h.poll<CommandResult>())
        ++ended[static_cast<std::uint32_t>(result->id)];
    for (std::uint32_t i = 0; i < id; ++i)
        QCOMPARE(ended[i], 1);
    QCOMPARE(h.vehicle.current().systemId, std::uint8_t(1));
}

SKYSEAL_TEST_APPLESS(CommandTest)
#include "command_test.moc"
