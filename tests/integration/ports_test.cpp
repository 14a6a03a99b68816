// Two programs on one port: the second reports it in one line and ends with status 3; the first is not affected.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::test;

class PortsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void secondMonitorOnOnePort();
    void badLinksAreNamed_data();
    void badLinksAreNamed();
    void linkThatNeverOpened();
    void agentsClearSideListensOnLoopback();
};

void PortsTest::secondMonitorOnOnePort()
{
    const QString link = QStringLiteral("udpin:127.0.0.1:%1").arg(freeUdpPort());
    const QStringList arguments{QStringLiteral("monitor"),  QStringLiteral("--link"), link,
                                QStringLiteral("--secure"), QStringLiteral("off"),    QStringLiteral("--json")};
    Program first(QStringLiteral("skyseal-cli"), arguments);
    QVERIFY(!first.waitFor(QStringLiteral("link")).isEmpty());
    Program second(QStringLiteral("skyseal-cli"), arguments);
    QCOMPARE(second.waitForExit(), 3);
    QCOMPARE(second.errors().trimmed().count('\n'), 0);
    QVERIFY2(second.errors().contains("in use"), second.errors().constData());
    QVERIFY(second.errors().contains(link.section(QLatin1Char(':'), 2).toUtf8()));
    QVERIFY(first.running());
    QCOMPARE(first.terminate(), 0);
}

void PortsTest::badLinksAreNamed_data()
{
    QTest::addColumn<QString>("url");
    QTest::addColumn<int>("status");
    QTest::newRow("scheme") << QStringLiteral("carrier-pigeon:coop:1") << 2;
    QTest::newRow("port") << QStringLiteral("udpin:127.0.0.1:99999") << 2;
    QTest::newRow("missing file") << QStringLiteral("tlog:/nonexistent/flight.tlog") << 3;
}

void PortsTest::badLinksAreNamed()
{
    QFETCH(QString, url);
    QFETCH(int, status);
    Program monitor(
        QStringLiteral("skyseal-cli"),
        {QStringLiteral("monitor"), QStringLiteral("--link"), url, QStringLiteral("--secure"), QStringLiteral("off")});
    QCOMPARE(monitor.waitForExit(), status);
    QVERIFY2(!monitor.errors().trimmed().isEmpty(), "no word said");
}

void PortsTest::linkThatNeverOpened()
{
    // Both might have come up later; when the time is over, nothing was reached, and a script should notice.
    for (const QString &url : {QStringLiteral("tcp:127.0.0.1:1"), QStringLiteral("serial:/dev/nonexistent:57600")}) {
        Program monitor(
            QStringLiteral("skyseal-cli"),
            {QStringLiteral("monitor"), QStringLiteral("--link"), url, QStringLiteral("--duration"), QStringLiteral("1")});
        QCOMPARE(monitor.waitForExit(), 3);
        QVERIFY2(monitor.errors().contains(url.toUtf8()), monitor.errors().constData());
    }
}

void PortsTest::agentsClearSideListensOnLoopback()
{
    const Flight flight;
    QVERIFY(flight.ready());
    for (const char *scheme : {"udpin", "tcpin"}) {
        QStringList arguments = flight.airArguments();
        arguments[1] = QLatin1String(scheme) + QStringLiteral(":0");
        Program air(QStringLiteral("skyseal-air"), arguments);
        const QJsonObject link = air.waitFor(QStringLiteral("link"), [](const QJsonObject &event) {
            return event[QLatin1String("side")].toString() == QLatin1String("vehicle")
                && event[QLatin1String("state")].toString() == QLatin1String("listening");
        });
        const QString address = link[QLatin1String("address")].toString();
        QVERIFY2(address.startsWith(QLatin1String("127.0.0.1:")), qPrintable(address));
    }
}

SKYSEAL_TEST(PortsTest)
#include "ports_test.moc"
