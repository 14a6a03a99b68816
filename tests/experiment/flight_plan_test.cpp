// The phases of a flight script, and the orders of the flights that a sweep carries out: to each phase, back down, and down
// from whatever state a sweep ends in.
#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/experiment/sweep_flight.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::experiment;
using namespace std::chrono_literals;

namespace {

QString legsOf(const char *script)
{
    const auto plan = parseFlightPlan(script);
    if (!plan)
        return QString::fromStdString(plan.error().message.text());
    QString out;
    for (const auto &leg : plan->legs) {
        for (const vehicle::FlightStep &step : leg)
            out += QString::fromStdString(step.text).trimmed() + QLatin1Char(';');
        out += QLatin1Char('|');
    }
    return out;
}

/// A vehicle, and a flight that it obeys: it is armed and disarmed as ordered, and lands at once.
struct Obedient
{
    explicit Obedient(const char *script) : flight(parseFlightPlan(script).value()) { addVehicle(1); }

    void addVehicle(std::uint8_t id)
    {
        engine::VehicleSnapshot one;
        one.state.systemId = id;
        snapshot.vehicles.push_back(one);
    }
    vehicle::VehicleState &state(std::size_t index = 0) { return snapshot.vehicles[index].state; }

    /// Until nothing is flown. False if that takes ten minutes of its time.
    bool finish()
    {
        for (int i = 0; i < 6000 && !flight.isFinished(); ++i) {
            now += 100ms;
            flight.advance(now, snapshot);
            while (const auto next = flight.pollRequest())
                answer(*next);
        }
        return flight.isFinished();
    }

    void answer(const vehicle::ScriptRequest &next)
    {
        const auto &command = std::get<vehicle::VehicleCommand>(next.request);
        vehicle::CommandResult result;
        result.id = vehicle::RequestId{++requests};
        flight.requestSent(result.id);
        vehicle::VehicleState &it = state(next.systemId - 1u);
        const auto set = [&](const char *what, bool armed, bool accepts) {
            orders += QStringLiteral("%1:%2 ").arg(next.systemId).arg(QLatin1String(what));
            result.outcome = accepts ? vehicle::CommandOutcome::Accepted : vehicle::CommandOutcome::Refused;
            it.armed = accepts ? armed : it.armed;
        };
        if (std::holds_alternative<vehicle::Arm>(command))
            set("arm", true, true);
        else if (std::holds_alternative<vehicle::Land>(command))
            set("land", false, lands);
        else if (std::holds_alternative<vehicle::Disarm>(command))
            set("disarm", false, disarms);
        else
            set("other", it.armed, true);
        flight.handleResult(result);
    }

    SweepFlight flight;
    engine::Snapshot snapshot;
    TimePoint now{1000s};
    std::uint32_t requests = 0;
    QString orders;
    bool lands = true, disarms = true;
};

} // namespace

class FlightPlanTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void phases_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QString>("legs");
        QTest::newRow("before the landing") << "arm; takeoff 5; land; wait armed==0"
                                            << "arm;takeoff 5;|land;wait armed==0;|";
        QTest::newRow("before a mode that lands") << "arm; mode rtl"
                                                  << "arm;|mode rtl;|";
        QTest::newRow("at the end") << "arm; takeoff 5"
                                    << "arm;takeoff 5;||";
        QTest::newRow("marked") << "sleep 1 | arm; takeoff 5 | land"
                                << "sleep 1;|arm;takeoff 5;|land;|";
        QTest::newRow("marked at the end") << "arm; takeoff 5; | 2: goto 1 2 3; |"
                                           << "arm;takeoff 5;|goto 1 2 3;||";
        QTest::newRow("nothing leads there") << "arm | | land"
                                             << "no step leads to phase 2";
        QTest::newRow("on the ground at once") << "land"
                                               << "no step leads to phase 1";
    }
    void phases()
    {
        QFETCH(QString, script);
        QTEST(legsOf(script.toUtf8().constData()), "legs");
    }

    void errorsAreThoseOfTheScript()
    {
        const auto plan = parseFlightPlan("arm | takeoff high");
        QVERIFY(!plan);
        QVERIFY2(plan.error().message.text().find("step 2: expected an altitude") == 0, plan.error().message.text().c_str());
    }

    /// Two flights of two phases, one block each.
    void everyPhaseHasItsLeg()
    {
        Obedient it("arm | takeoff 5 | land");
        SweepFlight &flight = it.flight;
        QVERIFY(flight.needsLeg(0) && !flight.endsBefore(0) && !flight.isUp());
        flight.beginLeg(0);
        QVERIFY(it.finish() && flight.isUp());
        QVERIFY(!flight.needsLeg(0) && flight.needsLeg(1) && !flight.endsBefore(1));
        flight.beginLeg(1);
        QVERIFY(it.finish());
        QVERIFY(!flight.needsLeg(1) && flight.endsBefore(2));
        flight.beginLanding();
        QVERIFY(it.finish() && !flight.isUp());
        QVERIFY(flight.needsLeg(2) && !flight.endsBefore(2));
        flight.beginLeg(2);
        QVERIFY(it.finish());
        QCOMPARE(it.orders, QStringLiteral("1:arm 1:other 1:land 1:arm "));
        QVERIFY(flight.problem().empty());
    }

    void scriptThatDoesNotLand()
    {
        Obedient it("arm; takeoff 5");
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.flight.beginLanding();
        QVERIFY(it.finish() && !it.flight.isUp());
        QCOMPARE(it.orders, QStringLiteral("1:arm 1:other 1:land "));
    }

    void disarmsWhatDoesNotLand()
    {
        Obedient it("arm");
        it.lands = false;
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.flight.bringDown();
        QVERIFY(it.finish() && !it.flight.isUp());
        QCOMPARE(it.orders, QStringLiteral("1:arm 1:land 1:disarm "));
        QVERIFY(it.flight.problem().empty());
    }

    void saysThatItIsStillUp()
    {
        Obedient it("arm");
        it.lands = it.disarms = false;
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.flight.bringDown();
        QVERIFY(it.finish() && it.flight.isUp());
        QVERIFY(it.flight.problem().find("flight 1 could not be ended") == 0);
    }

    /// Which cannot be told from one that flies on.
    void silentVehicleIsNotDown()
    {
        Obedient it("arm");
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.state().armed = false;
        it.state().lost = true;
        it.lands = it.disarms = false;
        it.flight.bringDown();
        QVERIFY(it.finish() && it.flight.isUp());
    }

    /// Only those that the script commands.
    void bringsEachVehicleDown()
    {
        Obedient it("1: arm; 3: arm");
        it.addVehicle(2);
        it.addVehicle(3);
        it.state(1).armed = true;
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.flight.bringDown();
        QVERIFY(it.finish() && !it.flight.isUp());
        QCOMPARE(it.orders, QStringLiteral("1:arm 3:arm 1:land 3:land "));
        QVERIFY(it.state(1).armed);
    }

    /// The order to arm was carried out, and the heartbeat that says so comes only now.
    void lateHeartbeatIsAwaited()
    {
        Obedient it("arm");
        it.flight.beginLeg(0);
        it.flight.advance(it.now, it.snapshot);
        it.flight.bringDown();
        it.flight.advance(it.now += 1s, it.snapshot);
        it.state().armed = true;
        QVERIFY(it.finish() && !it.flight.isUp());
        QCOMPARE(it.orders, QStringLiteral("1:land "));
    }

    void failedStepIsNamed()
    {
        Obedient it("arm; wait alt_rel>=500 2; land");
        it.state().altitudeRelative = 12;
        it.flight.beginLeg(0);
        QVERIFY(it.finish() && it.flight.isUp());
        QCOMPARE(it.flight.problem(), std::string("flight 1 failed at 'wait alt_rel>=500 2': timeout, alt_rel is 12"));
    }

    void phaseMayEndByItself()
    {
        Obedient it("arm");
        it.flight.beginLeg(0);
        QVERIFY(it.finish());
        it.flight.advance(it.now, it.snapshot);
        QVERIFY(it.flight.endOfPhase(it.snapshot).empty());
        it.state().armed = false;
        QVERIFY(!it.flight.endOfPhase(it.snapshot).empty());
    }
};

SKYSEAL_TEST(FlightPlanTest)
#include "flight_plan_test.moc"
