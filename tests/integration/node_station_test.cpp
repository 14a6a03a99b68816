// A ground station that we did not write, the npm package node-mavlink, through the gateway: it reads the parameters, transfers
// a mission and flies while the cipher is switched every two seconds; one that may only read sees everything and commands
// nothing.
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/node_mavlink.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtTest/QTest>

using namespace skyseal::test;

class NodeStationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void pilotFliesWhileCiphersSwitch();
    void readerSeesEverythingAndCommandsNothing();

private:
    Program station(quint16 port, const char *purpose) const
    {
        return {m_node,
                {QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/integration/node_station.cjs"), QString::number(port),
                 QLatin1String(purpose)}};
    }

    QString m_node;
};

void NodeStationTest::initTestCase()
{
    SKYSEAL_REQUIRES("node_mavlink");
    m_node = findNodeMavlink();
}

void NodeStationTest::pilotFliesWhileCiphersSwitch()
{
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1,write=all").arg(port)});
    flight.startSimulatedVehicle();
    QVERIFY(flight.waitForSession());
    Program pilot = station(port, "fly");
    const QStringList suites = GatewayFlight::suites();
    int switched = 0;
    while (pilot.events(QStringLiteral("done")).empty() && pilot.running()) {
        QCOMPARE(flight.control({QStringLiteral("switch"), suites[switched++ % suites.size()]}).status, 0);
        for (int second = 0; second < 2; ++second)
            QVERIFY(!flight.gateway->waitFor(QStringLiteral("stats")).isEmpty());
    }
    const QJsonObject parameters = pilot.last(QStringLiteral("parameters"));
    QVERIFY2(parameters[QLatin1String("total")].toInt() > 0, pilot.errors().constData());
    QCOMPARE(parameters[QLatin1String("read")], parameters[QLatin1String("total")]);
    const QJsonObject mission = pilot.last(QStringLiteral("mission"));
    QCOMPARE(mission[QLatin1String("result")].toInt(-1), 0);
    QCOMPARE(mission[QLatin1String("count")].toInt(), 3);
    QVERIFY(mission[QLatin1String("same")].toBool());
    const QJsonObject done = pilot.last(QStringLiteral("done"));
    QVERIFY2(!done.isEmpty(), pilot.errors().constData());
    QCOMPARE(done[QLatin1String("lost")].toInt(-1), 0);
    QVERIFY(done[QLatin1String("frames")].toInt() > 1000);
    QVERIFY(switched > 5);
}

void NodeStationTest::readerSeesEverythingAndCommandsNothing()
{
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1").arg(port)});
    flight.startSimulatedVehicle();
    QVERIFY(flight.waitForSession());
    Program reader = station(port, "read");
    const QJsonObject done = reader.waitFor(QStringLiteral("done"));
    QVERIFY2(!done.isEmpty(), reader.errors().constData());
    const QJsonObject parameters = reader.last(QStringLiteral("parameters"));
    QVERIFY(parameters[QLatin1String("total")].toInt() > 0);
    QCOMPARE(parameters[QLatin1String("read")], parameters[QLatin1String("total")]);
    QVERIFY(reader.last(QStringLiteral("unchanged"))[QLatin1String("same")].toBool());
    QCOMPARE(done[QLatin1String("armed")], QJsonValue(false));
    QVERIFY(!flight.gateway->events(QStringLiteral("client_denied")).empty());
}

SKYSEAL_TEST(NodeStationTest)
#include "node_station_test.moc"
