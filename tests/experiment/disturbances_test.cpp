// What may have disturbed a run, by made-up readings: the values that are recorded, the thresholds that warn, where the
// programs are placed.
#include "core/engine/station/snapshot.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/html_report.h"
#include "core/experiment/idle_power.h"
#include "core/experiment/measurement.h"
#include "core/experiment/placement.h"
#include "core/experiment/sweep_csv.h"
#include "core/experiment/sweep_json.h"
#include "core/experiment/sweep_text.h"
#include "core/metrics/machine_usage.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>
#include <thread>

#include <sched.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::experiment;
using namespace std::chrono_literals;

namespace {

/// Two seconds of a machine on which everything has a known cost; `share`: how far it has got, 0 or 1.
Reading reading(std::uint64_t share)
{
    auto snapshot = std::make_shared<engine::Snapshot>();
    snapshot->time = 100 + 2.0 * static_cast<double>(share);
    snapshot->mavlink.frames = 3000 * share;
    snapshot->mavlink.bytes = 90'000 * share;
    engine::LinkSnapshot link;
    link.rxBytes = 100'000 * share;
    link.rxDatagrams = 1000 * share;
    snapshot->links.push_back(std::move(link));
    auto probe = std::make_shared<engine::Probe>();
    const auto used = [share](Duration time) { return static_cast<std::int64_t>(share) * time; };
    probe->processCpu = used(500ms);
    probe->ioThreadCpu = used(400ms);
    probe->watchingCpu = used(4ms);
    probe->wakeUps = 800 * share;
    probe->preemptions = 120 * share;
    snapshot->probe = std::move(probe);
    Reading out;
    out.mavlink = snapshot->mavlink;
    out.station = std::move(snapshot);
    out.programs.at = TimePoint(50s) + used(2s);
    out.programs.agentCpu = used(600ms);
    out.programs.simulatorCpu = used(200ms);
    out.programs.agentSwitches = metrics::ContextSwitches{600 * share, 40 * share};
    out.machine.busy = used(2000ms);
    out.machine.stolen = used(30ms);
    out.machine.megahertz = share ? 1900 : 2100;
    out.machine.load = share ? 1.25 : 0.5;
    out.machine.throttlings = 7 + 2 * share;
    return out;
}

Sample quiet()
{
    Sample out;
    out.values[Metric::OtherCpu] = 3;
    out.values[Metric::Steal] = 0;
    out.values[Metric::Preemptions] = 4;
    out.values[Metric::LoadBegin] = out.values[Metric::LoadEnd] = 0.6;
    out.values[Metric::MeterCpu] = 0.4;
    out.values[Metric::FrequencyChange] = 0;
    return out;
}

} // namespace

class DisturbancesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void circumstancesAreTheDifferences();
    void unknownProgramsAreNotGuessed();
    void energyIsAboveIdle();
    void idleMachineIsMeasured();
    void thresholdsWarn_data();
    void thresholdsWarn();
    void coresGivenToWokenReceiversAreNone();
    void warningsAreOnTheFirstPageAndAtTheRun();
    void cpuTimesOfTheKernelAreRead();
    void frequencyIsTheMean();
    void thisMachineTells();
    void everyProgramHasACoreOfItsOwn();
    void threadsAreBackOnTheirCores();
};

void DisturbancesTest::circumstancesAreTheDifferences()
{
    const Values values = valuesBetween(reading(0), reading(1), false, true);
    QCOMPARE(values[Metric::MeterCpu], 1.0);
    QCOMPARE(values[Metric::FramesPerDatagram], 3.0);
    QCOMPARE(values[Metric::WakeUps], 400.0);
    QCOMPARE(values[Metric::Preemptions], 60.0);
    QCOMPARE(values[Metric::AgentWakeUps], 300.0);
    QCOMPARE(values[Metric::AgentPreemptions], 20.0);
    QCOMPARE(values[Metric::AgentCpu], 30.0);
    QCOMPARE(values[Metric::SimulatorCpu], 10.0);
    QVERIFY(std::isnan(values[Metric::RelayCpu]));
    QCOMPARE(values[Metric::OtherCpu], 100.0 - 25 - 30 - 10); // of both cores
    QCOMPARE(values[Metric::Steal], 1.5);
    QCOMPARE(values[Metric::Frequency], 2000.0);
    QCOMPARE(values[Metric::FrequencyChange], 10.0);
    QCOMPARE(values[Metric::LoadBegin], 0.5);
    QCOMPARE(values[Metric::LoadEnd], 1.25);
    QCOMPARE(values[Metric::Throttlings], 2.0);
}

