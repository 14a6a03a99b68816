// AgentReceiver alone, without sockets and sessions of its own: where the frames of the vehicle and of the ground go.
#include "core/channel/endpoint.h"
#include "core/engine/agent/agent_receiver.h"
#include "core/link/address_text.h"
#include "tests/channel/identity.h"
#include "tests/crypto/seeded_random.h"
#include "tests/support/clear_frames.h"
#include "tests/support/command_long.h"
#include "tests/support/heartbeat.h"
#include "tests/support/idle_link.h"
#include "tests/support/test_runner.h"
#include "tests/support/volatile_counters.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr TimePoint kArrival{std::chrono::seconds(100)};
constexpr std::uint8_t kPilotsSystem = 201; ///< bound to the pilot by the list

enum class Clear { Forbidden, Allowed };

constexpr const char *kVehicleUrl = "udpin:127.0.0.1:0", *kGroundUrl = "udpout:127.0.0.1:14550";

AgentConfig agentConfig(Clear clear, Carrier carrier)
{
    AgentConfig out{urlOf(kVehicleUrl), {{urlOf(kGroundUrl), carrier}}, {}};
    out.allowPlain = clear == Clear::Allowed;
    return out;
}

channel::Config channelConfig(const channel::Peer &peer)
{
    channel::Config out;
    out.role = channel::Role::Agent;
    out.identity = newIdentity(1);
    out.peers = {peer};
    return out;
}

struct Rig final : private link::LinkListener, private AgentReceiver::EventHandler
{
    explicit Rig(Clear clear = Clear::Forbidden, Carrier carrier = Carrier::Datagram) : config(agentConfig(clear, carrier))
    {
        receiver.setPeers({pilot});
        receiver.addLinks();
    }
    void takeFromVehicle(const QByteArray &bytes) { take(vehicle, vehiclePath, bytes); }
    void takeFromGround(const QByteArray &bytes) { take(ground, groundPath, bytes); }
    void beginSession()
    {
        receiver.sessionUp({.session = kSession, .peer = pilot.key, .peerName = pilot.name, .path = groundPath});
    }
    template<typename Kind> qsizetype count() const
    {
        return std::ranges::count_if(events, [](const AgentEvent &event) { return std::holds_alternative<Kind>(event); });
    }

    static constexpr channel::SessionId kSession{1};

    SeededRandom random{1};
    VolatileCounters counterStore;
    const channel::Peer pilot{.key = publicKeyOf(*newIdentity(2)), .name = "pilot", .systemIds = {kPilotsSystem}};
    AgentConfig config;
    IdleLink vehicle{kVehicleUrl, kVehicleLink}, ground{kGroundUrl, groundLink(0)};
    Path vehiclePath{kVehicleLink, *link::parseHost("127.0.0.1", 5760)};
    Path groundPath{groundLink(0), *link::parseHost("127.0.0.1", 14550)};
    LinkPool links{*this, [](link::Link &) {}};
    Ingress ingress{mavlink::Dialect::builtin(), links.carriers()};
    ChannelDriver channel{{channelConfig(pilot), random, counterStore, kArrival}, links};
    std::vector<channel::PairingEvent> pairingEvents;
    PairingDriver pairing{links, random, [this](const channel::PairingEvent &event) { pairingEvents.push_back(event); }};
    NodeHeartbeat node;
    std::vector<AgentEvent> events;
    AgentEvents publisher{[this](AgentEvent event) { events.push_back(std::move(event)); }};
    AgentReceiver receiver{{config, links, ingress, channel, pairing, node, publisher, *this}};

private:
    void take(link::Link &link, const Path &from, const QByteArray &bytes)
    {
        Bytes block(bytes.begin(), bytes.end());
        ingress.take(link, {from, block, kArrival});
    }
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
    void handleEvents(std::optional<channel::SessionId>) override {}
};

const QByteArray kVehicleHeartbeat = clearHeartbeat(1, 1, false);
const QByteArray kCommand = frameOf(commandLong(400), 255);

} // namespace

class AgentReceiverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void vehicleWithoutStation();
    void vehicleWithStation();
    void clearCommand();
    void clearCommandWhileSealed();
    void clearIsAllowedUntilASessionBegins();
    void clearWithoutVehicle();
    void vehicleClaimsAGroundId();
    void armedVehicleEndsPairing();
    void damagedFrames();
    void unusableDatagrams_data();
    void unusableDatagrams();
};

void AgentReceiverTest::vehicleWithoutStation()
{
    Rig rig;
    rig.takeFromVehicle(kVehicleHeartbeat);
    QVERIFY(rig.receiver.isVehicle(1));
    QCOMPARE(rig.receiver.onlySystem(), std::uint8_t(1));
    QVERIFY(!rig.receiver.isAnyArmed());
    QCOMPARE(rig.receiver.counters().undelivered, std::uint64_t(1));
    QCOMPARE(rig.receiver.counters().toGround, std::uint64_t(0));
}

