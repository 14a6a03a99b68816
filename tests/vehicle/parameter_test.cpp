// Parameters against a scripted autopilot, first by hand with exact times, then through a radio that drops.
#include "parameter_peer.h"
#include "core/vehicle/parameter_client.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

#include <cmath>
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
    void integersAreExact_data();
    void integersAreExact();
    void floatsThatCannotHoldTheIntegerAreRefused();
    void valuesThatDoNotFitAreRefused();
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
    void componentsHaveParametersOfTheirOwn();
    void listsOfAllComponentsAreRead_data();
    void listsOfAllComponentsAreRead();
    void otherComponentsDoNotFailTheRead();
    void componentThatSendsBytesIsReadSo();
    void satelliteModemCarriesOneRequest();
    void errorEndsTheRequest_data();
    void errorEndsTheRequest();
    void foreignErrorsEndNothing_data();
    void foreignErrorsEndNothing();
    void refusedIndexEndsTheList();
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

void ParameterTest::integersAreExact_data()
{
    QTest::addColumn<double>("present");
    QTest::addColumn<double>("wanted");
    QTest::addColumn<int>("type");
    const int signedType = mavlink::MAV_PARAM_TYPE_INT32, unsignedType = mavlink::MAV_PARAM_TYPE_UINT32;
    QTest::newRow("above 2^24") << 16777216. << 16777217. << signedType;
    QTest::newRow("the neighbour of a device") << 60180513. << 60180512. << signedType;
    QTest::newRow("-1, the bytes of a NaN") << 0. << -1. << signedType;
    QTest::newRow("the least") << -2147483647. << -2147483648. << signedType;
    QTest::newRow("the greatest") << 2147483646. << 2147483647. << signedType;
    QTest::newRow("the greatest without a sign") << 4294967294. << 4294967295. << unsignedType;
    QTest::newRow("the bytes of an infinity") << 1. << double(0x7f800000) << unsignedType;
}

/// A PX4 whose value is another one, which as a float is the same: it is written, and the vehicle's word is compared exactly.
void ParameterTest::integersAreExact()
{
    QFETCH(double, present);
    QFETCH(double, wanted);
    QFETCH(int, type);
    const auto report = [&](Harness &h, double number) {
        const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(number));
        h.feed(value("CAL_MAG0_ID", std::bit_cast<float>(bits), 0, 1, static_cast<std::uint8_t>(type)));
    };
    for (const bool isKnown : {false, true}) {
        Harness h = Harness::px4();
        if (isKnown)
            report(h, present);
        h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"CAL_MAG0_ID", wanted});
        if (!isKnown)
            report(h, present);
        const auto sent = h.sentOf<mavlink::ParamSet>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(std::bit_cast<std::uint32_t>(sent[0].param_value),
                 static_cast<std::uint32_t>(static_cast<std::int64_t>(wanted)));
        QCOMPARE(int(sent[0].param_type), type);
        report(h, present);
        QVERIFY(!h.poll<ParameterResult>());
        report(h, wanted);
        const auto result = h.poll<ParameterResult>();
        QVERIFY(result && result->ok);
        QCOMPARE(result->parameter.value, wanted);
        QCOMPARE(h.vehicle.parameters()->front().value, wanted);
    }
}

/// ArduPilot rounds silently what a float cannot hold.
void ParameterTest::floatsThatCannotHoldTheIntegerAreRefused()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"OSD_OPTIONS", 1073741825});
    QVERIFY(h.sentOf<mavlink::ParamSet>().empty());
    h.feed(value("OSD_OPTIONS", 3, 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    QVERIFY(h.sentOf<mavlink::ParamSet>().empty());
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason.text(),
             std::string("this vehicle takes whole numbers as floats, which cannot hold 1073741825; the "
                         "nearest is 1073741824"));
    h.vehicle.perform(h.now, RequestId{2}, WriteParameter{"OSD_OPTIONS", 1073741824});
    QCOMPARE(h.sentOf<mavlink::ParamSet>().at(0).param_value, 1073741824.f);
}