void DisturbancesTest::unknownProgramsAreNotGuessed()
{
    Reading begin = reading(0), end = reading(1);
    for (Reading *one : {&begin, &end}) {
        one->programs.agentCpu.reset();
        one->programs.agentSwitches.reset();
        one->machine = {};
    }
    const Values values = valuesBetween(begin, end, false, true);
    for (const Metric metric :
         {Metric::AgentCpu, Metric::AgentWakeUps, Metric::AgentPreemptions, Metric::OtherCpu, Metric::Steal, Metric::Frequency,
          Metric::FrequencyChange, Metric::LoadBegin, Metric::LoadEnd, Metric::Throttlings})
        QVERIFY2(std::isnan(values[metric]), info(metric).key.data());
    QCOMPARE(values[Metric::WakeUps], 400.0);
}

void DisturbancesTest::energyIsAboveIdle()
{
    std::vector<Sample> samples(2);
    samples[0].values[Metric::Power] = 12;
    samples[0].values[Metric::Packets] = 500;
    samples[0].seconds = 2;
    subtractIdle(samples, {});
    QVERIFY(std::isnan(samples[0].values[Metric::PowerAboveIdle]));
    subtractIdle(samples, {.before = 9, .after = 11});
    QCOMPARE(samples[0].values[Metric::IdlePower], 10.0);
    QCOMPARE(samples[0].values[Metric::IdlePowerChange], 20.0);
    QCOMPARE(samples[0].values[Metric::PowerAboveIdle], 2.0);
    QCOMPARE(samples[0].values[Metric::EnergyPerFrame], 8000.0);    // 4 J
    QVERIFY(std::isnan(samples[1].values[Metric::EnergyPerFrame])); // no power was measured in it
}

