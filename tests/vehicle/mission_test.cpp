// Missions against a scripted autopilot, by hand and through a radio that drops.
#include "core/vehicle/mission_client.h"
#include "lossy_link.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class MissionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void uploadAnswersAsItIsAsked();
    void oldFirmwareGetsFloatsUnlessItTakesIntegers();
    void refusalsAreWorded();
    void uploadStopsWhenNobodyAsks();
    void lostAcknowledgementBeginsAnew();
    void downloadAsksUntilItHasAll();
    void arduPilotIsAskedForSeveralAtATime();
    void downloadThatTheVehicleEndedBeginsAnew();
    void refusedRepetitionStandsForALostRequest();
    void requestThatCrossedItsItemIsNotAnswered();
    void fenceAndRallyPointsAreListsOfTheirOwn();
    void firmwareWithoutIntegersIsAskedForFloats();
    void oneTransferAtATime();
    void otherKindsOfPlansAreNotOurs();
    void uploadAndDownloadThroughABadRadio_data();
    void uploadAndDownloadThroughABadRadio();
    void lossCostsLittleTime_data();
    void lossCostsLittleTime();
};

namespace {

std::vector<MissionItem> plan(std::size_t count)
{
    std::vector<MissionItem> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i].sequence = static_cast<std::uint16_t>(i);
        out[i].latitude = 48 + static_cast<double>(i) * 1e-4;
        out[i].longitude = 11 - static_cast<double>(i) * 1e-4;
        out[i].altitude = 10.f + static_cast<float>(i);
        out[i].parameters[0] = static_cast<float>(i % 7);
    }
    return out;
}

template<typename Message> Message toUs(std::uint16_t sequence = 0)
{
    Message out;
    out.target_system = 255;
    out.target_component = 190;
    if constexpr (requires { out.seq; })
        out.seq = sequence;
    if constexpr (requires { out.count; })
        out.count = sequence;
    return out;
}

Harness px4()
{
    VehicleConfig config;
    config.streams = StreamProfile::Quiet;
    Harness out(config);
    out.feed(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4));
    out.feed(mavlink::AutopilotVersion{});
    out.sent();
    return out;
}

mavlink::MissionAck acknowledgement(std::uint8_t result)
{
    auto out = toUs<mavlink::MissionAck>();
    out.type = result;
    return out;
}

/// An autopilot's side of the protocol, with its own slow repetition of requests.
class MissionPeer : public ScriptedPeer
{
public:
    explicit MissionPeer(bool isPx4 = false) : m_isPx4(isPx4) {}

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        if (const auto count = as<mavlink::MissionCount>(message)) {
            m_receiving.assign(count->count, {});
            m_next = 0;
            m_active = true;
            ask(now, out);
        }
        if (const auto item = as<mavlink::MissionItemInt>(message))
            take(now, *item, out);
        if (as<mavlink::MissionRequestList>(message)) {
            m_asked = 0;
            out.push_back(send(toUs<mavlink::MissionCount>(static_cast<std::uint16_t>(stored.size()))));
        }
        if (const auto request = as<mavlink::MissionRequestInt>(message))
            answer(request->seq, out);
        if (as<mavlink::MissionClearAll>(message)) {
            stored.clear();
            out.push_back(send(acknowledgement(0)));
        }
    }

    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override { ask(now, out); }
    TimePoint nextDeadline() const override { return m_active ? m_repeat : kNever; }

    std::vector<mavlink::MissionItemInt> stored;

private:
    void take(TimePoint now, const mavlink::MissionItemInt &item, std::vector<ToStation> &out)
    {
        if (m_active && item.seq == m_next) {
            m_receiving[m_next++] = item;
            ask(now, out);
        } else if (m_active && m_isPx4) {
            ask(now, out);
        } else if (m_active) {
            out.push_back(send(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE)));
        } else if (m_isPx4 && item.seq + std::size_t(1) == m_next) {
            out.push_back(send(acknowledgement(0)));
        } else if (!m_isPx4) {
            out.push_back(send(acknowledgement(mavlink::MAV_MISSION_ERROR)));
        }
    }

    void answer(std::uint16_t sequence, std::vector<ToStation> &out)
    {
        if (sequence >= stored.size())
            return;
        if (m_isPx4 && sequence != m_asked && sequence + 1 != m_asked)
            return out.push_back(send(acknowledgement(mavlink::MAV_MISSION_ERROR)));
        m_asked = sequence + 1;
        auto item = stored[sequence];
        item.target_system = 255;
        item.target_component = 190;
        out.push_back(send(item));
    }

    void ask(TimePoint now, std::vector<ToStation> &out)
    {
        m_repeat = now + std::chrono::seconds(1);
        if (m_next < m_receiving.size()) {
            out.push_back(send(toUs<mavlink::MissionRequestInt>(static_cast<std::uint16_t>(m_next))));
            return;
        }
        m_active = false;
        stored = m_receiving;
        out.push_back(send(acknowledgement(0))); // once: it may get lost
    }

    const bool m_isPx4;
    std::vector<mavlink::MissionItemInt> m_receiving;
    std::size_t m_next = 0;
    int m_asked = 0;
    bool m_active = false;
    TimePoint m_repeat = kNever;
};

