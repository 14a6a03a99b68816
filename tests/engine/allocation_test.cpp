// The path of a packet through the engines allocates nothing: receive, open, parse, vehicle in the station, and both ways
// through the agent. Counted against operator new in this program, over real sockets.
#include "tests/engine/agent_rig.h"
#include "tests/engine/station_rig.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_runner.h"

#include "core/crypto/init_crypto.h"
#include "core/engine/station/snapshot.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr int kRounds = 40;
/// Timers, samples and snapshots come a few times a second, whatever the traffic; a single allocation in each packet would
/// be a hundred times as many.
constexpr std::uint64_t kAllowed = kRounds * kFrames / 100;

template<typename Round> std::uint64_t allocationsOf(Round &&round)
{
    round(); // one-time allocations
    const std::uint64_t before = allocations;
    for (int i = 0; i < kRounds; ++i)
        round();
    const std::uint64_t allocated = allocations - before;
    qInfo("%llu allocations for %zu frames", static_cast<unsigned long long>(allocated), kRounds * kFrames);
    return allocated;
}

} // namespace

class EngineAllocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void countsAtAll();
    void agentBothWays();
    void agentSignsAndVerifies();
    void stationReceives();
    void stationRefuses();
};

void EngineAllocationTest::countsAtAll()
{
    std::vector<std::unique_ptr<int>> kept;
    QVERIFY(allocationsOf([&] { kept.push_back(std::make_unique<int>(1)); }) >= kRounds);
}

void EngineAllocationTest::agentBothWays()
{
    AgentRig rig(crypto::SuiteId::ChaCha20Poly1305);
    QVERIFY(allocationsOf([&] { rig.toGround(64); }) < kAllowed);
    QVERIFY(allocationsOf([&] { rig.toVehicle(64); }) < kAllowed);
}

void EngineAllocationTest::agentSignsAndVerifies()
{
    AgentRig rig(crypto::SuiteId::ChaCha20Poly1305, AgentRig::VehicleSide::Signed);
    QVERIFY(allocationsOf([&] { rig.toGround(64); }) < kAllowed);
    QVERIFY(allocationsOf([&] { rig.toVehicle(64); }) < kAllowed);
}

void EngineAllocationTest::stationReceives()
{
    StationRig rig(crypto::SuiteId::ChaCha20Poly1305);
    const std::uint64_t before = rig.frames();
    QVERIFY(allocationsOf([&] { rig.receive(); }) < kAllowed);
    QCOMPARE(rig.frames() - before, std::uint64_t(kRounds + 1) * kFrames);
}

void EngineAllocationTest::stationRefuses()
{
    StationRig rig(crypto::SuiteId::ChaCha20Poly1305, {2});
    QVERIFY(allocationsOf([&] { rig.receive(); }) < kAllowed);
    QCOMPARE(rig.refused(), std::uint64_t(kRounds + 1) * kFrames);
}

SKYSEAL_TEST(EngineAllocationTest)
#include "allocation_test.moc"
