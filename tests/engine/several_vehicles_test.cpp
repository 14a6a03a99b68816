// Several vehicles behind one agent: each is addressed alone, by each station with its rights, whichever part starts again.
#include "core/engine/station/snapshot.h"
#include "core/keys/usable_peers.h"
#include "tests/engine/ground.h"
#include "tests/support/test_runner.h"

#include <array>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr int kVehicles = 3;

/// Three vehicles on one link of an agent, as autopilots that share a network or a serial bus with it.
struct SeveralVehicles
{
    explicit SeveralVehicles(std::vector<std::uint8_t> pinned = {}) : rig(channel::PeerRole::Pilot, std::move(pinned)) {}

    void start(int number) // 1 to kVehicles, its system id
    {
        vehicles[static_cast<std::size_t>(number - 1)] = std::make_unique<VehicleOnUdp>(rig.vehicleAddress(),
                                                                                        static_cast<std::uint8_t>(number));
    }
    void startAll()
    {
        for (int number = 1; number <= kVehicles; ++number)
            start(number);
    }
    sim::Autopilot &autopilot(int number) { return vehicles[static_cast<std::size_t>(number - 1)]->vehicle.autopilot(); }
    float speedOf(int number) { return autopilot(number).parameters().value("WPNAV_SPEED"); }

    FlightRig rig;
    std::array<std::unique_ptr<VehicleOnUdp>, kVehicles> vehicles;
};

std::size_t heardBy(const Ground &ground)
{
    const auto &vehicles = ground.ears->snapshot->vehicles;
    return static_cast<std::size_t>(std::ranges::count_if(
        vehicles, [](const engine::VehicleSnapshot &vehicle) { return !vehicle.state.lost && !vehicle.ended; }));
}

/// Writes a parameter of one vehicle; returns whether the vehicle has it.
bool setSpeed(Ground &ground, int number, double speed)
{
    const vehicle::RequestId id = ground.station->perform(static_cast<std::uint8_t>(number),
                                                          vehicle::WriteParameter{"WPNAV_SPEED", speed});
    std::optional<bool> ok;
    const bool came = eventually([&] {
        for (const auto &result : ground.ears->all<vehicle::ParameterResult>()) {
            if (result.id == id)
                ok = result.ok;
        }
        return ok.has_value();
    });
    return came && *ok;
}

} // namespace

class SeveralVehiclesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachIsAddressedAlone();
    void rolesAndRevocationConcernEachStation();
    void agentIsBoundToSomeOfThem();
    void eachPartMayStartAgain();
    void figuresOfACipherAreThoseOfWhatItOpened();
};

void SeveralVehiclesTest::eachIsAddressedAlone()
{
    SeveralVehicles flight;
    Ground pilot(flight.rig.stationConfig());
    flight.rig.startAgent(pilot.ears->listening());
    flight.startAll();
    EVENTUALLY_EQUAL(heardBy(pilot), std::size_t(kVehicles));
    const float before = flight.speedOf(1);
    QVERIFY(setSpeed(pilot, 2, 720) && setSpeed(pilot, 3, 730));
    QCOMPARE(flight.speedOf(1), before);
    QCOMPARE(flight.speedOf(2), 720.f);
    QCOMPARE(flight.speedOf(3), 730.f);

    pilot.station->perform(2, vehicle::VehicleCommand(vehicle::Arm{.force = true}));
    EVENTUALLY(flight.autopilot(2).armed());
    EVENTUALLY_EQUAL(pilot.ears->all<vehicle::CommandResult>().size(), std::size_t(1));
    QCOMPARE(int(pilot.ears->all<vehicle::CommandResult>()[0].systemId), 2);
    QVERIFY(!flight.autopilot(1).armed() && !flight.autopilot(3).armed());
    QCOMPARE(pilot.ears->snapshot->mavlink.lost, std::uint64_t(0));
}

void SeveralVehiclesTest::rolesAndRevocationConcernEachStation()
{
    SeveralVehicles flight;
    Ground pilot(flight.rig.stationConfig());
    Ground observer(flight.rig.addStation("observer", channel::PeerRole::Observer));
    flight.rig.startAgentAt({pilot.ears->listening(), observer.ears->listening()});
    flight.startAll();
    EVENTUALLY(heardBy(pilot) == kVehicles && heardBy(observer) == kVehicles);
    for (int number = 1; number <= kVehicles; ++number) {
        const float before = flight.speedOf(number);
        QVERIFY(!setSpeed(observer, number, 650));
        QCOMPARE(flight.speedOf(number), before);
        QVERIFY(setSpeed(pilot, number, 600 + number));
        QCOMPARE(flight.speedOf(number), float(600 + number));
    }
    // The pilot's key is removed: its session ends for all vehicles, and the observer sees all of them on.
    std::vector<channel::Peer> others;
    std::ranges::copy_if(flight.rig.peersOfAgent(), std::back_inserter(others),
                         [](const channel::Peer &peer) { return peer.name == "observer"; });
    QCOMPARE(others.size(), std::size_t(1));
    flight.rig.agent->setPeers(others);
    EVENTUALLY(!pilot.ears->all<channel::SessionDown>().empty());
    EVENTUALLY_EQUAL(heardBy(pilot), std::size_t(0));
    pilot.station->perform(1, vehicle::VehicleCommand(vehicle::Arm{.force = true}));
    const std::uint64_t frames = observer.ears->snapshot->mavlink.frames;
    EVENTUALLY(observer.ears->snapshot->mavlink.frames > frames + 100);
    QCOMPARE(heardBy(observer), std::size_t(kVehicles));
    QVERIFY(!flight.autopilot(1).armed());
}

