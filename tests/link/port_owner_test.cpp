// Which program holds a port of this machine, and which is connected to one: this test itself, by sockets of every kind.
#include "core/link/address_text.h"
#include "core/link/port_owner.h"
#include "tests/support/eventually.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal::link;

class PortOwnerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listenerAndCaller() { seeListenerAndCaller(QHostAddress::LocalHost); }
    void listenerAndCallerOnIpv6();
    void datagrams();

private:
    static void seeListenerAndCaller(QHostAddress::SpecialAddress address);
};

void PortOwnerTest::listenerAndCallerOnIpv6()
{
    SKYSEAL_REQUIRES("ipv6");
    seeListenerAndCaller(QHostAddress::LocalHostIPv6);
}

void PortOwnerTest::seeListenerAndCaller(QHostAddress::SpecialAddress address)
{
    QTcpServer server;
    QVERIFY(server.listen(address));
    const auto port = server.serverPort();
    const auto owner = portOwner(PortKind::Tcp, port);
    QVERIFY(owner);
    QCOMPARE(owner->process, qint64(QCoreApplication::applicationPid()));
    QVERIFY(!portCaller(PortKind::Tcp, port));
    QTcpSocket caller;
    caller.connectToHost(server.serverAddress(), port);
    QVERIFY(caller.waitForConnected(skyseal::test::kDeadlineMs));
    const auto found = portCaller(PortKind::Tcp, port);
    QVERIFY(found);
    QCOMPARE(found->process, qint64(QCoreApplication::applicationPid()));
    QVERIFY(!found->name.empty());
    QVERIFY(!portOwner(PortKind::Tcp, caller.localPort())); // it does not listen there
}

/// A UDP socket that only sends names its destination to nobody; one that is connected does. Either is found by the address
/// from which it sends.
void PortOwnerTest::datagrams()
{
    QUdpSocket station, sender, caller;
    QVERIFY(station.bind(QHostAddress::LocalHost) && sender.bind(QHostAddress::LocalHost));
    QVERIFY(portOwner(PortKind::Udp, station.localPort()));
    QCOMPARE(sender.writeDatagram("x", QHostAddress::LocalHost, station.localPort()), qint64(1));
    QVERIFY(!portCaller(PortKind::Udp, station.localPort()));
    caller.connectToHost(QHostAddress(QHostAddress::LocalHost), station.localPort());
    QVERIFY(caller.waitForConnected(skyseal::test::kDeadlineMs));
    const auto found = portCaller(PortKind::Udp, station.localPort());
    QVERIFY(found);
    QCOMPARE(found->process, qint64(QCoreApplication::applicationPid()));

    constexpr std::uint32_t kLoopback = 0x7f000001, kElsewhere = 0xc0000201, kOtherLoopback = 0x7f000002;
    QUdpSocket anywhere;
    QVERIFY(anywhere.bind(QHostAddress(QHostAddress::Any)));
    for (const QUdpSocket *socket : {&sender, &caller, &anywhere}) {
        const auto sending = datagramSender(ipv4(kLoopback, socket->localPort()));
        QVERIFY(sending);
        QCOMPARE(sending->process, qint64(QCoreApplication::applicationPid()));
    }
    QVERIFY(!datagramSender(ipv4(kElsewhere, sender.localPort())));     // another machine
    QVERIFY(!datagramSender(ipv4(kOtherLoopback, sender.localPort()))); // the port of another address
    QUdpSocket six;
    if (six.bind(QHostAddress(QHostAddress::LocalHostIPv6))) {
        QVERIFY(datagramSender(fromQt(six.localAddress(), six.localPort())));
        QVERIFY(!datagramSender(ipv4(kLoopback, six.localPort())));
    }
}

SKYSEAL_TEST(PortOwnerTest)
#include "port_owner_test.moc"