void AgentReceiverTest::vehicleWithStation()
{
    Rig rig;
    rig.beginSession();
    rig.takeFromVehicle(kVehicleHeartbeat + kVehicleHeartbeat);
    QCOMPARE(rig.receiver.counters().toGround, std::uint64_t(2));
    rig.receiver.sessionDown(Rig::kSession);
    rig.takeFromVehicle(kVehicleHeartbeat);
    QCOMPARE(rig.receiver.counters().toGround, std::uint64_t(2));
    QCOMPARE(rig.receiver.counters().undelivered, std::uint64_t(1));
}

void AgentReceiverTest::clearCommand()
{
    Rig rig(Clear::Allowed);
    rig.takeFromVehicle(kVehicleHeartbeat);
    rig.takeFromGround(kCommand);
    QCOMPARE(rig.receiver.counters().toVehicle, std::uint64_t(1));
    QCOMPARE(rig.receiver.counters().clearRefused, std::uint64_t(0));
}

void AgentReceiverTest::clearCommandWhileSealed()
{
    Rig rig;
    rig.takeFromVehicle(kVehicleHeartbeat);
    rig.takeFromGround(kCommand);
    QCOMPARE(rig.receiver.counters().toVehicle, std::uint64_t(0));
    QCOMPARE(rig.receiver.counters().clearRefused, std::uint64_t(1));
}

void AgentReceiverTest::clearIsAllowedUntilASessionBegins()
{
    Rig rig(Clear::Allowed);
    rig.takeFromVehicle(kVehicleHeartbeat);
    rig.beginSession();
    rig.takeFromGround(kCommand);
    QCOMPARE(rig.receiver.counters().toVehicle, std::uint64_t(0));
    QCOMPARE(rig.receiver.counters().clearRefused, std::uint64_t(1));
    rig.receiver.sessionDown(Rig::kSession);
    rig.takeFromGround(kCommand);
    QCOMPARE(rig.receiver.counters().toVehicle, std::uint64_t(1));
}

void AgentReceiverTest::clearWithoutVehicle()
{
    Rig rig(Clear::Allowed);
    rig.takeFromGround(kCommand);
    QCOMPARE(rig.receiver.counters().toVehicle, std::uint64_t(0));
    QCOMPARE(rig.receiver.counters().undelivered, std::uint64_t(1));
}

/// Shown as a vehicle, it could speak as the station of another pilot.
void AgentReceiverTest::vehicleClaimsAGroundId()
{
    Rig rig;
    rig.beginSession();
    rig.takeFromVehicle(clearHeartbeat(kPilotsSystem, 1, false));
    QVERIFY(!rig.receiver.isVehicle(kPilotsSystem));
    QCOMPARE(rig.receiver.counters().toGround, std::uint64_t(0));
    QCOMPARE(rig.receiver.counters().groundIdRefused, std::uint64_t(1));
    QCOMPARE(rig.count<GroundIdClaimed>(), qsizetype(1));
}

void AgentReceiverTest::armedVehicleEndsPairing()
{
    Rig rig;
    channel::PairingConfig window;
    window.role = channel::Role::Agent;
    window.identity = newIdentity(1);
    rig.pairing.open(kArrival, std::move(window));
    rig.takeFromVehicle(kVehicleHeartbeat);
    QVERIFY(rig.pairing.isOpen());
    rig.takeFromVehicle(clearHeartbeat(1, 1, true));
    QVERIFY(rig.receiver.isAnyArmed());
    rig.pairing.flush();
    QVERIFY(!rig.pairing.isOpen());
    QCOMPARE(rig.pairingEvents.size(), std::size_t(1));
    const auto *over = std::get_if<channel::PairingOver>(&rig.pairingEvents.front());
    QVERIFY(over && over->reason == channel::PairingEnd::Armed);
}

void AgentReceiverTest::damagedFrames()
{
    Rig rig;
    QByteArray damaged = kVehicleHeartbeat;
    damaged[damaged.size() - 1] = static_cast<char>(damaged.back() ^ 1);
    rig.takeFromVehicle(damaged);
    QVERIFY(!rig.receiver.isVehicle(1));
    QCOMPARE(rig.receiver.counters().undelivered, std::uint64_t(0));
}

void AgentReceiverTest::unusableDatagrams_data()
{
    QTest::addColumn<Carrier>("carrier");
    QTest::addColumn<std::uint64_t>("unusable");
    QTest::addRow("from a station") << Carrier::Datagram << std::uint64_t(1);
    QTest::addRow("from a router") << Carrier::Tunnel << std::uint64_t(0);
}

void AgentReceiverTest::unusableDatagrams()
{
    QFETCH(Carrier, carrier);
    QFETCH(std::uint64_t, unusable);
    Rig rig(Clear::Forbidden, carrier);
    rig.takeFromGround(QByteArray(20, char(0xFF))); // neither a record nor a frame begins with it
    QCOMPARE(rig.receiver.counters().unusable, unusable);
    QCOMPARE(rig.receiver.counters().clearRefused, std::uint64_t(0));
}

SKYSEAL_TEST_APPLESS(AgentReceiverTest)
#include "agent_receiver_test.moc"
