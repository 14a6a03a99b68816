// The exposition of a snapshot follows the OpenMetrics text format, version 1.0.
#include "core/engine/headless/open_metrics.h"
#include "core/engine/station/snapshot.h"
#include "tests/support/test_runner.h"

#include <QtCore/QRegularExpression>
#include <QtCore/QSet>
#include <QtCore/QStringList>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

Snapshot flight()
{
    Snapshot out;
    out.mavlink.frames = 1200;
    out.channel.rx.good = 400;
    out.channel.rx.forged = 3;
    out.sessions.emplace_back().info.peerName = "air \"1\" \\ \n";
    VehicleSnapshot vehicle;
    vehicle.state.systemId = 7;
    vehicle.state.altitudeRelative = 12.5; // all other values are unknown
    out.vehicles.push_back(vehicle);
    out.clients.push_back({"planner", "127.0.0.1:5000", "none", {5, 2, 1, 0}});
    out.broker = mqtt::PublisherStatus{.connected = true, .connections = 2, .state = {100, 7}, .event = {3, 0}, .raw = {0, 1}};
    return out;
}

QStringList lines(const Snapshot &snapshot)
{
    return QString::fromStdString(openMetrics(snapshot)).split(QLatin1Char('\n'));
}

} // namespace

class OpenMetricsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLineIsWellFormed();
    void valuesAreThoseOfTheSnapshot();
    void unknownValuesAreLeftOut();
    void nothingIsKnownAtTheStart();
};

void OpenMetricsTest::everyLineIsWellFormed()
{
    static const QRegularExpression kMetadata(QStringLiteral("^# (TYPE [a-z_:]+ (counter|gauge)|HELP [a-z_:]+ .+)$"));
    static const QRegularExpression kSample(
        QStringLiteral(R"(^([a-z_:]+)(\{[a-z_]+="([^"\\]|\\[\\"n])*"(,[a-z_]+="([^"\\]|\\[\\"n])*")*\})? -?[0-9.e+-]+$)"));
    QStringList all = lines(flight());
    QCOMPARE(all.takeLast(), QString()); // the text ends with a line feed
    QCOMPARE(all.takeLast(), QStringLiteral("# EOF"));
    QString family, type;
    QSet<QString> families;
    for (const QString &line : all) {
        if (line.startsWith(QLatin1Char('#'))) {
            QVERIFY2(kMetadata.match(line).hasMatch(), qPrintable(line));
            if (line.startsWith(QLatin1String("# TYPE "))) {
                family = line.section(QLatin1Char(' '), 2, 2);
                type = line.section(QLatin1Char(' '), 3, 3);
                QVERIFY2(!families.contains(family), qPrintable(family)); // its samples stand together
                families.insert(family);
            }
            continue;
        }
        const auto match = kSample.match(line);
        QVERIFY2(match.hasMatch(), qPrintable(line));
        QCOMPARE(match.captured(1), family + (type == QLatin1String("counter") ? QStringLiteral("_total") : QString()));
    }
}

void OpenMetricsTest::valuesAreThoseOfTheSnapshot()
{
    const QStringList all = lines(flight());
    for (const char *line : {"skyseal_mavlink_frames_total 1200", "skyseal_records_total{outcome=\"forged\"} 3",
                             "skyseal_vehicle_alt_rel{sysid=\"7\"} 12.5",
                             "skyseal_session_epoch{peer=\"air \\\"1\\\" \\\\ \\n\",suite=\"none\"} 0",
                             "skyseal_client_frames_total{client=\"planner\",address=\"127.0.0.1:5000\",outcome=\"denied\"} 2",
                             "skyseal_mqtt_connected 1", "skyseal_mqtt_connections_total 2",
                             "skyseal_mqtt_messages_total{kind=\"state\",outcome=\"dropped\"} 7",
                             "skyseal_mqtt_messages_total{kind=\"event\",outcome=\"sent\"} 3"})
        QVERIFY2(all.contains(QLatin1String(line)), qPrintable(QLatin1String(line) + all.join(QLatin1Char('\n'))));
}

void OpenMetricsTest::unknownValuesAreLeftOut()
{
    for (const QString &line : lines(flight()))
        QVERIFY2(!line.startsWith(QLatin1String("skyseal_vehicle_heading{")) && !line.contains(QLatin1String("nan")),
                 qPrintable(line));
}

void OpenMetricsTest::nothingIsKnownAtTheStart()
{
    QVERIFY(lines({}).contains(QStringLiteral("skyseal_mavlink_frames_total 0")));
    QVERIFY(lines({}).filter(QStringLiteral("mqtt")).isEmpty()); // without a broker
}

SKYSEAL_TEST_APPLESS(OpenMetricsTest)
#include "open_metrics_test.moc"
