// An observer's station under an attacker's control, in front of an agent whose line to the autopilot loses bytes.
#include "core/crypto/init_crypto.h"
#include "core/engine/agent/agent_core.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/engine/bare_end.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

Bytes copyOf(ByteView bytes)
{
    return Bytes(bytes.begin(), bytes.end());
}

std::uint32_t kindOf(const Bytes &frame)
{
    const auto read = mavlink::readFrame(frame, mavlink::Dialect::builtin());
    return read ? read->messageId() : UINT32_MAX;
}

/// One of `Message` whose payload ends with `hidden`: behind all of its fields, or at the end of them.
template<typename Message> Bytes frameWith(const Message &message, ByteView hidden, bool behind, mavlink::FrameWriter &writer)
{
    Bytes payload(Message::kMaxLength);
    message.encode(std::span<std::uint8_t, Message::kMaxLength>(payload));
    if (behind)
        payload.insert(payload.end(), hidden.begin(), hidden.end());
    else
        std::copy(hidden.begin(), hidden.end(), payload.begin() + 8);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return copyOf(writer.write(Message::kId, Message::kCrcExtra, Message::kMinLength, payload, buffer));
}

Bytes heartbeatOfAnAutopilot()
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter autopilot(1, 1);
    return copyOf(autopilot.write(
        mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, buffer));
}

/// An agent between an autopilot's socket and an observer.
struct ObservedFlight
{
    ObservedFlight()
    {
        auto secrets = keys.secrets(channel::Role::Agent);
        secrets->peers[0].role = channel::PeerRole::Observer;
        engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"),
                                   {{urlOf("udpout:127.0.0.1:" + std::to_string(observer.port()))}},
                                   {channel::defaultSuites(), false, false},
                                   false};
        agent = std::make_unique<engine::AgentCore>(std::move(config), std::move(secrets), [](const engine::AgentEvent &) {});
        agent->start();
        vehicle.send(portOf(agent->snapshot().vehicle.localAddress), std::array{ByteView(heartbeat)});
    }
    template<typename Until> bool wait(Until until)
    {
        return eventually([&] { return observer.pump(), until(); });
    }
    /// All that reaches the autopilot until this does.
    std::vector<Bytes> arrivedUntil(const Bytes &last)
    {
        std::vector<Bytes> out;
        const bool came = wait([&] {
            while (const std::size_t count = vehicle.receive()) {
                for (std::size_t i = 0; i < count; ++i)
                    out.push_back(copyOf(vehicle.received(i)));
            }
            return !out.empty() && out.back() == last;
        });
        return came ? out : std::vector<Bytes>();
    }

    const Bytes heartbeat = heartbeatOfAnAutopilot();
    Introduced keys;
    BareEnd observer{keys, channel::Role::Station, {channel::defaultSuites(), false, false}};
    std::unique_ptr<engine::AgentCore> agent;
    BareSocket vehicle;
};

/// Commands within questions, and old frames whose second byte may be lost.
std::vector<Bytes> hostileQuestions(mavlink::FrameWriter &writer)
{
    mavlink::FrameWriter old(255, 190, 1);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const Bytes arm = copyOf(writer.write(mavlink::CommandLong{.target_system = 1,
                                                               .target_component = 1,
                                                               .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM,
                                                               .param1 = 1,
                                                               .param2 = 21196},
                                          buffer));
    const Bytes clear = copyOf(
        mavlink::writeFrame(buffer, 1, 7, 255, 190, mavlink::MissionClearAll::kId, mavlink::MissionClearAll::kCrcExtra, 0, {}));
    if (clear.size() != 8)
        qFatal("it would not fit into a time");
    std::vector<Bytes> out;
    for (int i = 0; i < 20; ++i) {
        out.push_back(frameWith(mavlink::Timesync{.ts1 = 1}, arm, true, writer));
        out.push_back(frameWith(mavlink::MissionRequestList{.target_system = 1}, arm, true, writer));
        out.push_back(frameWith(mavlink::ParamRequestRead{.target_system = 1}, arm, true, writer));
        out.push_back(frameWith(mavlink::Timesync{}, clear, false, writer));
        out.push_back(frameWith(mavlink::Timesync{}, clear, false, old));
    }
    return out;
}

/// Frames of other kinds that are read where the line loses the beginning of this one, before `next`.
std::size_t othersWithin(const Bytes &frame, const Bytes &next)
{
    std::size_t others = 0;
    for (std::size_t lost = 0; lost < frame.size(); ++lost) {
        Bytes stream(frame.begin() + static_cast<std::ptrdiff_t>(lost), frame.end());
        stream.insert(stream.end(), next.begin(), next.end());
        mavlink::StreamParser parser(mavlink::Dialect::builtin());
        const auto look = [&](const mavlink::ScanItem &item) {
            others += item.frame && item.frame->messageId() != kindOf(next) && item.frame->messageId() != kindOf(frame);
        };
        parser.feed(stream, look);
        parser.finish(look);
    }
    return others;
}

template<typename Message> Bytes frameWrittenBy(const Message &message, mavlink::FrameWriter &writer)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return copyOf(writer.write(message, buffer));
}

mavlink::RequestDataStream streamAt(std::uint16_t rate)
{
    return {.target_system = 1, .target_component = 1, .req_message_rate = rate, .start_stop = 1};
}

/// ATTITUDE every so many microseconds.
mavlink::CommandLong messageEvery(float microseconds)
{
    return {.target_system = 1,
            .target_component = 1,
            .command = mavlink::MAV_CMD_SET_MESSAGE_INTERVAL,
            .param1 = mavlink::Attitude::kId,
            .param2 = microseconds};
}

