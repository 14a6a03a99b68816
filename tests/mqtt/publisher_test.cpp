// The client of an MQTT broker against a broker of the test, which can be slow, silent, refuse or go away.
#include "core/mqtt/publisher.h"

#include "core/mqtt/publish_queue.h"
#include "core/mqtt/topics.h"
#include "tests/support/eventually.h"
#include "tests/support/mqtt_broker.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

using namespace skyseal;
using namespace skyseal::mqtt;
using namespace skyseal::test;

namespace {

struct Rig
{
    MqttBroker broker;
    PublisherConfig config{.broker = *BrokerUrl::parse(broker.url().toStdString())};
    std::unique_ptr<Publisher> publisher;

    bool start()
    {
        auto created = Publisher::create(config);
        if (!created)
            qFatal("%s", created.error().text().c_str());
        publisher = std::move(*created);
        return eventually([this] { return publisher->status().connected; });
    }
    /// The broker answers meanwhile.
    bool end()
    {
        std::atomic<bool> ended = false;
        std::thread ending([this, &ended] { // ThreadSanitizer does not see the end of a QThread
            publisher.reset();
            ended = true;
        });
        const bool inTime = eventually([&ended] { return ended.load(); });
        ending.join();
        return inTime;
    }
    std::size_t received(const QByteArray &topic) const { return broker.payloadsOf(topic).size(); }
};

const QByteArray kOnline = R"({"event":"gateway","state":"online"})", kOffline = R"({"event":"gateway","state":"offline"})";

} // namespace

class PublisherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void announcesItselfAndItsEnd();
    void publishesEachKindAsItShould();
    void loginComesFromAFile();
    void refusalIsReported();
    void absentBrokerIsTriedAgain();
    void eventsAreRepeatedUntilConfirmed();
    void slowBrokerCostsNoMemoryAndNoCount();
    void silentBrokerEndsNothing();
    void nothingOfTheBrokerIsObeyed();
    void wrongFilesAreNamed_data();
    void wrongFilesAreNamed();
};

void PublisherTest::announcesItselfAndItsEnd()
{
    Rig rig;
    QVERIFY(rig.start());
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"), std::size_t(1));
    const MqttBroker::Client client = rig.broker.clients.at(0);
    QVERIFY(client.id.startsWith("skyseal-") && client.id.size() == 20);
    QCOMPARE(client.keepAlive, Publisher::kKeepAliveSeconds);
    QCOMPARE(client.willTopic, QByteArray("fleet/gateway/state"));
    QCOMPARE(client.willPayload, kOffline);
    QCOMPARE(client.willQos, 1);
    QVERIFY(client.willRetained);
    rig.publisher->putEvent("gateway/event", "last");
    QVERIFY(rig.end());
    EVENTUALLY(rig.broker.packets.contains(MqttBroker::Disconnect));
    QCOMPARE(rig.broker.payloadsOf("fleet/gateway/state"), (std::vector<QByteArray>{kOnline, kOffline}));
    QCOMPARE(rig.received("fleet/gateway/event"), std::size_t(1)); // what waited was published before
    for (const MqttBroker::Published &message : rig.broker.published) {
        if (message.topic.endsWith("state"))
            QVERIFY(message.retained && message.qos == 1);
    }
}

void PublisherTest::publishesEachKindAsItShould()
{
    Rig rig;
    QVERIFY(rig.start());
    rig.publisher->putState(vehicleState(7), "state");
    rig.publisher->putEvent(vehicleEvent(7), "event");
    rig.publisher->putRaw(7, asBytes("frame"));
    rig.publisher->putRaw(7, asBytes("frame"));
    const auto frames = [&rig] { // in one message, or in two
        QByteArray out;
        for (const QByteArray &payload : rig.broker.payloadsOf("fleet/vehicle/7/mavlink"))
            out += payload;
        return out;
    };
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/7/state"), std::size_t(1));
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/7/event"), std::size_t(1));
    EVENTUALLY_EQUAL(frames(), QByteArray("frameframe"));
    for (const MqttBroker::Published &message : rig.broker.published) {
        const bool isState = message.topic == "fleet/vehicle/7/state", isEvent = message.topic == "fleet/vehicle/7/event";
        if (isState || isEvent)
            QCOMPARE(message.payload, QByteArray(isState ? "state" : "event"));
        if (message.topic.startsWith("fleet/vehicle/")) {
            QCOMPARE(message.retained, isState);
            QCOMPARE(message.qos, isEvent ? 1 : 0);
        }
    }
    EVENTUALLY_EQUAL(rig.publisher->status().event.sent, std::uint64_t(1));
    const PublisherStatus status = rig.publisher->status();
    QCOMPARE(status.state.sent, std::uint64_t(1));
    QVERIFY(status.raw.sent >= 1);
    QCOMPARE(status.state.dropped + status.event.dropped + status.raw.dropped, std::uint64_t(0));
}

