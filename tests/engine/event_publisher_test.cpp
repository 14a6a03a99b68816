// The limit of the events that strangers can cause, on a simulated clock: one a second for all kinds, each kind in its turn,
// nothing lost of those that count.
#include "core/engine/station/event.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

Path from(std::uint16_t port)
{
    Path path;
    path.remote.port = port;
    return path;
}

channel::HandshakeRefused refused(channel::RefusalReason reason, std::uint16_t port = 1)
{
    return {from(port), reason, {}};
}

struct Published
{
    std::vector<Event> events;
    EventPublisher<Event, StationCauses> publisher{[this](Event event) { events.push_back(std::move(event)); }};

    /// Publishes what is due until nothing waits; returns the time of the last event.
    TimePoint drain()
    {
        TimePoint now{};
        while (publisher.nextDeadline() != kNever)
            publisher.publishDue(now = publisher.nextDeadline());
        return now;
    }
};

} // namespace

class EventPublisherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void othersAreNotDelayed();
    void oneASecond();
    void kindsTakeTurns();
    void countsAreAdded();
    void eachAgentIsReported();
    void queuesAreBounded();
};

void EventPublisherTest::othersAreNotDelayed()
{
    Published out;
    for (int i = 0; i < 10; ++i) {
        out.publisher.publish({}, VehicleLost{1});
        out.publisher.publish({}, refused(channel::RefusalReason::CounterBehind));
    }
    QCOMPARE(out.events.size(), std::size_t(20));
    QCOMPARE(out.publisher.nextDeadline(), kNever);
}

void EventPublisherTest::oneASecond()
{
    Published out;
    TimePoint now{};
    for (; now < TimePoint() + 20s; now += 1ms) {
        out.publisher.publish(now, refused(channel::RefusalReason::Version));
        out.publisher.publish(now, refused(channel::RefusalReason::Flood));
        out.publisher.publish(now, channel::ForgeryAlarm{channel::SessionId{1}, 1, 0});
        out.publisher.publish(now, PlaintextRefused{1, "a", 1});
    }
    QCOMPARE(out.events.size(), std::size_t(20));
}

void EventPublisherTest::kindsTakeTurns()
{
    Published out;
    TimePoint now{};
    out.publisher.publish(now, refused(channel::RefusalReason::Version));
    for (; now < TimePoint() + 2500ms; now += 1ms) {
        out.publisher.publish(now, refused(channel::RefusalReason::Version));
        if (now == TimePoint() + 500ms)
            out.publisher.publish(now, refused(channel::RefusalReason::UnknownPeer));
        if (now == TimePoint() + 600ms)
            out.publisher.publish(now, PlaintextRefused{1, "a", 1});
    }
    QCOMPARE(out.events.size(), std::size_t(3));
    QCOMPARE(int(std::get<channel::HandshakeRefused>(out.events[1]).reason), int(channel::RefusalReason::UnknownPeer));
    QVERIFY(std::holds_alternative<PlaintextRefused>(out.events[2]));
}

void EventPublisherTest::countsAreAdded()
{
    Published out;
    for (int i = 0; i < 10; ++i) {
        out.publisher.publish({}, channel::ForgeryAlarm{channel::SessionId{1}, 2, 1});
        out.publisher.publish({}, PlaintextRefused{static_cast<std::uint8_t>(i), "a", 3});
    }
    out.drain();
    std::uint64_t forged = 0, replayed = 0, frames = 0;
    for (const Event &event : out.events) {
        if (const auto *alarm = std::get_if<channel::ForgeryAlarm>(&event))
            forged += alarm->forged, replayed += alarm->replayed;
        else
            frames += std::get<PlaintextRefused>(event).frames;
    }
    QCOMPARE(out.events.size(), std::size_t(3));
    QCOMPARE(forged, std::uint64_t(20));
    QCOMPARE(replayed, std::uint64_t(10));
    QCOMPARE(frames, std::uint64_t(30));
}

void EventPublisherTest::eachAgentIsReported()
{
    Published out;
    for (std::uint16_t port = 1; port <= 8; ++port)
        out.publisher.publish({}, refused(channel::RefusalReason::UnknownPeer, port));
    QCOMPARE(out.drain(), TimePoint() + 7s);
    QCOMPARE(out.events.size(), std::size_t(8));
}

void EventPublisherTest::queuesAreBounded()
{
    Published out;
    for (int port = 0; port < 5000; ++port)
        out.publisher.publish({}, refused(channel::RefusalReason::UnknownPeer, static_cast<std::uint16_t>(port)));
    out.drain();
    QCOMPARE(out.events.size(), decltype(out.publisher)::kMostWaiting + 1);
}

SKYSEAL_TEST(EventPublisherTest)
#include "event_publisher_test.moc"
