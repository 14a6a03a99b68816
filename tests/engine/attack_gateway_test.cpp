// An attack on the sealed link of a gateway while a client flies a vehicle through it. The gateway counts each forged and each
// replayed record, and reports them; the client, whose own link is not sealed, notices nothing.
#include "core/engine/headless/event_json.h"
#include "core/engine/headless/open_metrics.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/request.h"
#include "tests/engine/served_flight.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/json_values.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

#include <QtCore/QJsonDocument>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// A flight behind a gateway with an attacker between agent and gateway, and a client that is a whole ground station.
struct AttackedGateway
{
    AttackedGateway() : ground(gatewayConfig(rig)), attacker(ground.port())
    {
        ground.station->serve({*engine::ServeConfig::parse("udpin:127.0.0.1:0,write=all")});
        rig.startAgent("127.0.0.1:" + std::to_string(attacker.port()));
        aircraft = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
        aircraft->vehicle.autopilot().parameters().set("SIM_SPEEDUP", 5);
        const auto isServed = [this] {
            const engine::Snapshot &now = *ground.ears->snapshot;
            return !now.vehicles.empty() && now.served.size() == 1 && now.served[0].phase == engine::LinkPhase::Listening;
        };
        if (!eventually(isServed))
            qFatal("no vehicle behind the gateway");
        client = std::make_unique<Ground>(plainConfig(), urlOf("udpout:" + ground.ears->snapshot->served[0].localAddress));
        if (!eventually([this] { return !client->ears->snapshot->vehicles.empty(); }))
            qFatal("the client sees no vehicle");
    }

    const engine::Snapshot &gateway() const { return *ground.ears->snapshot; }
    /// Whether the vehicle accepts a command of the client, which repeats it until then.
    bool obeys(const vehicle::VehicleCommand &command) const
    {
        vehicle::RequestId id = client->station->perform(1, command);
        return eventually([&] {
            for (const vehicle::CommandResult &result : client->ears->all<vehicle::CommandResult>()) {
                if (result.id != id)
                    continue;
                if (result.outcome == vehicle::CommandOutcome::Accepted)
                    return true;
                id = client->station->perform(1, command); // refused before the vehicle is ready
                return false;
            }
            return false;
        });
    }
    /// The records of the agent that arrived.
    std::vector<QByteArray> records() const
    {
        std::vector<QByteArray> out;
        for (const UdpAttacker::Seen &seen : attacker.seen) {
            if (seen.toGround && (seen.bytes[0] & 0xfc) == 0x50)
                out.push_back(seen.bytes);
        }
        return out;
    }

    FlightRig rig;
    Ground ground;
    UdpAttacker attacker;
    std::unique_ptr<VehicleOnUdp> aircraft;
    std::unique_ptr<Ground> client;
};

/// With a counter that was not received yet, so that only the tag shows the forgery.
QByteArray withFutureCounter(QByteArray record)
{
    return record.replace(3, 3, QByteArray::fromHex("ffff3f"));
}

} // namespace

class AttackGatewayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void attackIsCountedAndTheClientNoticesNothing();
};

