// Parameters against a scripted autopilot, first by hand with exact times, then through a radio that drops.
#include "parameter_peer.h"
#include "core/vehicle/parameter_client.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

#include <set>

using namespace skyseal;
using namespace skyseal::vehicle;

class ParameterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gapsAreAskedForByIndex();
    void silentVehicleIsGivenUp();
    void writeIsReadBackAndRepeated();
    void singleParameterIsReadByName();
    void singleParametersFollowTheRoundTrip();
    void lossCostsSingleParametersLittleTime();
    void vehicleMayKeepItsOwnValue();
    void writesTakeTurns();
    void bytewiseIntegers();
    void hashOfAllValuesIsNoParameter();
    void typeIsReadBeforeABytewiseWrite();
    void unchangedListIsShared();
    void namesWithoutEndAreNotKept_data();
    void namesWithoutEndAreNotKept();
    void unsolicitedValuesAreCollected();
    void wholeListThroughABadRadio_data();
    void wholeListThroughABadRadio();
    void gapsAreAskedForWhileTheListComes();
    void overtakenValuesAreNotAskedFor();
    void slowListIsNotAskedForTwice();
    void deadLinkIsNotFlooded();
    void lossCostsLittleTime();
};

void ParameterTest::gapsAreAskedForByIndex()
{
    Harness h = Harness::copter();
    QVERIFY(!h.vehicle.parameters());
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    QCOMPARE(h.sentOf<mavlink::ParamRequestList>().size(), std::size_t(1));
    h.feed(value("A", 1, 0, 3));
    h.feed(value("C", 3, 2, 3));
    QCOMPARE(h.vehicle.parametersExpected(), 3u);
    const auto read = h.nextSent<mavlink::ParamRequestRead>(at(110));
    QVERIFY(read);
    QCOMPARE(read->first, at(101)); // a second after the last one came: the pace of the list is not known yet
    QCOMPARE(read->second.param_index, std::int16_t(1));
    const auto again = h.nextSent<mavlink::ParamRequestRead>(at(110)); // the last ones are asked for twice
    QVERIFY(again && again->first == read->first && again->second.param_index == 1);
    h.feed(value("B", 2, 1, 3));
    QVERIFY(!h.nextSent<mavlink::ParamRequestRead>(at(150)));
    const auto all = h.vehicle.parameters();
    QCOMPARE(all->size(), std::size_t(3));
    QCOMPARE((*all)[1].name, std::string("B"));
    QCOMPARE((*all)[1].value, 2.);
}

void ParameterTest::silentVehicleIsGivenUp()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.runUntil(at(150));
    QCOMPARE(h.sentOf<mavlink::ParamRequestList>().size(), std::size_t(10));
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason.text(), std::string("the vehicle does not send its parameters"));
    QVERIFY(!h.poll<ParameterResult>());
}

void ParameterTest::writeIsReadBackAndRepeated()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"WPNAV_SPEED", 750});
    for (int attempt = 0; attempt < 3; ++attempt) {
        const auto sent = h.nextSent<mavlink::ParamSet>(at(110));
        QVERIFY(sent);
        QCOMPARE(sent->first, at(100 + attempt * 0.5)); // the round trip is not known yet
        QCOMPARE(mavlink::textOf(sent->second.param_id), std::string_view("WPNAV_SPEED"));
    }
    h.feed(value("WPNAV_SPEED", 750, 65535, 900));
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(result->parameter.value, 750.);

    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"NOBODY", 1});
    h.runUntil(at(120));
    const auto silent = h.poll<ParameterResult>();
    QVERIFY(silent && !silent->ok && silent->reason.text().starts_with("no answer to "));
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"A_NAME_THAT_IS_TOO_LONG", 1});
    QVERIFY(!h.poll<ParameterResult>()->ok);
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"A", std::numeric_limits<double>::quiet_NaN()});
    QVERIFY(!h.poll<ParameterResult>()->ok);
}

void ParameterTest::singleParameterIsReadByName()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameter{"RTL_ALT"});
    h.vehicle.perform(h.now, RequestId{2}, ReadParameter{"NOBODY"});
    const auto asked = h.sentOf<mavlink::ParamRequestRead>();
    QCOMPARE(asked.size(), std::size_t(1)); // one after the other
    QCOMPARE(asked[0].param_index, std::int16_t(-1));
    QCOMPARE(mavlink::textOf(asked[0].param_id), std::string_view("RTL_ALT"));
    h.feed(value("OTHER", 1, 4, 900));
    QVERIFY(!h.poll<ParameterResult>());
    h.feed(value("RTL_ALT", 1500, 5, 900));
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && result->ok && result->action == ParameterAction::Read);
    QCOMPARE(result->parameter.value, 1500.);
    h.runUntil(at(120));
    const auto missing = h.poll<ParameterResult>();
    QVERIFY(missing && !missing->ok && missing->id == RequestId{2} && !missing->changeUnanswered);
    QVERIFY(missing->reason.text().starts_with("no answer to "));
}

