// Which frames of the ground an agent forwards, how it counts the others, and when a pairing is possible.
#include "core/engine/agent/armed_vehicles.h"
#include "core/engine/agent/command_gate.h"
#include "core/engine/agent/ground_sessions.h"
#include "core/engine/agent/repeated_refusals.h"
#include "core/engine/agent/vehicle_routes.h"
#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr channel::SessionId kPilot{1}, kObserver{2};

channel::Peer peer(std::uint8_t number, channel::PeerRole role)
{
    channel::Peer out;
    out.key[0] = number;
    out.name = "peer-" + std::to_string(number);
    out.role = role;
    return out;
}

struct Gate : CommandGate
{
    Gate()
    {
        const channel::Peer pilot = peer(1, channel::PeerRole::Pilot), observer = peer(2, channel::PeerRole::Observer);
        setPeers({pilot, observer});
        sessionUp({kPilot, pilot.key, pilot.name, {}, {}});
        sessionUp({kObserver, observer.key, observer.name, {}, {}});
    }
    bool take(channel::SessionId session, const QByteArray &frame, channel::Freshness freshness = channel::Freshness::Fresh)
    {
        mavlink::FrameScanner scanner(viewOf(frame), mavlink::Dialect::builtin());
        channel::Delivery delivery;
        delivery.session = session;
        delivery.freshness = freshness;
        return accept(now, delivery, *scanner.next(), [](std::uint8_t systemId) { return systemId == 1; });
    }
    TimePoint now{};

    AgentCounters counters() const
    {
        AgentCounters out;
        addTo(out);
        return out;
    }
};

QByteArray armCommand()
{
    mavlink::CommandLong command;
    command.target_system = 1;
    command.command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM;
    command.param1 = 1;
    return frameOf(command, 255);
}

bool note(ArmedVehicles &armed, const QByteArray &heartbeat)
{
    return armed.note(*mavlink::readFrame(viewOf(heartbeat), mavlink::Dialect::builtin()));
}

} // namespace

class CommandGateTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void observerDoesNotCommand();
    void nobodySpeaksAsTheVehicle();
    void heartbeatsOfAnObserverAreOnlyCounted();
    void questionsAreLimitedForEachPeer();
    void groundSystemsAreThoseOfPilots();
    void observersIdIsNoGroundSystem();
    void lateFramesHaveTheRightsOfAnObserver();
    void anyArmedVehicleCounts();
    void onlyVehicleIsNamed();
    void lossOfEachStationIsItsOwn();
    void repeatedRefusalsAreMerged();
};

void CommandGateTest::repeatedRefusalsAreMerged()
{
    RepeatedRefusals refusals;
    TimePoint now{std::chrono::hours(1)};
    const FramesRefused arm{FramesRefused::Reason::Observer,       "vm", mavlink::CommandLong::kId, "COMMAND_LONG",
                            mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 1};
    FramesRefused takeOff = arm;
    takeOff.command = mavlink::MAV_CMD_NAV_TAKEOFF;
    QVERIFY(refusals.isNew(now, arm));
    QVERIFY(refusals.isNew(now, takeOff)); // another command
    for (int retry = 0; retry < 4; ++retry) {
        now += std::chrono::seconds(2);
        QVERIFY(!refusals.isNew(now, arm));
        QVERIFY(refusals.takeDue(now).empty());
    }
    now += std::chrono::seconds(2);
    const auto merged = refusals.takeDue(now);
    QCOMPARE(merged.size(), std::size_t(1));
    QCOMPARE(merged[0].frames, std::uint64_t(4));
    QCOMPARE(merged[0].command, arm.command);
    QVERIFY(!refusals.isNew(now, arm));
    QCOMPARE(refusals.takeDue(kNever).size(), std::size_t(1)); // at the end of the program
    RepeatedRefusals later;
    QVERIFY(later.isNew(now, arm));
    QVERIFY(later.takeDue(now + RepeatedRefusals::kWindow).empty());
    QVERIFY(later.isNew(now + RepeatedRefusals::kWindow, arm)); // not a repetition any more
}

