// A MAVLink router between agent and station, and an attacker who sends to it under every system id: everything that it copies
// to him is sealed, nothing that he sends is accepted, and delivery continues.
#include "core/channel/cobs.h"
#include "core/channel/handshake_messages.h"
#include "core/engine/common/ingress.h"
#include "core/engine/station/snapshot.h"
#include "tests/engine/ground.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/idle_link.h"
#include "tests/support/mavlink_hub.h"
#include "tests/support/router_spoofers.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

engine::StationConfig underAesCtr(engine::StationConfig config)
{
    config.preferredSuite = crypto::SuiteId::Aes256Ctr;
    return config;
}

/// Joins a socket to one end of a hub.
void join(QUdpSocket &socket, const MavlinkHub &hub, std::size_t end)
{
    socket.connectToHost(QHostAddress(QHostAddress::LocalHost), hub.port(end));
}

/// Agent and station at the first two ends of the router, the spoofers at the three behind them, the last is free.
struct RoutedFlight
{
    RoutedFlight() : ground(underAesCtr(rig.stationConfig()))
    {
        hub.setRemote(1, ground.port());
        rig.carrier = Carrier::Tunnel;
        rig.startAgent("127.0.0.1:" + std::to_string(hub.port(0)));
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
    }
    bool flying() const
    {
        return ground.up() && vehicle->sent > 20 && !ground.ears->snapshot->vehicles.empty()
            && ground.ears->snapshot->channel.suite == crypto::SuiteId::Aes256Ctr;
    }
    sim::FlightMode mode() const { return vehicle->vehicle.autopilot().modes().current(); }

    FlightRig rig;
    Ground ground;
    MavlinkHub hub{6};
    RouterSpoofers<QUdpSocket> spoofers{[this](std::size_t i, QUdpSocket &socket) { join(socket, hub, 2 + i); }};
    std::unique_ptr<VehicleOnUdp> vehicle;
};

/// Counts messages of the channel, and opens none.
struct MessageCounter final : engine::IngressSink
{
    bool takeRecord(const link::Link &, const link::ReceivedBlock &message) override
    {
        (message.path.carrier == Carrier::Tunnel ? inTunnel : inCobs) += 1;
        return false;
    }
    void takeClear(const link::Link &, const link::ReceivedBlock &, const mavlink::ScanItem &) override {}
    std::size_t inTunnel = 0, inCobs = 0;
};

} // namespace

class AttackRouterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void copiesAreSealed();
    void spoofedHeartbeatsAreNotTaken();
    void forgedTunnelsDivertNothing();
    void fakedCobsSilencesNothing();
};

void AttackRouterTest::copiesAreSealed()
{
    RoutedFlight flight;
    EVENTUALLY(flight.flying());
    std::size_t copies = 0, readable = 0;
    flight.spoofers.onCopy = [&](const mavlink::Frame &frame) {
        const mavlink::Tunnel copy = mavlink::Tunnel::decode(frame.payload());
        ++copies;
        readable += framesIn(QByteArray(reinterpret_cast<const char *>(copy.payload.data()), copy.payload_length));
    };
    flight.ground.station->perform(1, vehicle::ReadParameters{});
    EVENTUALLY(copies > 150);
    HOLDS(readable == 0, "he gets nothing but what is sealed");
    QVERIFY(!flight.spoofers.more);
    // The same search finds what an unsealed part would carry.
    QCOMPARE(framesIn(QByteArray(6, 'x') + frameOf(mavlink::Attitude{.roll = 1}, 1)), std::size_t(1));
}

void AttackRouterTest::spoofedHeartbeatsAreNotTaken()
{
    RoutedFlight flight;
    EVENTUALLY(flight.flying());
    const auto taken = [&] {
        const auto &vehicles = flight.ground.ears->snapshot->vehicles;
        return vehicles.size() != 1 || vehicles[0].state.armed;
    };
    const std::uint64_t before = flight.ground.ears->snapshot->plaintextRefused;
    EVENTUALLY(flight.ground.ears->snapshot->plaintextRefused > before + 30 || taken());
    HOLDS(!taken(), "the vehicle is shown as it is");
    QVERIFY(!flight.vehicle->vehicle.autopilot().armed());
}