void ParameterTest::singleParametersFollowTheRoundTrip()
{
    Harness h = Harness::copter();
    for (int i = 0; i < 10; ++i) {
        h.vehicle.perform(h.now, RequestId{1}, ReadParameter{"A"});
        h.now += std::chrono::milliseconds(40);
        h.feed(value("A", 1, 0, 900));
        QVERIFY(h.poll<ParameterResult>()->ok);
    }
    h.sent();
    const TimePoint begin = h.now;
    h.vehicle.perform(h.now, RequestId{2}, WriteParameter{"A", 2});
    QCOMPARE(h.nextSent<mavlink::ParamSet>(at(200))->first, begin);
    const auto again = h.nextSent<mavlink::ParamSet>(at(200));
    QVERIFY(again && again->first < begin + std::chrono::milliseconds(80));
    h.runUntil(begin + ParameterClient::kExchangeGiveUp - std::chrono::milliseconds(1));
    QVERIFY(!h.poll<ParameterResult>()); // a short outage is no failure
    h.runUntil(begin + ParameterClient::kExchangeGiveUp + RttEstimator::kMostTimeout);
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && !result->ok && result->changeUnanswered);
}

/// A hundred writes, one after the other, over 25 ms each way.
void ParameterTest::lossCostsSingleParametersLittleTime()
{
    const auto timeToWrite = [](double loss, unsigned seed) {
        Harness h = Harness::copter();
        ParameterPeer peer(100);
        LossyLink link(h, peer, loss, seed, std::chrono::milliseconds(25));
        const TimePoint begin = h.now;
        for (std::size_t i = 0; i < 100; ++i)
            h.vehicle.perform(h.now, RequestId{1}, WriteParameter{nameOf(i), 7});
        int written = 0;
        const auto done = [&] {
            while (const auto result = h.poll<ParameterResult>())
                written += result->ok;
            return written == 100;
        };
        return link.run(std::chrono::seconds(600), done) ? seconds(h.now - begin) : 600.;
    };
    const double clean = timeToWrite(0, 1);
    verifyCostOfLoss(timeToWrite, clean);
}

void ParameterTest::vehicleMayKeepItsOwnValue()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"RTL_ALT", 1.5});
    h.feed(value("RTL_ALT", 1000, 5, 900)); // perhaps from before the writing
    QVERIFY(!h.poll<ParameterResult>());
    for (int i = 1; i <= 10; ++i) {
        h.runUntil(at(100 + i));
        h.feed(value("RTL_ALT", 1000, 65535, 900));
    }
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason.text(), std::string("the vehicle keeps 1000"));
    QCOMPARE(result->parameter.value, 1000.);
}

void ParameterTest::writesTakeTurns()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"A", 1});
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"B", 0.1});
    QCOMPARE(h.sentOf<mavlink::ParamSet>().size(), std::size_t(1));
    h.feed(value("A", 1, 0, 2));
    QCOMPARE(h.sentOf<mavlink::ParamSet>().size(), std::size_t(1));
    h.feed(value("B", 0.1f, 1, 2)); // as exact as a float is
    QVERIFY(h.poll<ParameterResult>()->ok && h.poll<ParameterResult>()->ok);
}

void ParameterTest::bytewiseIntegers()
{
    Harness h;
    h.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    h.feed(value("COM_LIMIT", std::bit_cast<float>(std::int32_t{-7}), 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    QCOMPARE(h.vehicle.parameters()->front().value, -7.);
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"COM_LIMIT", 42});
    const auto sent = h.sentOf<mavlink::ParamSet>();
    QCOMPARE(std::bit_cast<std::int32_t>(sent.at(0).param_value), 42);
    QCOMPARE(int(sent.at(0).param_type), int(mavlink::MAV_PARAM_TYPE_INT32));
}

