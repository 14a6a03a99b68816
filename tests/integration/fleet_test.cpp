// Two hundred simulated vehicles behind ten agents and ten gateways, which publish to one broker on this machine over TLS:
// no frame is lost between vehicle and gateway, each message that a gateway sent reaches the reader, none is dropped, memory
// does not grow. Prints what a vehicle costs.
#include "tests/support/gateway_flight.h"
#include "tests/support/mosquitto.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/process_figures.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

#include <unistd.h>

using namespace skyseal::test;

namespace {

constexpr int kGateways = 10, kVehiclesEach = 20;

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Seconds of CPU time that a process or thread has used, by its "stat" in proc(5).
double cpuSeconds(const QString &stat)
{
    const QByteArray content = contentOf(stat);
    const QByteArrayList fields = content.mid(content.lastIndexOf(')') + 2).split(' ');
    return fields.size() < 13 ? 0 : (fields[11].toDouble() + fields[12].toDouble()) / double(::sysconf(_SC_CLK_TCK));
}

double cpuOf(qint64 pid)
{
    return cpuSeconds(QStringLiteral("/proc/%1/stat").arg(pid));
}

/// Of the thread of this name.
double cpuOfThread(qint64 pid, const char *name)
{
    const QString tasks = QStringLiteral("/proc/%1/task/").arg(pid);
    for (const QString &task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (contentOf(tasks + task + QStringLiteral("/comm")).trimmed() == name)
            return cpuSeconds(tasks + task + QStringLiteral("/stat"));
    }
    return 0;
}

double residentMegabytes(qint64 pid)
{
    return double(statusKilobytes(pid, "VmRSS")) * 1024 / 1e6;
}

struct Usage
{
    double gateways = 0, publishers = 0, agents = 0, broker = 0; ///< seconds of CPU time
    double gatewayMegabytes = 0, brokerMegabytes = 0;            ///< of the largest gateway, of the broker
};

/// A gateway with its agent and its vehicles.
struct Member
{
    Member(int number, const Authority &authority, quint16 broker, bool raw)
        : prefix("g" + QByteArray::number(number)),
          flight({QStringLiteral("udpin:0")},
                 {"mqtt = mqtts://127.0.0.1:" + QByteArray::number(broker) + '/' + prefix,
                  "mqtt-ca = " + authority.path(QStringLiteral("ca.crt")).toLocal8Bit(),
                  "mqtt-cert = " + authority.path(QString::fromLatin1(prefix + ".crt")).toLocal8Bit(),
                  "mqtt-key = " + authority.path(QString::fromLatin1(prefix + ".key")).toLocal8Bit(),
                  raw ? "mqtt-raw = yes" : "mqtt-raw = no"})
    {
        QStringList systems; // a peer with more than a few vehicles has to have a list of them
        for (int i = 1; i <= kVehiclesEach; ++i)
            systems << QString::number(number * kVehiclesEach + i);
        const RunResult bound = runProgram("skyseal-cli",
                                           {QStringLiteral("keys"), QStringLiteral("peers"), QStringLiteral("sysids"),
                                            QStringLiteral("--peers"), flight.flight.path(QStringLiteral("ground.peers")),
                                            QStringLiteral("air-1"), systems.join(QLatin1Char(','))});
        if (bound.status != 0)
            qFatal("%s", bound.err.constData());
        const QStringList vehicles{QStringLiteral("--vehicles"), QString::number(kVehiclesEach), QStringLiteral("--sysid"),
                                   QString::number(number * kVehiclesEach + 1)};
        flight.sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), flight.flight.simArguments(vehicles));
        flight.air = std::make_unique<Program>(QStringLiteral("skyseal-air"), flight.flight.airArguments());
    }

    const QByteArray prefix;
    GatewayFlight flight;
};

struct Received
{
    std::map<QByteArray, quint64> states, events, raw; ///< messages of vehicles, by the prefix of their gateway
    std::map<QByteArray, quint64> sealed;              ///< states of sealed vehicles, by topic
    quint64 messages = 0, bytes = 0;                   ///< topics and payloads
};

} // namespace

class FleetTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void twoHundredVehiclesThroughOneBroker_data();
    void twoHundredVehiclesThroughOneBroker();
    void cleanup() { m_members.clear(); }

private:
    Usage usage() const;
    double frames() const;

    std::unique_ptr<Mosquitto> m_mosquitto;
    std::vector<std::unique_ptr<Member>> m_members;
};

void FleetTest::initTestCase()
{
    SKYSEAL_REQUIRES("mosquitto");
}

Usage FleetTest::usage() const
{
    Usage out;
    for (const auto &member : m_members) {
        const qint64 gateway = member->flight.gateway->pid();
        out.gateways += cpuOf(gateway);
        out.publishers += cpuOfThread(gateway, "skyseal-mqtt");
        out.agents += cpuOf(member->flight.air->pid());
        out.gatewayMegabytes = std::max(out.gatewayMegabytes, residentMegabytes(gateway));
    }
    out.broker = cpuOf(m_mosquitto->pid());
    out.brokerMegabytes = residentMegabytes(m_mosquitto->pid());
    return out;
}

/// That the gateways accepted, by their newest statistics.
double FleetTest::frames() const
{
    double out = 0;
    for (const auto &member : m_members) {
        const QJsonObject stats = member->flight.gateway->last(QStringLiteral("stats"));
        out += stats[QLatin1String("mavlink")][QLatin1String("frames")].toDouble();
    }
    return out;
}

