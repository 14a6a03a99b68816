// Addresses of brokers, and errors that say what is wrong with one.
#include "core/mqtt/broker_url.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::mqtt;

class BrokerUrlTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsHostPortAndPrefix_data();
    void readsHostPortAndPrefix();
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void showsNoPassword();
    void knowsThisMachine();
};

void BrokerUrlTest::readsHostPortAndPrefix_data()
{
    QTest::addColumn<QString>("whole");
    QTest::newRow("mqtts://broker.example") << "mqtts://broker.example:8883/skyseal";
    QTest::newRow("mqtt://127.0.0.1") << "mqtt://127.0.0.1:1883/skyseal";
    QTest::newRow("mqtt://127.0.0.1/") << "mqtt://127.0.0.1:1883/skyseal";
    QTest::newRow("mqtts://broker:1234/fleet/north") << "mqtts://broker:1234/fleet/north";
    QTest::newRow("mqtts://[::1]:65535/x") << "mqtts://[::1]:65535/x";
    QTest::newRow("mqtts://[2001:db8::1]") << "mqtts://[2001:db8::1]:8883/skyseal";
}

void BrokerUrlTest::readsHostPortAndPrefix()
{
    QFETCH(QString, whole);
    const auto url = BrokerUrl::parse(QTest::currentDataTag());
    QVERIFY2(url, url ? "" : url.error().text().c_str());
    QCOMPARE(QString::fromStdString(url->toText()), whole);
    const auto again = BrokerUrl::parse(url->toText());
    QVERIFY(again && again->toText() == url->toText());
}

void BrokerUrlTest::saysWhatIsWrong_data()
{
    QTest::addColumn<QString>("problem");
    QTest::newRow("") << "mqtts://HOST";
    QTest::newRow("broker.example") << "mqtts://HOST";
    QTest::newRow("http://broker") << "mqtts://HOST";
    QTest::newRow("mqtts://") << "a host is expected";
    QTest::newRow("mqtts:///fleet") << "a host is expected";
    QTest::newRow("mqtts://[::1") << "a host is expected";
    QTest::newRow("mqtts://[::1]8883") << "a host is expected";
    QTest::newRow("mqtts://bro\nker") << "a host is expected";
    QTest::newRow("mqtts://broker:0") << "a port";
    QTest::newRow("mqtts://broker:65536") << "a port";
    QTest::newRow("mqtts://broker:88x") << "a port";
    QTest::newRow("mqtts://2001:db8::1") << "a port";
    QTest::newRow("mqtts://broker/fleet/#") << "prefix";
    QTest::newRow("mqtts://broker/+/x") << "prefix";
    QTest::newRow("mqtts://broker/$SYS") << "prefix";
    QTest::newRow("mqtts://broker/fleet/") << "prefix";
    QTest::newRow("mqtts://broker//fleet") << "prefix";
    QTest::newRow("mqtts://broker/a\tb") << "prefix";
    QTest::newRow(("mqtts://broker/" + QByteArray(129, 'x')).constData()) << "prefix";
}

void BrokerUrlTest::saysWhatIsWrong()
{
    QFETCH(QString, problem);
    const auto url = BrokerUrl::parse(QTest::currentDataTag());
    QVERIFY(!url);
    QVERIFY2(url.error().message.text().find(problem.toStdString()) != std::string::npos, url.error().text().c_str());
}

void BrokerUrlTest::showsNoPassword()
{
    const auto url = BrokerUrl::parse("mqtts://pilot:sesame@broker");
    QVERIFY(!url);
    QVERIFY2(url.error().text().find("--mqtt-login") != std::string::npos, url.error().text().c_str());
    QVERIFY2(url.error().text().find("sesame") == std::string::npos, url.error().text().c_str());
}

void BrokerUrlTest::knowsThisMachine()
{
    for (const char *here : {"mqtt://localhost", "mqtt://127.1.2.3", "mqtt://[::1]"})
        QVERIFY2(BrokerUrl::parse(here)->isLoopback(), here);
    for (const char *elsewhere : {"mqtt://10.0.0.1", "mqtt://128.0.0.1", "mqtt://broker", "mqtt://127.example", "mqtt://[::2]"})
        QVERIFY2(!BrokerUrl::parse(elsewhere)->isLoopback(), elsewhere);
}

SKYSEAL_TEST_APPLESS(BrokerUrlTest)
#include "broker_url_test.moc"
