// Which senders of MAVLink are trusted.
#include "core/engine/common/sender_policy.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr channel::SessionId kFirst{1}, kSecond{2};
const Path kPathA{LinkId{1}, {{1}, 1000}}, kPathB{LinkId{1}, {{1}, 2000}}, kElsewhere{LinkId{1}, {{9}, 9}};

channel::Peer peerWith(std::uint8_t number, std::vector<std::uint8_t> systemIds,
                       channel::PeerRole role = channel::PeerRole::Pilot)
{
    channel::Peer peer;
    peer.key[0] = number;
    peer.name = "peer-" + std::to_string(number);
    peer.role = role;
    peer.systemIds = std::move(systemIds);
    return peer;
}

} // namespace

class SenderPolicyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void peerSpeaksOnlyAsItsSystems();
    void systemBelongsToTheFirstThatSpokeAsIt();
    void systemStaysWithWhoHadItInAnEarlierRun();
    void stationsShareASystem();
    void systemBoundToAPeerIsNobodyElses();
    void samePeerKeepsItsSystemOverARestart();
    void clearFramesByMode();
    void systemHeardSealedIsNeverClearAgain();
    void clearWaitsWhileAnAgentIsStillToBeHeard();
    void clearFramesFromASessionsPlaceAreRefused();
    void removedPeerSpeaksAsNothing();
    void observerMayNotCommand();
    void earlierRunsCount();
    void clearStaysRefusedAfterAClaim();
    void claimLastsAsLongAsItsSession();
    void boundPeersAreNotLimited();
};

void SenderPolicyTest::peerSpeaksOnlyAsItsSystems()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer peer = peerWith(1, {3, 4});
    policy.setPeers({peer});
    QVERIFY(!policy.acceptSealed(kFirst, 3)); // no session
    policy.sessionUp(kFirst, peer.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 3));
    QVERIFY(policy.acceptSealed(kFirst, 4));
    QVERIFY(!policy.acceptSealed(kFirst, 5));
}

void SenderPolicyTest::systemBelongsToTheFirstThatSpokeAsIt()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {}), b = peerWith(2, {});
    policy.setPeers({a, b});
    policy.sessionUp(kFirst, a.key, kPathA);
    policy.sessionUp(kSecond, b.key, kPathB);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    QVERIFY(!policy.acceptSealed(kSecond, 1));
    QVERIFY(policy.acceptSealed(kSecond, 2));
    QCOMPARE(policy.ownerOf(1, kSecond), a.name);
    QCOMPARE(policy.ownerOf(1, kFirst), std::string());
    policy.sessionDown(kFirst);
    QVERIFY(!policy.acceptSealed(kSecond, 1)); // a vehicle that is silent has no other agent
    policy.setPeers({b});
    QVERIFY(policy.acceptSealed(kSecond, 1)); // until a person removes the first one
}

void SenderPolicyTest::systemStaysWithWhoHadItInAnEarlierRun()
{
    const channel::Peer a = peerWith(1, {}), b = peerWith(2, {}), bound = peerWith(2, {1}), others = peerWith(1, {5});
    SealedSystems heard;
    heard[a.key].set(1);
    const auto policyOf = [&](std::vector<channel::Peer> peers, Speakers rule = Speakers::OnePerSystem) {
        SenderPolicy policy(SecureMode::Preferred, rule);
        policy.setPeers(peers);
        policy.rememberSealed(heard);
        policy.sessionUp(kSecond, b.key, kPathB);
        return policy;
    };
    QVERIFY(!policyOf({a, b}).acceptSealed(kSecond, 1)); // though its owner has no session
    QVERIFY(policyOf({a, b}).acceptSealed(kSecond, 2));
    QVERIFY(policyOf({b}).acceptSealed(kSecond, 1));
    QVERIFY(policyOf({a, bound}).acceptSealed(kSecond, 1));  // a person said so
    QVERIFY(policyOf({others, b}).acceptSealed(kSecond, 1)); // and that the first one is something else now
    QVERIFY(policyOf({a, b}, Speakers::MayShareASystem).acceptSealed(kSecond, 1));
    heard[b.key].set(1);
    QVERIFY(policyOf({a, b}).acceptSealed(kSecond, 1)); // both had it, by an earlier rule: one session at a time
}

void SenderPolicyTest::stationsShareASystem()
{
    SenderPolicy policy(SecureMode::Required, Speakers::MayShareASystem);
    const channel::Peer first = peerWith(1, {}), spare = peerWith(2, {});
    policy.setPeers({first, spare});
    policy.sessionUp(kFirst, first.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 255));
    policy.sessionUp(kSecond, spare.key, kPathB); // the first crashed; its session is not over yet
    QVERIFY(policy.acceptSealed(kSecond, 255));
}