void FleetTest::twoHundredVehiclesThroughOneBroker_data()
{
    QTest::addColumn<bool>("raw");
    QTest::newRow("states and events") << false;
    QTest::newRow("frames, too") << true;
}

void FleetTest::twoHundredVehiclesThroughOneBroker()
{
    QFETCH(bool, raw);
    const int seconds = qEnvironmentVariableIntValue("SKYSEAL_FLEET_SECONDS");
    Authority authority;
    authority.certify("broker");
    authority.certify("dashboard");
    for (int i = 0; i < kGateways; ++i)
        authority.certify(("g" + QByteArray::number(i)).constData());
    m_mosquitto = std::make_unique<Mosquitto>(authority);
    MqttReader reader(m_mosquitto->port, authority.clientSettings("dashboard"));
    Received received;
    reader.setTaker([&received](const MqttReader::Message &message) {
        const QByteArrayList levels = message.topic.split('/');
        ++received.messages;
        received.bytes += quint64(message.topic.size() + message.payload.size());
        if (levels.value(1) == "gateway")
            received.events[levels[0]] += levels.value(2) == "event";
        else if (levels.value(3) == "event")
            ++received.events[levels[0]];
        else if (levels.value(3) == "mavlink")
            ++received.raw[levels[0]];
        else if (levels.value(3) == "state" && ++received.states[levels[0]])
            received.sealed[message.topic] += message.payload.contains("\"sealed\":true");
    });
    QVERIFY(reader.waitUntilSubscribed());
    for (int i = 0; i < kGateways; ++i)
        m_members.push_back(std::make_unique<Member>(i, authority, m_mosquitto->port, raw));
    const auto allThere = [&received] {
        return received.sealed.size() == kGateways * kVehiclesEach
            && std::ranges::all_of(received.sealed, [](const auto &topic) { return topic.second >= 20; });
    };
    for (int i = 0; i < 5 && !allThere(); ++i)
        static_cast<void>(eventually(allThere));
    QVERIFY2(allThere(), qPrintable(QString::number(received.sealed.size())));

    const Usage before = usage();
    const Received first = received;
    const double firstFrames = frames();
    QElapsedTimer clock;
    clock.start();
    const int wanted = seconds > 0 ? seconds : 60;
    while (clock.elapsed() < wanted * 1000)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 100);
    const double time = double(clock.elapsed()) / 1000;
    const Usage after = usage();
    const Received last = received;
    const double lastFrames = frames();

    for (const auto &member : m_members) {
        Program &gateway = *member->flight.gateway;
        QVERIFY2(gateway.terminate() == 0, gateway.errors().constData());
        const QJsonObject summary = gateway.last(QStringLiteral("summary"));
        const QJsonObject mavlink = summary[QLatin1String("mavlink")].toObject();
        QVERIFY(mavlink[QLatin1String("frames")].toDouble() > 0);
        for (const char *fault : {"lost", "duplicate", "bad_crc"}) // on the way from the vehicles to the gateway
            QVERIFY2(mavlink[QLatin1String(fault)].toInt(-1) == 0, (member->prefix + ' ' + fault).constData());
        const QJsonObject mqtt = summary[QLatin1String("mqtt")].toObject();
        std::vector<std::pair<const char *, std::map<QByteArray, quint64> *>> kinds{{"state", &received.states},
                                                                                    {"event", &received.events}};
        if (raw)
            kinds.emplace_back("raw", &received.raw);
        for (const auto &[kind, arrived] : kinds) {
            const QJsonObject count = mqtt[QLatin1String(kind)].toObject();
            const auto sent = quint64(count[QLatin1String("sent")].toDouble());
            QVERIFY(sent > 0);
            QCOMPARE(count[QLatin1String("dropped")].toDouble(-1), 0.0);
            const auto allArrived = [&, &messages = *arrived] { return messages[member->prefix] >= sent; };
            EVENTUALLY2(allArrived(), (member->prefix + ' ' + kind).constData());
        }
        QCOMPARE(mqtt[QLatin1String("connections")].toInt(), 1);
    }

    const double vehicles = kGateways * kVehiclesEach, vehicleSeconds = vehicles * time;
    const auto perVehicle = [&](double Usage::*part) { return (after.*part - before.*part) / vehicleSeconds * 1e3; };
    double load = 0;
    ::getloadavg(&load, 1);
    qInfo("%.0f vehicles, %d gateways, %.0f s, load of the machine %.1f", vehicles, kGateways, time, load);
    qInfo("per vehicle and second: %.1f frames received, %.2f messages published, %.0f bytes",
          (lastFrames - firstFrames) / vehicleSeconds, double(last.messages - first.messages) / vehicleSeconds,
          double(last.bytes - first.bytes) / vehicleSeconds);
    qInfo("CPU time per vehicle and second, ms: gateway %.3f, of it publishing %.3f; broker %.3f; agent %.3f",
          perVehicle(&Usage::gateways), perVehicle(&Usage::publishers), perVehicle(&Usage::broker), perVehicle(&Usage::agents));
    qInfo("resident MB, before and after: largest gateway %.1f %.1f, broker %.1f %.1f", before.gatewayMegabytes,
          after.gatewayMegabytes, before.brokerMegabytes, after.brokerMegabytes);
    QVERIFY(after.gatewayMegabytes < before.gatewayMegabytes + 4);
    QVERIFY(after.brokerMegabytes < before.brokerMegabytes + 4);
}

SKYSEAL_TEST(FleetTest)
#include "fleet_test.moc"
