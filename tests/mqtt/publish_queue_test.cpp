// The messages that wait for a slow or absent broker: bounded, and each one that is dropped is counted.
#include "core/mqtt/publish_queue.h"
#include "core/mqtt/topics.h"
#include "tests/support/test_runner.h"

#include <rapidcheck.h>

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::mqtt;

namespace {

std::string topicOf(std::optional<OutgoingMessage> message)
{
    return message ? message->topic : "none";
}

} // namespace

class PublishQueueTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newerStateReplacesAnOlderOne();
    void statesWaitInTurn();
    void oldestEventIsDropped();
    void framesOfAVehicleBecomeOneMessage();
    void staleFramesMakeRoomForNewOnes();
    void nothingIsLostUncounted();
};

void PublishQueueTest::newerStateReplacesAnOlderOne()
{
    PublishQueue queue;
    queue.putState("a", "1");
    queue.putState("a", "2");
    const auto state = queue.takeOther();
    QVERIFY(state && state->payload == "2" && state->kind == Kind::State);
    QVERIFY(!queue.takeOther());
    QVERIFY(queue.isEmpty());
    QCOMPARE(queue.dropped(Kind::State), std::uint64_t(1));
}

/// A busy vehicle does not keep the others from being shown.
void PublishQueueTest::statesWaitInTurn()
{
    PublishQueue queue;
    for (const char *topic : {"a", "b", "a", "c", "a"})
        queue.putState(topic, "");
    queue.putRaw(1, asBytes("frame"));
    for (const std::string topic : {"a", "b", "c", "vehicle/1/mavlink", "none"})
        QCOMPARE(topicOf(queue.takeOther()), topic);
    for (std::size_t i = 0; i <= PublishQueue::kMostStates; ++i)
        queue.putState(std::to_string(i), "");
    QCOMPARE(topicOf(queue.takeOther()), std::string("1")); // the oldest of too many is dropped
}

void PublishQueueTest::oldestEventIsDropped()
{
    PublishQueue queue;
    for (std::size_t i = 0; i < PublishQueue::kMostEvents + 3; ++i)
        queue.putEvent("a", std::to_string(i));
    QCOMPARE(queue.dropped(Kind::Event), std::uint64_t(3));
    for (std::size_t i = 3; i < PublishQueue::kMostEvents + 3; ++i)
        QCOMPARE(queue.takeEvent()->payload, std::to_string(i));
    QVERIFY(!queue.takeEvent());
}

void PublishQueueTest::framesOfAVehicleBecomeOneMessage()
{
    PublishQueue queue;
    queue.putRaw(255, asBytes("x"));
    queue.putRaw(7, asBytes("one"));
    queue.putRaw(255, asBytes("y"));
    queue.putRaw(7, asBytes("two"));
    const auto first = queue.takeOther(), second = queue.takeOther();
    QVERIFY(first && first->topic == vehicleMavlink(7) && first->payload == "onetwo" && first->kind == Kind::Raw);
    QVERIFY(second && second->topic == vehicleMavlink(255) && second->payload == "xy");
    QVERIFY(!queue.takeOther());
    queue.putRaw(255, asBytes("z"));
    QCOMPARE(queue.takeOther()->payload, std::string("z"));
}

void PublishQueueTest::staleFramesMakeRoomForNewOnes()
{
    PublishQueue queue;
    const std::string frame(280, 'f');
    const std::size_t fit = PublishQueue::kMostRawBytes / frame.size();
    for (std::size_t i = 0; i < fit; ++i)
        queue.putRaw(1, asBytes(frame));
    QCOMPARE(queue.dropped(Kind::Raw), std::uint64_t(0));
    queue.putRaw(2, asBytes("other"));
    const std::string newest(280, 'n');
    queue.putRaw(1, asBytes(newest));
    QCOMPARE(queue.dropped(Kind::Raw), std::uint64_t(fit));
    QCOMPARE(queue.takeOther()->payload, newest);
    QCOMPARE(queue.takeOther()->payload, std::string("other"));
}

void PublishQueueTest::nothingIsLostUncounted()
{
    const auto holds = [] {
        PublishQueue queue;
        std::array<std::uint64_t, kKinds> put{}, taken{};
        const auto take = [&](std::optional<OutgoingMessage> message) {
            if (!message)
                return false;
            // Each frame is one byte.
            taken[std::size_t(message->kind)] += message->kind == Kind::Raw ? message->payload.size() : 1;
            RC_ASSERT(message->payload.size() <= PublishQueue::kMostRawBytes);
            return true;
        };
        const int steps = *rc::gen::inRange(0, 400);
        for (int i = 0; i < steps; ++i) {
            const int burst = *rc::gen::inRange(1, 200);
            const auto system = std::uint8_t(*rc::gen::inRange(0, 256));
            const int act = *rc::gen::inRange(0, 5);
            for (int j = 0; j < burst; ++j) {
                if (act == 0)
                    queue.putState(vehicleState(std::uint8_t(system + j % 3)), "s"), ++put[0];
                else if (act == 1)
                    queue.putEvent("e", "e"), ++put[1];
                else if (act == 2)
                    queue.putRaw(system, asBytes("f")), ++put[2];
                else
                    take(act == 3 ? queue.takeEvent() : queue.takeOther());
            }
        }
        while (take(queue.takeEvent()) || take(queue.takeOther()))
            ;
        RC_ASSERT(queue.isEmpty());
        for (std::size_t kind = 0; kind < kKinds; ++kind)
            RC_ASSERT(taken[kind] + queue.dropped(Kind(kind)) == put[kind]);
    };
    QVERIFY(rc::check("taken and dropped are what was put", holds));
}

SKYSEAL_TEST_APPLESS(PublishQueueTest)
#include "publish_queue_test.moc"
