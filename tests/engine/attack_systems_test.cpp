// A rogue agent that is listed and bound to no system claims the system ids of others at a station.
#include "core/engine/common/sender_policy.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr channel::SessionId kRogue{1}, kHonest{2};
const Path kRoguePath{LinkId{1}, {{1}, 1000}}, kHonestPath{LinkId{1}, {{1}, 2000}};

channel::Peer peer(std::uint8_t number)
{
    channel::Peer out;
    out.key[0] = number;
    out.name = "peer-" + std::to_string(number);
    return out;
}

/// A station with two agents that were paired and not yet heard; the rogue one connects first.
struct Agents
{
    Agents()
    {
        policy.setPeers({rogue, honest});
        policy.sessionUp(kRogue, rogue.key, kRoguePath);
    }

    const channel::Peer rogue = peer(1), honest = peer(2);
    SenderPolicy policy{SecureMode::Preferred};
};

} // namespace

class AttackSystemsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneAgentClaimsEverySystem();
    void claimEnds_data();
    void claimEnds();
};

void AttackSystemsTest::oneAgentClaimsEverySystem()
{
    Agents rig;
    std::size_t claimed = 0;
    for (int round = 0; round < 3; ++round) {
        claimed = 0;
        for (int systemId = 1; systemId <= 255; ++systemId)
            claimed += rig.policy.acceptSealed(kRogue, static_cast<std::uint8_t>(systemId));
        // A new session brings no further ids.
        rig.policy.sessionDown(kRogue);
        rig.policy.sessionUp(kRogue, rig.rogue.key, kRoguePath);
    }
    rig.policy.sessionUp(kHonest, rig.honest.key, kHonestPath);
    HOLDS(rig.policy.acceptSealed(kHonest, 42), "an honest agent is not locked out");
    QCOMPARE(claimed, SenderPolicy::kMostUnbound);
    QVERIFY(rig.policy.acceptSealed(kRogue, 1));
    QVERIFY(!rig.policy.acceptSealed(kHonest, 1));
}

void AttackSystemsTest::claimEnds_data()
{
    QTest::addColumn<bool>("earlierRun");
    QTest::newRow("of a session that ended") << false;
    QTest::newRow("of an earlier run") << true;
}

void AttackSystemsTest::claimEnds()
{
    QFETCH(bool, earlierRun);
    Agents rig;
    SealedSystems claimed;
    claimed[rig.rogue.key].set(1);
    if (earlierRun)
        rig.policy.rememberSealed(claimed);
    else
        QVERIFY(rig.policy.acceptSealed(kRogue, 1));
    rig.policy.sessionDown(kRogue);
    rig.policy.sessionUp(kHonest, rig.honest.key, kHonestPath);
    TimePoint now{};
    rig.policy.endClaims(now);
    QVERIFY(!rig.policy.acceptSealed(kHonest, 1));
    rig.policy.endClaims(now += SenderPolicy::kClaimOutlivesSession);
    HOLDS(rig.policy.acceptSealed(kHonest, 1), "an honest agent is not locked out");
    rig.policy.sessionUp(kRogue, rig.rogue.key, kRoguePath);
    QVERIFY(!rig.policy.acceptSealed(kRogue, 1));
}

SKYSEAL_TEST(AttackSystemsTest)
#include "attack_systems_test.moc"
