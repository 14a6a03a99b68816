// A sweep on a station that is there already, whose link or vehicle is lost meanwhile: what is measured is what is named, a
// run that had not begun yet is made, and in the end the station is as it was.
#include "core/engine/station/snapshot.h"
#include "core/experiment/sweep_runner.h"
#include "tests/engine/ground.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using crypto::SuiteId;

class LostLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lostBeforeARunIsMeasured();
    void lostWhileARunIsMeasured();
    void lostAtTheEnd();
    void switchIsOrderedEightTimes();
    void switchTakesFromItsFirstOrder();
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
            under.invalidate();
        });
        QObject::connect(&*runner, &experiment::SweepRunner::sampleTaken, &*runner,
                         [this](const experiment::Sample &sample) { samples.emplace_back(sample, suite()); });
        QObject::connect(&*runner, &experiment::SweepRunner::finished, &*runner, [this](bool, const std::string &said) {
            over = true;
            problem = said;
        });
        QObject::connect(ground.station.get(), &engine::Station::snapshotReady, &*runner, [this] { watch(); });
        QObject::connect(ground.station.get(), &engine::Station::eventOccurred, &*runner,
                         [this](const engine::Event &event) { hear(event); });
    }

    const experiment::Results &results() const { return runner->results(); }
    bool ready() const { return ground.up() && !ground.ears->snapshot->vehicles.empty(); }
    /// As kill -9, and the next life of the agent at once: the session is another one.
    void loseLink()
    {
        ++lost;
        rig.killAgent();
        rig.startAgent(ground.ears->listening());
    }
    /// Of the session that is heard; None without one.
    SuiteId suite() const
    {
        for (const engine::SessionSnapshot &session : ground.ears->snapshot->sessions) {
            if (!session.info.silent && !session.info.pending)
                return session.info.suite;
        }
        return SuiteId::None;
    }
    /// Looks how long the run's suite has been in use.
    void watch()
    {
        if (suite() != wanted)
            return under.invalidate();
        if (!under.isValid())
            under.start();
        if (whenUnder)
            whenUnder(under.elapsed());
    }

    /// Of the orders of the wanted suite, lets so many be taken back at once by another, which is refused.
    void hear(const engine::Event &event)
    {
        const auto *pending = std::get_if<channel::SwitchPending>(&event);
        const auto *done = std::get_if<channel::SwitchDone>(&event);
        if (done && done->to == wanted && done->failure == channel::SwitchFailure::None) {
            confirmedAfter = sinceOrder.isValid() ? static_cast<double>(sinceOrder.nsecsElapsed()) / 1e6 : 0;
            lastTook = 1000 * seconds(done->took);
        }
        if (!pending || pending->to != wanted || pending->rekey)
            return;
        if (orders++ == 0)
            sinceOrder.start();
        if (orders <= takenBack)
            ground.station->switchSuite(pending->session, SuiteId::None);
    }

    FlightRig rig;
    Ground ground{configOf(rig)};
    std::unique_ptr<VehicleOnUdp> vehicle;
    std::optional<experiment::SweepRunner> runner;
    std::vector<std::pair<experiment::Sample, SuiteId>> samples; ///< and what was in use when they were taken
    SuiteId wanted{};
    QElapsedTimer under;
    std::function<void(qint64 milliseconds)> whenUnder;
    int lost = 0, orders = 0, takenBack = 0;
    QElapsedTimer sinceOrder;
    double confirmedAfter = 0, lastTook = 0; ///< milliseconds, from the first order on and from the last
    bool over = false;
    std::string problem;
};

} // namespace

void LostLinkTest::lostBeforeARunIsMeasured()
{
    Sweep sweep({SuiteId::Aes256Gcm, SuiteId::Aes256Ctr}, std::chrono::seconds(4)); // another session is up before that
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    sweep.whenUnder = [&](qint64) { // both times while it warms up
        if (sweep.lost == static_cast<int>(sweep.samples.size()) && sweep.lost < 2)
            sweep.loseLink();
    };
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 60000);
    QCOMPARE(sweep.problem, std::string());
    QCOMPARE(sweep.lost, 2);
    QCOMPARE(sweep.samples.size(), std::size_t(2));
    for (const auto &[sample, suite] : sweep.samples) {
        QCOMPARE(sample.problem, std::string());
        QCOMPARE(int(suite), int(sweep.results().plan.arms[sample.run.arm].suite));
        QVERIFY(sample.values[experiment::Metric::Packets] > 0);
    }
}