void CommandGateTest::lateFramesHaveTheRightsOfAnObserver()
{
    using channel::Freshness;
    mavlink::ParamRequestList question;
    question.target_system = 1;
    question.target_component = 1;
    for (const Freshness late : {Freshness::Overtaken, Freshness::TooOld, Freshness::AfterClose}) {
        Gate gate;
        QVERIFY(gate.take(kPilot, armCommand()));
        QVERIFY(!gate.take(kPilot, armCommand(), late));
        QVERIFY(gate.take(kPilot, frameOf(question, 255), late));
        QVERIFY(!gate.take(kPilot, frameOf(mavlink::Heartbeat{}, 255), late));
        QCOMPARE(gate.counters().lateRefused, std::uint64_t(2));
        QCOMPARE(gate.counters().observerRefused, std::uint64_t(0));
        const auto refused = gate.takeRefused();
        QCOMPARE(refused.size(), 1u); // heartbeats are only counted
        QCOMPARE(int(refused[0].reason), int(FramesRefused::Reason::Late));
        QCOMPARE(refused[0].peer, std::string("peer-1"));
        QVERIFY(!gate.take(kObserver, armCommand(), late));
        QCOMPARE(gate.counters().observerRefused, std::uint64_t(1));
    }
}

void CommandGateTest::observerDoesNotCommand()
{
    Gate gate;
    QVERIFY(gate.take(kPilot, armCommand()));
    QVERIFY(!gate.take(kObserver, armCommand()));
    QVERIFY(!gate.take(kObserver, armCommand()));
    QCOMPARE(gate.counters().observerRefused, std::uint64_t(2));
    const auto refused = gate.takeRefused();
    QCOMPARE(refused.size(), std::size_t(1));
    QCOMPARE(int(refused[0].reason), int(FramesRefused::Reason::Observer));
    QCOMPARE(refused[0].peer, std::string("peer-2"));
    QCOMPARE(refused[0].messageName, std::string("COMMAND_LONG"));
    QCOMPARE(int(refused[0].command), int(mavlink::MAV_CMD_COMPONENT_ARM_DISARM));
    QCOMPARE(refused[0].frames, std::uint64_t(2));
    QVERIFY(gate.takeRefused().empty());
}

void CommandGateTest::nobodySpeaksAsTheVehicle()
{
    Gate gate;
    QVERIFY(!gate.take(kPilot, clearHeartbeat(1, 1, false)));
    QCOMPARE(gate.counters().spoofRefused, std::uint64_t(1));
    const auto refused = gate.takeRefused();
    QCOMPARE(refused.size(), std::size_t(1));
    QCOMPARE(int(refused[0].reason), int(FramesRefused::Reason::System));
}

void CommandGateTest::heartbeatsOfAnObserverAreOnlyCounted()
{
    Gate gate;
    QVERIFY(!gate.take(kObserver, clearHeartbeat(255, 190, false)));
    QCOMPARE(gate.counters().observerRefused, std::uint64_t(1));
    QVERIFY(gate.takeRefused().empty());
}

/// The system id that an agent gives for its vehicle when it is paired.
void CommandGateTest::onlyVehicleIsNamed()
{
    VehicleRoutes routes;
    QCOMPARE(routes.onlySystem(), std::uint8_t(0));
    routes.heard({}, {}, 7);
    QCOMPARE(routes.onlySystem(), std::uint8_t(7));
    routes.heard({}, {}, 9);
    QCOMPARE(routes.onlySystem(), std::uint8_t(0)); // to bind one would exclude the other
}

void CommandGateTest::questionsAreLimitedForEachPeer()
{
    Gate gate;
    const auto askedBy = [&gate](channel::SessionId session) {
        const QByteArray question = frameOf(mavlink::MissionRequestList{.target_system = 1, .target_component = 1}, 255);
        int passed = 0;
        for (int i = 0; i < 300; ++i)
            passed += gate.take(session, question);
        return passed;
    };
    constexpr int kAtOnce = static_cast<int>(QuestionBudget::kAtOnce),
                  kPerSecond = static_cast<int>(QuestionBudget::kPerSecond);
    QCOMPARE(askedBy(kObserver), kAtOnce);
    QCOMPARE(gate.counters().observerTooOften, std::uint64_t(300 - kAtOnce));
    const auto refused = gate.takeRefused();
    QCOMPARE(refused.size(), std::size_t(1));
    QCOMPARE(int(refused[0].reason), int(FramesRefused::Reason::TooOften));
    QCOMPARE(refused[0].frames, std::uint64_t(300 - kAtOnce));
    QCOMPARE(askedBy(kPilot), 300); // is not limited
    // A new session of the same key has no fresh burst.
    gate.sessionDown(kObserver);
    constexpr channel::SessionId kAgain{3};
    const channel::Peer observer = peer(2, channel::PeerRole::Observer);
    gate.sessionUp({kAgain, observer.key, observer.name, {}, {}});
    QCOMPARE(askedBy(kAgain), 0);
    gate.now += std::chrono::seconds(2);
    QCOMPARE(askedBy(kAgain), 2 * kPerSecond);
}

