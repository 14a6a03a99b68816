// A station beside a vehicle that knows MAVLink 1 alone, in clear and over the sealed link, and the station's heartbeat where
// vehicles of both versions share a link.
#include "core/engine/station/snapshot.h"
#include "tests/engine/ground.h"
#include "tests/support/scripted_vehicle.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class Mavlink1Test : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationSpeaksWhatItHears();
    void alsoThroughTheSeal();
};

namespace {

std::vector<ScriptedVehicle::Value> twoValues()
{
    return {{.name = "RTL_ALT", .raw = 1500}, {.name = "SYSID_THISMAV", .raw = 1}};
}

std::uint16_t portIn(const std::string &address)
{
    return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

} // namespace

void Mavlink1Test::stationSpeaksWhatItHears()
{
    Ground ground(plainConfig());
    ScriptedVehicle vehicle(ground.port(), twoValues(), 1);
    EVENTUALLY(!ground.ears->all<engine::VehicleFound>().empty());
    ground.station->perform(1, vehicle::ReadParameters{});
    EVENTUALLY(!ground.ears->all<vehicle::ParameterResult>().empty());
    QVERIFY(ground.ears->all<vehicle::ParameterResult>()[0].ok);
    ground.station->perform(1, vehicle::WriteParameter{"RTL_ALT", 2000});
    EVENTUALLY_EQUAL(ground.ears->all<vehicle::ParameterResult>().size(), std::size_t(2));
    QVERIFY(ground.ears->all<vehicle::ParameterResult>()[1].ok);
    QCOMPARE(vehicle.find(1, "RTL_ALT")->raw, 2000.f);
    const int before = vehicle.heardIn(1);
    EVENTUALLY(vehicle.heardIn(1) > before + 2); // heartbeats and the like
    QCOMPARE(vehicle.heardIn(2), 0);
    ground.station->perform(1, vehicle::ClearMission{.type = vehicle::MissionType::Fence});
    EVENTUALLY(!ground.ears->all<vehicle::MissionResult>().empty());
    QVERIFY(ground.ears->all<vehicle::MissionResult>()[0].reason.text().find("MAVLink 1") != std::string::npos);

    vehicle.version = 2; // its settings have changed
    EVENTUALLY(vehicle.heardIn(2) > 0);
    ground.station->perform(1, vehicle::WriteParameter{"RTL_ALT", 2500});
    EVENTUALLY_EQUAL(ground.ears->all<vehicle::ParameterResult>().size(), std::size_t(3));
    QVERIFY(ground.ears->all<vehicle::ParameterResult>()[2].ok);
    const int old = vehicle.heardIn(1);
    const int fresh = vehicle.heardIn(2);
    EVENTUALLY(vehicle.heardIn(2) > fresh + 2);
    QCOMPARE(vehicle.heardIn(1), old);
}

/// The agent forwards the bytes as they are.
void Mavlink1Test::alsoThroughTheSeal()
{
    FlightRig rig;
    Ground ground(rig.stationConfig());
    rig.startAgent(ground.ears->listening());
    ScriptedVehicle vehicle(portIn(rig.vehicleAddress()), twoValues(), 1);
    EVENTUALLY(!ground.ears->all<engine::VehicleFound>().empty());
    QVERIFY(ground.ears->all<engine::VehicleFound>()[0].sealed);
    ground.station->perform(1, vehicle::ReadParameters{});
    EVENTUALLY(!ground.ears->all<vehicle::ParameterResult>().empty());
    QVERIFY(ground.ears->all<vehicle::ParameterResult>()[0].ok);
    const int before = vehicle.heardIn(1);
    EVENTUALLY(vehicle.heardIn(1) > before + 2);
    QCOMPARE(vehicle.heardIn(2), 0);
}

SKYSEAL_TEST(Mavlink1Test)
#include "mavlink1_test.moc"
