// What a client of the gateway may send, on a simulated clock.
#include "core/engine/gateway/client.h"
#include "core/engine/gateway/client_places.h"
#include "core/link/address_text.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/message_ids.h"
#include "core/mavlink/messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <limits>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

const TimePoint kConnected{std::chrono::hours(1)};

/// A client that may do what `options` say, and that sends as system 255.
struct Sender
{
    explicit Sender(const char *options = "")
        : config(*ServeConfig::parse(std::string("udpin:14550") + options)), client(config, budget)
    {}

    template<typename Message>
    Client::Verdict send(const Message &message, TimePoint now = kConnected, bool isVehicle = false, bool pilotThere = false)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = mavlink::FrameWriter(255, 190).write(message, buffer);
        Client::Verdict verdict{};
        mavlink::scanFrames(frame, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
            verdict = client.judge(now, item, isVehicle, pilotThere);
            if (verdict == Client::Verdict::Deny)
                denial = client.takeDenial(now, item);
        });
        return verdict;
    }

    ServeConfig config;
    QuestionBudget budget;
    Client client;
    std::optional<Denial> denial;
};

mavlink::CommandLong command(unsigned id, float first = 0, float second = 0)
{
    mavlink::CommandLong out;
    out.target_system = 1;
    out.command = static_cast<std::uint16_t>(id);
    out.param1 = first;
    out.param2 = second;
    return out;
}

mavlink::RequestDataStream stream(unsigned rate)
{
    mavlink::RequestDataStream out;
    out.target_system = 1;
    out.start_stop = 1;
    out.req_message_rate = static_cast<std::uint16_t>(rate);
    return out;
}

/// A request for ATTITUDE every so many microseconds.
mavlink::CommandLong interval(float microseconds)
{
    return command(mavlink::MAV_CMD_SET_MESSAGE_INTERVAL, mavlink::Attitude::kId, microseconds);
}

Path at(const char *host, std::uint16_t port)
{
    return {LinkId{0}, *link::parseHost(host, port)};
}

} // namespace

class GatewayClientTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readerAsks();
    void readerCommandsNothing();
    void readersHeartbeatIsNoPilots();
    void readerSetsModestRatesOnly();
    void readerLeavesThePilotsRatesAlone();
    void readerHidesNothingInAQuestion();
    void readerAsksOnlySoOften();
    void rightsOpenClassesAlone();
    void clientSpeaksAsItsSystemAlone();
    void denialIsToldOnceAMinute();
    void silentClientIsForgotten();
    void oneHostTakesNoPlaceOfOthers();
    void silentPlacesAreFreed();
};

