// The pauses between attempts to reach a broker.
#include "core/mqtt/reconnect_delay.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <set>

using namespace skyseal;
using skyseal::mqtt::ReconnectDelay;

class ReconnectDelayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void doublesUpToAMinute();
    void beginsAnew();
    void gatewaysDoNotReturnTogether();
};

void ReconnectDelayTest::doublesUpToAMinute()
{
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        ReconnectDelay delay(seed);
        for (const int whole : {1, 2, 4, 8, 16, 32, 60, 60, 60}) {
            const double pause = seconds(delay.next());
            QVERIFY2(pause >= whole / 2.0 && pause <= whole, qPrintable(QString::number(pause)));
        }
    }
}

void ReconnectDelayTest::beginsAnew()
{
    ReconnectDelay delay(1);
    for (int i = 0; i < 10; ++i)
        delay.next();
    delay.reset();
    QVERIFY(delay.next() <= ReconnectDelay::kFirst);
}

void ReconnectDelayTest::gatewaysDoNotReturnTogether()
{
    std::set<Duration> pauses;
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        ReconnectDelay delay(seed * 7919);
        for (int i = 0; i < 6; ++i)
            delay.next();
        pauses.insert(delay.next());
    }
    QVERIFY2(pauses.size() > 50, qPrintable(QString::number(pauses.size())));
}

SKYSEAL_TEST_APPLESS(ReconnectDelayTest)
#include "reconnect_delay_test.moc"