void ParameterTest::valuesThatDoNotFitAreRefused()
{
    Harness h = Harness::px4();
    h.feed(value("COM_LIMIT", 0, 0, 1, mavlink::MAV_PARAM_TYPE_INT32));
    h.sent();
    const auto refusal = [&h](double number) {
        h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"COM_LIMIT", number});
        const auto result = h.poll<ParameterResult>();
        return result && !result->ok ? result->reason.text() : std::string();
    };
    QCOMPARE(refusal(2147483648), std::string("2147483648 does not fit the parameter, which takes -2147483648 to 2147483647"));
    QCOMPARE(refusal(1.5), std::string("1.5 does not fit the parameter, which takes whole numbers"));
    QVERIFY(h.sent().empty());
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
    std::optional<ParameterResult> read;
    QVERIFY(link.run(std::chrono::seconds(1), [&] { return (read = h.poll<ParameterResult>()).has_value(); }));
    QVERIFY(read->ok && read->action == ParameterAction::ReadList);
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
    for (std::uint16_t i = 0; i <= 2 + ParameterList::kReordered; ++i) {
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

namespace {

constexpr std::uint8_t kGimbal = 154, kCamera = 100;

/// A message of another component of the vehicle.
template<typename Message> void feedFrom(Harness &h, std::uint8_t component, const Message &message)
{
    Sender sender(1, component);
    h.vehicle.handleFrame(h.now, {}, sender.frame(message));
}

mavlink::Heartbeat gimbalHeartbeat()
{
    return heartbeat(0, false, mavlink::MAV_TYPE_GIMBAL, mavlink::MAV_AUTOPILOT_INVALID);
}

mavlink::ParamError error(std::string_view name, std::int16_t index, std::uint8_t code)
{
    mavlink::ParamError out;
    out.target_system = 255;
    out.target_component = mavlink::MAV_COMP_ID_MISSIONPLANNER;
    mavlink::setText(out.param_id, name);
    out.param_index = index;
    out.error = code;
    return out;
}

/// The label and the value of each parameter.
std::string words(const std::vector<Parameter> &parameters)
{
    std::string out;
    for (const Parameter &parameter : parameters)
        out += parameterLabel(parameter) + "=" + std::to_string(std::lround(parameter.value)) + " ";
    return out;
}

} // namespace

/// The same name on two components: each value is that of its own.
void ParameterTest::componentsHaveParametersOfTheirOwn()
{
    Harness h = Harness::copter();
    h.feed(value("RTL_ALT", 1500, 0, 1));
    feedFrom(h, kGimbal, value("RTL_ALT", 3, 0, 1));
    h.runUntil(h.now + ParameterStore::kCollectFor);
    QCOMPARE(words(*h.vehicle.parameters()), std::string("RTL_ALT=1500 154:RTL_ALT=3 "));
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"RTL_ALT", 4, kGimbal});
    const auto sent = h.sentOf<mavlink::ParamSet>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].target_component, kGimbal);
    h.feed(value("RTL_ALT", 4, 65535, 1)); // the autopilot's does not answer it
    QVERIFY(!h.poll<ParameterResult>());
    feedFrom(h, kGimbal, value("RTL_ALT", 4, 65535, 1));
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(result->parameter.componentId, kGimbal);

    h.vehicle.perform(h.now, RequestId{2}, ReadParameter{"RTL_ALT", 1}); // by its number
    QCOMPARE(h.sentOf<mavlink::ParamRequestRead>().at(0).target_component, std::uint8_t(1));
    feedFrom(h, kGimbal, value("RTL_ALT", 5, 65535, 1));
    QVERIFY(!h.poll<ParameterResult>());
    h.feed(value("RTL_ALT", 1500, 0, 1));
    QCOMPARE(h.poll<ParameterResult>()->parameter.componentId, std::uint8_t(0));

    // A component whose encoding is not known is asked for the type first.
    h.vehicle.perform(h.now, RequestId{3}, WriteParameter{"CAM_MODE", 1, kCamera});
    QVERIFY(h.sentOf<mavlink::ParamSet>().empty());
}

void ParameterTest::listsOfAllComponentsAreRead_data()
{
    QTest::addColumn<bool>("hasHeartbeat");
    QTest::newRow("known by its heartbeat") << true;
    QTest::newRow("silent until asked") << false;
}

/// Indexes and counts are those of each component; what is lost of either is asked for there.
void ParameterTest::listsOfAllComponentsAreRead()
{
    QFETCH(bool, hasHeartbeat);
    Harness h = Harness::px4();
    if (hasHeartbeat)
        feedFrom(h, kGimbal, gimbalHeartbeat());
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    const auto asked = h.sentOf<mavlink::ParamRequestList>();
    QCOMPARE(asked.size(), std::size_t(1));
    QCOMPARE(asked[0].target_component, std::uint8_t(mavlink::MAV_COMP_ID_ALL));
    h.feed(value("A", 1, 0, 2));
    h.feed(value("B", 2, 1, 2));
    feedFrom(h, kGimbal, value("A", 3, 0, 3));
    feedFrom(h, kGimbal, value("C", 5, 2, 3));
    const auto lost = h.nextSent<mavlink::ParamRequestRead>(at(110));
    QVERIFY(lost);
    QCOMPARE(lost->second.target_component, kGimbal);
    QCOMPARE(lost->second.param_index, std::int16_t(1));
    QVERIFY(!h.poll<ParameterResult>());
    feedFrom(h, kGimbal, value("B", 4, 1, 3));
    h.runUntil(h.now + ParameterClient::kSettle);
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && result->ok && result->reason.empty());
    QCOMPARE(words(*result->all), std::string("A=1 B=2 154:A=3 154:B=4 154:C=5 "));
    QCOMPARE(h.vehicle.parametersExpected(), 5u);
}

