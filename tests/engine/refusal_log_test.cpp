// The counts of refused frames and the events that are made of them.
#include "core/engine/station/refusal_log.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

constexpr TimePoint kAtFirst{100s};
const Address kFrom{{10, 0, 0, 9}, 14550}, kOther{{10, 0, 0, 8}, 14550};

} // namespace

class RefusalLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesBecomeOneEventASecond();
    void kindsAreCountedApart();
    void peerIsNamedBeforeTheEvent();
};

void RefusalLogTest::framesBecomeOneEventASecond()
{
    RefusalLog log;
    QVERIFY(!log.takePlaintext(kAtFirst));
    log.refusePlaintext(1, kFrom);
    const auto first = log.takePlaintext(kAtFirst);
    QVERIFY(first);
    QCOMPARE(first->frames, std::uint64_t(1));
    for (int i = 0; i < 500; ++i)
        log.refusePlaintext(2, kOther);
    QVERIFY(!log.takePlaintext(kAtFirst + 999ms));
    const auto second = log.takePlaintext(kAtFirst + 1s);
    QVERIFY(second);
    QCOMPARE(second->frames, std::uint64_t(500)); // since the last event
    QCOMPARE(second->systemId, std::uint8_t(2));
    QVERIFY(second->remoteAddress.ends_with(":14550") && second->remoteAddress != first->remoteAddress);
    QVERIFY(!log.takePlaintext(kAtFirst + 10s)); // nothing new
    QCOMPARE(log.plaintextFrames(), std::uint64_t(501));
}

void RefusalLogTest::kindsAreCountedApart()
{
    RefusalLog log;
    log.refusePlaintext(1, kFrom);
    QVERIFY(log.takePlaintext(kAtFirst));
    log.refuseSystem(1, channel::SessionId{4});
    QVERIFY(log.isSystemDue(kAtFirst)); // though an event of the other kind was taken at this time
    QVERIFY(log.takeSystem(kAtFirst));
    QCOMPARE(log.plaintextFrames(), std::uint64_t(1));
    QCOMPARE(log.systemFrames(), std::uint64_t(1));
}

void RefusalLogTest::peerIsNamedBeforeTheEvent()
{
    RefusalLog log;
    QVERIFY(!log.unnamedSession());
    log.refuseSystem(7, channel::SessionId{4});
    QCOMPARE(log.unnamedSession(), std::optional(channel::SessionId{4}));
    QCOMPARE(log.refusedSystem(), std::uint8_t(7));
    log.namePeer("air-2", "air-1");
    const auto event = log.takeSystem(kAtFirst);
    QVERIFY(event);
    QCOMPARE(event->peer, std::string("air-2"));
    QCOMPARE(event->owner, std::string("air-1"));
    QVERIFY(!log.unnamedSession());
}

SKYSEAL_TEST(RefusalLogTest)
#include "refusal_log_test.moc"
