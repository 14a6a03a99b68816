// A gateway that publishes to Debian's broker mosquitto, over TLS with certificates, in the set-up of packaging/fleet.
#include "core/mavlink/frame_intake.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/mosquitto.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

using Message = MqttReader::Message;

auto isState(const char *state)
{
    return
        [state](const Message &message) { return message.json()[QLatin1String("state")].toString() == QLatin1String(state); };
}

auto isEvent(const char *event)
{
    return
        [event](const Message &message) { return message.json()[QLatin1String("event")].toString() == QLatin1String(event); };
}

/// The options of a gateway that publishes below north/ with the certificate `name`.
QByteArrayList broker(const Authority &authority, quint16 port, const char *name = "north")
{
    const QByteArray folder = authority.folder().toLocal8Bit();
    return {"mqtt = mqtts://127.0.0.1:" + QByteArray::number(port) + "/north", "mqtt-ca = " + folder + "ca.crt",
            "mqtt-cert = " + folder + name + ".crt", "mqtt-key = " + folder + name + ".key"};
}

} // namespace

class MqttBrokerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void flightIsPublished();
    void framesArePublishedWhereAskedFor();
    void deathOfTheGatewayIsTold();
    void brokerMayRestart();
    void passwordOpensTheBroker();
    void falseBrokerLearnsNothing_data();
    void falseBrokerLearnsNothing();
    void gatewayWritesBelowItsNameOnly();
    void wrongSetUpsAreExplained_data();
    void wrongSetUpsAreExplained();

private:
    std::unique_ptr<Authority> m_authority;
};

void MqttBrokerTest::initTestCase()
{
    SKYSEAL_REQUIRES("mosquitto");
    m_authority = std::make_unique<Authority>();
    for (const char *name : {"broker", "north", "south", "dashboard"})
        m_authority->certify(name);
}

void MqttBrokerTest::flightIsPublished()
{
    Mosquitto mosquitto(*m_authority);
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    QVERIFY(reader.waitUntilSubscribed());
    GatewayFlight flight({QStringLiteral("udpin:0")}, broker(*m_authority, mosquitto.port));
    QCOMPARE(reader.waitFor("north/gateway/state").json()[QLatin1String("state")].toString(), QStringLiteral("online"));
    flight.startSimulatedVehicle();
    QVERIFY2(flight.waitForSession(), flight.gateway->errors().constData());
    QVERIFY(!reader.waitFor("north/vehicle/1/event", isEvent("vehicle")).topic.isEmpty());
    const auto isSealed = [](const Message &message) { return message.json()[QLatin1String("sealed")].toBool(); };
    const QJsonObject state = reader.waitFor("north/vehicle/1/state", isSealed).json();
    QCOMPARE(state[QLatin1String("peer")].toString(), QStringLiteral("air-1"));
    QCOMPARE(state[QLatin1String("sysid")].toInt(), 1);
    const QString suite = GatewayFlight::suites().first(); // not the one of the start
    QCOMPARE(flight.control({QStringLiteral("switch"), suite}).status, 0);
    const QJsonObject switched = reader.waitFor("north/vehicle/1/event", isEvent("switch")).json();
    QCOMPARE(switched[QLatin1String("to")].toString(), suite);
    QCOMPARE(switched, flight.gateway->waitFor(QStringLiteral("switch"))); // the form is that of --json
    flight.sim->kill();
    flight.air->kill();
    QVERIFY(!reader.waitFor("north/vehicle/1/event", isEvent("vehicle_lost")).topic.isEmpty());
    const RunResult status = flight.control({QStringLiteral("status")});
    QVERIFY2(status.out.contains("broker connected: "), status.out.constData());
    QVERIFY2(flight.gateway->terminate() == 0, flight.gateway->errors().constData());
    QVERIFY(!reader.waitFor("north/gateway/state", isState("offline")).topic.isEmpty());
}