void ParameterTest::otherComponentsDoNotFailTheRead()
{
    Harness h = Harness::px4();
    feedFrom(h, kGimbal, gimbalHeartbeat());
    feedFrom(h, kCamera, heartbeat(0, false, mavlink::MAV_TYPE_CAMERA, mavlink::MAV_AUTOPILOT_INVALID)); // has none
    const TimePoint begin = h.now;
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.feed(value("A", 1, 0, 1));
    feedFrom(h, kGimbal, value("G", 1, 0, 4)); // counts those of the whole vehicle
    std::optional<ParameterResult> result;
    while (!result && h.now < begin + std::chrono::seconds(20)) {
        h.runUntil(h.now + std::chrono::milliseconds(10));
        result = h.poll<ParameterResult>();
    }
    QVERIFY(result && result->ok);
    QVERIFY(h.now < begin + std::chrono::seconds(4));
    QCOMPARE(words(*result->all), std::string("A=1 154:G=1 "));
    QCOMPARE(result->reason.text(), std::string("of component 154 only 1 of 4 parameters came"));
}

/// The bytes of a small integer are no whole number as a float.
void ParameterTest::componentThatSendsBytesIsReadSo()
{
    Harness h = Harness::copter();
    feedFrom(h, kGimbal, value("MODE", 2, 0, 2, mavlink::MAV_PARAM_TYPE_INT32)); // as the autopilot would
    QCOMPARE(h.vehicle.parameters()->front().value, 2.);
    const auto bytes = [](std::int32_t number) { return std::bit_cast<float>(number); };
    feedFrom(h, kCamera, value("ID", bytes(60180513), 0, 2, mavlink::MAV_PARAM_TYPE_INT32));
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"ID", 60180512, kCamera});
    QCOMPARE(std::bit_cast<std::int32_t>(h.sentOf<mavlink::ParamSet>().at(0).param_value), 60180512);
    feedFrom(h, kCamera, value("ID", bytes(60180512), 0, 2, mavlink::MAV_PARAM_TYPE_INT32));
    QCOMPARE(h.poll<ParameterResult>()->parameter.value, 60180512.);
    h.feed(value("ID", bytes(5), 0, 2, mavlink::MAV_PARAM_TYPE_INT32)); // the autopilot is known
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"ID", 7});
    QCOMPARE(h.sentOf<mavlink::ParamSet>().at(0).param_value, 7.f);
}

void ParameterTest::satelliteModemCarriesOneRequest()
{
    Harness h = Harness::px4();
    h.feed(mavlink::HighLatency2{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_PX4});
    feedFrom(h, kGimbal, gimbalHeartbeat());
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    const auto asked = h.sentOf<mavlink::ParamRequestList>();
    QCOMPARE(asked.size(), std::size_t(1));
    QCOMPARE(asked[0].target_component, std::uint8_t(1));
}

void ParameterTest::errorEndsTheRequest_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("reason");
    QTest::newRow("does not exist") << 1 << QStringLiteral("the vehicle has no such parameter");
    QTest::newRow("out of range") << 2 << QStringLiteral("the vehicle refuses the value: it is out of range");
    QTest::newRow("permission") << 3 << QStringLiteral("the vehicle denies the permission");
    QTest::newRow("read-only") << 5 << QStringLiteral("the parameter is read-only");
    QTest::newRow("type unsupported") << 6 << QStringLiteral("the vehicle does not support the type of the parameter");
    QTest::newRow("type mismatch") << 7 << QStringLiteral("the vehicle has the parameter with another type");
    QTest::newRow("read fails") << 8 << QStringLiteral("the vehicle cannot read the parameter");
    QTest::newRow("of a later standard") << 200 << QStringLiteral("the vehicle refuses it with error 200");
}

