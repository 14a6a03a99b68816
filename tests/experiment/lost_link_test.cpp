// A sweep on a connected station whose link or vehicle is lost meanwhile: each sample was measured with the suite that it
// names, a run that lost its link before its measurement began is repeated, and the station is restored at the end.
#include "core/engine/station/snapshot.h"
#include "core/experiment/sweep_runner.h"
#include "tests/engine/ground.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QSet>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using crypto::SuiteId;

class LostLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noReportOfARunHasCosts();
    void lostBeforeARunIsMeasured();
    void lostWhileARunIsMeasured();
    void lostAtTheEnd();
    void vehicleFallsSilent_data();
    void vehicleFallsSilent();
};

namespace {

engine::StationConfig configOf(const FlightRig &rig)
{
    engine::StationConfig config = rig.stationConfig();
    config.policy.allowPlain = true;
    return config;
}

/// A flight, a station that has its session, and a sweep of two suites on it.
struct Sweep
{
    explicit Sweep(std::vector<SuiteId> suites, Duration warmUp = std::chrono::milliseconds(800),
                   Duration measure = std::chrono::seconds(1))
    {
        rig.allowPlain = true;
        rig.startAgent(ground.ears->listening());
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
        experiment::SweepConfig config;
        for (const SuiteId suite : suites)
            config.plan.arms.push_back({suite});
        config.plan.repeats = 1;
        config.plan.warmUp = warmUp;
        config.plan.measure = measure;
        config.borrowed = ground.station.get();
        runner.emplace(std::move(config));
        QObject::connect(&*runner, &experiment::SweepRunner::runBegan, &*runner, [this](const experiment::Run &run) {
            wanted = results().plan.arms[run.arm].suite;
            inUseFrom.reset();
        });
        QObject::connect(&*runner, &experiment::SweepRunner::sampleTaken, &*runner,
                         [this](const experiment::Sample &sample) { samples.emplace_back(sample, suite()); });
        QObject::connect(&*runner, &experiment::SweepRunner::finished, &*runner, [this](bool, const Reason &said) {
            over = true;
            problem = said.text();
        });
        QObject::connect(ground.station.get(), &engine::Station::snapshotReady, &*runner, [this] { watch(); });
    }

    const experiment::Results &results() const { return runner->results(); }
    bool ready() const { return ground.up() && !ground.ears->snapshot->vehicles.empty(); }
    /// Ends the agent like kill -9 and starts the next one at once, with which another session is made.
    void loseLink()
    {
        ++lost;
        rig.killAgent();
        rig.startAgent(ground.ears->listening());
    }
    /// Suite of the session that is not silent; None without one.
    SuiteId suite() const
    {
        for (const engine::SessionSnapshot &session : ground.ears->snapshot->sessions) {
            if (!session.info.silent && !session.info.pending)
                return session.info.suite;
        }
        return SuiteId::None;
    }
    /// Measures how long the run's suite has been in use, by the snapshots' clock as the sweep does.
    void watch()
    {
        const double now = ground.ears->snapshot->time;
        if (suite() != wanted)
            return inUseFrom.reset();
        if (!inUseFrom)
            inUseFrom = now;
        if (whenInUse)
            whenInUse(now - *inUseFrom);
    }

    FlightRig rig;
    Ground ground{configOf(rig)};
    std::unique_ptr<VehicleOnUdp> vehicle;
    std::optional<experiment::SweepRunner> runner;
    std::vector<std::pair<experiment::Sample, SuiteId>> samples; ///< with the suite in use when each was taken
    SuiteId wanted{};
    std::optional<double> inUseFrom;               ///< snapshot time
    std::function<void(double seconds)> whenInUse; ///< called for each snapshot with the time since `inUseFrom`
    int lost = 0;
    bool over = false;
    std::string problem;
};

} // namespace

/// Reports of the agent for the measurement would be measured in sealed runs only. Their content is known from before and after
/// the run.
void LostLinkTest::noReportOfARunHasCosts()
{
    constexpr double kRun = 3;
    Sweep sweep({SuiteId::Aes256Gcm}, std::chrono::milliseconds(800), std::chrono::seconds(3));
    EVENTUALLY(sweep.ready());
    std::optional<double> unaskedFrom;
    double longest = 0;
    int asked = 0;
    QSet<std::uint32_t> reports; ///< of the longest time without costs
    sweep.whenInUse = [&](double) {
        const engine::Snapshot &snapshot = *sweep.ground.ears->snapshot;
        const channel::SessionStats &stats = snapshot.sessions.front().stats;
        if (stats.peerCosts) {
            ++asked;
            unaskedFrom.reset();
            return;
        }
        if (!asked)
            return; // the run has not begun
        if (!unaskedFrom) {
            unaskedFrom = snapshot.time;
            reports.clear();
        }
        reports << stats.peerStamp;
        longest = std::max(longest, snapshot.time - *unaskedFrom);
    };
    sweep.runner->start();
    EVENTUALLY(sweep.over);
    QCOMPARE(sweep.samples.size(), std::size_t(1));
    const experiment::Sample &sample = sweep.samples[0].first;
    QCOMPARE(sample.problem.text(), std::string());
    QVERIFY(asked >= 2); // before and after
    QVERIFY2(longest >= 0.9 * kRun, qPrintable(QString::number(longest)));
    QVERIFY(reports.size() >= 3); // the agent went on reporting
    QVERIFY(sample.values[experiment::Metric::AgentCpuSuite] > 0 && sample.values[experiment::Metric::AgentSeal] > 0);
}

