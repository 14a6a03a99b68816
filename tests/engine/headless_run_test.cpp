// A run without a window ends in an orderly way: a switch that is in progress may finish within its usual time.
#include "core/engine/headless/headless_run.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/flight_script.h"
#include "tests/engine/ground.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// Kills the agent during a switch, which is then neither confirmed nor refused.
class KillingListener final : public engine::RunListener
{
public:
    explicit KillingListener(FlightRig &rig) : m_rig(rig) {}

    void eventOccurred(const engine::Event &event) override
    {
        if (std::holds_alternative<channel::SwitchPending>(event))
            m_rig.killAgent();
        if (const auto *done = std::get_if<channel::SwitchDone>(&event))
            switches.push_back(*done);
    }
    void stepEnded(const vehicle::StepReport &) override {}
    void secondPassed(const engine::Snapshot &, double) override {}
    void ended(const engine::Snapshot &, double) override {}

    std::vector<channel::SwitchDone> switches;

private:
    FlightRig &m_rig;
};

} // namespace

class HeadlessRunTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pendingSwitchMayFinish_data();
    void pendingSwitchMayFinish();
};

void HeadlessRunTest::pendingSwitchMayFinish_data()
{
    QTest::addColumn<QString>("script");
    QTest::newRow("duration") << QString();
    QTest::newRow("script") << QStringLiteral("sleep 0.5"); // over long before a switch is given up
}

void HeadlessRunTest::pendingSwitchMayFinish()
{
    QFETCH(QString, script);
    FlightRig rig;
    Ground ground(rig.stationConfig());
    KillingListener listener(rig);
    engine::RunPlan plan;
    plan.switchTo = {crypto::SuiteId::Aes256Gcm};
    plan.switchEvery = 100ms;
    if (script.isEmpty())
        plan.duration = 3s;
    else
        plan.script = *vehicle::parseFlightScript(script.toStdString());
    engine::HeadlessRun run(*ground.station, listener, std::move(plan), {});
    std::optional<engine::RunOutcome> outcome;
    connect(&run, &engine::HeadlessRun::finished, this, [&](engine::RunOutcome reached) { outcome = reached; });
    rig.startAgent(ground.ears->listening());
    EVENTUALLY(ground.up()); // before the time of the run begins
    const VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->snapshot->vehicles.empty());
    run.start();
    EVENTUALLY(outcome);
    QCOMPARE(listener.switches.size(), std::size_t(1));
    QCOMPARE(int(listener.switches[0].failure), int(channel::SwitchFailure::NotConfirmed));
    QCOMPARE(int(*outcome), int(engine::RunOutcome::SuiteNotReached));
}

SKYSEAL_TEST(HeadlessRunTest)
#include "headless_run_test.moc"
