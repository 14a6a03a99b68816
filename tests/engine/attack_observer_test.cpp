// An observer's station that is in an attacker's hands, before an agent whose line to the autopilot loses bytes.
#include "core/crypto/init_crypto.h"
#include "core/engine/agent_core.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"
#include "tests/engine/bare_end.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

#define HOLDS(condition, words) QVERIFY2(condition, words)

namespace {

link::LinkUrl urlOf(const std::string &text)
{
    return *link::LinkUrl::parse(text);
}

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

} // namespace

class AttackObserverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsNestedInAQuestion();
};

void AttackObserverTest::nothingIsNestedInAQuestion()
{
    QVERIFY(crypto::initCrypto());
    Introduced keys;
    BareEnd observer(keys, channel::Role::Station, {channel::defaultSuites(), false, false});
    auto secrets = keys.secrets(channel::Role::Agent);
    secrets->peers[0].role = channel::PeerRole::Observer;
    engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"), urlOf("udpout:127.0.0.1:" + std::to_string(observer.port())),
                               {channel::defaultSuites(), false, false}, false};
    engine::AgentCore agent(std::move(config), std::move(secrets), [](const engine::AgentEvent &) {});
    agent.start();
    BareSocket vehicle;
    const std::string address = agent.snapshot().vehicle.localAddress;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter autopilot(1, 1);
    const Bytes heartbeat = copyOf(autopilot.write(mavlink::Heartbeat{.type = 2, .autopilot = 3}, buffer));
    vehicle.send(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))),
                 std::array{ByteView(heartbeat)});
    const auto wait = [&](const auto &until) { return QTest::qWaitFor([&] { return observer.pump(), until(); }, 20000); };
    QVERIFY(wait([&] { return observer.up() && agent.snapshot().mavlink.frames > 0; }));

    // Commands within questions, old frames whose second byte may be lost, and at last an honest question.
    mavlink::FrameWriter writer(255, 190), old(255, 190, 1);
    const Bytes arm = copyOf(writer.write(mavlink::CommandLong{.target_system = 1, .target_component = 1,
                                                               .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM, .param1 = 1,
                                                               .param2 = 21196},
                                          buffer));
    const Bytes clear = copyOf(mavlink::writeFrame(buffer, 1, 7, 255, 190, mavlink::MissionClearAll::kId,
                                                   mavlink::MissionClearAll::kCrcExtra, 0, {}));
    QCOMPARE(clear.size(), std::size_t(8));
    std::vector<Bytes> said;
    for (int i = 0; i < 20; ++i) {
        said.push_back(frameWith(mavlink::Timesync{.ts1 = 1}, arm, true, writer));
        said.push_back(frameWith(mavlink::MissionRequestList{.target_system = 1}, arm, true, writer));
        said.push_back(frameWith(mavlink::ParamRequestRead{.target_system = 1}, arm, true, writer));
        said.push_back(frameWith(mavlink::Timesync{}, clear, false, writer));
        said.push_back(frameWith(mavlink::Timesync{}, clear, false, old));
    }
    const Bytes honest = copyOf(writer.write(mavlink::MissionRequestList{.target_system = 1, .target_component = 1}, buffer));
    for (const Bytes &frame : said)
        observer.sendEach(std::array{ByteView(frame)});
    observer.sendEach(std::array{ByteView(honest)});
    std::vector<Bytes> arrived;
    QVERIFY(wait([&] {
        while (const std::size_t count = vehicle.receive()) {
            for (std::size_t i = 0; i < count; ++i)
                arrived.push_back(copyOf(vehicle.received(i)));
        }
        return !arrived.empty() && arrived.back() == honest;
    }));

    // The line loses the beginning of each in turn.
    std::size_t others = 0;
    for (std::size_t damaged = 0; damaged < arrived.size(); ++damaged) {
        for (std::size_t lost = 0; lost < arrived[damaged].size(); ++lost) {
            Bytes stream(arrived[damaged].begin() + static_cast<std::ptrdiff_t>(lost), arrived[damaged].end());
            stream.insert(stream.end(), heartbeat.begin(), heartbeat.end());
            mavlink::StreamParser parser(mavlink::Dialect::builtin());
            const auto look = [&](const mavlink::ScanItem &item) {
                if (item.frame && item.frame->messageId() != mavlink::Heartbeat::kId
                    && item.frame->messageId() != kindOf(arrived[damaged]))
                    ++others;
            };
            parser.feed(stream, look);
            parser.finish(look);
        }
    }
    HOLDS(others == 0, "nothing else is found in what it said");
    QCOMPARE(arrived.size(), std::size_t(1));
    const engine::AgentCounters counters = agent.snapshot().counters;
    QCOMPARE(counters.observerRefused, std::uint64_t(80));
    QCOMPARE(counters.observerUnclear, std::uint64_t(20));
}

QTEST_GUILESS_MAIN(AttackObserverTest)
#include "attack_observer_test.moc"
