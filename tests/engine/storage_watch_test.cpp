// Reports that the counters of handshakes cannot be stored.
#include "core/engine/common/storage_watch.h"
#include "core/engine/headless/agent_json.h"
#include "core/engine/headless/channel_event_json.h"
#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

class StorageWatchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void repeatsEachMinute();
    void isInTheStatistics();
};

void StorageWatchTest::repeatsEachMinute()
{
    StorageWatch watch;
    TimePoint now{};
    const auto eventsIn = [&](int seconds, const std::string &problem) {
        std::vector<std::string> out;
        for (int i = 0; i < seconds; ++i) {
            if (const auto event = watch.note(now += std::chrono::seconds(1), problem))
                out.push_back(event->problem.text());
        }
        return out;
    };
    QVERIFY(eventsIn(100, "").empty());
    QCOMPARE(eventsIn(150, "full"), (std::vector<std::string>{"full", "full", "full"}));
    QCOMPARE(watch.problem().text(), std::string("full"));
    QCOMPARE(eventsIn(100, ""), std::vector<std::string>{""});
    QCOMPARE(eventsIn(10, "full"), std::vector<std::string>{"full"}); // at once
}

void StorageWatchTest::isInTheStatistics()
{
    AgentSnapshot agent;
    QVERIFY(agentStatsEvent("stats", agent, 1).find("storage_problem") == std::string::npos);
    agent.storageProblem = "full";
    QVERIFY(agentStatsEvent("stats", agent, 1).find(R"("storage_problem":"full")") != std::string::npos);
    Snapshot station;
    station.storageProblem = "full";
    QVERIFY(statsEvent("stats", station, 1).find(R"("storage_problem":"full")") != std::string::npos);
    QCOMPARE(counterStorageEvent({"full"}), std::string(R"({"event":"counter_storage","works":false,"problem":"full"})"));
    QCOMPARE(counterStorageEvent({}), std::string(R"({"event":"counter_storage","works":true})"));
    PeerNames names;
    names.note(channel::Event(channel::SessionUp{channel::SessionId{1}, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}}));
    QCOMPARE(channelEvent(channel::PeerStorageChanged{channel::SessionId{1}, true}, names),
             std::string(R"({"event":"agent_storage","peer":"air-1","works":false})"));
}

SKYSEAL_TEST(StorageWatchTest)
#include "storage_watch_test.moc"