void AttackRouterTest::forgedTunnelsDivertNothing()
{
    // From an address of his own he repeats each copy as a newer record; a receiver that accepted it would send to him.
    RoutedFlight flight;
    EVENTUALLY(flight.flying());
    QUdpSocket forger;
    join(forger, flight.hub, 5);
    constexpr std::uint8_t kForger = 42;
    flight.spoofers.onCopy = [&](const mavlink::Frame &frame) {
        mavlink::Tunnel copy = mavlink::Tunnel::decode(frame.payload());
        const bool isRecord = channel::kindOf(copy.payload[0]) == channel::DatagramKind::Record;
        if (frame.systemId() == kForger || !isRecord)
            return;
        copy.payload[4] = static_cast<std::uint8_t>(copy.payload[4] + 1); // its counter
        forger.write(frameOf(copy, kForger));
    };
    const auto station = [&] { return flight.ground.ears->snapshot->channel.rx; };
    const auto agent = [&] { return flight.rig.agent->snapshot().channel.rx; };
    const auto lost = [&] { return station().lost + agent().lost; };
    EVENTUALLY(agent().forged + station().forged > 0);
    const std::uint64_t good = station().good;
    const bool arrive = eventually([&] { return station().good > good + 60 && station().forged > 20; });
    HOLDS(arrive && lost() == 0, "delivery goes on");
    flight.ground.station->perform(1, vehicle::SetMode{"ALT_HOLD"});
    const bool set = eventually([&] { return flight.mode() == sim::FlightMode::AltHold; });
    const std::size_t sessions = flight.ground.ears->all<channel::SessionUp>().size();
    HOLDS(set && lost() == 0 && sessions == 1, "delivery goes on");
}

void AttackRouterTest::fakedCobsSilencesNothing()
{
    // A router passes frames of everybody on to the station's stream. One of them holds bytes that would open a handshake if
    // the stream were COBS, on which nobody looks for TUNNEL.
    constexpr LinkId kLink{1};
    constexpr TimePoint kReceivedAt{std::chrono::seconds(100)};
    MessageCounter sink;
    engine::CarrierWriter carriers;
    carriers.setNode({255, 190});
    engine::Ingress ingress(mavlink::Dialect::builtin(), carriers);
    ingress.addLink(kLink, {.isStream = true, .takesCobs = true, .takesTunnel = true, .clear = engine::ClearScan::UnlessCobs},
                    sink);
    const IdleLink link("tcp:127.0.0.1:1", kLink);
    const auto take = [&](ByteView frame) {
        Bytes bytes(frame.begin(), frame.end());
        ingress.take(link, {{kLink, {}}, bytes, kReceivedAt});
    };
    Bytes answer(channel::kAnswerLength, 7);
    answer[0] = channel::firstByte(channel::HandshakeMessage::Answer);
    mavlink::Tunnel fake{.payload_type = 1};
    fake.payload_length = static_cast<std::uint8_t>(channel::writeCobs(answer, fake.payload));
    QVERIFY(fake.payload_length > 0);
    fake.payload.back() = 1; // MAVLink leaves out zeros at the end
    constexpr std::size_t kMessages = 10;
    for (std::size_t i = 0; i < kMessages; ++i) {
        carriers.write({kLink, {}, Carrier::Tunnel, {}}, answer, take);
        const QByteArray bytes = frameOf(fake, 42);
        take({reinterpret_cast<const std::uint8_t *>(bytes.data()), static_cast<std::size_t>(bytes.size())});
    }
    HOLDS(sink.inTunnel == kMessages, "every message in TUNNEL is read");
    QCOMPARE(sink.inCobs, kMessages);
}

SKYSEAL_TEST(AttackRouterTest)
#include "attack_router_test.moc"
