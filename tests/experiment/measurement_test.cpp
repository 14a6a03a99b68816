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

SKYSEAL_TEST(MeasurementTest)
#include "measurement_test.moc"
