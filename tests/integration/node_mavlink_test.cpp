// An independent peer: the npm package node-mavlink simulates a vehicle over UDP, plain and signed. The monitor reports its
// messages, and it decodes the commands of the monitor.
#include "tests/support/eventually.h"
#include "tests/support/node_mavlink.h"
#include "tests/support/program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal::test;

class NodeMavlinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void monitorReportsItsTelemetry_data();
    void monitorReportsItsTelemetry();
    void itUnderstandsOurCommands();

private:
    QString m_node;
};

void NodeMavlinkTest::initTestCase()
{
    SKYSEAL_REQUIRES("node_mavlink");
    m_node = findNodeMavlink();
}

void NodeMavlinkTest::monitorReportsItsTelemetry_data()
{
    QTest::addColumn<bool>("isSigned");
    QTest::newRow("plain") << false;
    QTest::newRow("signed") << true;
}

void NodeMavlinkTest::monitorReportsItsTelemetry()
{
    QFETCH(bool, isSigned);
    const quint16 port = freeUdpPort();
    QTemporaryDir folder;
    QStringList monitorArguments{
        QStringLiteral("monitor"),  QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(port),
        QStringLiteral("--secure"), QStringLiteral("off"),    QStringLiteral("--json")};
    QStringList nodeArguments{QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/integration/node_vehicle.cjs"), QString::number(port)};
    if (isSigned)
        nodeArguments << QString(64, QLatin1Char('5'));
    Program monitor(QStringLiteral("skyseal-cli"), monitorArguments);
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    Program vehicle(m_node, nodeArguments);

    const QJsonObject found = monitor.waitFor(QStringLiteral("vehicle"));
    QCOMPARE(found[QLatin1String("sysid")].toInt(), 42);
    QJsonObject state;
    const auto complete = [&state](const QJsonObject &stats) {
        const QJsonArray vehicles = stats[QLatin1String("vehicles")].toArray();
        if (vehicles.isEmpty() || stats[QLatin1String("mavlink")][QLatin1String("frames")].toInt() < 60)
            return false;
        state = vehicles[0].toObject();
        return state[QLatin1String("lat")].isDouble();
    };
    QVERIFY(!monitor.waitFor(QStringLiteral("stats"), complete).isEmpty());
    QCOMPARE(state[QLatin1String("mode")].toString(), QStringLiteral("GUIDED"));
    QCOMPARE(state[QLatin1String("roll")].toDouble(), 0.25);
    QCOMPARE(state[QLatin1String("pitch")].toDouble(), -0.125);
    QCOMPARE(state[QLatin1String("yaw")].toDouble(), 1.5);
    QCOMPARE(state[QLatin1String("lat")].toDouble(), 47.397742);
    QCOMPARE(state[QLatin1String("lon")].toDouble(), 8.545594);
    QCOMPARE(state[QLatin1String("alt_rel")].toDouble(), 12.5);
    QCOMPARE(state[QLatin1String("ground_speed")].toDouble(), 5.0);
    const QJsonObject mavlink = monitor.last(QStringLiteral("stats"))[QLatin1String("mavlink")].toObject();
    QCOMPARE(mavlink[QLatin1String("bad_crc")].toInt(), 0);
    QCOMPARE(mavlink[QLatin1String("lost")].toInt(), 0);
    QVERIFY(vehicle.running());
}

void NodeMavlinkTest::itUnderstandsOurCommands()
{
    const quint16 port = freeUdpPort();
    Program monitor(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(port),
                     QStringLiteral("--secure"), QStringLiteral("off"), QStringLiteral("--json"), QStringLiteral("--do"),
                     QStringLiteral("takeoff 12.5"), QStringLiteral("--duration"), QStringLiteral("20")});
    QVERIFY(!monitor.waitFor(QStringLiteral("link")).isEmpty());
    Program vehicle(m_node, {QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/integration/node_vehicle.cjs"), QString::number(port)});
    const auto takeOff = [](const QJsonObject &message) {
        return message[QLatin1String("id")].toInt() == 76
            && message[QLatin1String("fields")][QLatin1String("command")].toInt() == 22;
    };
    const QJsonObject command = vehicle.waitFor(QStringLiteral("message"), takeOff)[QLatin1String("fields")].toObject();
    QCOMPARE(command[QLatin1String("_param7")].toDouble(), 12.5);
    QCOMPARE(command[QLatin1String("targetSystem")].toInt(), 42);
    const auto heartbeat = [](const QJsonObject &message) { return message[QLatin1String("id")].toInt() == 0; };
    EVENTUALLY(std::ranges::any_of(vehicle.events(), heartbeat));
    const QJsonObject station = *std::ranges::find_if(vehicle.events(), heartbeat);
    QCOMPARE(station[QLatin1String("sysid")].toInt(), 255);
    QCOMPARE(station[QLatin1String("compid")].toInt(), 190);
    QCOMPARE(station[QLatin1String("fields")][QLatin1String("type")].toInt(), 6);
    const QJsonObject answer = monitor.waitFor(QStringLiteral("command"));
    QCOMPARE(answer[QLatin1String("result")].toString(), QStringLiteral("accepted"));
}

SKYSEAL_TEST(NodeMavlinkTest)
#include "node_mavlink_test.moc"
