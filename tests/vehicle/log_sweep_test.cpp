// Where a vehicle is sent that streams a log from the latest request on: past what has arrived, without a pause, and again.
#include "core/vehicle/log_sweep.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

constexpr Duration kInterval = std::chrono::milliseconds(1), kRoundTrip = std::chrono::milliseconds(40);
constexpr std::size_t kChunks = 200;

using TimedRequest = QPair<double, int>; ///< seconds and first chunk

/// A log of which the vehicle has streamed every chunk since a request at 0; some were lost.
struct StreamedLog
{
    /// `burst`: so many chunks are sent at once.
    explicit StreamedLog(std::initializer_list<std::size_t> lost, std::size_t burst = 1)
    {
        sweep.begin(TimePoint{}, content);
        for (std::size_t i = 0; i < kChunks; ++i) {
            if (std::ranges::find(lost, i) == lost.end())
                arrive(i, TimePoint{} + kRoundTrip + kInterval * static_cast<int>(i / burst * burst));
        }
    }

    void arrive(std::size_t chunk, TimePoint time)
    {
        content.store(chunk, Bytes(LogContent::kChunk, 1));
        sweep.arrived(time, chunk);
    }

    TimedRequest nextRequest()
    {
        while (sweep.nextDeadline() != kNever) {
            const TimePoint now = sweep.nextDeadline();
            if (const auto chunk = sweep.poll(now, content, kRoundTrip))
                return {seconds(now - TimePoint{}), static_cast<int>(*chunk)};
        }
        return {0, -1};
    }

    LogContent content{kChunks * LogContent::kChunk};
    LogSweep sweep;
};

} // namespace

class LogSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void followsTheVehicle();
    void chunksThatComeByThemselvesAreNotRequested();
    void eachBurstServesOneRequest();
    void lastChunksAreRequestedSeveralTimesInARoundTrip();
    void nothingIsRequestedBeforeThePaceIsKnown();
    void endsWithTheLastChunk();
};

void LogSweepTest::followsTheVehicle()
{
    StreamedLog log({10, 50, 51, 52, 53, 54, 55, 56, 90, 150});
    QCOMPARE(log.nextRequest(), TimedRequest(0.200, 10)); // when it has sent all, although the end is still under way
    QCOMPARE(log.nextRequest(), TimedRequest(0.205, 50)); // not sooner than the least spacing
    QCOMPARE(log.nextRequest(), TimedRequest(0.212, 90)); // when the whole run was sent
    QCOMPARE(log.nextRequest(), TimedRequest(0.217, 150));
    QCOMPARE(log.nextRequest(), TimedRequest(0.222, 10)); // again
}

void LogSweepTest::chunksThatComeByThemselvesAreNotRequested()
{
    StreamedLog log({10, 15, 16, 18, 40});
    QCOMPARE(log.nextRequest(), TimedRequest(0.200, 10)); // sent up to 14 when the next may be requested, and then 15 and 16
    QCOMPARE(log.nextRequest(), TimedRequest(0.207, 18));
    QCOMPARE(log.nextRequest(), TimedRequest(0.212, 40));
}

void LogSweepTest::eachBurstServesOneRequest()
{
    StreamedLog log({10, 22, 50, 150}, 10);
    QCOMPARE(log.nextRequest(), TimedRequest(0.200, 10));
    QCOMPARE(log.nextRequest(), TimedRequest(0.210, 22)); // not in the same burst
    QCOMPARE(log.nextRequest(), TimedRequest(0.220, 50));
}

void LogSweepTest::lastChunksAreRequestedSeveralTimesInARoundTrip()
{
    StreamedLog log({10});
    double latest = log.nextRequest().first;
    for (int i = 0; i < 10; ++i) {
        const auto [time, chunk] = log.nextRequest();
        QCOMPARE(chunk, 10);
        QCOMPARE(time - latest, seconds(kRoundTrip) / LogSweep::kInRoundTrip);
        latest = time;
    }
}

void LogSweepTest::nothingIsRequestedBeforeThePaceIsKnown()
{
    LogContent content(kChunks * LogContent::kChunk);
    LogSweep sweep;
    sweep.begin(TimePoint{}, content);
    for (std::size_t i = 0; i < LogSweep::kMeasured; ++i)
        sweep.arrived(TimePoint{} + kRoundTrip + kInterval * static_cast<int>(i), i);
    QCOMPARE(sweep.nextDeadline(), kNever);
    sweep.arrived(TimePoint{} + kRoundTrip + kInterval * static_cast<int>(LogSweep::kMeasured), LogSweep::kMeasured);
    QCOMPARE(sweep.nextDeadline(), TimePoint{} + kInterval * static_cast<int>(kChunks));
    sweep.stop();
    QCOMPARE(sweep.nextDeadline(), kNever);
}

void LogSweepTest::endsWithTheLastChunk()
{
    StreamedLog log({10});
    log.nextRequest();
    log.arrive(10, TimePoint{} + std::chrono::milliseconds(240));
    QCOMPARE(log.nextRequest().second, -1);
}

SKYSEAL_TEST_APPLESS(LogSweepTest)
#include "log_sweep_test.moc"