void MqttBrokerTest::framesArePublishedWhereAskedFor()
{
    Mosquitto mosquitto(*m_authority);
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    QVERIFY(reader.waitUntilSubscribed());
    for (const bool raw : {true, false}) {
        GatewayFlight flight({QStringLiteral("udpin:0")},
                             broker(*m_authority, mosquitto.port) << (raw ? "mqtt-raw = yes" : "mqtt-raw = no"));
        flight.startSimulatedVehicle();
        int frames = 0;
        const auto wholeFrames = [&frames](const Message &message) {
            qsizetype bytes = 0;
            mavlink::scanFrames(asBytes(message.payload.toStdString()), mavlink::Dialect::builtin(),
                                [&](const mavlink::ScanItem &item) {
                                    frames += item.frame && item.frame->systemId() == 1;
                                    bytes += mavlink::isWholeFrame(item) ? qsizetype(item.bytes.size()) : 0;
                                });
            return bytes != message.payload.size() || frames > 100; // stop at the first damaged one
        };
        if (raw) {
            QVERIFY(!reader.waitFor("north/vehicle/1/mavlink", wholeFrames).topic.isEmpty());
            QVERIFY(frames > 100);
            continue;
        }
        QVERIFY(!reader.waitFor("north/gateway/state", isState("offline")).topic.isEmpty()); // the last of the first gateway
        reader.messages.clear();
        for (int i = 0; i < 4; ++i)
            QVERIFY(!reader.waitFor("north/vehicle/1/state").topic.isEmpty());
        for (const Message &message : reader.messages)
            QVERIFY(!message.topic.endsWith("mavlink"));
    }
}

void MqttBrokerTest::deathOfTheGatewayIsTold()
{
    Mosquitto mosquitto(*m_authority);
    GatewayFlight flight({QStringLiteral("udpin:0")}, broker(*m_authority, mosquitto.port));
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    QVERIFY(!reader.waitFor("north/gateway/state", isState("online")).topic.isEmpty());
    flight.gateway->kill();
    QVERIFY(!reader.waitFor("north/gateway/state", isState("offline")).topic.isEmpty());
    MqttReader later(mosquitto.port, m_authority->clientSettings("dashboard"));
    const Message told = later.waitFor("north/gateway/state");
    QVERIFY(told.retained && isState("offline")(told));
}

void MqttBrokerTest::brokerMayRestart()
{
    Mosquitto mosquitto(*m_authority);
    GatewayFlight flight({QStringLiteral("udpin:0")}, broker(*m_authority, mosquitto.port));
    const auto is = [](const char *state) {
        return [state](const QJsonObject &event) { return event[QLatin1String("state")].toString() == QLatin1String(state); };
    };
    QVERIFY(!flight.gateway->waitFor(QStringLiteral("mqtt"), is("connected")).isEmpty());
    mosquitto.stop();
    const QJsonObject waiting = flight.gateway->waitFor(QStringLiteral("mqtt"), is("waiting"));
    QVERIFY(!waiting[QLatin1String("problem")].toString().isEmpty());
    flight.startSimulatedVehicle(); // flies meanwhile
    QVERIFY(flight.waitForSession());
    QVERIFY(mosquitto.start());
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    QVERIFY(!reader.waitFor("north/vehicle/1/event", isEvent("vehicle")).topic.isEmpty()); // it waited
    QVERIFY(!reader.waitFor("north/vehicle/1/state").topic.isEmpty());
    const auto connected = [&flight] {
        const RunResult result = flight.control({QStringLiteral("status"), QStringLiteral("--json")});
        const QJsonObject mqtt = QJsonDocument::fromJson(result.out)[QLatin1String("status")][QLatin1String("mqtt")].toObject();
        return mqtt[QLatin1String("connected")].toBool() && mqtt[QLatin1String("connections")].toInt() == 2
            && mqtt[QLatin1String("state")][QLatin1String("dropped")].toInt(-1) >= 0;
    };
    EVENTUALLY(connected());
}