/// Seconds of a transfer of 500 items over 25 ms each way.
double transferTime(bool isPx4, bool isUpload, double loss, unsigned seed)
{
    constexpr Duration kLimit = std::chrono::seconds(600);
    Harness h = isPx4 ? px4() : Harness::copter();
    MissionPeer peer(isPx4);
    peer.stored.resize(isUpload ? 0 : 500);
    for (std::size_t i = 0; i < peer.stored.size(); ++i) {
        peer.stored[i].seq = static_cast<std::uint16_t>(i);
        peer.stored[i].x = static_cast<std::int32_t>(i);
    }
    LossyLink link(h, peer, loss, seed, std::chrono::milliseconds(25));
    const TimePoint begin = h.now;
    if (isUpload)
        h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(500)});
    else
        h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    std::optional<MissionResult> result;
    if (!link.run(kLimit, [&] { return (result = h.poll<MissionResult>()).has_value(); }) || !result->ok)
        return seconds(kLimit);
    for (std::size_t i = 0; i < 500; ++i) {
        if (isUpload ? peer.stored[i].seq != i : std::llround(result->items->at(i).latitude * 1e7) != int(i))
            return seconds(kLimit);
    }
    return seconds(h.now - begin);
}

} // namespace

void MissionTest::uploadAnswersAsItIsAsked()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    QCOMPARE(h.sentOf<mavlink::MissionCount>().at(0).count, std::uint16_t(3));
    for (const std::uint16_t sequence : {0, 1, 1, 2}) { // asked twice for one: answered twice
        h.feed(toUs<mavlink::MissionRequestInt>(sequence));
        const auto item = h.sentOf<mavlink::MissionItemInt>();
        QCOMPARE(item.size(), std::size_t(1));
        QCOMPARE(item[0].seq, sequence);
        QCOMPARE(item[0].x, 480000000 + sequence * 1000);
        QCOMPARE(item[0].command, std::uint16_t(16));
    }
    h.feed(toUs<mavlink::MissionRequestInt>(9)); // there is none
    QVERIFY(h.sent().empty());
    QVERIFY(!h.vehicle.mission());
    h.feed(acknowledgement(0));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(*h.vehicle.mission(), plan(3));
}

void MissionTest::oldFirmwareGetsFloatsUnlessItTakesIntegers()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1)});
    h.feed(toUs<mavlink::MissionRequest>(0));
    const auto item = h.sentOf<mavlink::MissionItem>();
    QCOMPARE(item.size(), std::size_t(1));
    QCOMPARE(item[0].x, 48.f);
    mavlink::AutopilotVersion version;
    version.capabilities = 4; // MAV_PROTOCOL_CAPABILITY_MISSION_INT
    h.feed(version);
    h.feed(toUs<mavlink::MissionRequest>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1)); // a metre more exact
}

void MissionTest::refusalsAreWorded()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(2)});
    h.feed(acknowledgement(0)); // of something before: nothing was sent yet
    QVERIFY(!h.poll<MissionResult>());
    h.feed(acknowledgement(4));
    auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason, std::string("no space left on the vehicle"));
    auto bad = plan(2);
    bad[1].latitude = 95;
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{bad});
    QCOMPARE(h.poll<MissionResult>()->reason, std::string("item 1 is not on the globe"));
}

void MissionTest::uploadStopsWhenNobodyAsks()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(2)});
    h.runUntil(at(150));
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(8));
    QCOMPARE(h.poll<MissionResult>()->reason, std::string("no answer to 8 attempts"));
}

void MissionTest::lostAcknowledgementBeginsAnew()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1)});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.runUntil(at(103));
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.feed(acknowledgement(0));
    QVERIFY(h.poll<MissionResult>()->ok);
}