void GatewayClientTest::readerAsks()
{
    Sender reader;
    QCOMPARE(reader.send(mavlink::ParamRequestList{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(reader.send(mavlink::ParamRequestRead{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(reader.send(mavlink::MissionRequestList{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(reader.send(mavlink::MissionRequestInt{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(reader.send(mavlink::Timesync{.ts1 = 5}), Client::Verdict::Forward);
    QCOMPARE(reader.send(command(mavlink::MAV_CMD_REQUEST_MESSAGE, mavlink::AutopilotVersion::kId)), Client::Verdict::Forward);
    QCOMPARE(reader.client.counters().forwarded, std::uint64_t(6));
}

void GatewayClientTest::readerCommandsNothing()
{
    Sender reader;
    QCOMPARE(reader.send(command(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 1)), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::CommandInt{.command = mavlink::MAV_CMD_DO_REPOSITION}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::SetMode{.target_system = 1}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::ParamSet{.target_system = 1}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::MissionCount{.target_system = 1}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::MissionClearAll{.target_system = 1}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::RcChannelsOverride{.target_system = 1}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::ManualControl{}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::SetupSigning{}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::SystemTime{}), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::Timesync{.tc1 = 9, .ts1 = 5}), Client::Verdict::Deny);
    QCOMPARE(reader.client.counters().denied, std::uint64_t(11));
    QCOMPARE(reader.client.counters().forwarded, std::uint64_t(0));
}

void GatewayClientTest::readersHeartbeatIsNoPilots()
{
    Sender reader, pilot(",write=rc");
    QCOMPARE(reader.send(mavlink::Heartbeat{}), Client::Verdict::Ignore);
    QCOMPARE(reader.client.counters().denied, std::uint64_t(0));
    QCOMPARE(pilot.send(mavlink::Heartbeat{}), Client::Verdict::Forward);
}

void GatewayClientTest::readerSetsModestRatesOnly()
{
    Sender reader;
    for (const unsigned rate : {1u, 4u, 10u})
        QCOMPARE(reader.send(stream(rate)), Client::Verdict::Forward);
    for (const unsigned rate : {0u, 11u, 65535u})
        QCOMPARE(reader.send(stream(rate)), Client::Verdict::Deny);
    for (const float permitted : {1e6f, 333'333.0f, float(1e6 / 3), 100'000.0f})
        QCOMPARE(reader.send(interval(permitted)), Client::Verdict::Forward);
    // Stops the message, its default, too slow, between two rates, too fast, and no interval at all.
    for (const float other : {-1.0f, 0.0f, 2e6f, 99'000.0f, 300'000.0f, 1000.0f, std::numeric_limits<float>::quiet_NaN()})
        QCOMPARE(reader.send(interval(other)), Client::Verdict::Deny);
}

void GatewayClientTest::readerLeavesThePilotsRatesAlone()
{
    Sender reader;
    QCOMPARE(reader.send(stream(4), kConnected, false, true), Client::Verdict::Deny);
    QCOMPARE(reader.send(interval(250'000), kConnected, false, true), Client::Verdict::Deny);
    QCOMPARE(reader.send(mavlink::ParamRequestList{.target_system = 1}, kConnected, false, true), Client::Verdict::Forward);
}

void GatewayClientTest::readerHidesNothingInAQuestion()
{
    Sender reader;
    mavlink::CommandLong question = command(mavlink::MAV_CMD_REQUEST_MESSAGE, mavlink::AutopilotVersion::kId);
    question.param5 = 1;
    QCOMPARE(reader.send(question), Client::Verdict::Deny);
    mavlink::CommandLong rate = interval(250'000);
    rate.param3 = 1;
    QCOMPARE(reader.send(rate), Client::Verdict::Deny);
    // The first byte of a frame among those of a question.
    QCOMPARE(reader.send(mavlink::MissionRequestInt{.target_system = 1, .seq = 0xFE}), Client::Verdict::Ignore);
    QCOMPARE(reader.client.counters().forwarded, std::uint64_t(0));
}

void GatewayClientTest::readerAsksOnlySoOften()
{
    Sender reader;
    int passed = 0;
    for (int i = 0; i < 1000; ++i)
        passed += reader.send(mavlink::ParamRequestRead{.target_system = 1}) == Client::Verdict::Forward;
    QCOMPARE(passed, int(QuestionBudget::kAtOnce));
    QCOMPARE(reader.client.counters().tooOften, std::uint64_t(1000 - passed));
    QCOMPARE(reader.send(mavlink::ParamRequestRead{.target_system = 1}, kConnected + std::chrono::seconds(1)),
             Client::Verdict::Forward);
    Sender pilot(",write=param");
    for (int i = 0; i < 1000; ++i)
        QCOMPARE(pilot.send(mavlink::ParamSet{.target_system = 1}), Client::Verdict::Forward);
}

void GatewayClientTest::rightsOpenClassesAlone()
{
    Sender planner(",write=mission,param");
    QCOMPARE(planner.send(mavlink::MissionCount{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(planner.send(mavlink::ParamSet{.target_system = 1}), Client::Verdict::Forward);
    QCOMPARE(planner.send(command(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 1)), Client::Verdict::Deny);
    QCOMPARE(planner.send(mavlink::RcChannelsOverride{.target_system = 1}), Client::Verdict::Deny);
    Sender all(",write=all");
    QCOMPARE(all.send(command(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 1)), Client::Verdict::Forward);
    QCOMPARE(all.send(mavlink::SetupSigning{}), Client::Verdict::Forward);
}

void GatewayClientTest::clientSpeaksAsItsSystemAlone()
{
    Sender other(",write=all,sysid=250");
    QCOMPARE(other.send(mavlink::Heartbeat{}), Client::Verdict::NotItsSystem);
    Sender vehicle(",write=all");
    QCOMPARE(vehicle.send(mavlink::Heartbeat{}, kConnected, true), Client::Verdict::NotItsSystem);
    QCOMPARE(vehicle.client.counters().notItsSystem, std::uint64_t(1));
}

void GatewayClientTest::denialIsToldOnceAMinute()
{
    Sender reader;
    reader.send(mavlink::ParamSet{.target_system = 1});
    QVERIFY(reader.denial);
    QCOMPARE(reader.denial->message, std::string("PARAM_SET"));
    QCOMPARE(reader.denial->frames, std::uint64_t(1));
    for (int second = 1; second < 60; ++second) {
        reader.send(mavlink::SetMode{.target_system = 1}, kConnected + std::chrono::seconds(second));
        QVERIFY(!reader.denial);
    }
    reader.send(mavlink::ManualControl{}, kConnected + std::chrono::seconds(60));
    QVERIFY(reader.denial);
    QCOMPARE(reader.denial->message, std::string("MANUAL_CONTROL"));
    QCOMPARE(reader.denial->frames, std::uint64_t(60));
}

void GatewayClientTest::silentClientIsForgotten()
{
    Sender reader;
    reader.send(mavlink::Heartbeat{});
    QVERIFY(!reader.client.isSilent(kConnected + std::chrono::seconds(59)));
    QVERIFY(reader.client.isSilent(kConnected + std::chrono::seconds(60)));
}

void GatewayClientTest::oneHostTakesNoPlaceOfOthers()
{
    using namespace std::chrono_literals;
    std::vector<ClientPlace> places; // one host sends from 31 ports all the time, another one only listens
    for (std::uint16_t port = 1; port <= 31; ++port)
        places.push_back({at("10.0.0.1", port), kConnected - port * 1ms});
    places.push_back({at("10.0.0.2", 14550), kConnected - 50s});

    const auto freedFor = [&](const char *host) { return placeToFree(places, at(host, 40000).remote, kConnected); };
    QCOMPARE(freedFor("10.0.0.3"), std::optional(at("10.0.0.1", 31))); // at once, the most silent of the greedy host
    QCOMPARE(freedFor("10.0.0.1"), std::nullopt);                      // not the listener's, and its own are in use
    places[4].heardAt = kConnected - kReplaceAfter;
    QCOMPARE(freedFor("10.0.0.1"), std::optional(at("10.0.0.1", 5)));

    // A host with IPv6 chooses the lower half of its address.
    places.clear();
    for (std::uint16_t i = 1; i <= 31; ++i)
        places.push_back({at(("2001:db8::" + std::to_string(i)).c_str(), 14550), kConnected});
    places.push_back({at("2001:db8:0:1::1", 14550), kConnected - 50s});
    QCOMPARE(freedFor("2001:db8::99"), std::nullopt);
    QCOMPARE(freedFor("2001:db8:0:2::1"), std::optional(at("2001:db8::1", 14550)));
}

void GatewayClientTest::silentPlacesAreFreed()
{
    using namespace std::chrono_literals;
    std::vector<ClientPlace> places;
    for (int host = 1; host <= 32; ++host)
        places.push_back({at(("10.0.0." + std::to_string(host)).c_str(), 14550), kConnected - 4s});
    const Address newcomer = at("10.0.1.1", 14550).remote;
    QCOMPARE(placeToFree(places, newcomer, kConnected), std::nullopt);
    places[7].heardAt = kConnected - 6s;
    places[9].heardAt = kConnected - 7s;
    QCOMPARE(placeToFree(places, newcomer, kConnected), std::optional(places[9].path));
}

SKYSEAL_TEST_APPLESS(GatewayClientTest)
#include "gateway_client_test.moc"