void ParameterTest::hashOfAllValuesIsNoParameter()
{
    Harness h;
    h.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    h.feed(value("_HASH_CHECK", std::bit_cast<float>(0x12345678u), 65535, 1, mavlink::MAV_PARAM_TYPE_UINT32));
    h.feed(value("COM_LIMIT", std::bit_cast<float>(std::int32_t{3}), 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    QCOMPARE(h.vehicle.parameters()->size(), std::size_t(1));
    QCOMPARE(h.vehicle.parameters()->front().name, std::string("COM_LIMIT"));
}

void ParameterTest::typeIsReadBeforeABytewiseWrite()
{
    Harness h;
    h.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"COM_LIMIT", 42});
    QCOMPARE(h.sentOf<mavlink::ParamSet>().size(), std::size_t(0));
    h.feed(value("COM_LIMIT", std::bit_cast<float>(std::int32_t{3}), 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    const auto sent = h.sentOf<mavlink::ParamSet>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(std::bit_cast<std::int32_t>(sent[0].param_value), 42);
    QCOMPARE(int(sent[0].param_type), int(mavlink::MAV_PARAM_TYPE_INT32));
    h.feed(value("COM_LIMIT", std::bit_cast<float>(std::int32_t{42}), 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    QVERIFY(h.poll<ParameterResult>()->ok);
}

void ParameterTest::unchangedListIsShared()
{
    Harness h = Harness::copter();
    h.feed(value("A", 1, 0, 1));
    const auto first = h.vehicle.parameters();
    h.feed(value("A", 1, 0, 1));
    QCOMPARE(h.vehicle.parameters().get(), first.get());
    h.runUntil(h.now + ParameterStore::kCollectFor);
    h.feed(value("A", 2, 65535, 1));
    QVERIFY(h.vehicle.parameters().get() != first.get());
    QCOMPARE(first->front().value, 1.); // who holds it may go on reading
    QCOMPARE(h.vehicle.parameters()->front().index, std::uint16_t(0));
}

void ParameterTest::namesWithoutEndAreNotKept_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("most");
    QTest::newRow("of a vehicle with ten") << 3 << 10 << 10 + static_cast<int>(ParameterStore::kNamesBeyondCount);
    QTest::newRow("of a vehicle that announces none") << 65535 << 0 << static_cast<int>(ParameterStore::kNamesBeyondCount);
    QTest::newRow("of a vehicle that announces all") << 3 << 65535 << static_cast<int>(ParameterStore::kMostNames);
}

void ParameterTest::namesWithoutEndAreNotKept()
{
    QFETCH(int, index);
    QFETCH(int, count);
    QFETCH(int, most);
    Harness h = Harness::copter();
    for (std::size_t i = 0; i < 20'000; ++i)
        h.feed(value(nameOf(i), 1, static_cast<std::uint16_t>(index), static_cast<std::uint16_t>(count)));
    h.runUntil(h.now + ParameterStore::kCollectFor);
    QCOMPARE(h.vehicle.parameters()->size(), static_cast<std::size_t>(most));
}

void ParameterTest::unsolicitedValuesAreCollected()
{
    // A thousand changes in ten seconds; the list is asked for after each, as the snapshots do.
    Harness h = Harness::copter();
    std::set<const void *> lists;
    std::vector<std::shared_ptr<const std::vector<Parameter>>> kept;
    const TimePoint start = h.now;
    for (int i = 0; i < 1000; ++i) {
        h.feed(value("A", static_cast<float>(i), 0, 1));
        kept.push_back(h.vehicle.parameters());
        lists.insert(kept.back().get());
        h.runUntil(start + std::chrono::milliseconds(10) * (i + 1));
    }
    QVERIFY2(lists.size() <= 21, std::to_string(lists.size()).c_str());
    h.runUntil(h.now + ParameterStore::kCollectFor);
    QCOMPARE(h.vehicle.parameters()->front().value, 999.); // the last one is shown as well
    // The answer to a write is shown at once.
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"A", 5});
    h.feed(value("A", 4, 0, 1));
    h.feed(value("A", 5, 0, 1));
    QCOMPARE(h.vehicle.parameters()->front().value, 5.);
}

void ParameterTest::wholeListThroughABadRadio_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 5; ++seed) {
        for (const double loss : {0.0, 0.05, 0.2})
            QTest::addRow("loss %.2f, seed %d", loss, seed) << loss << seed;
    }
}

void ParameterTest::wholeListThroughABadRadio()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    Harness h = Harness::copter();
    ParameterPeer peer(600);
    LossyLink link(h, peer, loss, static_cast<unsigned>(seed));
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    const auto complete = [&] { return h.vehicle.parameters() && h.vehicle.parameters()->size() == 600; };
    QVERIFY(link.run(std::chrono::seconds(60), complete));
    for (const Parameter &parameter : *h.vehicle.parameters())
        QCOMPARE(parameter.value, parameter.index * 0.5);
    QCOMPARE(link.dropped() > 0, loss > 0);
    const auto read = h.poll<ParameterResult>();
    QVERIFY(read && read->ok && read->action == ParameterAction::ReadList);
    QCOMPARE(read->all->size(), std::size_t(600));

    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{nameOf(17), 99});
    std::optional<ParameterResult> result;
    QVERIFY(link.run(std::chrono::seconds(60), [&] { return (result = h.poll<ParameterResult>()).has_value(); }));
    QVERIFY2(result->ok, result->reason.text().c_str());
    QCOMPARE(peer.at(17), 99.f);
}

