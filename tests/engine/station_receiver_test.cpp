// StationReceiver alone, without sockets, channel and threads: where the frames of a link go.
#include "core/channel/handshake_messages.h"
#include "core/engine/station/station_receiver.h"
#include "core/link/address_text.h"
#include "tests/support/heartbeat.h"
#include "tests/support/idle_link.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr LinkId kLink{1};
constexpr Node kStation{255, 190};
constexpr TimePoint kReceivedAt{std::chrono::seconds(100)};

struct FrameLog final : Feed
{
    void takeFrame(ByteView frame) override
    {
        bytes.append(reinterpret_cast<const char *>(frame.data()), qsizetype(frame.size()));
    }
    mqtt::PublisherStatus status() const override { return {}; }

    QByteArray bytes;
};

struct Rig final : private link::LinkListener, private StationReceiver::EventHandler
{
    explicit Rig(SecureMode mode = SecureMode::Off) : settings(mode, {}, std::nullopt)
    {
        carriers.setNode(kStation);
        receiver.setFeed(&feed);
    }
    void take(const QByteArray &bytes)
    {
        Bytes block(bytes.begin(), bytes.end());
        ingress.take(idle, {from, block, kReceivedAt});
    }
    template<typename Kind> qsizetype count() const
    {
        return std::ranges::count_if(events, [](const Event &event) { return std::holds_alternative<Kind>(event); });
    }

    IdleLink idle{"udpin:127.0.0.1:0", kLink};
    Path from{kLink, *link::parseHost("127.0.0.1", 14551)};
    CarrierWriter carriers;
    LinkPool links{*this, [](link::Link &) {}};
    Ingress ingress{mavlink::Dialect::builtin(), carriers};
    Fleet fleet{StationConfig{}};
    RouteTable routes;
    SecuritySettings settings;
    std::vector<Event> events;
    FrameLog feed;
    StationReceiver receiver{
        kStation,
        {links, ingress, fleet, routes, settings, [this](Event event) { events.push_back(std::move(event)); }, *this}};

private:
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
    void handleEvents(TimePoint, std::optional<channel::SessionId>) override {}
};

const QByteArray kHeartbeat = clearHeartbeat(1, 1, false);

} // namespace

class StationReceiverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void vehicleInClear();
    void recording();
    void ownFrames();
    void sealedOnly();
    void recordWithoutKeys();
    void removedLink();
};

void StationReceiverTest::vehicleInClear()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.take(kHeartbeat);
    rig.take(kHeartbeat);
    QVERIFY(rig.fleet.find(1));
    QCOMPARE(rig.count<VehicleFound>(), qsizetype(1));
    const Route *route = rig.routes.leadingTo(1);
    QVERIFY(route && !route->session && route->path == rig.from);
    QCOMPARE(rig.feed.bytes, kHeartbeat + kHeartbeat);
}

/// A vehicle of a recording is shown, but nothing can be sent to it, and no client takes it for a live one.
void StationReceiverTest::recording()
{
    Rig rig;
    rig.receiver.addLink(kLink, {.isRecording = true});
    rig.take(kHeartbeat);
    QVERIFY(rig.fleet.find(1));
    QVERIFY(!rig.routes.leadingTo(1));
    QVERIFY(rig.feed.bytes.isEmpty());
}

void StationReceiverTest::ownFrames()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.take(clearHeartbeat(kStation.system, kStation.component, false));
    QVERIFY(!rig.fleet.find(kStation.system));
    QVERIFY(rig.feed.bytes.isEmpty());
}

void StationReceiverTest::sealedOnly()
{
    Rig rig(SecureMode::Required);
    rig.receiver.addLink(kLink, {});
    rig.take(kHeartbeat);
    QVERIFY(!rig.fleet.find(1));
    QVERIFY(!rig.routes.leadingTo(1));
    QVERIFY(rig.feed.bytes.isEmpty());
    QCOMPARE(rig.count<VehicleFound>(), qsizetype(0));
}

void StationReceiverTest::recordWithoutKeys()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    QByteArray record(40, '\x07');
    record[0] = static_cast<char>(channel::firstByte(channel::HandshakeMessage::First));
    rig.take(record);
    QCOMPARE(rig.receiver.datagrams().waitingCount, std::uint64_t(1));
    QCOMPARE(rig.receiver.datagrams().waitingBytes, std::uint64_t(record.size()));
    QVERIFY(rig.events.empty());
}

void StationReceiverTest::removedLink()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.receiver.removeLink(kLink);
    rig.take(kHeartbeat);
    QVERIFY(!rig.fleet.find(1));
}

SKYSEAL_TEST_APPLESS(StationReceiverTest)
#include "station_receiver_test.moc"
