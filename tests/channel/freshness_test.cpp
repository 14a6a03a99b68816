// The limits on the age of commands: slow links and suspended machines stay within them, and both ends report late commands.
#include "core/channel/arrival_history.h"
#include "core/channel/endpoint.h"
#include "core/channel/peer_clock.h"
#include "core/crypto/init_crypto.h"
#include "delayed_flight.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class FreshnessTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void overtakenRecordsAreDetected();
    void ageIsNeverTooSmall();
    void slowLinkStaysFresh_data();
    void slowLinkStaysFresh();
    void suspendedMachineRecovers_data();
    void suspendedMachineRecovers();
    void unknownAgeIsReported();
    void limitsAndRefusalsReachTheStation();
    void framesSealedInPlaceHaveTheAgeOfTheLastReport();
};

void FreshnessTest::overtakenRecordsAreDetected()
{
    // Against the list of all arrivals.
    constexpr Duration kLimit = 1s;
    std::mt19937_64 random(7);
    for (int round = 0; round < 200; ++round) {
        ArrivalHistory history(kLimit);
        std::vector<std::pair<TimePoint, std::uint64_t>> arrivals;
        TimePoint now{10s};
        const auto mostPause = std::chrono::milliseconds(1 << random() % 12);
        for (std::uint64_t position = 1; position < 300; position += 1 + random() % 3) {
            now += Duration(static_cast<Duration::rep>(random() % static_cast<std::uint64_t>(Duration(mostPause).count())));
            history.add(now, RecordPosition{position});
            arrivals.emplace_back(now, position);
            const std::uint64_t asked = random() % (position + 2);
            const auto overtakenBy = [&](Duration limit) {
                return std::any_of(arrivals.begin(), arrivals.end(),
                                   [&](const auto &a) { return a.second > asked && a.first + limit <= now; });
            };
            const bool overtaken = history.overtaken(now, RecordPosition{asked});
            if (overtakenBy(kLimit))
                QVERIFY(overtaken);
            if (overtaken)
                QVERIFY(overtakenBy(kLimit - kLimit / 16));
        }
    }
}

void FreshnessTest::ageIsNeverTooSmall()
{
    // Random delays each way, and clocks of up to 200 ppm.
    std::mt19937_64 random(8);
    const auto randomly = [&random](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    for (int round = 0; round < 100; ++round) {
        const double ours = 1 + randomly(-2e-4, 2e-4), theirs = 1 + randomly(-2e-4, 2e-4), most = randomly(.001, 4);
        const auto ourClock = [&](double t) {
            return TimePoint(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(t * ours)));
        };
        const auto theirStamp = [&](double t) {
            return static_cast<std::uint32_t>(static_cast<std::int64_t>(t * theirs * 1e6)); // t may be negative
        };
        PeerClock clock(ourClock(0));
        for (double t = 0; t < 900; t += randomly(.1, 3)) { // our report leaves at t
            const double there = t + randomly(0, most), held = randomly(0, 1), back = there + held + randomly(0, most);
            const auto passed = ourClock(back) - ourClock(t),
                       heldByTheirs = Duration(static_cast<Duration::rep>(held * theirs * 1e9));
            clock.add(ourClock(back), ourClock(back) - (passed - heldByTheirs) - heldByTheirs / PeerClock::kDrift,
                      theirStamp(there + held));
            const double sent = back + randomly(-1, 1), arrived = sent + randomly(1, 1 + most);
            const auto age = clock.age(ourClock(arrived), theirStamp(sent) & ~1023u);
            QVERIFY(age);
            QVERIFY2(seconds(*age) >= (arrived - sent) * ours - 2e-6,
                     qPrintable(QString::number(seconds(*age) - (arrived - sent))));
        }
    }
}

void FreshnessTest::slowLinkStaysFresh_data()
{
    QTest::addColumn<Way>("way");
    QTest::addColumn<int>("loss");
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("least"); // share of fresh frames
    // Frames sealed in place count as old as the report before them, so that lost reports make them older.
    for (const Way &way : kWays) {
        QTest::addRow("%s, no loss", way.name) << way << 0 << 1. << 1.;
        QTest::addRow("%s, a tenth lost, a clock 200 ppm fast", way.name) << way << 10 << 1.0002 << (way.inPlace ? 0.99 : 1.);
        QTest::addRow("%s, half lost, a clock 200 ppm slow", way.name) << way << 50 << .9998 << (way.inPlace ? 0.8 : 1.);
    }
}