void SenderPolicyTest::systemBoundToAPeerIsNobodyElses()
{
    for (const Speakers rule : {Speakers::OnePerSystem, Speakers::MayShareASystem}) {
        SenderPolicy policy(SecureMode::Required, rule);
        const channel::Peer any = peerWith(1, {}), bound = peerWith(2, {7});
        policy.setPeers({any, bound});
        policy.sessionUp(kFirst, any.key, kPathA);
        QVERIFY(!policy.acceptSealed(kFirst, 7)); // though its owner has not come up yet
        QVERIFY(policy.acceptSealed(kFirst, 8));
        policy.sessionUp(kSecond, bound.key, kPathB);
        QVERIFY(policy.acceptSealed(kSecond, 7));
    }
}

void SenderPolicyTest::samePeerKeepsItsSystemOverARestart()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {});
    policy.setPeers({a});
    policy.sessionUp(kFirst, a.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    policy.sessionUp(kSecond, a.key, kPathB); // the new session is up before the old one is known to be down
    QVERIFY(policy.acceptSealed(kSecond, 1));
}

void SenderPolicyTest::clearFramesByMode()
{
    QVERIFY(SenderPolicy(SecureMode::Preferred).acceptClear(kPathA, 1));
    QVERIFY(SenderPolicy(SecureMode::Off).acceptClear(kPathA, 1));
    QVERIFY(!SenderPolicy(SecureMode::Required).acceptClear(kPathA, 1));
}

void SenderPolicyTest::systemHeardSealedIsNeverClearAgain()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer any = peerWith(1, {}), pinned = peerWith(2, {7});
    policy.setPeers({any, pinned});
    QVERIFY(!policy.acceptClear(kElsewhere, 7)); // pinned by the list
    policy.allowPlaintext(1);
    policy.allowPlaintext(7);
    QVERIFY(policy.acceptClear(kElsewhere, 1));
    QVERIFY(!policy.acceptClear(kElsewhere, 7));
    policy.sessionUp(kFirst, any.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    QVERIFY(!policy.acceptClear(kElsewhere, 1));
    QVERIFY(policy.sessionConcerned(kElsewhere, 1) == kFirst);
    policy.sessionDown(kFirst); // cutting the sealed link must not open the clear one
    QVERIFY(!policy.acceptClear(kElsewhere, 1));
    QVERIFY(policy.acceptClear(kElsewhere, 2));
}

void SenderPolicyTest::clearWaitsWhileAnAgentIsStillToBeHeard()
{
    SenderPolicy policy(SecureMode::Preferred);
    QVERIFY(policy.acceptClear(kElsewhere, 1)); // without known peers there is none to impersonate
    const channel::Peer a = peerWith(1, {}), b = peerWith(2, {}), bound = peerWith(3, {7});
    policy.setPeers({a, b, bound});
    for (const std::uint8_t systemId : {1, 2, 200}) {
        QVERIFY(!policy.acceptClear(kElsewhere, systemId));
        QVERIFY(policy.needsApproval(kElsewhere, systemId));
    }
    QVERIFY(!policy.needsApproval(kElsewhere, 7)); // refused, whatever a person says
    QCOMPARE(policy.neverHeard(), a.name + ", " + b.name);
    policy.sessionUp(kFirst, a.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    QVERIFY(!policy.acceptClear(kElsewhere, 2)); // the other one is still to be heard
    QCOMPARE(policy.neverHeard(), b.name);
    policy.allowPlaintext(2);
    QVERIFY(policy.acceptClear(kElsewhere, 2));
    QVERIFY(!policy.acceptClear(kElsewhere, 3)); // that system and no other
    QVERIFY(!policy.acceptClear(kPathA, 2));
    policy.sessionUp(kSecond, b.key, kPathB);
    QVERIFY(policy.acceptSealed(kSecond, 2));
    QVERIFY(!policy.acceptClear(kElsewhere, 2)); // it was an impostor, as is known now
    QVERIFY(policy.acceptClear(kElsewhere, 3));
    // A changed key is another agent, which has to be heard first.
    channel::Peer changed = a;
    changed.key[1] ^= 1;
    policy.setPeers({changed, b, bound});
    QVERIFY(policy.needsApproval(kElsewhere, 1));
    policy.setMode(SecureMode::Required);
    QVERIFY(!policy.needsApproval(kElsewhere, 1) && !policy.acceptClear(kElsewhere, 1));
    policy.setMode(SecureMode::Off);
    QVERIFY(policy.acceptClear(kElsewhere, 1));
}

void SenderPolicyTest::clearFramesFromASessionsPlaceAreRefused()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer any = peerWith(1, {});
    policy.setPeers({any});
    policy.sessionUp(kFirst, any.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    QVERIFY(!policy.acceptClear(kPathA, 40));
    policy.sessionMoved(kFirst, kPathB);
    QVERIFY(policy.acceptClear(kPathA, 40));
    QVERIFY(!policy.acceptClear(kPathB, 40));
}

void SenderPolicyTest::removedPeerSpeaksAsNothing()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {});
    policy.setPeers({a});
    policy.sessionUp(kFirst, a.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 1));
    policy.setPeers({});
    QVERIFY(!policy.acceptSealed(kFirst, 1));
    QVERIFY(!policy.mayCommand(kFirst));
}

