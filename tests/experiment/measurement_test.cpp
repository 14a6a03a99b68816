// The values of a run from two snapshots: overhead of plain MAVLink, and loss by sequence numbers.
#include "core/engine/station/snapshot.h"
#include "core/experiment/measurement.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;
using namespace std::chrono_literals;

namespace {

Reading reading(double time, std::uint64_t frames, std::uint64_t waiting)
{
    auto snapshot = std::make_shared<engine::Snapshot>();
    snapshot->time = time;
    snapshot->mavlink.frames = frames;
    snapshot->mavlink.bytes = 40 * frames;
    snapshot->mavlink.duplicate = frames / 10;
    snapshot->mavlink.lost = frames / 5;
    engine::LinkSnapshot link;
    link.rxBytes = 40 * frames + 133 * waiting;
    link.rxDatagrams = frames / 4 + waiting;
    snapshot->links.push_back(std::move(link));
    auto probe = std::make_shared<engine::Probe>();
    probe->waitingBytes = 133 * waiting;
    probe->waitingDatagrams = waiting;
    snapshot->probe = std::move(probe);
    Reading out;
    out.mavlink = snapshot->mavlink;
    out.station = std::move(snapshot);
    return out;
}

} // namespace

class MeasurementTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void announcementsDoNotCountAsOverheadOfPlain();
    void lossIsEmptyWhereSequenceNumbersDoNotCountIt();
    void sequenceNumbersCountLossWithLittleJitter();
    void agentsCpuHasOneSourceForAllArms();
    void reportsCountWhereTheAgentIsElsewhere();
    void messagesAreThoseOfTheRun();
    void lineLoadIsThatOfTheLine();
};

void MeasurementTest::announcementsDoNotCountAsOverheadOfPlain()
{
    const Values values = valuesBetween(reading(1, 1000, 5), reading(3, 2000, 9), false, true);
    QCOMPARE(values[Metric::ByteRate], 20000.0);
    QCOMPARE(values[Metric::WireRate], 20000.0);
    QCOMPARE(values[Metric::WireBytes], 40000.0);
    QCOMPARE(values[Metric::Overhead], 0.0);
    QCOMPARE(values[Metric::WirePerFrame], (40000.0 + 28 * 250) / 900); // a tenth are duplicates
}

void MeasurementTest::lossIsEmptyWhereSequenceNumbersDoNotCountIt()
{
    const Reading begin = reading(0, 0, 0), end = reading(1, 1000, 0);
    const Values counted = valuesBetween(begin, end, false, true);
    QCOMPARE(counted[Metric::Packets], 900.0);
    QCOMPARE(counted[Metric::Loss], 200.0 / 1100);
    const Values uncounted = valuesBetween(begin, end, false, false);
    QCOMPARE(uncounted[Metric::Packets], 1000.0);
    QVERIFY(std::isnan(uncounted[Metric::Loss]));
}

void MeasurementTest::sequenceNumbersCountLossWithLittleJitter()
{
    impair::ImpairmentSettings link;
    QVERIFY(sequenceNumbersCountLoss(link, Load::Saturated));
    link.delay = 50ms;
    link.loss = 0.05;
    link.reorder = 0.1;
    link.duplicate = 0.1;
    QVERIFY(sequenceNumbersCountLoss(link, Load::Saturated));
    link.jitter = 20ms;
    QVERIFY(sequenceNumbersCountLoss(link, Load::Natural));
    QVERIFY(!sequenceNumbersCountLoss(link, Load::Saturated));
    link.baud = 57'600;
    QVERIFY(sequenceNumbersCountLoss(link, Load::Saturated)); // a frame overtakes ten others at most
    link.baud = 921'600;
    QVERIFY(!sequenceNumbersCountLoss(link, Load::Saturated));
}

/// The agent's report: `microseconds` after the first one, it has used `used`.
static AgentCostReport report(std::uint32_t microseconds, Duration used)
{
    AgentCostReport out;
    out.stamp = 4'000'000'000 + microseconds; // passes 2^32
    out.costs.cpuMicroseconds = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(used).count());
    out.costs.residentBytes = 7'000'000;
    out.costs.sealNanoseconds = microseconds * 50;
    out.costs.sealed = microseconds / 100;
    return out;
}

