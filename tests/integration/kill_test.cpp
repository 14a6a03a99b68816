// Two hundred times kill -9 of an agent or its station in traffic, with an ear on the wire: no life repeats a key of
// another, and no counter is sealed twice under one.
#include "tests/support/eventually.h"
#include "tests/support/flight.h"
#include "tests/support/key_uses.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

#include <QtTest/QTest>

#include <memory>

using namespace skyseal::test;

class KillTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLifeHasKeysOfItsOwn();
};

void KillTest::everyLifeHasKeysOfItsOwn()
{
    const int asked = qEnvironmentVariableIntValue("SKYSEAL_KILLS");
    const int kills = asked > 0 ? asked : 200;
    Flight flight;
    QVERIFY(flight.ready());
    UdpAttacker tap(flight.groundPort);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    const auto startAir = [&] {
        return std::make_unique<Program>(QStringLiteral("skyseal-air"), flight.airArguments(tap.port()));
    };
    const auto startMonitor = [&] {
        return std::make_unique<Program>(QStringLiteral("skyseal-cli"), flight.monitorArguments());
    };
    auto air = startAir(), monitor = startMonitor();

    const auto count = [&tap](bool toGround, int kind) {
        return std::count_if(tap.seen.begin(), tap.seen.end(), [=](const UdpAttacker::Seen &seen) {
            return seen.toGround == toGround && !seen.bytes.isEmpty() && (seen.bytes[0] & (kind == 0x50 ? 0xfc : 0xff)) == kind;
        });
    };
    for (int life = 0; life < kills; ++life) {
        // Until both ends have sealed a few under the keys of this life.
        const auto answers = count(true, 0x5a), fromAir = count(true, 0x50), fromGround = count(false, 0x50);
        if (life > 0) {
            auto &victim = life % 2 ? air : monitor;
            victim->kill();
            victim = life % 2 ? startAir() : startMonitor();
        }
        EVENTUALLY2(count(true, 0x5a) > answers, qPrintable(QStringLiteral("life %1").arg(life)));
        EVENTUALLY2(count(true, 0x50) > fromAir + 5 && count(false, 0x50) > fromGround + 2,
                    qPrintable(QStringLiteral("life %1").arg(life)));
    }

    KeyUses uses;
    for (const UdpAttacker::Seen &seen : tap.seen)
        uses.take(seen.toGround, seen.bytes);
    qInfo("%d kills, %d sessions, %lld records, %d repeated", kills, uses.sessions, uses.records, uses.repeated);
    QVERIFY(uses.sessions >= kills);
    QCOMPARE(uses.repeated, 0);
}

SKYSEAL_TEST(KillTest)
#include "kill_test.moc"
