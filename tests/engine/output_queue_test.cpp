// The queue between a station and its reader is bounded, keeps its order, and never drops pairing events or the final
// snapshot; a reader learns how many events it did not receive.
#include "core/engine/station/output_queue.h"
#include "core/engine/station/snapshot.h"

#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

SnapshotPtr snapshotNumber(std::uint64_t number)
{
    auto out = std::make_shared<Snapshot>();
    out->number = number;
    return out;
}

Event lostVehicle(std::size_t systemId)
{
    return VehicleLost{static_cast<std::uint8_t>(systemId)};
}

template<typename Kind> std::size_t countOf(const std::deque<OutputQueue::Item> &items)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(items, [](const auto &item) { return std::holds_alternative<Kind>(item); }));
}

} // namespace

class OutputQueueTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hungReaderCollectsABoundedAmount();
    void pairingEventsAndTheEndAreNeverDropped();
    void snapshotComesAfterTheEventsBeforeIt();
    void readerIsWokenOnce();
};

void OutputQueueTest::hungReaderCollectsABoundedAmount()
{
    OutputQueue queue;
    constexpr std::size_t kSent = OutputQueue::kMostEvents + 250;
    for (std::size_t i = 0; i < kSent; ++i) {
        queue.put(lostVehicle(i % 256));
        queue.put(snapshotNumber(i + 1));
    }
    QCOMPARE(queue.eventsDropped(), std::uint64_t(250));
    auto items = queue.takeAll();
    QCOMPARE(std::get<EventsDropped>(std::get<Event>(items.front())).events, std::uint64_t(250));
    items.pop_front();
    QCOMPARE(countOf<SnapshotPtr>(items), std::size_t(1));
    QCOMPARE(countOf<Event>(items), OutputQueue::kMostEvents);
    QCOMPARE(std::get<SnapshotPtr>(items.back())->number, std::uint64_t(kSent));
    // The oldest events were dropped, the others are in order.
    for (std::size_t i = 0; i < OutputQueue::kMostEvents; ++i)
        QCOMPARE(std::size_t(std::get<VehicleLost>(std::get<Event>(items[i])).systemId), (i + 250) % 256);
    // The bound starts again for a reader that took everything, and the same drops are not reported twice.
    queue.put(lostVehicle(1));
    QCOMPARE(queue.takeAll().size(), std::size_t(1));
    QCOMPARE(queue.eventsDropped(), std::uint64_t(250));
    for (std::size_t i = 0; i < OutputQueue::kMostEvents + 3; ++i)
        queue.put(lostVehicle(1));
    items = queue.takeAll();
    QCOMPARE(std::get<EventsDropped>(std::get<Event>(items.front())).events, std::uint64_t(3));
    QCOMPARE(queue.eventsDropped(), std::uint64_t(253));
}

void OutputQueueTest::pairingEventsAndTheEndAreNeverDropped()
{
    OutputQueue queue;
    queue.put(channel::PairingEvent(channel::PairingOver{}));
    for (std::size_t i = 0; i < 3 * OutputQueue::kMostEvents; ++i)
        queue.put(lostVehicle(1));
    queue.put(Stopped{snapshotNumber(7)});
    const auto items = queue.takeAll();
    QCOMPARE(countOf<channel::PairingEvent>(items), std::size_t(1));
    QVERIFY(std::holds_alternative<Stopped>(items.back()));
    QCOMPARE(items.size(), OutputQueue::kMostEvents + 3); // and EventsDropped
}

void OutputQueueTest::snapshotComesAfterTheEventsBeforeIt()
{
    OutputQueue queue;
    queue.put(snapshotNumber(1));
    queue.put(lostVehicle(1));
    queue.put(snapshotNumber(2));
    queue.put(lostVehicle(2));
    const auto items = queue.takeAll();
    QCOMPARE(items.size(), std::size_t(3));
    QVERIFY(std::holds_alternative<Event>(items[0]));
    QCOMPARE(std::get<SnapshotPtr>(items[1])->number, std::uint64_t(2));
    QVERIFY(std::holds_alternative<Event>(items[2]));
}

void OutputQueueTest::readerIsWokenOnce()
{
    OutputQueue queue;
    QVERIFY(queue.put(snapshotNumber(1)));
    QVERIFY(!queue.put(snapshotNumber(2))); // takes the place of the first
    QVERIFY(!queue.put(lostVehicle(1)));
    queue.takeAll();
    QVERIFY(queue.put(lostVehicle(2)));
}

SKYSEAL_TEST(OutputQueueTest)
#include "output_queue_test.moc"