void CommandGateTest::groundSystemsAreThoseOfPilots()
{
    Gate gate;
    channel::Peer pilot = peer(1, channel::PeerRole::Pilot), observer = peer(2, channel::PeerRole::Observer),
                  bound = peer(3, channel::PeerRole::Pilot);
    bound.systemIds = {77};
    gate.setPeers({pilot, observer, bound});
    QVERIFY(gate.isGroundSystem(255));
    QVERIFY(gate.isGroundSystem(77));
    QVERIFY(!gate.isGroundSystem(42));
    // An observer that used the id of the vehicle first would cut it off.
    const mavlink::MissionRequestList question{.target_system = 1, .target_component = 1};
    QVERIFY(gate.take(kObserver, frameOf(question, 42)));
    QVERIFY(!gate.isGroundSystem(42));
    QVERIFY(gate.take(kPilot, frameOf(question, 42)));
    QVERIFY(gate.isGroundSystem(42));
    gate.sessionDown(kPilot);
    QVERIFY(gate.isGroundSystem(42)); // the pilot comes back
    gate.setPeers({observer, bound});
    QVERIFY(!gate.isGroundSystem(42));
}

/// An observer that was paired with the id of the vehicle would take the vehicle away from the pilot.
void CommandGateTest::observersIdIsNoGroundSystem()
{
    Gate gate;
    channel::Peer pilot = peer(1, channel::PeerRole::Pilot), observer = peer(2, channel::PeerRole::Observer);
    observer.systemIds = {1};
    gate.setPeers({pilot, observer});
    QVERIFY(!gate.isGroundSystem(1));
    const mavlink::MissionRequestList question{.target_system = 1, .target_component = 1};
    QVERIFY(!gate.take(kObserver, frameOf(question, 1))); // a vehicle that is heard keeps its id
    QVERIFY(gate.take(kPilot, armCommand()));
    observer.role = channel::PeerRole::Pilot;
    gate.setPeers({pilot, observer});
    QVERIFY(gate.isGroundSystem(1));
}

void CommandGateTest::anyArmedVehicleCounts()
{
    ArmedVehicles armed;
    QVERIFY(!note(armed, clearHeartbeat(1, 1, false)));
    QVERIFY(note(armed, clearHeartbeat(1, 1, true)));
    QVERIFY(note(armed, clearHeartbeat(2, 1, false))); // the first one still is
    QVERIFY(armed.any());
    QVERIFY(!note(armed, clearHeartbeat(1, 1, false)));
    QVERIFY(!armed.any());
}

void CommandGateTest::lossOfEachStationIsItsOwn()
{
    GroundSessions sessions;
    sessions.add(kPilot);
    sessions.add(kObserver);
    const auto frame = [](std::uint8_t sequence) {
        mavlink::FrameWriter writer(255, 190);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        for (std::uint8_t i = 0; i < sequence; ++i)
            writer.write(mavlink::Heartbeat{}, buffer);
        const ByteView bytes = writer.write(mavlink::Heartbeat{}, buffer);
        return QByteArray(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    const auto take = [&](channel::SessionId session, std::uint8_t sequence) {
        const QByteArray bytes = frame(sequence);
        return sessions.note(TimePoint{}, session, *mavlink::readFrame(viewOf(bytes), mavlink::Dialect::builtin()));
    };
    QCOMPARE(take(kPilot, 0).lost, std::uint64_t(0));
    QCOMPARE(take(kPilot, 3).lost, std::uint64_t(2));
    QCOMPARE(take(kObserver, 5).lost, std::uint64_t(0));
    sessions.remove(kPilot);
    QCOMPARE(sessions.all(), std::vector{kObserver});
    sessions.remove(kObserver);
    QVERIFY(sessions.none());
}

SKYSEAL_TEST(CommandGateTest)
#include "command_gate_test.moc"
