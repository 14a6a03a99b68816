// Attacks by delay: commands of a pilot that are withheld and released later, one by one, in bursts, or with the whole flow;
// after the pilot's close, over a change of epochs, with clocks that drift; in each carrier, and sealed in place.
#include "core/channel/endpoint.h"
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "crowd.h"
#include "delayed_flight.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

namespace {

void everyWay()
{
    QTest::addColumn<Way>("way");
    for (const Way &way : kWays)
        QTest::newRow(way.name) << way;
}

/// Whether all commands of the station since then were fresh at the agent, and there were some.
bool areFresh(const Pair &pair, TimePoint since)
{
    std::size_t fresh = 0, sent = 0;
    for (const std::uint64_t number : pair.sent[Ground]) {
        if (pair.sentAt.at(number) < since || pair.sentAt.at(number) > pair.now - 1s)
            continue;
        ++sent;
        const auto judged = pair.ends[Air].freshness.find(number);
        fresh += judged != pair.ends[Air].freshness.end() && judged->second == Freshness::Fresh;
    }
    return sent > 0 && fresh == sent;
}

} // namespace

class AttackFreshnessTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void withheldCommand_data();
    void withheldCommand();
    void withheldBurst_data();
    void withheldBurst();
    void releasedAfterClose_data() { everyWay(); }
    void releasedAfterClose();
    void releasedAfterAWithheldClose_data() { everyWay(); }
    void releasedAfterAWithheldClose();
    void releasedWhenTheStampsRepeat_data() { everyWay(); }
    void releasedWhenTheStampsRepeat();
    void releasedAfterASwitch_data() { everyWay(); }
    void releasedAfterASwitch();
    void wholeFlowHeldThenReleased_data();
    void wholeFlowHeldThenReleased();
    void wholeFlowDelayed_data();
    void wholeFlowDelayed();
    void onlyTheWayBackDelayed_data() { everyWay(); }
    void onlyTheWayBackDelayed();
    void growingDelay_data() { everyWay(); }
    void growingDelay();
    void staleTelemetry_data() { everyWay(); }
    void staleTelemetry();
    void withheldReports_data();
    void withheldReports();
    void bothEndsAsleep();
    void limitIsConfigurable();
    void otherStationsKeepNothingFresh();
};

void AttackFreshnessTest::withheldReports_data()
{
    QTest::addColumn<int>("from");
    QTest::newRow("of the station") << static_cast<int>(Ground);
    QTest::newRow("of the agent") << static_cast<int>(Air);
}

void AttackFreshnessTest::withheldReports()
{
    // Control records can be told from frames by size and rhythm. After 36 minutes without them a stamp of 32 bits does not say
    // any more which of two is the older one.
    QFETCH(int, from);
    auto pair = flight(optionsWith(kRecords, kAge));
    pair->stopTraffic();
    pair->every(1s, [&] { pair->sendFrame(Ground); });
    pair->every(2s, [&] { pair->sendFrame(Air); });
    pair->link.attacker = [from](TimePoint, SentDatagram &datagram) { return datagram.from != from || datagram.tag != 0; };
    pair->run(40min);
    pair->link.attacker = {};
    pair->run(2min);
    const TimePoint healed = pair->now;
    pair->run(5min);
    const auto hasTimedOut = [&pair](Side side) {
        const auto ended = pair->ends[side].all<SessionDown>();
        return std::ranges::any_of(ended, [](const SessionDown &down) { return down.reason == DownReason::TimedOut; });
    };
    HOLDS(hasTimedOut(Ground) && hasTimedOut(Air), "a session without reports ends");
    QVERIFY(areFresh(*pair, healed));
}

void AttackFreshnessTest::bothEndsAsleep()
{
    // A datagram that waited in the socket is taken before the deadline that was missed.
    auto pair = flight(optionsWith(kRecords, kAge));
    pair->stopTraffic();
    const Caught fromAir = catchOne(*pair, 28, Air), fromGround = catchOne(*pair, 28, Ground);
    auto ground = std::move(pair->ground().endpoint), air = std::move(pair->air().endpoint);
    pair->run(40min);
    pair->ground().endpoint = std::move(ground);
    pair->air().endpoint = std::move(air);
    HOLDS(!release(*pair, fromAir) && !release(*pair, fromGround), "a session that is over takes nothing");
    pair->every(1s, [&] { pair->sendFrame(Ground); });
    pair->run(2min);
    const TimePoint awake = pair->now;
    pair->run(5min);
    QVERIFY(areFresh(*pair, awake));
}