void FreshnessTest::slowLinkStaysFresh()
{
    QFETCH(Way, way);
    QFETCH(int, loss);
    QFETCH(double, rate);
    QFETCH(double, least);
    PairOptions options = optionsWith(way, kAge);
    options.link.delay = 900ms;
    options.link.jitter = 300ms; // 0.9 to 1.5 s each way
    options.link.loss = loss / 100.;
    Pair pair(options);
    pair.ground().clock.rate = rate;
    pair.start(Ground);
    QVERIFY(pair.run(60s, [&] { return pair.bothUp(); }));
    pair.every(1s, [&] { pair.sendFrame(Ground); });
    const TimePoint begin = pair.now;
    pair.run(900s); // with a change of keys
    QVERIFY(pair.air().freshness.size() > 300);
    const double share = shareOfFresh(pair, begin);
    QVERIFY2(share >= least, qPrintable(QString::number(share)));
}

void FreshnessTest::suspendedMachineRecovers_data()
{
    QTest::addColumn<int>("side");
    QTest::addColumn<int>("seconds");
    for (const int seconds : {3, 8, 300}) {
        QTest::addRow("station, %d s", seconds) << static_cast<int>(Ground) << seconds;
        QTest::addRow("agent, %d s", seconds) << static_cast<int>(Air) << seconds;
    }
}

void FreshnessTest::suspendedMachineRecovers()
{
    // Its steady clock stands still, and it receives nothing. Its first frames may be refused; the agent requests a report.
    QFETCH(int, side);
    QFETCH(int, seconds);
    auto pair = flight(optionsWith(kRecords, kAge));
    Pair::End &end = pair->ends[static_cast<std::size_t>(side)];
    const auto asleep = std::chrono::seconds(seconds);
    std::unique_ptr<Endpoint> suspended = std::move(end.endpoint);
    pair->run(asleep);
    end.endpoint = std::move(suspended);
    end.clock.offset -= asleep;
    const TimePoint awake = pair->now;
    pair->run(60s);
    QVERIFY(pair->ground().all<SessionDown>().empty() && pair->air().all<SessionDown>().empty());
    QCOMPARE(shareOfFresh(*pair, awake + 1500ms), 1.);
    QCOMPARE(freshAndOlder(*pair, kAge), std::size_t(0));
}

void FreshnessTest::unknownAgeIsReported()
{
    // After a step of the station's steady clock, as of a virtual machine, its stamps say nothing before its next report.
    auto pair = flight(optionsWith(kRecords, kAge));
    pair->ground().clock.offset += 8s;
    pair->link.attacker = [](TimePoint, SentDatagram &datagram) { return datagram.from == Air || datagram.tag != 0; };
    QVERIFY(pair->run(3s, [&] { return !pair->ground().all<CommandsLate>().empty(); }));
    QVERIFY(!pair->ground().all<CommandsLate>().front().report.isAgeKnown());
    pair->link.attacker = {};
    const TimePoint reported = pair->now;
    pair->run(5s);
    QCOMPARE(shareOfFresh(*pair, reported + 1500ms), 1.);
    QVERIFY(pair->ground().stats()->peerFreshness->isAgeKnown());
}

void FreshnessTest::limitsAndRefusalsReachTheStation()
{
    auto pair = flight(optionsWith(kRecords, kAge));
    const Caught command = catchOne(*pair, 40, Ground);
    pair->run(2s);
    QCOMPARE(static_cast<int>(*release(*pair, command)), static_cast<int>(Freshness::Overtaken));
    QVERIFY(pair->run(2s, [&] { return !pair->ground().all<CommandsLate>().empty(); }));
    const auto late = pair->ground().all<CommandsLate>().front();
    QCOMPARE(late.records, std::uint64_t(1));
    QCOMPARE(late.report.overtakenMilliseconds, std::uint64_t(1000));
    QCOMPARE(late.report.limitMilliseconds, std::uint64_t(5000));
    const auto stats = pair->ground().stats();
    QVERIFY(stats->peerFreshness && stats->peerFreshness->stale == 1);
    QVERIFY(stats->peerFreshness->ageMicroseconds < 20'000); // a millisecond each way
    pair->run(3s);
    QCOMPARE(pair->ground().all<CommandsLate>().size(), 1u); // once
}

void FreshnessTest::framesSealedInPlaceHaveTheAgeOfTheLastReport()
{
    PairOptions options = inlineOptions();
    options.freshness = {kOvertaken, 2500ms};
    auto pair = flight(options);
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Ctr);
    pair->run(5s);
    QCOMPARE(static_cast<int>(pair->ground().framing()), static_cast<int>(Framing::Inline));
    const TimePoint begin = pair->now;
    pair->run(20s);
    QCOMPARE(shareOfFresh(*pair, begin), 1.);
    // Without reports the agent cannot determine their age.
    pair->link.attacker = [](TimePoint, SentDatagram &datagram) { return datagram.from == Air || datagram.bytes[0] == 0xfd; };
    pair->run(5s);
    const TimePoint silent = pair->now;
    pair->run(5s);
    QCOMPARE(shareOfFresh(*pair, silent), 0.);
}

SKYSEAL_TEST(FreshnessTest)
#include "freshness_test.moc"
