// An observer can send only harmless questions to the vehicle, of all messages and commands: tested on the rules alone, and on
// the wire, where a simulated vehicle and a bare socket show what arrived.
#include "core/engine/agent/agent_core.h"
#include "core/engine/agent/observer_rules.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/flight_rig.h"
#include "tests/support/command_long.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <bit>
#include <limits>
#include <set>

using namespace skyseal;
using namespace skyseal::test;

namespace {

using Frames = std::vector<Bytes>;

Bytes frameFor(std::uint32_t id, std::uint8_t crcExtra, std::uint8_t minLength, ByteView payload)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter writer(255, 190);
    const ByteView frame = writer.write(id, crcExtra, minLength, payload, buffer);
    return Bytes(frame.begin(), frame.end());
}

template<typename Message> Bytes frameFor(const Message &message)
{
    std::array<std::uint8_t, Message::kMaxLength> payload;
    message.encode(payload);
    return frameFor(Message::kId, Message::kCrcExtra, Message::kMinLength, payload);
}

bool maySend(const Bytes &bytes, bool pilotThere = false)
{
    mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
    const auto item = scanner.next();
    if (!item || !item->frame)
        qFatal("no frame");
    return engine::observerMaySend(*item->frame, pilotThere);
}

Bytes commandBytes(std::uint16_t command, std::array<float, 7> p = {})
{
    return frameFor(test::commandLong(command, p));
}

Bytes commandInt(std::uint16_t command, float first = 0, float second = 0)
{
    return frameFor(
        mavlink::CommandInt{.target_system = 1, .target_component = 1, .command = command, .param1 = first, .param2 = second});
}

/// Messages that would fly the vehicle, or stop the pilot's telemetry.
Frames acts()
{
    using namespace mavlink;
    ParamSet failsafe{.target_system = 1, .target_component = 1};
    setText(failsafe.param_id, "FS_GCS_ENABLE");
    return {
        commandBytes(MAV_CMD_COMPONENT_ARM_DISARM, {1, 2989}),
        commandInt(MAV_CMD_COMPONENT_ARM_DISARM, 1, 2989),
        commandBytes(MAV_CMD_DO_SET_MODE, {1, 9}),
        commandBytes(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}),
        commandBytes(MAV_CMD_SET_MESSAGE_INTERVAL, {30, -1}),
        commandBytes(MAV_CMD_DO_MOTOR_TEST, {1, 0, 50, 5}),
        commandBytes(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}),
        frameFor(SetMode{.target_system = 1, .base_mode = 1, .custom_mode = 9}),
        frameFor(RcChannelsOverride{.target_system = 1, .target_component = 1, .chan1_raw = 1900, .chan3_raw = 1900}),
        frameFor(ManualControl{.target = 1, .x = 1000, .z = 1000}),
        frameFor(failsafe),
        frameFor(MissionCount{.target_system = 1, .target_component = 1, .count = 3}),
        frameFor(MissionClearAll{.target_system = 1, .target_component = 1}),
        frameFor(MissionSetCurrent{.target_system = 1, .target_component = 1, .seq = 1}),
        frameFor(MissionAck{.target_system = 1, .target_component = 1, .type = MAV_MISSION_OPERATION_CANCELLED}),
        frameFor(SetPositionTargetLocalNed{.target_system = 1, .target_component = 1, .x = 100}),
        frameFor(SetHomePosition{.target_system = 1}),
        frameFor(Heartbeat{.type = MAV_TYPE_GCS, .autopilot = MAV_AUTOPILOT_INVALID}),
        frameFor(SystemTime{.time_unix_usec = 1}),
        frameFor(Ping{.time_usec = 5}),
        frameFor(Timesync{.tc1 = 7, .ts1 = 5}),
        frameFor(SetupSigning{.target_system = 1, .target_component = 1}),
        frameFor(RequestDataStream{.target_system = 1, .target_component = 1, .start_stop = 0}),
        frameFor(180'000, 77, 4, Bytes(4, 1)), // of no dialect that is known here
    };
}