void AttackFreshnessTest::withheldCommand_data()
{
    QTest::addColumn<Way>("way");
    QTest::addColumn<int>("milliseconds");
    QTest::addColumn<int>("limit");
    for (const Way &way : kWays) {
        QTest::addRow("%s, 0.5 s", way.name) << way << 500 << 200;
        for (const int seconds : {2, 20, 300, 590})
            QTest::addRow("%s, %d s", way.name, seconds) << way << seconds * 1000 << 1000;
    }
}

void AttackFreshnessTest::withheldCommand()
{
    QFETCH(Way, way);
    QFETCH(int, milliseconds);
    QFETCH(int, limit);
    PairOptions options = optionsWith(way, {});
    options.freshness.overtaken = std::chrono::milliseconds(limit);
    auto pair = flight(options);
    const Caught command = catchOne(*pair, 40, Ground);
    QCOMPARE(looksInline(command.flight.bytes), way.inPlace);
    if (limit < 1000) // Records that overtake it within that time.
        pair->every(100ms, [&] { pair->sendFrame(Ground); });
    pair->run(std::chrono::milliseconds(milliseconds));
    HOLDS(!commands(release(*pair, command)), "no overtaken command is obeyed");
    HOLDS(freshAndOlder(*pair, kOvertaken) == 0, "no overtaken command is obeyed");
    QCOMPARE(received(pair->air()).stale, std::uint64_t(1)); // after 600 s the keys of its epoch are gone
    QVERIFY(pair->bothUp());
}

void AttackFreshnessTest::withheldBurst_data()
{
    QTest::addColumn<Way>("way");
    QTest::addColumn<bool>("reversed");
    for (const Way &way : kWays) {
        QTest::addRow("%s, in order", way.name) << way << false;
        QTest::addRow("%s, reversed", way.name) << way << true;
    }
}

void AttackFreshnessTest::withheldBurst()
{
    QFETCH(Way, way);
    QFETCH(bool, reversed);
    auto pair = flight(optionsWith(way, {}));
    std::vector<Caught> burst;
    for (int i = 0; i < 20; ++i)
        burst.push_back(catchOne(*pair, 40, Ground));
    pair->run(2s);
    if (reversed)
        std::reverse(burst.begin(), burst.end());
    std::size_t obeyed = 0, delivered = 0;
    for (int copy = 0; copy < 2; ++copy) {
        for (const Caught &caught : burst) {
            const auto freshness = release(*pair, caught);
            obeyed += commands(freshness);
            delivered += freshness.has_value();
        }
    }
    HOLDS(obeyed == 0, "no overtaken command is obeyed");
    QCOMPARE(delivered, burst.size()); // each once, for the questions in them
    QCOMPARE(received(pair->air()).stale, std::uint64_t(burst.size()));
    QCOMPARE(received(pair->air()).replayed, std::uint64_t(burst.size()));
}

void AttackFreshnessTest::releasedAfterClose()
{
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, kAge));
    const Caught command = catchOne(*pair, 40, Ground);
    pair->ground().close(pair->now);
    pair->stopTraffic();
    pair->run(50ms);           // less than either limit
    QVERIFY(pair->air().up()); // it waits for records that the close overtook
    HOLDS(!commands(release(*pair, command)), "nothing commands after the close");
}

/// Everything after the command is withheld, the close too: only the age of the command limits its use.
void AttackFreshnessTest::releasedAfterAWithheldClose()
{
    QFETCH(Way, way);
    // A frame sealed in place counts as old as the report before it, which is up to a second older.
    for (const Duration held : {way.inPlace ? Duration(3500ms) : Duration(4500ms), Duration(5100ms), Duration(60s)}) {
        auto pair = flight(optionsWith(way, kAge));
        const Caught command = catchOne(*pair, 40, Ground);
        pair->link.attacker = [](TimePoint, SentDatagram &datagram) { return datagram.from == Air; };
        pair->ground().close(pair->now);
        pair->stopTraffic();
        pair->run(held);
        QVERIFY(pair->air().up());
        const auto judged = release(*pair, command);
        HOLDS(held <= kAge || !commands(judged), "nothing older than the limit is obeyed");
        QCOMPARE(commands(judged), held <= kAge);
    }
}

