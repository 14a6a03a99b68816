// Agents with unknown keys, on a simulated clock: listed while they announce themselves, reported once a minute, and limited
// in number.
#include "core/engine/station/unknown_agents.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using engine::UnknownAgents;

namespace {

TimePoint at(double s)
{
    return TimePoint{} + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

Path from(std::uint16_t port)
{
    Path path;
    path.remote.port = port;
    return path;
}

} // namespace

class UnknownAgentsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reportedOnceAMinute()
    {
        UnknownAgents agents;
        int told = 0;
        for (int second = 0; second < 150; ++second) {
            told += agents.note(at(second), from(1));
            QCOMPARE(agents.all(at(second)).size(), std::size_t(1));
        }
        QCOMPARE(told, 3); // at 0, 60 and 120
    }

    void listedWhileItAnnouncesItself()
    {
        UnknownAgents agents;
        QVERIFY(agents.all(at(0)).empty());
        QVERIFY(agents.note(at(0), from(1)));
        QVERIFY(agents.note(at(1), from(2)));
        QCOMPARE(agents.all(at(3)).size(), std::size_t(2));
        QCOMPARE(agents.all(at(4.5)).size(), std::size_t(1));
        QVERIFY(agents.all(at(6)).empty());
        QVERIFY(!agents.note(at(7), from(1))); // back within the minute
        QVERIFY(agents.note(at(70), from(1))); // and after it
    }

    void manyAgentsRaiseFewEvents()
    {
        UnknownAgents agents;
        std::size_t told = 0;
        for (int i = 0; i < 5000; ++i)
            told += agents.note(at(i * 0.01), from(static_cast<std::uint16_t>(i)));
        QCOMPARE(told, UnknownAgents::kMost);
        QVERIFY(agents.all(at(0.1)).size() <= UnknownAgents::kMost);
    }
};

SKYSEAL_TEST(UnknownAgentsTest)
#include "unknown_agents_test.moc"
