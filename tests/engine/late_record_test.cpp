// The last record of a session arrives after its goodbye: its frames are accepted, and the end of the session is published
// after them.
#include "core/crypto/init_crypto.h"
#include "core/engine/agent/agent_core.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/bare_end.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

const channel::Policy kPolicy{channel::defaultSuites(), false, false};

template<typename Message> Bytes frameFrom(const Message &message, std::uint8_t systemId, std::uint8_t componentId)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter writer(systemId, componentId);
    const ByteView frame = writer.write(message, buffer);
    return Bytes(frame.begin(), frame.end());
}

/// Sends the record after the goodbye that followed it.
void sayLate(BareEnd &end, ByteView frame)
{
    const Bytes late = end.seal(frame);
    end.close();
    end.pump();
    end.send(late);
}

bool waitFor(BareEnd &end, const std::function<bool()> &until)
{
    return eventually([&] { return end.pump(), until(); });
}

} // namespace

class LateRecordTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void agentTakesIt();
    void stationTakesIt();
    void clientsReceiveOvertakenAnswers();
};

void LateRecordTest::agentTakesIt()
{
    Introduced keys;
    BareEnd ground(keys, channel::Role::Station, kPolicy);
    std::vector<channel::SessionDown> downs;
    bool refused = false;
    engine::AgentCore agent(
        {urlOf("udpin:127.0.0.1:0"), {{urlOf("udpout:127.0.0.1:" + std::to_string(ground.port()))}}, kPolicy, false},
        keys.secrets(channel::Role::Agent), [&](const engine::AgentEvent &event) {
            const auto *happened = std::get_if<channel::Event>(&event);
            if (const auto *down = happened ? std::get_if<channel::SessionDown>(happened) : nullptr)
                downs.push_back(*down);
            refused = refused || std::holds_alternative<engine::FramesRefused>(event);
        });
    agent.start();
    BareSocket vehicle;
    vehicle.send(portOf(agent.snapshot().vehicle.localAddress),
                 std::array{ByteView(frameFrom(
                     mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA},
                     1, 1))});
    QVERIFY(waitFor(ground, [&] { return ground.up() && agent.snapshot().mavlink.frames > 0; }));

    const std::uint64_t before = agent.snapshot().counters.toVehicle;
    // A request for information is answered; a command would be refused (attack_freshness: releasedAfterClose).
    mavlink::ParamRequestList question;
    question.target_system = 1;
    question.target_component = 1;
    sayLate(ground, frameFrom(question, 255, 190));
    QVERIFY(waitFor(ground, [&] { return !downs.empty(); }));
    QCOMPARE(downs.size(), std::size_t(1));
    QCOMPARE(int(downs[0].reason), int(channel::DownReason::PeerClosed));
    const engine::AgentSnapshot after = agent.snapshot();
    QCOMPARE(after.counters.spoofRefused + after.counters.observerRefused, std::uint64_t(0));
    QVERIFY(!refused);
    QCOMPARE(after.counters.toVehicle, before + 1);
}