void PublisherTest::loginComesFromAFile()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("login")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("gateway\nsesame street\n") > 0);
    file.close();
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    Rig rig;
    rig.config.loginFile = file.fileName().toStdString();
    QVERIFY(rig.start());
    QCOMPARE(rig.broker.clients.at(0).user, QByteArray("gateway"));
    QCOMPARE(rig.broker.clients.at(0).password, QByteArray("sesame street"));
}

void PublisherTest::refusalIsReported()
{
    Rig rig;
    rig.broker.code = 5; // not authorized, section 3.2.2.3
    auto created = Publisher::create(rig.config);
    QVERIFY(created);
    rig.publisher = std::move(*created);
    const auto isRefused = [&rig] { return rig.publisher->status().problem.find("not authorised") != std::string::npos; };
    EVENTUALLY2(isRefused(), rig.publisher->status().problem.c_str());
    QVERIFY(!rig.publisher->status().connected);
    rig.broker.code = 0;
    EVENTUALLY(rig.publisher->status().connected);
    QCOMPARE(rig.publisher->status().problem, std::string());
}

void PublisherTest::absentBrokerIsTriedAgain()
{
    Rig rig;
    rig.broker.stopListening();
    auto created = Publisher::create(rig.config);
    QVERIFY(created);
    rig.publisher = std::move(*created);
    const auto isRefused = [&rig] { return rig.publisher->status().problem == "Connection refused"; };
    EVENTUALLY2(isRefused(), rig.publisher->status().problem.c_str());
    for (int i = 0; i < 3; ++i)
        rig.publisher->putState(vehicleState(1), std::to_string(i));
    rig.publisher->putEvent(vehicleEvent(1), "waited");
    rig.broker.listen();
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/event"), std::size_t(1));
    EVENTUALLY_EQUAL(rig.broker.payloadsOf("fleet/vehicle/1/state"), std::vector<QByteArray>{"2"}); // the newest one
    QCOMPARE(rig.publisher->status().state.dropped, std::uint64_t(2));
    rig.broker.drop(); // and again
    EVENTUALLY_EQUAL(rig.publisher->status().connections, std::uint64_t(2));
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"), std::size_t(2)); // online
}

void PublisherTest::eventsAreRepeatedUntilConfirmed()
{
    Rig rig;
    QVERIFY(rig.start());
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"), std::size_t(1));
    rig.broker.confirming = false;
    rig.publisher->putEvent(vehicleEvent(1), "once");
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/event"), std::size_t(1));
    rig.broker.drop();
    rig.broker.confirming = true;
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/event"), std::size_t(2));
    const auto isRepeated = [](const MqttBroker::Published &message) {
        return message.topic.endsWith("event") && message.again;
    };
    QVERIFY(std::ranges::any_of(rig.broker.published, isRepeated));
    EVENTUALLY_EQUAL(rig.publisher->status().event.sent, std::uint64_t(1));
    QCOMPARE(rig.publisher->status().event.dropped, std::uint64_t(0));
}

/// All that does not fit is counted, and all else arrives when the broker goes on.
void PublisherTest::slowBrokerCostsNoMemoryAndNoCount()
{
    Rig rig;
    QVERIFY(rig.start());
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"), std::size_t(1));
    rig.broker.setReading(false);
    const std::string large(2000, 'x');
    std::uint64_t events = 0, states = 0;
    const auto flood = [&] {
        for (std::uint8_t system = 1; system <= 250; ++system) {
            rig.publisher->putState(vehicleState(system), large);
            ++states;
        }
        for (int i = 0; i < 100; ++i) {
            rig.publisher->putEvent(vehicleEvent(1), large);
            ++events;
        }
        rig.publisher->putRaw(1, asBytes(std::string_view(large).substr(0, 280)));
        const PublisherStatus status = rig.publisher->status();
        return status.state.dropped > 100 && status.event.dropped > 100 && status.raw.dropped > 0;
    };
    EVENTUALLY(flood());
    QVERIFY(rig.publisher->status().connected);
    rig.broker.setReading(true);
    const auto drained = [&] {
        const PublisherStatus status = rig.publisher->status();
        return status.event.sent + status.event.dropped == events && status.state.sent + status.state.dropped == states;
    };
    EVENTUALLY(drained());
    const PublisherStatus status = rig.publisher->status();
    const auto arrived = [&] {
        std::size_t out = 0;
        for (int system = 1; system <= 250; ++system)
            out += rig.received("fleet/vehicle/" + QByteArray::number(system) + "/state");
        return out;
    };
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/event"), std::size_t(status.event.sent));
    EVENTUALLY_EQUAL(arrived(), std::size_t(status.state.sent));
}