void MqttBrokerTest::passwordOpensTheBroker()
{
    const QString users = m_authority->path(QStringLiteral("users"));
    QCOMPARE(runToItsEnd(QStringLiteral("mosquitto_passwd"),
                         {QStringLiteral("-c"), QStringLiteral("-b"), users, QStringLiteral("north"), QStringLiteral("sesame")})
                 .status,
             0);
    // A second listener, for users with a password: the settings of the first are not its own.
    const quint16 port = freeTcpPort();
    const QByteArray folder = m_authority->folder().toLocal8Bit();
    Mosquitto mosquitto(*m_authority,
                        "listener " + QByteArray::number(port) + " 127.0.0.1\ncafile " + folder + "ca.crt\ncertfile " + folder
                            + "broker.crt\nkeyfile " + folder + "broker.key\npassword_file " + users.toLocal8Bit() + '\n');
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    QVERIFY(reader.waitUntilSubscribed());
    for (const char *password : {"wrong", "sesame"}) {
        QFile login(m_authority->path(QStringLiteral("login")));
        QVERIFY(login.open(QIODevice::WriteOnly));
        login.write("north\n" + QByteArray(password) + '\n');
        login.close();
        login.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        GatewayFlight flight({QStringLiteral("udpin:0")},
                             {"mqtt = mqtts://127.0.0.1:" + QByteArray::number(port) + "/north",
                              "mqtt-ca = " + folder + "ca.crt", "mqtt-login = " + folder + "login"});
        const QJsonObject event = flight.gateway->waitFor(QStringLiteral("mqtt"));
        if (QByteArray(password) == "sesame") {
            QCOMPARE(event[QLatin1String("state")].toString(), QStringLiteral("connected"));
            QVERIFY(!reader.waitFor("north/gateway/state", isState("online")).topic.isEmpty());
        } else {
            QVERIFY2(event[QLatin1String("problem")].toString().contains(QLatin1String("not authorised")),
                     QJsonDocument(event).toJson().constData());
            QVERIFY(flight.gateway->running());
        }
    }
}

void MqttBrokerTest::falseBrokerLearnsNothing_data()
{
    QTest::addColumn<QByteArray>("host");
    QTest::addColumn<bool>("ownAuthority");
    QTest::newRow("certificate of another authority") << QByteArray("127.0.0.1") << false;
    QTest::newRow("certificate of another host") << QByteArray("localhost") << true;
}

void MqttBrokerTest::falseBrokerLearnsNothing()
{
    QFETCH(QByteArray, host);
    QFETCH(bool, ownAuthority);
    Authority other;
    other.certify("broker");
    Mosquitto mosquitto(ownAuthority ? *m_authority : other);
    QByteArrayList options = broker(*m_authority, mosquitto.port);
    options[0].replace("127.0.0.1", host);
    GatewayFlight flight({QStringLiteral("udpin:0")}, options);
    const QJsonObject event = flight.gateway->waitFor(QStringLiteral("mqtt"));
    QCOMPARE(event[QLatin1String("state")].toString(), QStringLiteral("waiting"));
    QVERIFY2(event[QLatin1String("problem")].toString().contains(QLatin1String("certificate verify failed")),
             QJsonDocument(event).toJson().constData());
}

/// The configuration that we ship lets no gateway speak for another, nor read.
void MqttBrokerTest::gatewayWritesBelowItsNameOnly()
{
    Mosquitto mosquitto(*m_authority);
    MqttReader reader(mosquitto.port, m_authority->clientSettings("dashboard"));
    MqttReader spy(mosquitto.port, m_authority->clientSettings("south"));
    QVERIFY(reader.waitUntilSubscribed());
    GatewayFlight wrong({QStringLiteral("udpin:0")}, broker(*m_authority, mosquitto.port, "south")); // publishes below north/
    QVERIFY(!wrong.gateway->waitFor(QStringLiteral("mqtt")).isEmpty());
    wrong.startSimulatedVehicle();
    QVERIFY(wrong.waitForSession());
    const auto published = [&wrong] {
        const RunResult result = wrong.control({QStringLiteral("status"), QStringLiteral("--json")});
        return QJsonDocument::fromJson(
                   result.out)[QLatin1String("status")][QLatin1String("mqtt")][QLatin1String("state")][QLatin1String("sent")]
                   .toInt()
            > 2;
    };
    EVENTUALLY(published());
    GatewayFlight right({QStringLiteral("udpin:0")}, broker(*m_authority, mosquitto.port));
    QVERIFY(!reader.waitFor("north/gateway/state").topic.isEmpty());
    for (const Message &message : reader.messages)
        QVERIFY2(!message.topic.contains("vehicle"), message.topic.constData());
    QVERIFY(spy.messages.empty());
}