void LateRecordTest::stationTakesIt()
{
    Introduced keys;
    std::shared_ptr<const engine::Snapshot> snapshot;
    std::vector<engine::Event> told;
    engine::StationConfig config;
    config.secure = engine::SecureMode::Required;
    config.record = false;
    config.policy = kPolicy;
    engine::StationCore station(
        config, keys.secrets(channel::Role::Station),
        {[&](auto next) { snapshot = std::move(next); }, [&](engine::Event event) { told.push_back(std::move(event)); }});
    station.addLink(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
    QVERIFY(eventually([&] { return snapshot && !snapshot->links.empty() && !snapshot->links[0].localAddress.empty(); }));
    BareEnd air(keys, channel::Role::Agent, kPolicy, portOf(snapshot->links[0].localAddress));
    QVERIFY(waitFor(air, [&] { return air.up() && !snapshot->sessions.empty(); }));
    QVERIFY(snapshot->vehicles.empty());

    sayLate(
        air,
        frameFrom(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, 1,
                  1));
    QVERIFY(waitFor(air, [&] { return snapshot->sessions.empty(); }));
    QCOMPARE(snapshot->spoofed, std::uint64_t(0));
    QCOMPARE(snapshot->vehicles.size(), std::size_t(1));
    QVERIFY(snapshot->vehicles[0].ended);
    // First that it was found, then that its session ended.
    const auto indexOf = [&](const auto &is) { return std::find_if(told.begin(), told.end(), is) - told.begin(); };
    const auto found = indexOf([](const auto &event) { return std::holds_alternative<engine::VehicleFound>(event); });
    const auto down = indexOf([](const auto &event) { return std::holds_alternative<channel::SessionDown>(event); });
    QVERIFY(found < down);
}

/// Two parameters and two attitudes, the older record after the newer one: the parameter names itself, so a gateway's client
/// receives it; the attitude would set a display back.
void LateRecordTest::clientsReceiveOvertakenAnswers()
{
    Introduced keys;
    std::shared_ptr<const engine::Snapshot> snapshot;
    engine::StationConfig config;
    config.secure = engine::SecureMode::Required;
    config.record = false;
    config.policy = kPolicy;
    engine::StationCore station(config, keys.secrets(channel::Role::Station),
                                {[&](auto next) { snapshot = std::move(next); }, [](engine::Event) {}});
    station.addLink(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
    station.serve({*engine::ServeConfig::parse("udpin:127.0.0.1:0")});
    QVERIFY(eventually([&] {
        return snapshot && !snapshot->links.empty() && !snapshot->links[0].localAddress.empty() && !snapshot->served.empty()
            && !snapshot->served[0].localAddress.empty();
    }));
    BareEnd air(keys, channel::Role::Agent, kPolicy, portOf(snapshot->links[0].localAddress));
    QVERIFY(waitFor(air, [&] { return air.up() && !snapshot->sessions.empty(); }));
    BareSocket client;
    client.send(portOf(snapshot->served[0].localAddress), std::array{ByteView(frameFrom(mavlink::Heartbeat{}, 255, 190))});
    QVERIFY(waitFor(air, [&] { return !snapshot->clients.empty(); }));

    const auto parameter = [](int index) { return frameFrom(mavlink::ParamValue{.param_index = std::uint16_t(index)}, 1, 1); };
    const auto attitude = [](int time) { return frameFrom(mavlink::Attitude{.time_boot_ms = std::uint32_t(time)}, 1, 1); };
    std::vector<Bytes> sent{parameter(1), attitude(1), attitude(2), parameter(2)};
    // Of other conversations, each older than one of its kind.
    const auto inTwo = [&sent](auto first, auto second) {
        sent.push_back(frameFrom(first, 1, 1));
        sent.push_back(frameFrom(second, 1, 1));
    };
    inTwo(mavlink::MissionItemInt{.seq = 1}, mavlink::MissionItemInt{.seq = 2});
    inTwo(mavlink::CommandAck{.command = 1}, mavlink::CommandAck{.command = 2});
    inTwo(mavlink::LogData{.ofs = 90}, mavlink::LogData{.ofs = 180});
    inTwo(mavlink::FileTransferProtocol{.payload = {1}}, mavlink::FileTransferProtocol{.payload = {2}});
    inTwo(mavlink::MessageInterval{.message_id = 30}, mavlink::MessageInterval{.message_id = 31});
    inTwo(mavlink::MissionItemReached{.seq = 1}, mavlink::MissionItemReached{.seq = 2});
    inTwo(mavlink::Timesync{.tc1 = 1}, mavlink::Timesync{.tc1 = 2});
    std::vector<Bytes> records;
    for (const Bytes &frame : sent)
        records.push_back(air.seal(frame));
    std::vector<Bytes> received;
    const auto last = [&] {
        while (const std::size_t arrived = client.receive()) {
            for (std::size_t i = 0; i < arrived; ++i)
                received.emplace_back(client.received(i).begin(), client.received(i).end());
        }
        return std::find(received.begin(), received.end(), sent[0]) != received.end();
    };
    for (std::size_t next = records.size(); next-- > 0;)
        air.send(records[next]);
    QVERIFY(waitFor(air, last));
    QCOMPARE(received.size(), sent.size() - 1);
    QVERIFY(std::find(received.begin(), received.end(), sent[1]) == received.end());
}

SKYSEAL_TEST(LateRecordTest)
#include "late_record_test.moc"
