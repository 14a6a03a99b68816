// The JSON lines of the station's monitor that no test over the programs reaches.
#include "core/engine/headless/common_json.h"
#include "core/engine/headless/channel_event_json.h"
#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"
#include "tests/support/json_values.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonObject>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using test::parsed;

class EventJsonTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void droppedEventsAreReported();
    void agentThatDoesNotAnswerIsNamed();
    void unknownAgeOfCommandsIsNull();
    void brokerIsInTheStatistics();
};

void EventJsonTest::droppedEventsAreReported()
{
    const QJsonObject event = parsed(eventsDroppedEvent({250}));
    QCOMPARE(event.value(QStringLiteral("event")).toString(), QStringLiteral("events_dropped"));
    QCOMPARE(event.value(QStringLiteral("events")).toInt(), 250);
    Snapshot snapshot;
    snapshot.eventsDropped = 253;
    for (const char *name : {"stats", "summary"}) {
        const QJsonObject statistics = parsed(statsEvent(name, snapshot, 1));
        QCOMPARE(statistics.value(QStringLiteral("event")).toString(), QLatin1String(name));
        QCOMPARE(statistics.value(QStringLiteral("events_dropped")).toInt(), 253);
    }
}

void EventJsonTest::agentThatDoesNotAnswerIsNamed()
{
    const QJsonObject event = parsed(unansweringEvent({{"air-1", "10.0.0.9:14551", "abc", 3}, false}));
    QCOMPARE(event.value(QStringLiteral("event")).toString(), QStringLiteral("unanswered"));
    QCOMPARE(event.value(QStringLiteral("state")).toString(), QStringLiteral("begun"));
    QCOMPARE(event.value(QStringLiteral("peer")).toString(), QStringLiteral("air-1"));
    QCOMPARE(event.value(QStringLiteral("own_fingerprint")).toString(), QStringLiteral("abc"));
}

void EventJsonTest::brokerIsInTheStatistics()
{
    Snapshot snapshot;
    QVERIFY(!parsed(statusEvent(snapshot)).contains(QStringLiteral("mqtt")));
    snapshot.broker = mqtt::PublisherStatus{.problem = "Connection refused", .event = {5, 2}};
    const QJsonObject status = parsed(statusEvent(snapshot)).value(QStringLiteral("mqtt")).toObject();
    QCOMPARE(status.value(QStringLiteral("connected")).toBool(true), false);
    QCOMPARE(status.value(QStringLiteral("problem")).toString(), QStringLiteral("Connection refused"));
    QCOMPARE(status.value(QStringLiteral("event"))[QStringLiteral("sent")].toInt(), 5);
    QCOMPARE(status.value(QStringLiteral("event"))[QStringLiteral("dropped")].toInt(), 2);
    const QJsonObject event = parsed(brokerEvent("mqtts://broker:8883/skyseal", *snapshot.broker));
    QCOMPARE(event.value(QStringLiteral("event")).toString(), QStringLiteral("mqtt"));
    QCOMPARE(event.value(QStringLiteral("state")).toString(), QStringLiteral("waiting"));
}

void EventJsonTest::unknownAgeOfCommandsIsNull()
{
    PeerNames names;
    channel::CommandsLate late;
    late.report.ageMicroseconds = 2'500'000;
    QCOMPARE(parsed(channelEvent(late, names)).value(QStringLiteral("age_ms")).toDouble(), 2500.0);
    late.report.ageMicroseconds = channel::FreshnessReport::kUnknownAge;
    QVERIFY(parsed(channelEvent(late, names)).value(QStringLiteral("age_ms")).isNull());
}

SKYSEAL_TEST(EventJsonTest)
#include "event_json_test.moc"
