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
    void componentsOfAVehicleAreListed();
    void otherSystemsAreListed();
    void conflictOfSystemIdsIsNamed();
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

void EventJsonTest::componentsOfAVehicleAreListed()
{
    Snapshot snapshot;
    snapshot.vehicles.emplace_back().state.components = {{.id = 100, .type = mavlink::MAV_TYPE_CAMERA, .age = 0.5}};
    const QJsonObject vehicle = parsed(statsEvent("stats", snapshot, 1))[QStringLiteral("vehicles")][0].toObject();
    QCOMPARE(vehicle.value(QStringLiteral("component")).toInt(), 1);
    const QJsonValue camera = vehicle.value(QStringLiteral("components"))[0];
    QCOMPARE(camera[QStringLiteral("component")].toInt(), 100);
    QCOMPARE(camera[QStringLiteral("type")].toInt(), int(mavlink::MAV_TYPE_CAMERA));
    QCOMPARE(camera[QStringLiteral("heartbeat_age")].toDouble(), 0.5);
}

void EventJsonTest::otherSystemsAreListed()
{
    const OtherSystemsHeard heard{"air-1", {51, 255}, {}, 12};
    const QJsonObject event = parsed(otherSystemsEvent(heard));
    QCOMPARE(event.value(QStringLiteral("event")).toString(), QStringLiteral("other_systems"));
    QCOMPARE(event.value(QStringLiteral("peer")).toString(), QStringLiteral("air-1"));
    QCOMPARE(event.value(QStringLiteral("systems"))[1].toInt(), 255);
    Snapshot snapshot;
    QVERIFY(!parsed(statsEvent("stats", snapshot, 1)).contains(QStringLiteral("other_systems")));
    snapshot.otherSystems = {heard};
    const QJsonValue listed = parsed(statsEvent("stats", snapshot, 1))[QStringLiteral("other_systems")][0];
    QCOMPARE(listed[QStringLiteral("systems")][0].toInt(), 51);
    QCOMPARE(listed[QStringLiteral("frames")].toInt(), 12);
}

void EventJsonTest::conflictOfSystemIdsIsNamed()
{
    const QJsonObject event = parsed(ownIdEvent({255, 1, "10.0.0.9:14550"}));
    QCOMPARE(event.value(QStringLiteral("event")).toString(), QStringLiteral("system_id_conflict"));
    QCOMPARE(event.value(QStringLiteral("sysid")).toInt(), 255);
    QCOMPARE(event.value(QStringLiteral("address")).toString(), QStringLiteral("10.0.0.9:14550"));
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
