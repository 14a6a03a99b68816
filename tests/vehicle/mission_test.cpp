// Missions against a scripted autopilot, by hand and through a radio that drops.
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
    void firmwareWithoutIntegersIsAskedForFloats();
    void oneTransferAtATime();
    void otherKindsOfPlansAreNotOurs();
    void uploadAndDownloadThroughABadRadio_data();
    void uploadAndDownloadThroughABadRadio();
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

mavlink::MissionAck acknowledgement(std::uint8_t result)
{
    auto out = toUs<mavlink::MissionAck>();
    out.type = result;
    return out;
}

/// An autopilot's side of the protocol, with its own repetition of requests.
class MissionPeer : public ScriptedPeer
{
public:
    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        if (const auto count = as<mavlink::MissionCount>(message)) {
            m_receiving.assign(count->count, {});
            m_next = 0;
            m_active = true;
            ask(now, out);
        }
        if (const auto item = as<mavlink::MissionItemInt>(message); item && m_active && item->seq == m_next) {
            m_receiving[m_next++] = *item;
            ask(now, out);
        }
        if (as<mavlink::MissionRequestList>(message))
            out.push_back(send(toUs<mavlink::MissionCount>(static_cast<std::uint16_t>(stored.size()))));
        if (const auto request = as<mavlink::MissionRequestInt>(message); request && request->seq < stored.size()) {
            auto item = stored[request->seq];
            item.target_system = 255;
            item.target_component = 190;
            out.push_back(send(item));
        }
        if (as<mavlink::MissionClearAll>(message)) {
            stored.clear();
            out.push_back(send(acknowledgement(0)));
        }
    }

    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override { ask(now, out); }
    TimePoint nextDeadline() const override { return m_active ? m_repeat : kNever; }

    std::vector<mavlink::MissionItemInt> stored;

private:
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

    std::vector<mavlink::MissionItemInt> m_receiving;
    std::size_t m_next = 0;
    bool m_active = false;
    TimePoint m_repeat = kNever;
};

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
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.runUntil(at(101.5));
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionCount>(2));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(0));
    auto item = toUs<mavlink::MissionItemInt>(0);
    item.x = 481234567;
    h.feed(item);
    h.feed(item); // twice
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().size(), std::size_t(1));
    h.runUntil(at(102));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(1));
    item.seq = 1;
    h.feed(item);
    QCOMPARE(h.sentOf<mavlink::MissionAck>().at(0).type, std::uint8_t(0));
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(2));
    QVERIFY(std::abs(h.vehicle.mission()->at(0).latitude - 48.1234567) < 1e-9);

    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(0)); // an empty one is a mission, too
    QVERIFY(h.poll<MissionResult>()->ok);
    QVERIFY(h.vehicle.mission()->empty());
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

SKYSEAL_TEST_APPLESS(MissionTest)
#include "mission_test.moc"