void SenderPolicyTest::observerMayNotCommand()
{
    SenderPolicy policy(SecureMode::Required);
    const channel::Peer pilot = peerWith(1, {}), observer = peerWith(2, {}, channel::PeerRole::Observer);
    policy.setPeers({pilot, observer});
    policy.sessionUp(kFirst, pilot.key, kPathA);
    policy.sessionUp(kSecond, observer.key, kPathB);
    QVERIFY(policy.mayCommand(kFirst));
    QVERIFY(!policy.mayCommand(kSecond));
    QVERIFY(!policy.mayCommand(channel::SessionId{99}));
}

void SenderPolicyTest::earlierRunsCount()
{
    const channel::Peer a = peerWith(1, {}), gone = peerWith(2, {});
    SealedSystems heard;
    heard[a.key].set(1);
    heard[gone.key].set(2);
    SenderPolicy policy(SecureMode::Preferred);
    policy.setPeers({a});
    policy.rememberSealed(heard);
    QVERIFY(!policy.acceptClear(kElsewhere, 1));
    QVERIFY(policy.acceptClear(kElsewhere, 2)); // its peer is no longer known
    policy.setPeers({a, peerWith(3, {})});
    QVERIFY(!policy.acceptClear(kElsewhere, 2)); // perhaps the new one's
    policy.setPeers({a, peerWith(3, {9})});
    QVERIFY(policy.acceptClear(kElsewhere, 2));
    policy.setPeers({});
    QVERIFY(policy.acceptClear(kElsewhere, 1)); // forgotten by the operator's act
}

void SenderPolicyTest::clearStaysRefusedAfterAClaim()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {}), b = peerWith(2, {});
    policy.setPeers({a, b});
    policy.sessionUp(kFirst, a.key, kPathA);
    QVERIFY(policy.acceptSealed(kFirst, 7));
    policy.sessionDown(kFirst);
    policy.endClaims(TimePoint{});
    policy.endClaims(TimePoint{} + SenderPolicy::kClaimOutlivesSession);
    QVERIFY(policy.isSealedSystem(7));
    QVERIFY(!policy.acceptClear(kElsewhere, 7));
    QCOMPARE(policy.sealedSystems().at(a.key).count(), std::size_t(1)); // what is stored for the next run
}

void SenderPolicyTest::claimLastsAsLongAsItsSession()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {}), b = peerWith(2, {});
    policy.setPeers({a, b});
    policy.sessionUp(kFirst, a.key, kPathA);
    policy.sessionUp(kSecond, b.key, kPathB);
    QVERIFY(policy.acceptSealed(kFirst, 7));
    TimePoint now{};
    for (int minute = 0; minute < 60; ++minute)
        policy.endClaims(now += std::chrono::minutes(1));
    QVERIFY(!policy.acceptSealed(kSecond, 7));
    policy.sessionDown(kFirst);
    policy.endClaims(now);
    policy.endClaims(now += SenderPolicy::kClaimOutlivesSession - std::chrono::seconds(1));
    QVERIFY(!policy.acceptSealed(kSecond, 7)); // still behind the hill
    policy.sessionUp(kFirst, a.key, kPathA);   // and back
    policy.endClaims(now += std::chrono::minutes(1));
    policy.sessionDown(kFirst);
    policy.endClaims(now);
    policy.endClaims(now += std::chrono::minutes(1));
    QVERIFY(!policy.acceptSealed(kSecond, 7)); // from the beginning
    policy.endClaims(now += SenderPolicy::kClaimOutlivesSession);
    QVERIFY(policy.acceptSealed(kSecond, 7));
    policy.sessionUp(kFirst, a.key, kPathA);
    QVERIFY(!policy.acceptSealed(kFirst, 7)); // one at a time
}

void SenderPolicyTest::boundPeersAreNotLimited()
{
    SenderPolicy policy(SecureMode::Preferred);
    const channel::Peer a = peerWith(1, {1, 2, 3, 4, 5, 6});
    policy.setPeers({a});
    policy.sessionUp(kFirst, a.key, kPathA);
    for (const std::uint8_t systemId : a.systemIds)
        QVERIFY(policy.acceptSealed(kFirst, systemId));
    // Stations share ids and may change theirs.
    SenderPolicy agents(SecureMode::Required, Speakers::MayShareASystem);
    const channel::Peer station = peerWith(2, {});
    agents.setPeers({station});
    agents.sessionUp(kFirst, station.key, kPathA);
    for (const std::uint8_t systemId : {250, 251, 252, 253, 254, 255})
        QVERIFY(agents.acceptSealed(kFirst, systemId));
}

SKYSEAL_TEST(SenderPolicyTest)
#include "sender_policy_test.moc"