void AttackFreshnessTest::releasedWhenTheStampsRepeat()
{
    // The stamps of reports repeat after 2^32 us. One old record every nine minutes would keep the session of the agent up
    // until then, if any record did; the reports that were sent before the command, and it, come half a second later.
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, kAge));
    std::vector<SentDatagram> withheld;
    pair->link.attacker = [&](TimePoint, SentDatagram &datagram) {
        if (datagram.from == Ground)
            withheld.push_back(datagram);
        return datagram.from == Air;
    };
    pair->run(12500ms);
    const std::size_t before = withheld.size();
    const std::uint64_t command = pair->sendFrame(Ground, 40);
    const TimePoint end = pair->now + std::chrono::microseconds(1LL << 32) + 500ms;
    pair->stopTraffic();
    pair->ground().close(pair->now);
    pair->run(1s);
    pair->kill(Ground);
    std::size_t next = 0;
    while (pair->now + 9min < end) {
        pair->run(9min);
        QVERIFY(next < before);
        pair->link.inject(pair->now, withheld[next++]);
    }
    pair->run(end - pair->now);
    for (; next <= before; ++next)
        pair->link.inject(pair->now + std::chrono::milliseconds(next), withheld[next]);
    pair->run(1s);
    const auto judged = pair->air().freshness.find(command);
    HOLDS(judged == pair->air().freshness.end() || !commands(judged->second), "nothing older than the limit is obeyed");
}

void AttackFreshnessTest::releasedAfterASwitch()
{
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, {}));
    const Caught command = catchOne(*pair, 40, Ground);
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    pair->run(1s, [&] { return !pair->ground().all<SwitchDone>().empty(); });
    pair->run(1500ms); // the keys of the previous epoch live for 3 s
    const auto judged = release(*pair, command);
    QVERIFY(judged);
    HOLDS(!commands(judged), "no overtaken command is obeyed");
}

void AttackFreshnessTest::wholeFlowHeldThenReleased_data()
{
    QTest::addColumn<Way>("way");
    QTest::addColumn<int>("seconds");
    QTest::addColumn<bool>("newestFirst");
    for (const Way &way : kWays) {
        for (const int seconds : {7, 30, 300}) {
            for (const bool newestFirst : {false, true})
                QTest::addRow("%s, %d s, %s", way.name, seconds, newestFirst ? "newest first" : "in order")
                    << way << seconds << newestFirst;
        }
    }
}

void AttackFreshnessTest::wholeFlowHeldThenReleased()
{
    // No record overtakes the first commands of the outage: only their age can reveal the delay.
    QFETCH(Way, way);
    QFETCH(int, seconds);
    QFETCH(bool, newestFirst);
    auto pair = flight(optionsWith(way, kAge));
    std::vector<SentDatagram> held;
    pair->link.attacker = [&](TimePoint, SentDatagram &datagram) {
        if (datagram.from == Ground)
            held.push_back(datagram);
        return datagram.from == Air;
    };
    pair->run(std::chrono::seconds(seconds));
    pair->link.attacker = {};
    if (newestFirst)
        std::reverse(held.begin(), held.end());
    for (SentDatagram &datagram : held)
        pair->link.inject(pair->now, std::move(datagram));
    pair->run(100ms);
    HOLDS(freshAndOlder(*pair, kAge) == 0, "nothing older than the limit is obeyed");
    const TimePoint after = pair->now;
    pair->run(5s);
    QVERIFY(shareOfFresh(*pair, after + 1s) > .99); // and the flight goes on
}

void AttackFreshnessTest::wholeFlowDelayed_data()
{
    QTest::addColumn<Way>("way");
    QTest::addColumn<int>("up");
    QTest::addColumn<int>("down");
    QTest::addColumn<double>("rate");
    QTest::addColumn<bool>("exchanged");
    for (const Way &way : kWays) {
        QTest::addRow("%s, both ways 7 s", way.name) << way << 7000 << 7000 << 1. << false;
        QTest::addRow("%s, up 7 s", way.name) << way << 7000 << 10 << 1. << false;
        QTest::addRow("%s, down 7 s, then up 7 s in its place", way.name) << way << 7000 << 10 << 1. << true;
        QTest::addRow("%s, up 5.05 s, a station's clock 200 ppm fast", way.name) << way << 5050 << 10 << 1.0002 << false;
        QTest::addRow("%s, up 5.05 s, a station's clock 200 ppm slow", way.name) << way << 5050 << 10 << .9998 << false;
    }
}

