// The failsafe of a vehicle for a lost ground station, behind a gateway: only the heartbeats of clients that may write keep it
// away. https://ardupilot.org/copter/docs/gcs-failsafe.html
#include "core/engine/station/snapshot.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/engine/served_flight.h"
#include "tests/engine/udp_end.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// FS_GCS_TIMEOUT in seconds: the heartbeats of this test are twelve times as frequent.
constexpr float kTimeout = 3;
constexpr int kHeartbeatMs = 250;

/// A hovering vehicle behind a gateway with a link for a pilot and one for a reader, both of which send heartbeats.
struct WatchedFlight
{
    WatchedFlight() : ground(gatewayConfig(rig))
    {
        ground.station->serve({*engine::ServeConfig::parse("udpin:127.0.0.1:0,write=command,name=pilot"),
                               *engine::ServeConfig::parse("udpin:127.0.0.1:0,name=reader")});
        rig.startAgent(ground.ears->listening());
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
        autopilot().parameters().set("SIM_SPEEDUP", 5); // of the flight, not of the heartbeats
        autopilot().parameters().set("FS_GCS_TIMEOUT", kTimeout);
        const auto isServed = [this] {
            const engine::Snapshot &now = *ground.ears->snapshot;
            return now.served.size() == 2 && !now.vehicles.empty()
                && std::ranges::all_of(now.served, [](const auto &link) { return link.phase == engine::LinkPhase::Listening; });
        };
        if (!eventually(isServed))
            qFatal("no vehicle behind the gateway");
        pilot = std::make_unique<UdpEnd>(portOf(ground.ears->snapshot->served[0].localAddress));
        reader = std::make_unique<UdpEnd>(portOf(ground.ears->snapshot->served[1].localAddress));
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { sendHeartbeats(); });
        m_timer.start(kHeartbeatMs);
        if (!eventually([this] { return takesOff(); }))
            qFatal("no take-off");
    }
    sim::Autopilot &autopilot() { return vehicle->vehicle.autopilot(); }
    bool isReturning() { return autopilot().modes().current() == sim::FlightMode::Rtl; }
    /// Whether the reader received the vehicle's report of the failsafe.
    bool isReported() const
    {
        const auto isFailsafe = [](const mavlink::Statustext &text) {
            return mavlink::textOf(text.text).starts_with("GCS Failsafe");
        };
        return reader->newest<mavlink::Statustext>(isFailsafe).has_value();
    }

    FlightRig rig;
    Ground ground;
    std::unique_ptr<VehicleOnUdp> vehicle;
    std::unique_ptr<UdpEnd> pilot, reader;
    bool isPilotThere = true;
    int readersHeartbeats = 0;

private:
    void sendHeartbeats()
    {
        const mavlink::Heartbeat heartbeat{.type = mavlink::MAV_TYPE_GCS};
        if (isPilotThere)
            pilot->send(heartbeat);
        reader->send(heartbeat); // as the pilot's system
        ++readersHeartbeats;
    }
    bool takesOff()
    {
        if (autopilot().armed())
            return !autopilot().landed();
        // Refused until the vehicle knows its position.
        if (!autopilot().requests().enterMode(sim::FlightMode::Guided) && !autopilot().arming().arm(false))
            autopilot().requests().takeOff(10);
        return false;
    }

    QTimer m_timer;
};

} // namespace

class GatewayFailsafeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void silentPilotIsMissedAlthoughAReaderIsThere();
};

void GatewayFailsafeTest::silentPilotIsMissedAlthoughAReaderIsThere()
{
    WatchedFlight flight;
    const auto time = [&] { return flight.ground.ears->snapshot->time; };
    const double begin = time();
    EVENTUALLY(time() > begin + 2 * double(kTimeout) || flight.isReturning());
    QVERIFY2(!flight.isReturning(), "no failsafe while the pilot's heartbeats arrive");
    QVERIFY(!flight.isReported());

    flight.isPilotThere = false;
    const int before = flight.readersHeartbeats;
    EVENTUALLY2(flight.isReturning(), "the failsafe acts although the reader sends heartbeats");
    EVENTUALLY(flight.isReported());
    QVERIFY(flight.readersHeartbeats - before > 2);
    QCOMPARE(flight.ground.ears->snapshot->clients.size(), std::size_t(2)); // both are connected all the time
}

SKYSEAL_TEST(GatewayFailsafeTest)
#include "gateway_failsafe_test.moc"