void LostLinkTest::lostWhileARunIsMeasured()
{
    Sweep sweep({SuiteId::Aes256Gcm, SuiteId::Aes256Ctr}, std::chrono::milliseconds(800), std::chrono::seconds(5));
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    sweep.whenUnder = [&](qint64 milliseconds) {
        if (sweep.lost == 0 && milliseconds > 1300)
            sweep.loseLink();
    };
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 60000);
    QCOMPARE(sweep.samples.size(), std::size_t(2));
    QCOMPARE(sweep.samples[0].first.problem, std::string("the session did not last through the run"));
    QCOMPARE(sweep.samples[1].first.problem, std::string());
    QCOMPARE(int(sweep.samples[1].second), int(sweep.results().plan.arms[sweep.samples[1].first.run.arm].suite));
}

void LostLinkTest::lostAtTheEnd()
{
    // The sweep is gone before the agent is back. The next session has the suite of before; the one after that begins as
    // sessions of this station always did.
    Sweep sweep({SuiteId::Aes256Gcm});
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    const auto sessionUps = [&] { return sweep.ground.ears->all<channel::SessionUp>(); };
    sweep.ground.station->switchSuite(sessionUps()[0].session, SuiteId::Aes256Ctr);
    QTRY_COMPARE_WITH_TIMEOUT(int(sweep.suite()), int(SuiteId::Aes256Ctr), 10000);
    bool killed = false;
    sweep.whenUnder = [&](qint64) {
        if (std::exchange(killed, true))
            return;
        sweep.rig.killAgent();
        sweep.runner->cancel();
    };
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 30000);
    sweep.runner.reset();
    for (const SuiteId expected : {SuiteId::Aes256Ctr, SuiteId::ChaCha20Poly1305}) {
        const std::size_t before = sessionUps().size();
        sweep.rig.startAgent(sweep.ground.ears->listening());
        QTRY_COMPARE_WITH_TIMEOUT(sessionUps().size(), before + 1, 10000);
        QTRY_COMPARE_WITH_TIMEOUT(int(sweep.suite()), int(expected), 10000);
        // A switch of its own would have come with the session.
        QTRY_VERIFY_WITH_TIMEOUT(sweep.ground.ears->snapshot->sessions.size() == 1, 10000);
        QCOMPARE(int(sweep.suite()), int(expected));
        sweep.rig.killAgent();
    }
}

void LostLinkTest::switchIsOrderedEightTimes()
{
    Sweep sweep({SuiteId::Aes256Gcm});
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    sweep.takenBack = 1000;
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 60000);
    QCOMPARE(sweep.orders, 8);
    QCOMPARE(sweep.samples.size(), std::size_t(1));
    QCOMPARE(sweep.samples[0].first.problem, std::string("another switch took the place of this one, 8 times"));
}

void LostLinkTest::switchTakesFromItsFirstOrder()
{
    Sweep sweep({SuiteId::Aes256Gcm});
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    sweep.takenBack = 3;
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 60000);
    QCOMPARE(sweep.orders, 4);
    QCOMPARE(sweep.samples.size(), std::size_t(1));
    QCOMPARE(sweep.samples[0].first.problem, std::string());
    const double took = sweep.samples[0].first.values[experiment::Metric::Switch];
    qInfo("%.1f ms, heard to take %.1f, the last order %.1f", took, sweep.confirmedAfter, sweep.lastTook);
    QVERIFY(sweep.confirmedAfter > sweep.lastTook);
    QVERIFY(took >= sweep.confirmedAfter && took < sweep.confirmedAfter + 1000);
}

void LostLinkTest::vehicleFallsSilent_data()
{
    QTest::addColumn<int>("suite");
    QTest::newRow("in clear") << int(SuiteId::None);
    QTest::newRow("behind an agent that goes on") << int(SuiteId::Aes256Gcm);
}

void LostLinkTest::vehicleFallsSilent()
{
    // Which takes 3.5 s to be seen.
    QFETCH(int, suite);
    Sweep sweep({SuiteId(suite)}, std::chrono::milliseconds(800), std::chrono::seconds(9));
    QTRY_VERIFY_WITH_TIMEOUT(sweep.ready(), 20000);
    sweep.whenUnder = [&](qint64 milliseconds) {
        if (milliseconds > 4000)
            sweep.vehicle.reset();
    };
    sweep.runner->start();
    QTRY_VERIFY_WITH_TIMEOUT(sweep.over, 60000);
    QCOMPARE(sweep.samples.size(), std::size_t(1));
    QCOMPARE(sweep.samples[0].first.problem, std::string("the vehicle fell silent during the run"));
    QVERIFY(std::isnan(sweep.samples[0].first.values[experiment::Metric::Packets]));
}

SKYSEAL_TEST(LostLinkTest)
#include "lost_link_test.moc"