/// The station's list binds the agent to two of the systems.
void SeveralVehiclesTest::agentIsBoundToSomeOfThem()
{
    SeveralVehicles flight({1, 2});
    Ground pilot(flight.rig.stationConfig());
    flight.rig.startAgent(pilot.ears->listening());
    flight.startAll();
    EVENTUALLY_EQUAL(heardBy(pilot), std::size_t(2));
    EVENTUALLY(!pilot.ears->all<engine::OtherSystemsHeard>().empty());
    QCOMPARE(pilot.ears->all<engine::OtherSystemsHeard>()[0].vehicles, std::vector<std::uint8_t>{3});
    QVERIFY(pilot.ears->all<engine::SystemRefused>().empty());
    QVERIFY(setSpeed(pilot, 2, 720));
    QCOMPARE(heardBy(pilot), std::size_t(2));
}

void SeveralVehiclesTest::eachPartMayStartAgain()
{
    SeveralVehicles flight;
    auto pilot = std::make_unique<Ground>(flight.rig.stationConfig());
    const std::string address = pilot->ears->listening();
    flight.rig.startAgent(address);
    flight.startAll();
    EVENTUALLY_EQUAL(heardBy(*pilot), std::size_t(kVehicles));
    double speed = 700;
    const auto allAreAddressed = [&] {
        for (int number = 1; number <= kVehicles; ++number) {
            speed += 1;
            if (!setSpeed(*pilot, number, speed) || flight.speedOf(number) != float(speed))
                return false;
        }
        return true;
    };
    // Each vehicle, at another port.
    for (int number = 1; number <= kVehicles; ++number) {
        flight.start(number);
        const auto moved = [&] { return setSpeed(*pilot, number, ++speed) && flight.speedOf(number) == float(speed); };
        EVENTUALLY(moved());
    }
    QVERIFY(allAreAddressed());
    QCOMPARE(pilot->ears->all<channel::SessionUp>().size(), std::size_t(1));

    flight.rig.killAgent();
    flight.rig.startAgent(address);
    EVENTUALLY_EQUAL(pilot->ears->all<channel::SessionUp>().size(), std::size_t(2));
    EVENTUALLY_EQUAL(heardBy(*pilot), std::size_t(kVehicles));
    QVERIFY(allAreAddressed());

    pilot.reset();
    pilot = std::make_unique<Ground>(flight.rig.stationConfig(), urlOf("udpin:" + address));
    EVENTUALLY_EQUAL(heardBy(*pilot), std::size_t(kVehicles));
    QVERIFY(allAreAddressed());
}

/// The cipher's sealed vehicle beside one in clear, which sends as much.
void SeveralVehiclesTest::figuresOfACipherAreThoseOfWhatItOpened()
{
    FlightRig rig(channel::PeerRole::Pilot, {1});
    Ground pilot(rig.stationConfig(engine::SecureMode::Preferred));
    rig.startAgent(pilot.ears->listening());
    VehicleOnUdp sealed(rig.vehicleAddress(), 1);
    EVENTUALLY(pilot.up() && heardBy(pilot) == 1);
    VehicleOnUdp clear(pilot.ears->listening(), 2);
    pilot.station->allowPlaintext(2);
    EVENTUALLY(heardBy(pilot) == 2);

    const auto snapshot = [&] { return pilot.ears->snapshot; };
    const auto totals = [&] { return snapshot()->sessions.at(0).mavlink; };
    const std::uint64_t before = totals().frames, clearBefore = snapshot()->clear.frames;
    const std::uint64_t sentBefore = sealed.sent, clearSentBefore = clear.sent;
    EVENTUALLY(snapshot()->clear.frames > clearBefore + 300 && totals().frames > before + 300);
    const std::uint64_t kOnTheWay = 40; // sent, and not yet in the snapshot, at either end
    const std::uint64_t opened = totals().frames - before, sent = sealed.sent - sentBefore;
    QVERIFY2(opened <= sent + kOnTheWay, qPrintable(QStringLiteral("%1 of %2").arg(opened).arg(sent)));
    QVERIFY(snapshot()->clear.frames - clearBefore <= clear.sent - clearSentBefore + kOnTheWay);
    QCOMPARE(snapshot()->mavlink.frames, snapshot()->clear.frames + totals().frames);

    // The samples of a second each, added up, are the growth of what was opened.
    std::uint64_t number = snapshot()->samples.back().number;
    const std::uint64_t begin = totals().frames, beginOfAll = snapshot()->mavlink.frames;
    double opening = 0;
    int readings = 0;
    EVENTUALLY([&] {
        for (const engine::MetricsSample &sample : snapshot()->samples) {
            if (sample.number != number + 4)
                continue;
            number = sample.number;
            opening += sample.openedFramesPerSecond;
            ++readings;
        }
        return readings >= 3;
    }());
    const auto grown = static_cast<double>(totals().frames - begin);
    const auto all = static_cast<double>(snapshot()->mavlink.frames - beginOfAll);
    QVERIFY2(opening < 0.75 * all && opening < grown + 2 * static_cast<double>(kOnTheWay),
             qPrintable(QStringLiteral("%1 of %2 and %3").arg(opening).arg(grown).arg(all)));
}

SKYSEAL_TEST(SeveralVehiclesTest)
#include "several_vehicles_test.moc"