/// The kernel has read the agent over the whole run, and its reports cover a part of it in which it did twice as much.
void MeasurementTest::agentsCpuHasOneSourceForAllArms()
{
    Reading begin = reading(0, 0, 0), end = reading(5, 1000, 0);
    begin.programs.at = TimePoint(1s);
    begin.programs.agentCpu = 2s;
    end.programs.at = TimePoint(6s); // read beside the station's thread
    end.programs.agentCpu = 3s;
    end.programs.agentMemory = 5'000'000;
    begin.agent = report(0, 0s);
    end.agent = report(1'000'000, 400ms);
    const Values sealed = valuesBetween(begin, end, true, true), plain = valuesBetween(begin, end, false, true);
    QCOMPARE(sealed[Metric::AgentCpu], 20.0);
    QCOMPARE(plain[Metric::AgentCpu], 20.0);
    QCOMPARE(sealed[Metric::AgentMemory], 5e6);
    QCOMPARE(plain[Metric::AgentMemory], 5e6);
    QCOMPARE(plain[Metric::AgentCpuPerFrame], 0.2e9 / (900 / 5.0)); // a tenth are duplicates
    QCOMPARE(sealed[Metric::AgentSeal], 5000.0);                    // only the agent knows
    QVERIFY(std::isnan(plain[Metric::AgentSeal]));
}

void MeasurementTest::reportsCountWhereTheAgentIsElsewhere()
{
    Reading begin = reading(0, 0, 0), end = reading(5, 1000, 0);
    begin.agent = report(0, 0s);
    end.agent = report(1'000'000, 400ms);
    const Values sealed = valuesBetween(begin, end, true, true), plain = valuesBetween(begin, end, false, true);
    QCOMPARE(sealed[Metric::AgentCpu], 40.0);
    QCOMPARE(sealed[Metric::AgentMemory], 7e6);
    QVERIFY(std::isnan(plain[Metric::AgentCpu]) && std::isnan(plain[Metric::AgentMemory])
            && std::isnan(plain[Metric::AgentCpuPerFrame]));
}

/// What the run received, and not what came before it.
void MeasurementTest::messagesAreThoseOfTheRun()
{
    Reading begin = reading(0, 0, 0), end = reading(5, 1000, 0);
    const auto withMessages = [](Reading &of, std::map<std::uint32_t, std::uint64_t> messages) {
        auto snapshot = std::make_shared<engine::Snapshot>(*of.station);
        auto probe = std::make_shared<engine::Probe>(*snapshot->probe);
        probe->messages = std::move(messages);
        snapshot->probe = std::move(probe);
        of.station = std::move(snapshot);
    };
    withMessages(begin, {{0, 4}, {30, 100}, {242, 1}});
    withMessages(end, {{0, 9}, {30, 700}, {33, 12}, {242, 1}});
    const std::map<std::uint32_t, std::uint64_t> expected{{0, 5}, {30, 600}, {33, 12}};
    QVERIFY(messagesBetween(begin, end) == expected);
}

void MeasurementTest::lineLoadIsThatOfTheLine()
{
    impair::ImpairmentSettings line;
    const Reading begin = reading(0, 0, 0), end = reading(10, 1200, 72); // 57,576 bytes, announcements included
    QVERIFY(std::isnan(lineLoad(begin, end, line)));
    line.baud = 57'600;
    QVERIFY(std::abs(lineLoad(begin, end, line) - 99.96) < 0.01);
    line.loss = 0.2; // before the line
    QVERIFY(std::abs(lineLoad(begin, end, line) - 99.96) < 0.01);
    line.duplicate = 0.25; // behind the line: a fifth of what arrived
    QVERIFY(std::abs(lineLoad(begin, end, line) - 79.97) < 0.01);
}

SKYSEAL_TEST(MeasurementTest)
#include "measurement_test.moc"