void AttackGatewayTest::attackIsCountedAndTheClientNoticesNothing()
{
    AttackedGateway flight;
    QVERIFY(flight.obeys(vehicle::SetMode{"GUIDED"}));
    QVERIFY(flight.obeys(vehicle::Arm{}));
    const channel::ReceiveCounters before = flight.gateway().channel.rx;
    QCOMPARE(before.forged + before.replayed + before.lost, std::uint64_t(0));
    const std::uint64_t framesBefore = flight.client->ears->snapshot->mavlink.frames;
    QVERIFY(flight.obeys(vehicle::TakeOff{10}));

    // From the agent's own address, as the attacker on the wire, and from another, as any stranger.
    const auto rx = [&flight] { return flight.gateway().channel.rx; };
    QUdpSocket stranger;
    std::uint64_t forged = 0, replayed = 0;
    for (int round = 0; round < 50 && rx().lost == 0; ++round) {
        const std::vector<QByteArray> records = flight.records();
        QVERIFY(records.size() >= 4);
        for (std::size_t i = records.size() - 4; i < records.size(); ++i) {
            flight.attacker.toGround(records[i]);
            flight.attacker.toGround(withFutureCounter(records[i]));
            stranger.writeDatagram(records[i], QHostAddress::LocalHost, flight.ground.port());
            stranger.writeDatagram(withFutureCounter(records[i]), QHostAddress::LocalHost, flight.ground.port());
            forged += 2, replayed += 2;
        }
        EVENTUALLY(rx().forged >= forged || rx().lost > 0); // the last datagram of a round is a forgery
    }
    HOLDS(rx().forged == forged && rx().replayed == replayed && rx().lost == 0,
          "each forged and each replayed record is refused and counted");

    // The client's flight goes on.
    EVENTUALLY(flight.aircraft->vehicle.autopilot().heightAboveHome() > 5);
    QVERIFY(flight.obeys(vehicle::Land{}));
    EVENTUALLY(flight.client->ears->snapshot->mavlink.frames > framesBefore + 200);
    const engine::Snapshot &seen = *flight.client->ears->snapshot;
    QCOMPARE(seen.vehicles.size(), std::size_t(1));
    QCOMPARE(seen.mavlink.lost, std::uint64_t(0));
    QCOMPARE(seen.mavlink.late, std::uint64_t(0));
    QCOMPARE(seen.mavlink.duplicate, std::uint64_t(0));
    QCOMPARE(seen.mavlink.badCrc, std::uint64_t(0));
    const auto isOfGateway = [](const vehicle::TextReceived &text) { return text.text.text.starts_with("Gateway:"); };
    QVERIFY(std::ranges::none_of(flight.client->ears->all<vehicle::TextReceived>(), isOfGateway));

    // Exactly the attacker's records, also in what scripts and monitoring read.
    const engine::Snapshot &gateway = flight.gateway();
    QCOMPARE(gateway.channel.rx.forged, forged);
    QCOMPARE(gateway.channel.rx.replayed, replayed);
    QCOMPARE(gateway.channel.rx.lost, std::uint64_t(0));
    QCOMPARE(gateway.clients.size(), std::size_t(1));
    QCOMPARE(gateway.clients[0].counters.denied, std::uint64_t(0));
    QCOMPARE(gateway.sessions.size(), std::size_t(1));
    QVERIFY(engine::isAttacked(gateway.sessions[0]));
    const QJsonObject status = QJsonDocument::fromJson(QByteArray::fromStdString(engine::statusEvent(gateway))).object();
    const QJsonValue counted = status[QLatin1String("channel")][QLatin1String("rx")];
    QCOMPARE(std::uint64_t(number(counted, "forged")), forged);
    QCOMPARE(std::uint64_t(number(counted, "replayed")), replayed);
    const std::string metrics = engine::openMetrics(gateway);
    for (const auto &[outcome, count] : {std::pair("forged", forged), std::pair("replayed", replayed)}) {
        const std::string line = "skyseal_records_total{outcome=\"" + std::string(outcome) + "\"} " + std::to_string(count)
            + "\n";
        QVERIFY2(metrics.find(line) != std::string::npos, line.c_str());
    }

    // And by events, all forged records together.
    const auto reported = [&] {
        std::uint64_t sum = 0;
        for (const channel::ForgeryAlarm &alarm : flight.ground.ears->all<channel::ForgeryAlarm>())
            sum += alarm.forged;
        return sum;
    };
    EVENTUALLY_EQUAL(reported(), forged);
    QCOMPARE(flight.ground.ears->all<channel::SessionUp>().size(), std::size_t(1));
    QVERIFY(flight.ground.ears->all<channel::PeerMoved>().empty());
}

SKYSEAL_TEST(AttackGatewayTest)
#include "attack_gateway_test.moc"