void ParameterTest::errorEndsTheRequest()
{
    QFETCH(int, code);
    QFETCH(QString, reason);
    for (const bool isWrite : {true, false}) {
        for (const std::uint8_t component : {std::uint8_t(1), kGimbal}) {
            Harness h = Harness::copter();
            if (isWrite)
                h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"STAT_BOOTCNT", 1, component});
            else
                h.vehicle.perform(h.now, RequestId{1}, ReadParameter{"STAT_BOOTCNT", component});
            h.vehicle.perform(h.now, RequestId{2}, ReadParameter{"NEXT"});
            h.sent();
            feedFrom(h, component, error("STAT_BOOTCNT", -1, static_cast<std::uint8_t>(code)));
            const auto result = h.poll<ParameterResult>();
            QVERIFY(result && !result->ok && result->id == RequestId{1});
            QVERIFY(!result->changeUnanswered); // it is answered
            QCOMPARE(QString::fromStdString(result->reason.text()), reason);
            const auto next = h.sentOf<mavlink::ParamRequestRead>();
            QCOMPARE(next.size(), std::size_t(1));
            QCOMPARE(mavlink::textOf(next[0].param_id), std::string_view("NEXT"));
        }
    }
    Harness h = Harness::copter(); // the autopilot speaks for a component that is not there
    h.vehicle.perform(h.now, RequestId{1}, ReadParameter{"PAN", kGimbal});
    h.feed(error("PAN", -1, mavlink::MAV_PARAM_ERROR_COMPONENT_NOT_FOUND));
    QCOMPARE(h.poll<ParameterResult>()->reason.text(), std::string("the vehicle has no such component"));
}

void ParameterTest::foreignErrorsEndNothing_data()
{
    QTest::addColumn<int>("sender");
    QTest::addColumn<int>("target");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("code");
    const QString asked = QStringLiteral("RTL_ALT");
    QTest::newRow("another component") << 154 << 255 << asked << -1 << 2;
    QTest::newRow("to another station") << 1 << 254 << asked << -1 << 2;
    QTest::newRow("another name") << 1 << 255 << QStringLiteral("RTL_ALT2") << -1 << 2;
    QTest::newRow("no name") << 1 << 255 << QString() << -1 << 2;
    QTest::newRow("an index that was not asked for") << 1 << 255 << asked << 3 << 2;
    QTest::newRow("no error") << 1 << 255 << asked << -1 << 0;
}

void ParameterTest::foreignErrorsEndNothing()
{
    QFETCH(int, sender);
    QFETCH(int, target);
    QFETCH(QString, name);
    QFETCH(int, index);
    QFETCH(int, code);
    Harness h = Harness::copter();
    mavlink::ParamError foreign = error(name.toStdString(), static_cast<std::int16_t>(index), static_cast<std::uint8_t>(code));
    foreign.target_system = static_cast<std::uint8_t>(target);
    feedFrom(h, static_cast<std::uint8_t>(sender), foreign); // nothing is asked at all
    h.vehicle.perform(h.now, RequestId{1}, WriteParameter{"RTL_ALT", 5});
    feedFrom(h, static_cast<std::uint8_t>(sender), foreign);
    QVERIFY(!h.poll<ParameterResult>());
    h.feed(value("RTL_ALT", 5, 0, 9));
    QVERIFY(h.poll<ParameterResult>()->ok);

    h.vehicle.perform(h.now, RequestId{2}, ReadParameters{});
    h.feed(value("A", 1, 0, 2));
    feedFrom(h, static_cast<std::uint8_t>(sender), foreign);
    h.feed(value("B", 1, 1, 2));
    h.runUntil(h.now + ParameterClient::kSettle);
    QVERIFY(h.poll<ParameterResult>()->ok);
}

/// Parameters may vanish while the list is read: the rest comes, and the read ends as soon as nothing is left to ask for.
void ParameterTest::refusedIndexEndsTheList()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    h.feed(value("A", 1, 0, 3));
    h.feed(error("", 1, mavlink::MAV_PARAM_ERROR_DOES_NOT_EXIST)); // not asked for
    h.feed(value("C", 3, 2, 3));
    QVERIFY(h.nextSent<mavlink::ParamRequestRead>(at(110)));
    QVERIFY(!h.poll<ParameterResult>());
    h.feed(error("", 1, mavlink::MAV_PARAM_ERROR_DOES_NOT_EXIST));
    const auto result = h.poll<ParameterResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason.text(), std::string("only 2 of 3 parameters came: the vehicle has no such parameter"));
    QCOMPARE(h.vehicle.parameters()->size(), std::size_t(2)); // nothing that came is lost
}

SKYSEAL_TEST_APPLESS(ParameterTest)
#include "parameter_test.moc"