void MissionTest::downloadAsksUntilItHasAll()
{
    Harness h = px4();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.runUntil(at(100.5));
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionCount>(2));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(0));
    auto item = toUs<mavlink::MissionItemInt>(0);
    item.x = 481234567;
    h.feed(item);
    h.feed(item); // twice
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().size(), std::size_t(1));
    h.runUntil(at(101));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(1));
    item.seq = 1;
    h.feed(item);
    QCOMPARE(h.sentOf<mavlink::MissionAck>().at(0).type, std::uint8_t(0));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(2));
    QCOMPARE(result->items, h.vehicle.mission());
    QVERIFY(std::abs(h.vehicle.mission()->at(0).latitude - 48.1234567) < 1e-9);

    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(0)); // an empty one is a mission, too
    QVERIFY(h.poll<MissionResult>()->ok);
    QVERIFY(h.vehicle.mission()->empty());
}

void MissionTest::arduPilotIsAskedForSeveralAtATime()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(100));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().size(), RequestWindow::kFirst);
    h.feed(toUs<mavlink::MissionItemInt>(3)); // in any order
    h.feed(toUs<mavlink::MissionItemInt>(0));
    const auto state = h.vehicle.state(h.now);
    QCOMPARE(state.transfers.size(), std::size_t(1));
    QCOMPARE(state.transfers[0].done, std::uint64_t(2));
    QCOMPARE(state.transfers[0].total, std::uint64_t(100));
    h.feed(toUs<mavlink::MissionItemInt>(100)); // there is none
    h.runUntil(h.now + std::chrono::seconds(60));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok && !result->items);
    QCOMPARE(result->reason, std::string("the vehicle does not send item 1"));
    QVERIFY(h.vehicle.state(h.now).transfers.empty());
}

void MissionTest::downloadThatTheVehicleEndedBeginsAnew()
{
    Harness h = px4();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(2));
    h.feed(toUs<mavlink::MissionItemInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionCount>(1));
    h.feed(toUs<mavlink::MissionItemInt>(0));
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(1));
    h.vehicle.perform(h.now, RequestId{2}, ReadMission{});
    for (int i = 0; i < 10; ++i) {
        h.feed(toUs<mavlink::MissionCount>(2));
        h.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    }
    QCOMPARE(h.poll<MissionResult>()->reason, std::string("the vehicle reports an error"));
}

void MissionTest::refusedRepetitionStandsForALostRequest()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(10)});
    h.now += std::chrono::milliseconds(50);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE)); // of something before: nothing was repeated yet
    QVERIFY(h.sent().empty());
    const auto again = h.nextSent<mavlink::MissionItemInt>(at(110));
    QVERIFY(again && again->second.seq == 0);
    QVERIFY(again->first < h.now + std::chrono::milliseconds(200)); // from the round trip, not from the vehicle's timer
    for (std::uint16_t next = 1; next <= MissionClient::kInferred; ++next) {
        h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE));
        QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).seq, next);
        QCOMPARE(h.nextSent<mavlink::MissionItemInt>(at(120))->second.seq, next);
    }
    h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE)); // the rest is for the vehicle to say
    QVERIFY(h.sentOf<mavlink::MissionItemInt>().empty());
    h.feed(toUs<mavlink::MissionRequestInt>(2));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).seq, std::uint16_t(2));
}

void MissionTest::requestThatCrossedItsItemIsNotAnswered()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    h.now += std::chrono::milliseconds(50);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.now += std::chrono::milliseconds(10);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1));
    h.now += std::chrono::milliseconds(40);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1));
}

void MissionTest::fenceAndRallyPointsAreListsOfTheirOwn()
{
    for (const auto type : {MissionType::Fence, MissionType::Rally}) {
        const auto number = static_cast<std::uint8_t>(type);
        const auto typed = [number](auto message) {
            message.mission_type = number;
            return message;
        };
        Harness h = Harness::copter();
        h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1), type});
        QCOMPARE(h.sentOf<mavlink::MissionCount>().at(0).mission_type, number);
        h.feed(toUs<mavlink::MissionRequestInt>(0)); // for the flight plan
        QVERIFY(h.sent().empty());
        h.feed(typed(toUs<mavlink::MissionRequestInt>(0)));
        QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).mission_type, number);
        h.feed(typed(acknowledgement(0)));
        QVERIFY(h.poll<MissionResult>()->ok);
        h.vehicle.perform(h.now, RequestId{2}, ReadMission{type});
        QCOMPARE(h.sentOf<mavlink::MissionRequestList>().at(0).mission_type, number);
        h.feed(typed(toUs<mavlink::MissionCount>(1)));
        QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).mission_type, number);
        h.feed(typed(toUs<mavlink::MissionItemInt>(0)));
        QCOMPARE(h.sentOf<mavlink::MissionAck>().at(0).mission_type, number);
        const auto read = h.poll<MissionResult>();
        QVERIFY(read && read->ok && read->type == type);
        QCOMPARE(read->items->size(), std::size_t(1));
        h.vehicle.perform(h.now, RequestId{3}, ClearMission{type});
        QCOMPARE(h.sentOf<mavlink::MissionClearAll>().at(0).mission_type, number);
        h.feed(typed(acknowledgement(0)));
        QVERIFY(h.poll<MissionResult>()->ok);
        QVERIFY(!h.vehicle.mission()); // the flight plan is not concerned
    }
}