void MqttBrokerTest::wrongSetUpsAreExplained_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, const char *options, int status, const char *text) {
        QTest::newRow(name) << QString::fromLatin1(options).split(QLatin1Char(' ')) << status << QString::fromLatin1(text);
    };
    const char *kTls = "--mqtt mqtts://127.0.0.1/north --mqtt-ca F/ca.crt";
    row("no URL", "--mqtt broker", 2, "mqtts://HOST[:PORT][/PREFIX]");
    row("password in the URL", "--mqtt mqtts://me:sesame@host", 2, "--mqtt-login");
    row("no broker", "--mqtt-raw", 2, "--mqtt-raw requires --mqtt");
    row("authority without TLS", "--mqtt mqtt://127.0.0.1 --mqtt-ca F/ca.crt", 2, "--mqtt-ca: mqtt:// has no TLS");
    row("certificate without key", "--mqtt mqtts://127.0.0.1 --mqtt-cert F/north.crt", 2, "require each other");
    row("missing authority", "--mqtt mqtts://127.0.0.1 --mqtt-ca F/none.crt", 3, "none.crt: cannot be read");
    row("key as authority", "--mqtt mqtts://127.0.0.1 --mqtt-ca F/ca.key", 3,
        "ca.key: cannot be read, or holds no certificate");
    const auto tls = [&](const char *name, const char *options, const char *text) {
        row(name, (QByteArray(kTls) + ' ' + options).constData(), 3, text);
    };
    tls("key of another certificate", "--mqtt-cert F/north.crt --mqtt-key F/south.key", "south.key: this private key does not");
    tls("certificate as key", "--mqtt-cert F/north.crt --mqtt-key F/secret.crt", "secret.crt: holds no private key");
    tls("key that others can read", "--mqtt-cert F/north.crt --mqtt-key F/open.key", "open.key: ");
    tls("sealed key", "--mqtt-cert F/north.crt --mqtt-key F/sealed.key", "sealed.key: holds no private key in PEM that can be");
    tls("missing login", "--mqtt-login F/none", "none: ");
    row("no TLS over the network", "--mqtt mqtt://192.0.2.1 --mqtt-login F/none", 3,
        "without TLS: anyone on the path can read and forge the states of the vehicles, and read the password");
}

void MqttBrokerTest::wrongSetUpsAreExplained()
{
    QFETCH(QStringList, options);
    QFETCH(int, status);
    QFETCH(QString, text);
    const auto copy = [this](const char *from, const char *to, QFile::Permissions permissions) {
        const QString target = m_authority->path(QLatin1String(to));
        if (!QFile::exists(target))
            QVERIFY(QFile::copy(m_authority->path(QLatin1String(from)), target));
        QFile::setPermissions(target, permissions);
    };
    copy("north.crt", "secret.crt", QFile::ReadOwner | QFile::WriteOwner);
    copy("north.key", "open.key", QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther);
    if (!QFile::exists(m_authority->path(QStringLiteral("sealed.key"))))
        m_authority->openssl({"pkcs8", "-topk8", "-passout", "pass:sesame", "-in", "north.key", "-out", "sealed.key"});
    QFile::setPermissions(m_authority->path(QStringLiteral("sealed.key")), QFile::ReadOwner | QFile::WriteOwner);
    Flight flight;
    QVERIFY(flight.ready());
    for (QString &option : options)
        option.replace(QLatin1String("F/"), m_authority->folder());
    const RunResult result = runProgram("skyseal-cli",
                                        QStringList{QStringLiteral("gateway"), QStringLiteral("--link"),
                                                    QStringLiteral("udpin:127.0.0.1:0"), QStringLiteral("--identity"),
                                                    flight.path(QStringLiteral("ground.key")), QStringLiteral("--peers"),
                                                    flight.path(QStringLiteral("ground.peers")), QStringLiteral("--no-record"),
                                                    QStringLiteral("--serve"), QStringLiteral("udpin:0")}
                                            + options);
    QVERIFY2(result.status == status, result.err.constData());
    QVERIFY2(result.err.contains(text.toLatin1()), result.err.constData());
    QVERIFY2(!result.err.contains("sesame"), result.err.constData());
}

SKYSEAL_TEST(MqttBrokerTest)
#include "mqtt_broker_test.moc"