void LostLinkTest::lostBeforeARunIsMeasured()
{
    Sweep sweep({SuiteId::Aes256Gcm, SuiteId::Aes256Ctr}, std::chrono::seconds(4)); // a lost session is silent before that
    EVENTUALLY(sweep.ready());
    sweep.whenInUse = [&](double) { // both times during the warm-up
        if (sweep.lost == static_cast<int>(sweep.samples.size()) && sweep.lost < 2)
            sweep.loseLink();
    };
    sweep.runner->start();
    EVENTUALLY(sweep.over);
    QCOMPARE(sweep.problem, std::string());
    QCOMPARE(sweep.lost, 2);
    QCOMPARE(sweep.samples.size(), std::size_t(2));
    for (const auto &[sample, suite] : sweep.samples) {
        QCOMPARE(sample.problem.text(), std::string());
        QCOMPARE(int(suite), int(sweep.results().plan.arms[sample.run.arm].suite));
        QVERIFY(sample.values[experiment::Metric::Packets] > 0);
        // The snapshots of a borrowed station go on for its reader, and the sample says what they cost.
        const double meter = sample.values[experiment::Metric::MeterCpu];
        QVERIFY(meter > 0 && meter < 100);
    }
}

void LostLinkTest::lostWhileARunIsMeasured()
{
    Sweep sweep({SuiteId::Aes256Gcm, SuiteId::Aes256Ctr}, std::chrono::milliseconds(800),
                std::chrono::seconds(9)); // silent after four
    EVENTUALLY(sweep.ready());
    sweep.whenInUse = [&](double seconds) {
        if (sweep.lost == 0 && seconds > 1.3)
            sweep.loseLink();
    };
    sweep.runner->start();
    EVENTUALLY(sweep.over);
    QCOMPARE(sweep.samples.size(), std::size_t(2));
    QCOMPARE(QString::fromStdString(sweep.samples[0].first.problem.text()),
             QStringLiteral("the session did not last through the run"));
    QCOMPARE(sweep.samples[1].first.problem.text(), std::string());
    QCOMPARE(int(sweep.samples[1].second), int(sweep.results().plan.arms[sweep.samples[1].first.run.arm].suite));
}

void LostLinkTest::lostAtTheEnd()
{
    // The sweep ends before the agent is back. The next session resumes the suite that was in use before the sweep; the session
    // after that begins with the station's default suite.
    Sweep sweep({SuiteId::Aes256Gcm});
    EVENTUALLY(sweep.ready());
    const auto sessionUps = [&] { return sweep.ground.ears->all<channel::SessionUp>(); };
    sweep.ground.station->switchSuite(sessionUps()[0].session, SuiteId::Aes256Ctr);
    EVENTUALLY_EQUAL(int(sweep.suite()), int(SuiteId::Aes256Ctr));
    bool killed = false;
    sweep.whenInUse = [&](double) {
        if (std::exchange(killed, true))
            return;
        sweep.rig.killAgent();
        sweep.runner->cancel();
    };
    sweep.runner->start();
    EVENTUALLY(sweep.over);
    sweep.runner.reset();
    for (const SuiteId expected : {SuiteId::Aes256Ctr, SuiteId::ChaCha20Poly1305}) {
        const std::size_t before = sessionUps().size();
        sweep.rig.startAgent(sweep.ground.ears->listening());
        EVENTUALLY_EQUAL(sessionUps().size(), before + 1);
        EVENTUALLY_EQUAL(int(sweep.suite()), int(expected));
        // A switch would have been announced together with the session.
        EVENTUALLY(sweep.ground.ears->snapshot->sessions.size() == 1);
        QCOMPARE(int(sweep.suite()), int(expected));
        sweep.rig.killAgent();
    }
}

void LostLinkTest::vehicleFallsSilent_data()
{
    QTest::addColumn<int>("suite");
    QTest::newRow("in clear") << int(SuiteId::None);
    QTest::newRow("behind an agent that keeps running") << int(SuiteId::Aes256Gcm);
}

void LostLinkTest::vehicleFallsSilent()
{
    // The station detects a lost vehicle after 3.5 s.
    QFETCH(int, suite);
    Sweep sweep({SuiteId(suite)}, std::chrono::milliseconds(800), std::chrono::seconds(9));
    EVENTUALLY(sweep.ready());
    sweep.whenInUse = [&](double seconds) {
        if (seconds > 2.5) // so that it is noticed long before the end
            sweep.vehicle.reset();
    };
    sweep.runner->start();
    EVENTUALLY(sweep.over);
    QCOMPARE(sweep.samples.size(), std::size_t(1));
    QCOMPARE(sweep.samples[0].first.problem.text(), std::string("the vehicle fell silent during the run"));
    QVERIFY(std::isnan(sweep.samples[0].first.values[experiment::Metric::Packets]));
}

SKYSEAL_TEST(LostLinkTest)
#include "lost_link_test.moc"