Frames questions()
{
    using namespace mavlink;
    return {
        frameFor(Timesync{.ts1 = 5}),
        frameFor(ParamRequestRead{.target_system = 1, .target_component = 1, .param_index = 3}),
        frameFor(MissionRequestList{.target_system = 1, .target_component = 1}),
        frameFor(MissionRequestInt{.target_system = 1, .target_component = 1, .seq = 0}),
        frameFor(MissionAck{.target_system = 1, .target_component = 1, .type = MAV_MISSION_ACCEPTED}),
        commandBytes(MAV_CMD_REQUEST_MESSAGE, {148}),
        commandInt(MAV_CMD_GET_HOME_POSITION),
        commandBytes(MAV_CMD_SET_MESSAGE_INTERVAL, {30, 250'000}),
        frameFor(RequestDataStream{.target_system = 1, .target_component = 1, .req_message_rate = 4, .start_stop = 1}),
    };
}

/// An agent with a vehicle side and a ground side, and the events that it published.
struct AgentWithOneStation
{
    explicit AgentWithOneStation(channel::PeerRole role)
        : ground(keys, channel::Role::Station, {channel::defaultSuites(), false, false})
    {
        auto secrets = keys.secrets(channel::Role::Agent);
        secrets->peers[0].role = role;
        engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"),
                                   {{urlOf("udpout:127.0.0.1:" + std::to_string(ground.port()))}},
                                   {channel::defaultSuites(), false, false},
                                   false};
        agent = std::make_unique<engine::AgentCore>(std::move(config), std::move(secrets),
                                                    [this](const engine::AgentEvent &event) { events.push_back(event); });
        agent->start();
    }

    bool wait(const std::function<bool()> &until)
    {
        return eventually([&] { return ground.pump(), until(); });
    }
    void send(const Frames &frames)
    {
        std::vector<ByteView> views(frames.begin(), frames.end());
        ground.sendEach(views);
    }
    std::vector<engine::FramesRefused> refused() const
    {
        std::vector<engine::FramesRefused> out;
        for (const engine::AgentEvent &event : events) {
            if (const auto *one = std::get_if<engine::FramesRefused>(&event))
                out.push_back(*one);
        }
        return out;
    }

    Introduced keys;
    BareEnd ground;
    std::vector<engine::AgentEvent> events;
    std::unique_ptr<engine::AgentCore> agent;
};

} // namespace

class ObserverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ofAllMessagesOnlyQuestions();
    void ofAllCommandsOnlyQuestions();
    void streamsAreThePilotsWhileThereIsOne();
    void onlyQuestionsReachTheVehiclesSocket();
    void actsChangeNothing_data();
    void actsChangeNothing();
};

void ObserverTest::ofAllMessagesOnlyQuestions()
{
    // `always`: passes with any payload. `depends`: the content decides, see below.
    const std::set<std::uint32_t> always{21, 40, 43, 51, 321}, depends{20, 47, 66, 75, 76, 111, 320};
    int passed = 0;
    for (const mavlink::MessageInfo &info : mavlink::Dialect::builtin().messages()) {
        for (const std::uint8_t filling : {0x00, 0xff}) {
            const Bytes payload(info.maxLength, filling);
            const bool may = maySend(frameFor(info.id, info.crcExtra, info.minLength, payload));
            if (!depends.contains(info.id))
                QVERIFY2(may == always.contains(info.id), std::string(info.name).c_str());
            passed += may;
        }
    }
    QVERIFY(passed >= 2 * int(always.size()));
    for (const Bytes &frame : questions())
        QVERIFY(maySend(frame));
}

void ObserverTest::ofAllCommandsOnlyQuestions()
{
    const std::set<int> allowed{410, 512, 519, 520};
    for (int command = 0; command < 65536; ++command) {
        QCOMPARE(maySend(commandBytes(std::uint16_t(command), {1, 1, 0, 0, 0, 0, 1})), allowed.contains(command));
        QCOMPARE(maySend(commandInt(std::uint16_t(command), 1, 1)), allowed.contains(command));
    }
    // Nor with more than a question needs.
    const float nothing = std::numeric_limits<float>::quiet_NaN();
    QVERIFY(maySend(commandBytes(512, {148, nothing, nothing, nothing, nothing, nothing, nothing})));
    for (std::size_t i = 0; i < 7; ++i) {
        std::array<float, 7> parameters{};
        parameters[i] = 0.5f;
        QVERIFY(!maySend(commandBytes(512, parameters)));
        parameters[i] = std::bit_cast<float>(0x7fc12345);
        QVERIFY(!maySend(commandBytes(512, parameters)));
    }
}