void AttackFreshnessTest::wholeFlowDelayed()
{
    QFETCH(Way, way);
    QFETCH(int, up);
    QFETCH(int, down);
    QFETCH(double, rate);
    QFETCH(bool, exchanged);
    auto pair = std::make_unique<Pair>(optionsWith(way, kAge));
    pair->ground().clock.rate = rate;
    pair->start(Ground);
    QVERIFY(pair->run(60s, [&] { return pair->bothUp(); }));
    pair->every(1s, [&] { pair->sendFrame(Ground); });
    pair->run(30s);
    // The attacker takes over and delays every datagram by the same time.
    const auto delayBy = [&](int fromGround, int fromAir) {
        pair->link.attacker = [=, &pair](TimePoint at, SentDatagram &datagram) {
            pair->link.inject(at + std::chrono::milliseconds(datagram.from == Ground ? fromGround : fromAir), datagram);
            return false;
        };
    };
    if (exchanged) { // The round trip stays the same.
        delayBy(down, up);
        pair->run(100s);
    }
    delayBy(up, down);
    pair->run(300s);
    HOLDS(freshAndOlder(*pair, kAge) == 0, "nothing older than the limit is obeyed");
}

void AttackFreshnessTest::onlyTheWayBackDelayed()
{
    // Commands arrive in time, but the agent does not know it: their answers take 7 s. The previous bound holds for a minute.
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, kAge));
    pair->link.attacker = [&](TimePoint at, SentDatagram &datagram) {
        pair->link.inject(at + (datagram.from == Ground ? 10ms : 7000ms), datagram);
        return false;
    };
    pair->run(70s);
    const TimePoint later = pair->now;
    const std::size_t before = pair->air().freshness.size();
    pair->run(60s);
    QVERIFY(pair->air().freshness.size() > before + 50);
    HOLDS(shareOfFresh(*pair, later) == 0, "nothing that may be older than the limit is obeyed");
    QCOMPARE(freshAndOlder(*pair, kAge), std::size_t(0));
}

void AttackFreshnessTest::growingDelay()
{
    // By a millisecond for each 20, so slowly that no single message stands out, up to ten seconds.
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, kAge));
    const TimePoint begin = pair->now;
    pair->link.attacker = [&](TimePoint at, SentDatagram &datagram) {
        pair->link.inject(at + (at - begin) / 20, datagram);
        return false;
    };
    pair->run(200s);
    HOLDS(freshAndOlder(*pair, kAge) == 0, "nothing older than the limit is obeyed");
    QVERIFY(!pair->ground().all<CommandsLate>().empty());
}

void AttackFreshnessTest::staleTelemetry()
{
    QFETCH(Way, way);
    auto pair = flight(optionsWith(way, kAge));
    const Caught telemetry = catchOne(*pair, 40, Air);
    pair->run(2s);
    const auto judged = release(*pair, telemetry);
    QVERIFY(judged);
    HOLDS(judged != Freshness::Fresh, "no overtaken telemetry sets a present value");
    QCOMPARE(received(pair->ground()).stale, std::uint64_t(1));
}

void AttackFreshnessTest::limitIsConfigurable()
{
    // 1.2 s each way, of which the agent knows the sum.
    const auto share = [](std::optional<Duration> limit) {
        PairOptions options = optionsWith(kRecords, limit);
        options.link.delay = 1200ms;
        auto pair = flight(options);
        const TimePoint begin = pair->now;
        pair->run(60s);
        return shareOfFresh(*pair, begin);
    };
    QCOMPARE(share({}), 1.);
    QCOMPARE(share(2500ms), 1.);
    HOLDS(share(2s) == 0, "nothing older than the limit is obeyed");
}

void AttackFreshnessTest::otherStationsKeepNothingFresh()
{
    // All that one station sends is held back for 7 s, while the others go on: neither do they make its records look younger,
    // nor do its old ones make theirs look older.
    Crowd crowd(3);
    for (const std::size_t station : {0, 1, 2})
        crowd.start(station);
    QVERIFY(crowd.run(10s, [&] { return crowd.up(0) && crowd.up(1) && crowd.up(2); }));
    crowd.run(5s);
    crowd.sendEvery(250ms);
    crowd.hold(0);
    crowd.run(7s);
    crowd.release(0);
    crowd.run(3s);
    std::size_t oldAndObeyed = 0, others = 0, late = 0, own = 0;
    for (const Crowd::Heard &frame : crowd.heard) {
        if (frame.station == 0) {
            oldAndObeyed += frame.freshness == Freshness::Fresh && frame.age > kAge;
            own += frame.freshness == Freshness::Fresh && frame.age < 2s;
            continue;
        }
        ++others;
        late += frame.freshness != Freshness::Fresh;
    }
    HOLDS(oldAndObeyed == 0, "nothing older than the limit is obeyed");
    QVERIFY(others >= 70);
    QCOMPARE(late, std::size_t(0));
    QVERIFY(own >= 10); // its later commands are obeyed again
}

SKYSEAL_TEST(AttackFreshnessTest)
#include "attack_freshness_test.moc"