namespace {

/// Seconds until the whole list of 915 parameters is there, as long as ArduCopter's, over 25 ms each way. ArduCopter in SITL
/// sends 1,830 a second.
double timeToRead(double loss, unsigned seed)
{
    Harness h = Harness::copter();
    PacedPeer peer(915, std::chrono::microseconds(546));
    LossyLink link(h, peer, loss, seed, std::chrono::milliseconds(25));
    const TimePoint begin = h.now;
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    const auto complete = [&] { return h.vehicle.parameters() && h.vehicle.parameters()->size() == 915; };
    return link.run(std::chrono::seconds(60), complete) ? seconds(h.now - begin) : 60;
}

} // namespace

void ParameterTest::gapsAreAskedForWhileTheListComes()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.sent();
    for (std::uint16_t i = 0; i <= 2 + ParameterClient::kReordered; ++i) {
        h.now += std::chrono::milliseconds(1);
        if (i != 2)
            h.feed(value(nameOf(i), 1, i, 500));
    }
    const auto requests = h.sentOf<mavlink::ParamRequestRead>();
    QCOMPARE(requests.size(), std::size_t(1));
    QCOMPARE(requests[0].param_index, std::int16_t(2));
}

void ParameterTest::overtakenValuesAreNotAskedFor()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.sent();
    for (std::uint16_t i = 0; i < 100; i = static_cast<std::uint16_t>(i + 5)) {
        for (const std::uint16_t k : {3, 0, 4, 1, 2}) {
            h.now += std::chrono::milliseconds(1);
            h.feed(value(nameOf(i + k), 1, static_cast<std::uint16_t>(i + k), 100));
        }
    }
    QVERIFY(h.sentOf<mavlink::ParamRequestRead>().empty());
    h.runUntil(h.now + std::chrono::seconds(30));
    QVERIFY(h.sentOf<mavlink::ParamRequestRead>().empty());
    QVERIFY(h.poll<ParameterResult>()->ok && !h.poll<ParameterResult>());
}

void ParameterTest::slowListIsNotAskedForTwice()
{
    Harness h = Harness::copter();
    PacedPeer peer(300, std::chrono::milliseconds(100)); // a radio with little room
    LossyLink link(h, peer, 0, 1);
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    QVERIFY(
        link.run(std::chrono::seconds(60), [&] { return h.vehicle.parameters() && h.vehicle.parameters()->size() == 300; }));
    QVERIFY2(peer.reads() < 20, std::to_string(peer.reads()).c_str());
}

void ParameterTest::deadLinkIsNotFlooded()
{
    // Half of the list came at 1,000 a second over a quick link, of which every tenth was lost; then the link is down.
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.sent();
    std::vector<std::uint16_t> asked;
    for (std::uint16_t i = 0; i < 450; ++i) {
        h.now += std::chrono::milliseconds(1);
        if (i % 10 != 0)
            h.feed(value(nameOf(i), 1, i, 900));
        for (const auto &request : h.sentOf<mavlink::ParamRequestRead>())
            asked.push_back(static_cast<std::uint16_t>(request.param_index));
        if (i % 20 == 19 && !asked.empty()) { // answered after some milliseconds
            h.feed(value(nameOf(asked.back()), 1, asked.back(), 900));
            asked.clear();
        }
    }
    std::size_t requests = 0;
    const TimePoint down = h.now;
    while (!h.poll<ParameterResult>() && h.now < down + std::chrono::seconds(20)) {
        h.runUntil(h.now + std::chrono::milliseconds(10));
        requests += h.sentOf<mavlink::ParamRequestRead>().size();
    }
    QVERIFY(seconds(h.now - down) < 11);
    QVERIFY2(requests < 1500, std::to_string(requests).c_str()); // 150 a second on average, most of them at the beginning
}

void ParameterTest::lossCostsLittleTime()
{
    const double clean = timeToRead(0, 1);
    QVERIFY2(clean < 0.6, std::to_string(clean).c_str());
    verifyCostOfLoss(timeToRead, clean);
}

SKYSEAL_TEST_APPLESS(ParameterTest)
#include "parameter_test.moc"
