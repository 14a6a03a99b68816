// Debian's Prometheus with the configuration of packaging/fleet reads a gateway, and knows what the alerts and the dashboard
// ask for.
#include "tests/support/gateway_flight.h"
#include "tests/support/mqtt_broker.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QRegularExpression>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtCore/QUrl>
#include <QtNetwork/QTcpSocket>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

QByteArray shipped(const char *name)
{
    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/packaging/fleet/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void collectExpressions(const QJsonValue &value, QStringList &out)
{
    for (const QJsonValue &element : value.toArray())
        collectExpressions(element, out);
    const QJsonObject object = value.toObject();
    for (auto member = object.begin(); member != object.end(); ++member) {
        if (member.key() == QLatin1String("expr"))
            out << member.value().toString();
        else
            collectExpressions(member.value(), out);
    }
}

} // namespace

class FleetMonitoringTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void prometheusKnowsWhatTheDashboardAsksFor();
};

void FleetMonitoringTest::initTestCase()
{
    SKYSEAL_REQUIRES("prometheus");
}

void FleetMonitoringTest::prometheusKnowsWhatTheDashboardAsksFor()
{
    MqttBroker broker;
    GatewayFlight flight({QStringLiteral("udpin:0,name=reader")}, {"mqtt = " + broker.url()});
    flight.startSimulatedVehicle();
    QTemporaryDir folder;
    QByteArray config = shipped("prometheus.yml");
    QVERIFY(config.contains("'127.0.0.1:9464'") && config.contains("scrape_interval: 5s"));
    config.replace("127.0.0.1:9464", "127.0.0.1:" + QByteArray::number(flight.metricsPort))
        .replace("interval: 5s", "interval: 1s");
    for (const auto &[name, content] : {std::pair("prometheus.yml", config), {"alerts.yml", shipped("alerts.yml")}}) {
        QFile file(folder.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) > 0);
    }
    const quint16 port = freeTcpPort();
    Program prometheus(QStandardPaths::findExecutable(QStringLiteral("prometheus")),
                       {QStringLiteral("--config.file=") + folder.filePath(QStringLiteral("prometheus.yml")),
                        QStringLiteral("--storage.tsdb.path=") + folder.filePath(QStringLiteral("data")),
                        QStringLiteral("--web.listen-address=127.0.0.1:%1").arg(port)});
    const auto get = [port](const QByteArray &path) {
        QTcpSocket socket;
        socket.connectToHost(QHostAddress::LocalHost, port);
        if (!socket.waitForConnected(kDeadlineMs))
            return QJsonObject();
        socket.write("GET " + path + " HTTP/1.0\r\nHost: localhost\r\n\r\n");
        while (socket.waitForReadyRead(kDeadlineMs))
            ;
        const QByteArray answer = socket.readAll();
        return QJsonDocument::fromJson(answer.mid(answer.indexOf("\r\n\r\n") + 4)).object()[QLatin1String("data")].toObject();
    };
    const auto query = [&get](const QString &expression) {
        return get("/api/v1/query?query=" + QUrl::toPercentEncoding(expression))[QLatin1String("result")].toArray();
    };
    const auto isRead = [&query] {
        const QJsonArray heard = query(QStringLiteral("skyseal_vehicle_heard{gateway=\"north\"} == 1"));
        return !heard.isEmpty() && !query(QStringLiteral("skyseal_mqtt_connected == 1")).isEmpty();
    };
    EVENTUALLY2(isRead(), prometheus.errors().constData());

    QStringList expressions;
    collectExpressions(QJsonDocument::fromJson(shipped("dashboard.json")).object(), expressions);
    QVERIFY(expressions.size() >= 10);
    QVERIFY(!expressions.contains(QString()));
    static const QRegularExpression kMetric(QStringLiteral("\\bskyseal_[a-z_]+"));
    const QString alerts = QString::fromUtf8(shipped("alerts.yml"));
    for (const QString &text : expressions + QStringList(alerts)) {
        for (const auto &metric : kMetric.globalMatch(text)) {
            const auto isKnown = [&] { return !query(metric.captured()).isEmpty(); };
            EVENTUALLY2(isKnown(), qPrintable(metric.captured()));
        }
    }
    for (const QString &expression : expressions) {
        const auto hasValue = [&] { return !query(expression).isEmpty(); };
        EVENTUALLY2(hasValue(), qPrintable(expression));
    }
    const QJsonArray groups = get("/api/v1/rules")[QLatin1String("groups")].toArray();
    QCOMPARE(groups[0][QLatin1String("rules")].toArray().size(), qsizetype(alerts.count(QLatin1String("- alert:"))));

    const auto fires = [&query] {
        return !query(QStringLiteral("ALERTS{alertname=\"VehicleLost\",alertstate=\"firing\"}")).isEmpty();
    };
    QVERIFY(!fires());
    flight.sim->kill();
    EVENTUALLY(fires());
}

SKYSEAL_TEST(FleetMonitoringTest)
#include "fleet_monitoring_test.moc"