void ObserverTest::streamsAreThePilotsWhileThereIsOne()
{
    const Bytes start = frameFor(mavlink::RequestDataStream{.target_system = 1, .req_message_rate = 4, .start_stop = 1});
    QVERIFY(maySend(start, false));
    QVERIFY(!maySend(start, true));
    QVERIFY(!maySend(frameFor(mavlink::RequestDataStream{.target_system = 1, .req_message_rate = 4, .start_stop = 0}), false));
    for (const int rate : {0, 1, 10, 11, 65535}) {
        const Bytes request = frameFor(mavlink::RequestDataStream{
            .target_system = 1, .req_message_rate = static_cast<std::uint16_t>(rate), .start_stop = 1});
        QCOMPARE(maySend(request, false), rate == 1 || rate == 10);
    }
    // By message: the whole rates from 1 to 10 Hz, as long as no pilot has others.
    const auto maySet = [](float interval) {
        return maySend(commandBytes(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, {30, interval}));
    };
    int passed = 0;
    for (int interval = -1000; interval <= 2'000'000; interval += 1000)
        passed += maySet(float(interval));
    QCOMPARE(passed, 6); // 1, 2, 4, 5, 8 and 10 Hz
    for (const float interval : {-1.0f, 99'999.0f, 100'001.0f, 166'665.0f, 333'332.0f, 999'999.0f, 1'000'001.0f})
        QVERIFY(!maySet(interval));
    for (const float interval : {166'666.0f, 166'667.0f, 333'333.0f})
        QVERIFY(maySet(interval));
    for (int rate = 1; rate <= 10; ++rate) {
        const float interval = float(1e6 / rate);
        QVERIFY(maySet(interval));
        QVERIFY(maySend(commandInt(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, 30, interval)));
        QVERIFY(!maySend(commandBytes(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, {30, interval}), true));
    }
}

void ObserverTest::onlyQuestionsReachTheVehiclesSocket()
{
    AgentWithOneStation rig(channel::PeerRole::Observer);
    BareSocket vehicle;
    const std::uint16_t port = portOf(rig.agent->snapshot().vehicle.localAddress);
    const Bytes heartbeat = [] {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::FrameWriter writer(1, 1);
        const ByteView frame = writer.write(
            mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, buffer);
        return Bytes(frame.begin(), frame.end());
    }();
    vehicle.send(port, std::array{ByteView(heartbeat)});
    QVERIFY(rig.wait([&] { return rig.ground.up() && rig.agent->snapshot().mavlink.frames > 0; }));

    Frames all = acts();
    const Frames good = questions();
    all.insert(all.end(), good.begin(), good.end());
    rig.send(all);
    Frames arrived;
    QVERIFY(rig.wait([&] {
        while (const std::size_t count = vehicle.receive()) {
            for (std::size_t i = 0; i < count; ++i) {
                const ByteView bytes = vehicle.received(i);
                mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
                while (const auto item = scanner.next())
                    arrived.emplace_back(item->bytes.begin(), item->bytes.end());
            }
        }
        return arrived.size() >= good.size();
    }));
    QCOMPARE(arrived, good);
    const engine::AgentSnapshot snapshot = rig.agent->snapshot();
    QCOMPARE(snapshot.counters.observerRefused, std::uint64_t(acts().size()));
    QCOMPARE(snapshot.counters.toVehicle, std::uint64_t(good.size()));
    std::uint64_t told = 0;
    for (const engine::FramesRefused &refused : rig.refused()) {
        QCOMPARE(int(refused.reason), int(engine::FramesRefused::Reason::Observer));
        QCOMPARE(refused.peer, std::string("ground"));
        QVERIFY(refused.messageId != mavlink::Heartbeat::kId);
        told += refused.frames;
    }
    QCOMPARE(told, std::uint64_t(acts().size() - 1)); // the heartbeat is counted and makes no event
}

void ObserverTest::actsChangeNothing_data()
{
    QTest::addColumn<bool>("pilot");
    QTest::newRow("observer") << false;
    QTest::newRow("pilot, so that the acts are real ones") << true;
}

void ObserverTest::actsChangeNothing()
{
    QFETCH(bool, pilot);
    AgentWithOneStation rig(pilot ? channel::PeerRole::Pilot : channel::PeerRole::Observer);
    VehicleOnUdp sim(rig.agent->snapshot().vehicle.localAddress);
    QVERIFY(rig.wait([&] { return rig.ground.up() && rig.agent->snapshot().counters.toGround > 20; }));
    const sim::FlightMode before = sim.vehicle.autopilot().modes().current();
    const Frames all = acts();
    for (int round = 0; round < 5; ++round) {
        // Without the reboot, which would undo the others.
        for (const Bytes &frame : all) {
            if (frame != commandBytes(mavlink::MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}))
                rig.send({frame});
        }
        const std::uint64_t seen = rig.agent->snapshot().counters.toGround;
        QVERIFY(rig.wait([&] { return rig.agent->snapshot().counters.toGround > seen + 5; }));
    }
    const bool changed = sim.vehicle.autopilot().armed() || sim.vehicle.autopilot().modes().current() != before;
    QCOMPARE(changed, pilot);
}

SKYSEAL_TEST(ObserverTest)
#include "observer_test.moc"
