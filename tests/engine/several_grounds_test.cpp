// One agent with several links to the ground: a station at each, or one station behind two modems.
#include "core/channel/endpoint.h"
#include "core/engine/station/snapshot.h"
#include "tests/engine/ground.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

using namespace skyseal;
using namespace skyseal::test;

namespace {

std::string local(quint16 port)
{
    return "127.0.0.1:" + std::to_string(port);
}

std::uint64_t framesAt(const Ground &ground)
{
    return ground.ears->snapshot->mavlink.frames;
}

bool hears(const Ground &ground)
{
    return ground.up() && framesAt(ground) > 20;
}

/// Between an agent and a station: what it carries can be cut in each direction.
struct Modem
{
    explicit Modem(quint16 station) : relay(station)
    {
        relay.passes = [this](const UdpAttacker::Seen &seen) {
            const bool passes = seen.toGround ? up : down;
            carried += passes && !channel::Endpoint::isAnnouncement(viewOf(seen.bytes));
            return passes;
        };
    }
    static ByteView viewOf(const QByteArray &bytes)
    {
        return {reinterpret_cast<const std::uint8_t *>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
    }

    bool up = true, down = true; ///< to the station, to the agent
    std::uint64_t carried = 0;   ///< datagrams other than announcements
    UdpAttacker relay;
};

} // namespace

class SeveralGroundsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationsEachAtItsLink();
    void plainFramesReachAll();
    void takesTheModemThatWorks_data();
    void takesTheModemThatWorks();
};

void SeveralGroundsTest::stationsEachAtItsLink()
{
    FlightRig rig;
    Ground pilot(rig.stationConfig());
    Ground observer(rig.addStation("observer", channel::PeerRole::Observer));
    rig.startAgentAt({pilot.ears->listening(), observer.ears->listening()});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(hears(pilot) && hears(observer));

    const engine::AgentSnapshot agent = rig.agent->snapshot();
    QCOMPARE(agent.grounds.size(), std::size_t(2));
    QCOMPARE(agent.grounds[0].remoteAddress, pilot.ears->listening());
    QCOMPARE(agent.grounds[1].remoteAddress, observer.ears->listening());
    QVERIFY(agent.grounds[0].rxDatagrams > 0 && agent.grounds[1].rxDatagrams > 0);

    // One station ends; the other does not notice.
    observer.station.reset();
    const std::uint64_t before = framesAt(pilot);
    EVENTUALLY(framesAt(pilot) > before + 50);
    QCOMPARE(pilot.ears->all<channel::SessionUp>().size(), std::size_t(1));
}

void SeveralGroundsTest::plainFramesReachAll()
{
    FlightRig rig;
    rig.allowPlain = true;
    Ground one(rig.stationConfig(engine::SecureMode::Off)), other(rig.stationConfig(engine::SecureMode::Off));
    rig.startAgentAt({one.ears->listening(), other.ears->listening()});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(framesAt(one) > 50 && framesAt(other) > 50);
    QCOMPARE(one.ears->snapshot->mavlink.lost, std::uint64_t(0));
    QCOMPARE(other.ears->snapshot->mavlink.lost, std::uint64_t(0));
}

void SeveralGroundsTest::takesTheModemThatWorks_data()
{
    QTest::addColumn<bool>("up");
    QTest::addColumn<bool>("down");
    QTest::newRow("cut in both directions") << false << false;
    QTest::newRow("cut towards the station") << false << true;
    QTest::newRow("cut towards the agent") << true << false;
}

/// channel/two_ways_test has the times.
void SeveralGroundsTest::takesTheModemThatWorks()
{
    QFETCH(bool, up);
    QFETCH(bool, down);
    FlightRig rig;
    Ground ground(rig.stationConfig());
    Modem first(ground.port()), second(ground.port());
    rig.startAgentAt({local(first.relay.port()), local(second.relay.port())});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(hears(ground));
    QCOMPARE(ground.ears->all<channel::SessionUp>().size(), std::size_t(1));

    const bool usedFirst = first.carried > second.carried;
    Modem &used = usedFirst ? first : second, &other = usedFirst ? second : first;
    for (const bool back : {false, true}) { // to the other modem, then back
        Modem &failing = back ? other : used, &good = back ? used : other;
        good.up = good.down = true;
        failing.up = up;
        failing.down = down;
        // Telemetry comes again, and what the station sends reaches the vehicle.
        const std::uint64_t carried = good.carried;
        EVENTUALLY(good.carried > carried + 50);
        const std::uint64_t frames = framesAt(ground), commands = rig.agent->snapshot().counters.toVehicle;
        EVENTUALLY(framesAt(ground) > frames + 20);
        EVENTUALLY(rig.agent->snapshot().counters.toVehicle > commands + 1);
        QCOMPARE(int(ground.ears->snapshot->security), int(engine::Security::Sealed));
    }
}

SKYSEAL_TEST(SeveralGroundsTest)
#include "several_grounds_test.moc"