/// Questions that the agent forwarded or refused.
std::uint64_t judged(const ObservedFlight &flight)
{
    const engine::AgentCounters counters = flight.agent->snapshot().counters;
    return counters.toVehicle + counters.observerUnclear + counters.observerTooOften;
}

} // namespace

class AttackObserverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsNestedInAQuestion();
    void streamRates_data();
    void streamRates();
    void thousandQuestions_data();
    void thousandQuestions();
};

void AttackObserverTest::streamRates_data()
{
    QTest::addColumn<int>("rate");
    QTest::addColumn<float>("interval"); // 0: a stream is asked for
    QTest::newRow("0 Hz stops a stream") << 0 << 0.0f;
    QTest::newRow("11 Hz") << 11 << 0.0f;
    QTest::newRow("65535 Hz fills the line") << 65535 << 0.0f;
    QTest::newRow("an interval of -1 stops a message") << 0 << -1.0f;
    QTest::newRow("1 ms fills the line") << 0 << 1000.0f;
}

void AttackObserverTest::streamRates()
{
    QFETCH(int, rate);
    QFETCH(float, interval);
    QVERIFY(crypto::initCrypto());
    ObservedFlight flight;
    QVERIFY(flight.wait([&] { return flight.observer.up() && flight.agent->snapshot().mavlink.frames > 0; }));
    mavlink::FrameWriter writer(255, 190);
    const bool isStream = interval == 0;
    const Bytes hostile = isStream ? frameWrittenBy(streamAt(static_cast<std::uint16_t>(rate)), writer)
                                   : frameWrittenBy(messageEvery(interval), writer);
    const Bytes honest = isStream ? frameWrittenBy(streamAt(10), writer) : frameWrittenBy(messageEvery(100'000), writer);
    for (const Bytes &frame : {hostile, honest})
        flight.observer.sendEach(std::array{ByteView(frame)});
    const std::vector<Bytes> arrived = flight.arrivedUntil(honest);
    QVERIFY(!arrived.empty());
    HOLDS(arrived.front() != hostile, "no stream is stopped or fills the line");
    QCOMPARE(flight.agent->snapshot().counters.observerRefused, std::uint64_t(1));
}

void AttackObserverTest::thousandQuestions_data()
{
    QTest::addColumn<int>("lists"); // of each ten questions
    QTest::addColumn<double>("atOnce");
    QTest::addColumn<double>("perSecond");
    using Limit = engine::QuestionBudget;
    QTest::newRow("single values") << 0 << Limit::kAtOnce << Limit::kPerSecond;
    QTest::newRow("whole lists") << 10 << Limit::kListsAtOnce << Limit::kListsPerSecond;
}

void AttackObserverTest::thousandQuestions()
{
    QFETCH(int, lists);
    QFETCH(double, atOnce);
    QFETCH(double, perSecond);
    QVERIFY(crypto::initCrypto());
    ObservedFlight flight;
    QVERIFY(flight.wait([&] { return flight.observer.up() && flight.agent->snapshot().mavlink.frames > 0; }));
    QElapsedTimer clock;
    clock.start();
    mavlink::FrameWriter writer(255, 190);
    constexpr int kQuestions = 1000;
    for (int i = 0; i < kQuestions; ++i) {
        const Bytes value = frameWrittenBy(mavlink::ParamRequestRead{.target_system = 1, .param_index = 7}, writer);
        const Bytes list = frameWrittenBy(mavlink::ParamRequestList{.target_system = 1, .target_component = 1}, writer);
        flight.observer.sendEach(std::array{ByteView(i % 10 < lists ? list : value)});
        if (i % 50 == 49)
            QVERIFY(flight.wait([&] { return judged(flight) > static_cast<std::uint64_t>(i); }));
    }
    const engine::AgentCounters counters = flight.agent->snapshot().counters;
    const double most = atOnce + perSecond * static_cast<double>(clock.elapsed()) / 1000;
    HOLDS(static_cast<double>(counters.toVehicle) <= most + 1, "an observer's questions are limited");
    QVERIFY(2 * static_cast<double>(counters.observerTooOften) > kQuestions - most); // some other frames are judged as well
    QVERIFY(static_cast<double>(counters.toVehicle) >= atOnce);                      // an honest burst passes
}

void AttackObserverTest::nothingIsNestedInAQuestion()
{
    QVERIFY(crypto::initCrypto());
    ObservedFlight flight;
    QVERIFY(flight.wait([&] { return flight.observer.up() && flight.agent->snapshot().mavlink.frames > 0; }));
    mavlink::FrameWriter writer(255, 190);
    for (const Bytes &frame : hostileQuestions(writer))
        flight.observer.sendEach(std::array{ByteView(frame)});
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const Bytes honest = copyOf(writer.write(mavlink::MissionRequestList{.target_system = 1, .target_component = 1}, buffer));
    flight.observer.sendEach(std::array{ByteView(honest)});
    const std::vector<Bytes> arrived = flight.arrivedUntil(honest);
    QVERIFY(!arrived.empty());

    std::size_t others = 0;
    for (const Bytes &frame : arrived)
        others += othersWithin(frame, flight.heartbeat);
    HOLDS(others == 0, "nothing else is found in what it said");
    QCOMPARE(arrived.size(), std::size_t(1));
    const engine::AgentCounters counters = flight.agent->snapshot().counters;
    QCOMPARE(counters.observerRefused, std::uint64_t(80));
    QCOMPARE(counters.observerUnclear, std::uint64_t(20));
}

SKYSEAL_TEST(AttackObserverTest)
#include "attack_observer_test.moc"