void DisturbancesTest::idleMachineIsMeasured()
{
    QTemporaryDir sysfs;
    const QDir chip(sysfs.filePath(QStringLiteral("class/hwmon/hwmon0")));
    QVERIFY(chip.mkpath(QStringLiteral(".")));
    for (const auto &[name, text] : {std::pair("name", "ina219"), std::pair("power1_input", "2500000")}) {
        QFile file(chip.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
    }
    std::optional<double> watts;
    IdleMeter meter(sysfs.path().toStdString());
    meter.measure([&](double measured) { watts = measured; }, 300);
    QVERIFY(!watts);
    EVENTUALLY(watts.has_value());
    QVERIFY2(std::abs(*watts - 2.5) < 0.001, qPrintable(QString::number(*watts)));

    IdleMeter nothing(sysfs.filePath(QStringLiteral("class")).toStdString());
    watts.reset();
    nothing.measure([&](double measured) { watts = measured; });
    QVERIFY(watts && std::isnan(*watts)); // at once
}

void DisturbancesTest::thresholdsWarn_data()
{
    QTest::addColumn<int>("metric");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    const auto row = [](Metric metric, double value, const char *text) {
        QTest::newRow(info(metric).key.data()) << static_cast<int>(metric) << value << QString::fromUtf8(text);
    };
    row(Metric::OtherCpu, 35, "other programs used 35 % of a core");
    row(Metric::Steal, 2, "the hypervisor took 2 % of a core");
    row(Metric::Preemptions, 300, "the station's I/O thread had to give up its core 300 times a second");
    row(Metric::AgentPreemptions, 300, "the agent had to give up its core 300 times a second");
    row(Metric::FrequencyChange, 12, "the frequency of the cores differed by 12 % between begin and end");
    row(Metric::LoadBegin, 7, "the load average at the start was 7 per core");
    row(Metric::LoadEnd, 7, "the load average at the end was 7 per core");
    row(Metric::IdlePowerChange, 9, "the power of the idle machine differed by 9 % before and after");
    row(Metric::Throttlings, 3, "the processor was throttled 3 times");
    row(Metric::MeterCpu, 48, "the measurement itself took 48 % of the CPU time of the station's I/O thread");
    row(Metric::SimulatorCpu, 99, "the simulator (which makes the load) used 99 % of a core");
}

void DisturbancesTest::thresholdsWarn()
{
    QFETCH(int, metric);
    QFETCH(double, value);
    QFETCH(QString, text);
    QVERIFY(disturbances(quiet()).empty());
    QVERIFY(disturbances(Sample()).empty()); // nothing is known
    Sample sample = quiet();
    sample.values[static_cast<Metric>(metric)] = value;
    QCOMPARE(disturbances(sample), std::vector{text.toStdString()});
    QVERIFY(!text.contains(QLatin1Char(','))); // a column of the CSV file
    sample.problem = "the link fell silent";
    QVERIFY(disturbances(sample).empty());
}

void DisturbancesTest::coresGivenToWokenReceiversAreNone()
{
    Sample sample = quiet();
    sample.values[Metric::AgentWakeUps] = 400;
    sample.values[Metric::AgentPreemptions] = 250;
    QVERIFY(disturbances(sample).empty());
    sample.values[Metric::AgentPreemptions] = 251;
    QCOMPARE(disturbances(sample), std::vector<std::string>{"the agent had to give up its core 251 times a second"});
    sample.values[Metric::AgentWakeUps] = 1; // a program that never waits: other programs want its core
    sample.values[Metric::AgentPreemptions] = 100;
    QCOMPARE(disturbances(sample), std::vector<std::string>{"the agent had to give up its core 100 times a second"});
}

void DisturbancesTest::warningsAreOnTheFirstPageAndAtTheRun()
{
    Results results;
    results.plan.arms = {{crypto::SuiteId::Aes256Gcm}};
    results.complete = true;
    results.placement = "agent on core 1";
    for (const double other : {2.0, 20.0, 60.0}) {
        Sample sample = quiet();
        sample.order = static_cast<unsigned>(results.samples.size());
        sample.run.repeat = sample.order;
        sample.values[Metric::OtherCpu] = other;
        results.samples.push_back(sample);
    }
    QCOMPARE(
        disturbedRuns(results).text(),
        std::string("2 of 3 runs were disturbed, so that their figures are noisier and may be wrong: other programs used up to "
                    "60 % of a core (2 runs)"));
    const std::string page = htmlReport({results, {}, {}, {}});
    QVERIFY(page.find("2 of 3 runs were disturbed") < page.find("<h2>Figures"));
    QVERIFY(page.find("disturbed: other programs used 20 % of a core</td>") > page.find("<h2>Every run"));
    QVERIFY(page.find("<td>placement</td><td class=\"text\">agent on core 1") != std::string::npos);
    QVERIFY(sweepJson(results, {}).find("\"disturbances\":[\"other programs used 60 % of a core\"]") != std::string::npos);
    QVERIFY(sweepCsv(results).find(",\"other programs used 20 % of a core\",") != std::string::npos);
    QVERIFY(runText(results.plan, results.samples[1], 3, 0).find("disturbed: other programs used 20 %") != std::string::npos);
    results.samples.resize(1);
    QVERIFY(disturbedRuns(results).empty());
}

void DisturbancesTest::cpuTimesOfTheKernelAreRead()
{
    metrics::MachineUsage usage;
    metrics::readCpuTimes("cpu  100 20 30 5000 40 5 6 70 1 0\ncpu0 1 1 1 1 1 1 1 1 1 1\n", 100, usage);
    QCOMPARE(*usage.busy, Duration(1610ms)); // not idle, and waiting for a disk is idle
    QCOMPARE(*usage.stolen, Duration(700ms));
    for (const char *broken : {"", "cpu 1 2 3", "intr 1 2 3 4 5 6 7 8", "cpu a b c d e f g h"}) {
        metrics::MachineUsage none;
        metrics::readCpuTimes(broken, 100, none);
        QVERIFY2(!none.busy && !none.stolen, broken);
    }
}

void DisturbancesTest::frequencyIsTheMean()
{
    QCOMPARE(metrics::meanMegahertz("processor\t: 0\ncpu MHz\t\t: 2000.5\nprocessor\t: 1\ncpu MHz\t\t: 3000.5\n"), 2500.5);
    QVERIFY(!metrics::meanMegahertz("processor : 0\n"));
}

void DisturbancesTest::thisMachineTells()
{
#ifdef Q_OS_LINUX
    const metrics::MachineUsage usage = metrics::machineUsage();
    QVERIFY(usage.busy > Duration::zero() && usage.stolen >= Duration::zero() && usage.load >= 0);
    const auto switches = metrics::contextSwitches(::getpid());
    QVERIFY(switches && switches->voluntary + switches->involuntary > 0);
    QVERIFY(!metrics::contextSwitches(-1));
#endif
}

void DisturbancesTest::everyProgramHasACoreOfItsOwn()
{
    QVERIFY(!placementOn({}).station);
    const Placement tooFew = placementOn({0, 1, 2, 3}); // none would be left for the rest of the machine
    QVERIFY(!tooFew.station && !tooFew.agent && !tooFew.simulator && !tooFew.relay);
    QCOMPARE(tooFew.text(), std::string("left to the system: 4 usable cores are too few for one each"));
    const Placement placed = placementOn({8, 2, 5, 1, 0});
    QCOMPARE(placed.text(),
             std::string("station's I/O thread on core 8; agent on core 2; simulator on core 5; relay on core 1"));
}

void DisturbancesTest::threadsAreBackOnTheirCores()
{
#ifdef Q_OS_LINUX
    const auto usable = [] { return placementHere().usable; };
    const int before = usable();
    int within = 0, inThread = 0;
    cpu_set_t set;
    QCOMPARE(::sched_getaffinity(0, sizeof set, &set), 0);
    int first = 0;
    while (!CPU_ISSET(first, &set))
        ++first;
    {
        const OnCore onCore(first);
        within = usable();
        std::thread([&] { inThread = usable(); }).join();
    }
    QCOMPARE(within, 1);
    QCOMPARE(inThread, 1);
    QCOMPARE(usable(), before);
    {
        const OnCore unchanged(std::nullopt);
        QCOMPARE(usable(), before);
    }
#endif
}

SKYSEAL_TEST(DisturbancesTest)
#include "disturbances_test.moc"