void MissionTest::firmwareWithoutIntegersIsAskedForFloats()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(1));
    const auto asked = h.nextSent<mavlink::MissionRequest>(at(110));
    QVERIFY(asked);
    auto item = toUs<mavlink::MissionItem>(0);
    item.x = 48.5f;
    h.feed(item);
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(h.vehicle.mission()->at(0).latitude, 48.5);
}

void MissionTest::oneTransferAtATime()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.vehicle.perform(h.now, RequestId{2}, ClearMission{});
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->id, RequestId{2});
    QCOMPARE(result->transfer, MissionTransfer::Clear);
    QCOMPARE(result->reason, std::string("another mission transfer is under way"));
}

void MissionTest::otherKindsOfPlansAreNotOurs()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.sent();
    auto fence = toUs<mavlink::MissionCount>(5);
    fence.mission_type = 1;
    h.feed(fence);
    auto others = toUs<mavlink::MissionCount>(5);
    others.target_system = 254;
    h.feed(others);
    QVERIFY(h.sent().empty());
}

void MissionTest::uploadAndDownloadThroughABadRadio_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 10; ++seed) {
        for (const double loss : {0.0, 0.05, 0.2})
            QTest::addRow("loss %.2f, seed %d", loss, seed) << loss << seed;
    }
}

void MissionTest::uploadAndDownloadThroughABadRadio()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    Harness h = Harness::copter();
    MissionPeer peer;
    LossyLink link(h, peer, loss, static_cast<unsigned>(seed));
    std::optional<MissionResult> result;
    const auto ended = [&] { return (result = h.poll<MissionResult>()).has_value(); };

    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(50)});
    QVERIFY(link.run(std::chrono::seconds(180), ended));
    QVERIFY2(result->ok, result->reason.c_str());
    QCOMPARE(peer.stored.size(), std::size_t(50));
    QCOMPARE(peer.stored[49].x, 480049000);

    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QVERIFY(link.run(std::chrono::seconds(180), ended));
    QVERIFY2(result->ok, result->reason.c_str());
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(50));
    for (std::size_t i = 0; i < 50; ++i)
        QVERIFY(std::abs(h.vehicle.mission()->at(i).latitude - plan(50)[i].latitude) < 1e-9);

    h.vehicle.perform(h.now, RequestId{1}, ClearMission{});
    QVERIFY(link.run(std::chrono::seconds(60), ended));
    QVERIFY(result->ok && peer.stored.empty() && h.vehicle.mission()->empty());
}

void MissionTest::lossCostsLittleTime_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<bool>("isUpload");
    QTest::addColumn<double>("most");
    QTest::newRow("download from ArduPilot") << false << false << 1.2;
    QTest::newRow("download from PX4, one at a time") << true << false << 26.;
    QTest::newRow("upload to ArduPilot") << false << true << 26.;
    QTest::newRow("upload to PX4") << true << true << 26.;
}

void MissionTest::lossCostsLittleTime()
{
    QFETCH(bool, isPx4);
    QFETCH(bool, isUpload);
    QFETCH(double, most);
    const double clean = transferTime(isPx4, isUpload, 0, 1);
    QVERIFY2(clean < most, std::to_string(clean).c_str());
    const std::pair<double, double> limits[] = {{0.1, 2}, {0.25, 3}};
    for (const auto &[loss, factor] : limits) {
        double sum = 0, longest = 0;
        constexpr unsigned kSeeds = 50;
        for (unsigned seed = 1; seed <= kSeeds; ++seed) {
            const double time = transferTime(isPx4, isUpload, loss, seed);
            sum += time;
            longest = std::max(longest, time);
        }
        const std::string said = "loss " + std::to_string(loss) + ": mean " + std::to_string(sum / kSeeds) + " s, longest "
            + std::to_string(longest) + " s, clean " + std::to_string(clean) + " s";
        qInfo("%s", said.c_str());
        QVERIFY2(sum / kSeeds <= factor * clean, said.c_str());
    }
}

SKYSEAL_TEST_APPLESS(MissionTest)
#include "mission_test.moc"