void PublisherTest::silentBrokerEndsNothing()
{
    Rig rig;
    QVERIFY(rig.start());
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"),
                     std::size_t(1)); // and confirmed: it is none of those that are counted
    rig.broker.confirming = false;    // so that the end has to be abandoned
    for (int i = 0; i < 100; ++i)
        rig.publisher->putEvent(vehicleEvent(1), "e");
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/event"), Publisher::kMostUnconfirmed);
    rig.publisher.reset(); // while this thread, and with it the broker, stands still
}

void PublisherTest::nothingOfTheBrokerIsObeyed()
{
    Rig rig;
    QVERIFY(rig.start());
    EVENTUALLY_EQUAL(rig.received("fleet/gateway/state"), std::size_t(1));
    const QByteArray topic = "fleet/vehicle/1/command", payload(1000, 'x');
    for (const char flags : {'\x30', '\x32'}) { // QoS 0 and 1, section 3.3
        const QByteArray id = flags == '\x30' ? QByteArray() : QByteArray("\x00\x01", 2);
        const QByteArray body = QByteArray(1, '\0') + char(topic.size()) + topic + id + payload;
        const char length[] = {static_cast<char>(0x80 | (body.size() & 0x7f)), static_cast<char>(body.size() >> 7)};
        rig.broker.send(QByteArray(1, flags) + QByteArray(length, 2) + body);
    }
    EVENTUALLY(rig.broker.packets.contains(MqttBroker::PubAck)); // it was received
    rig.publisher->putState(vehicleState(1), "unmoved");
    EVENTUALLY_EQUAL(rig.received("fleet/vehicle/1/state"), std::size_t(1));
    rig.broker.drop();
    EVENTUALLY_EQUAL(rig.publisher->status().connections, std::uint64_t(2));
    rig.broker.send(QByteArray("\x82\x05garbage", 9)); // no packet of a broker: the connection ends
    EVENTUALLY_EQUAL(rig.publisher->status().connections, std::uint64_t(3));
    QVERIFY(rig.end());
    EVENTUALLY(rig.broker.packets.contains(MqttBroker::Disconnect));
    const std::set<int> allowed{MqttBroker::Connect, MqttBroker::Publish, MqttBroker::PubAck, MqttBroker::PingReq,
                                MqttBroker::Disconnect};
    for (const int packet : rig.broker.packets)
        QVERIFY2(allowed.contains(packet), qPrintable(QString::number(packet))); // and above all no SUBSCRIBE
}

void PublisherTest::wrongFilesAreNamed_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("problem");
    QTest::newRow("empty") << QByteArray() << "a user in the first line";
    QTest::newRow("no password") << QByteArray("gateway") << "a user in the first line";
    QTest::newRow("no user") << QByteArray("\nsesame\n") << "a user in the first line";
    QTest::newRow("binary") << QByteArray("gate\0way\nsesame\n", 16) << "a user in the first line";
    QTest::newRow("no UTF-8") << QByteArray("gate\xffway\nsesame\n") << "a user in the first line";
}

void PublisherTest::wrongFilesAreNamed()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, problem);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("login")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    file.close();
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    PublisherConfig config{.broker = *BrokerUrl::parse("mqtt://127.0.0.1:1")};
    config.loginFile = file.fileName().toStdString();
    const auto created = Publisher::create(config);
    QVERIFY(!created);
    QVERIFY2(created.error().message.text().find(problem.toStdString()) != std::string::npos, created.error().text().c_str());
    QCOMPARE(created.error().source, config.loginFile);
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther);
    const auto open = Publisher::create(config);
    QVERIFY(!open && open.error().source == config.loginFile && open.error().message != created.error().message);
}

SKYSEAL_TEST(PublisherTest)
#include "publisher_test.moc"
