// Frames sealed in place between real programs over real sockets, watched on the wire: the four suites that can do it in
// turn, both directions, nothing lost; and no inline frame without the agent's consent.
#include "tests/support/flight.h"
#include "tests/support/record_counters.h"
#include "tests/support/test_runner.h"

#include <QtCore/QSet>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

/// Carries datagrams between the agent and the station, and looks at them.
class Tap : public QObject
{
public:
    explicit Tap(quint16 groundPort) : m_groundPort(groundPort)
    {
        m_socket.bind(QHostAddress::LocalHost, 0);
        connect(&m_socket, &QUdpSocket::readyRead, this, [this] { carry(); });
    }
    quint16 port() const { return m_socket.localPort(); }

    int sealedDown = 0, sealedUp = 0, records = 0, clear = 0;

private:
    void carry()
    {
        while (m_socket.hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(m_socket.pendingDatagramSize()), 0);
            QHostAddress from;
            quint16 fromPort = 0;
            m_socket.readDatagram(datagram.data(), datagram.size(), &from, &fromPort);
            const bool up = fromPort == m_groundPort;
            if (!up)
                m_airPort = fromPort;
            look(datagram, up);
            m_socket.writeDatagram(datagram, QHostAddress::LocalHost, up ? m_airPort : m_groundPort);
        }
    }

    void look(const QByteArray &datagram, bool up)
    {
        if (static_cast<quint8>(datagram[0]) != 0xfd)
            ++records;
        else if (static_cast<quint8>(datagram[2]) != 0x81)
            ++clear;
        else
            ++(up ? sealedUp : sealedDown);
    }

    QUdpSocket m_socket;
    quint16 m_groundPort;
    quint16 m_airPort = 0;
};

const QString kFour = QStringLiteral("aes-256-cbc,chacha20,rc4,aes-256-ctr");

} // namespace

class InlineFramingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fourSuitesLoseNothing();
    void takesTheAgentsConsent();
};

void InlineFramingTest::fourSuitesLoseNothing()
{
    Flight flight;
    QVERIFY(flight.ready());
    Tap tap(flight.groundPort);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments(tap.port(), {QStringLiteral("--allow-inline")}));
    Program monitor(
        QStringLiteral("skyseal-cli"),
        flight.monitorArguments({QStringLiteral("--framing"), QStringLiteral("inline"), QStringLiteral("--switch-to"), kFour,
                                 QStringLiteral("--switch-every"), QStringLiteral("1"), QStringLiteral("--stream-rate"),
                                 QStringLiteral("50"), QStringLiteral("--duration"), QStringLiteral("10")}));
    QCOMPARE(monitor.waitForExit(), 0);

    const QJsonObject up = monitor.events(QStringLiteral("session")).front();
    QCOMPARE(up[QLatin1String("framing")].toString(), QStringLiteral("inline"));
    QCOMPARE(up[QLatin1String("suite")].toString(), QStringLiteral("aes-256-ctr")); // the first that can be inline
    QSet<QString> reached;
    for (const QJsonObject &event : monitor.events(QStringLiteral("switch"))) {
        QCOMPARE(event[QLatin1String("result")].toString(), QStringLiteral("committed"));
        reached.insert(event[QLatin1String("to")].toString());
    }
    const QStringList four = kFour.split(QLatin1Char(','));
    QCOMPARE(reached, QSet<QString>(four.begin(), four.end()));

    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject mavlink = summary[QLatin1String("mavlink")].toObject();
    const QJsonObject channel = summary[QLatin1String("channel")].toObject();
    const QJsonObject received = receivedRecords(channel);
    QCOMPARE(channel[QLatin1String("framing")].toString(), QStringLiteral("inline"));
    QVERIFY2(mavlink[QLatin1String("frames")].toInt() > 350,
             qPrintable(QString::number(mavlink[QLatin1String("frames")].toInt())));
    for (const char *counter : {"lost", "duplicate", "late", "bad_crc"})
        QVERIFY2(mavlink[QLatin1String(counter)].toInt() == 0, counter);
    for (const char *counter : {"lost", "late", "replayed", "forged", "malformed"})
        QVERIFY2(received[QLatin1String(counter)].toInt() == 0, counter);
    const QJsonObject sent = channel[QLatin1String("tx")].toObject();
    for (const char *counter : {"lost", "replayed", "forged", "malformed"})
        QVERIFY2(sent[QLatin1String(counter)].toInt() == 0, counter);

    qInfo("on the wire: %d datagrams of inline frames down, %d up, %d others, %d clear", tap.sealedDown, tap.sealedUp,
          tap.records, tap.clear);
    QVERIFY(tap.sealedDown > 100);
    QVERIFY(tap.sealedUp >= 5); // heartbeats at the least
    QCOMPARE(tap.clear, 0);
}

void InlineFramingTest::takesTheAgentsConsent()
{
    Flight flight;
    QVERIFY(flight.ready());
    Tap tap(flight.groundPort);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments(tap.port()));
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--framing"), QStringLiteral("inline"),
                                             QStringLiteral("--duration"), QStringLiteral("4")}));
    QCOMPARE(monitor.waitForExit(), 1); // the requested framing was not reached
    QCOMPARE(monitor.events(QStringLiteral("session")).front()[QLatin1String("framing")].toString(), QStringLiteral("sealed"));
    QCOMPARE(tap.sealedDown + tap.sealedUp + tap.clear, 0);
    QVERIFY(monitor.last(QStringLiteral("summary"))[QLatin1String("mavlink")][QLatin1String("frames")].toInt() > 20);
}

SKYSEAL_TEST(InlineFramingTest)
#include "inline_framing_test.moc"
