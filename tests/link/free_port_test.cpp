// The ports that a program chooses for those that it starts.
#include "core/link/free_port.h"
#include "tests/support/test_runner.h"

#include <QtCore/QString>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;

class FreePortTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void portsDiffer();
    void systemGivesThemToNobody();
};

/// So many that chance would name one twice: 300 of 6,000.
void FreePortTest::portsDiffer()
{
    auto ports = link::freeUdpPorts(300);
    QCOMPARE(ports.size(), std::size_t(300));
    std::sort(ports.begin(), ports.end());
    QVERIFY(std::adjacent_find(ports.begin(), ports.end()) == ports.end());
}

void FreePortTest::systemGivesThemToNobody()
{
    constexpr int kFirst = 32'768; // net.ipv4.ip_local_port_range as Linux sets it (Documentation/networking/ip-sysctl.rst)
    for (const std::uint16_t port : link::freeUdpPorts(100))
        QVERIFY2(port < kFirst, qPrintable(QString::number(port)));
}

SKYSEAL_TEST(FreePortTest)
#include "free_port_test.moc"
