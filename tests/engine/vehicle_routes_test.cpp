// The paths to the vehicles of an agent, the system ids that count as vehicles, and the reports of claims to others.
#include "core/engine/agent/ground_id_claims.h"
#include "core/engine/agent/vehicle_routes.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr TimePoint kHeardAt{};
constexpr Path kPlace{LinkId{1}, {}}, kElsewhere{LinkId{2}, {}};

bool leadsTo(const VehicleRoutes &routes, std::uint8_t systemId, const Path &path)
{
    bool found = false;
    routes.forEachPathTo(systemId, [&](const Path &to) { found = found || to == path; });
    return found;
}

} // namespace

class VehicleRoutesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyHeartbeatsOfAutopilotsCount();
    void silentVehiclesAreForgotten();
    void vehicleOutlivesItsStream();
    void claimsAreReportedOnceAMinute();
};

void VehicleRoutesTest::onlyHeartbeatsOfAutopilotsCount()
{
    const auto isVehicle = [](const QByteArray &frame) {
        return VehicleRoutes::isVehicleHeartbeat(*mavlink::readFrame(viewOf(frame), mavlink::Dialect::builtin()));
    };
    QVERIFY(isVehicle(clearHeartbeat(1, 1, false)));
    QVERIFY(
        !isVehicle(frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS, .autopilot = mavlink::MAV_AUTOPILOT_INVALID}, 1)));
    QVERIFY(!isVehicle(frameOf(mavlink::Attitude{}, 1)));
    // A companion beside the vehicle, whose library names no autopilot, has another address.
    QVERIFY(!isVehicle(frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_ONBOARD_CONTROLLER, .autopilot = 0}, 1, 191)));
    QVERIFY(!isVehicle(frameOf(mavlink::Heartbeat{.type = 0, .autopilot = 0}, 1, 191)));
}

void VehicleRoutesTest::silentVehiclesAreForgotten()
{
    VehicleRoutes routes;
    routes.heard(kHeardAt, kPlace, 7);
    QVERIFY(routes.isVehicle(7));
    QVERIFY(!routes.isVehicle(8));
    routes.forgetSilent(kHeardAt + VehicleRoutes::kForgetAfter);
    QVERIFY(routes.isVehicle(7));
    QVERIFY(leadsTo(routes, 7, kPlace));
    routes.forgetSilent(kHeardAt + VehicleRoutes::kForgetAfter + 1ms);
    QVERIFY(!routes.isVehicle(7)); // a ground station may use the id
    QVERIFY(!leadsTo(routes, 7, kPlace));
}

void VehicleRoutesTest::vehicleOutlivesItsStream()
{
    VehicleRoutes routes;
    routes.heard(kHeardAt, kPlace, 7);
    routes.heard(kHeardAt, kElsewhere, 8);
    routes.streamChanged(kPlace);
    QVERIFY(!leadsTo(routes, 7, kPlace));
    QVERIFY(leadsTo(routes, 8, kElsewhere));
    QVERIFY(routes.isVehicle(7));
    routes.forget(8);
    QVERIFY(!routes.isVehicle(8));
    QVERIFY(!leadsTo(routes, 8, kElsewhere));
}

void VehicleRoutesTest::claimsAreReportedOnceAMinute()
{
    GroundIdClaims claims;
    int reported = 0;
    for (int second = 0; second < 120; ++second)
        reported += claims.note(kHeardAt + std::chrono::seconds(second), 255);
    QCOMPARE(reported, 2);
    QVERIFY(claims.note(kHeardAt + 1s, 254)); // each id alone
    QCOMPARE(claims.count(), std::uint64_t(121));
}

SKYSEAL_TEST(VehicleRoutesTest)
#include "vehicle_routes_test.moc"
