// Cycling through a list of suites.
#include "core/engine/headless/switch_plan.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using crypto::SuiteId;

namespace {

constexpr channel::SessionId kPlanSession{4};
constexpr TimePoint kStart{std::chrono::seconds(100)};

channel::SwitchDone done(SuiteId to, channel::SwitchFailure failure = channel::SwitchFailure::None)
{
    channel::SwitchDone out;
    out.session = kPlanSession;
    out.to = to;
    out.failure = failure;
    return out;
}

} // namespace

class SwitchPlanTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cyclesThroughTheList();
    void oneSwitchAtATime();
    void continuesFromTheSuiteInUse();
    void endsWithItsSession();
    void remembersWhatWasNeverReached();
};

void SwitchPlanTest::cyclesThroughTheList()
{
    SwitchPlan plan({SuiteId::Aes256Gcm, SuiteId::ChaCha20}, std::chrono::seconds(1));
    QVERIFY(plan.poll(kStart).empty());
    plan.sessionUp(kStart, kPlanSession);
    QVERIFY(plan.poll(kStart + std::chrono::milliseconds(999)).empty());
    std::vector<SuiteId> seen;
    for (int second = 1; second <= 3; ++second) {
        const auto orders = plan.poll(kStart + std::chrono::seconds(second));
        QCOMPARE(orders.size(), std::size_t(1));
        seen.push_back(orders[0].suite);
        plan.switchDone(done(orders[0].suite));
    }
    QCOMPARE(seen, (std::vector{SuiteId::Aes256Gcm, SuiteId::ChaCha20, SuiteId::Aes256Gcm}));
}

void SwitchPlanTest::oneSwitchAtATime()
{
    SwitchPlan plan({SuiteId::Aes256Gcm, SuiteId::ChaCha20}, std::chrono::seconds(1));
    plan.sessionUp(kStart, kPlanSession);
    QVERIFY(!plan.isPending());
    QCOMPARE(plan.poll(kStart + std::chrono::seconds(1)).size(), std::size_t(1));
    QVERIFY(plan.isPending());
    QVERIFY(plan.poll(kStart + std::chrono::seconds(7)).empty());
    plan.switchDone(done(SuiteId::Aes256Gcm, channel::SwitchFailure::NotConfirmed));
    QVERIFY(!plan.isPending());
    QCOMPARE(plan.poll(kStart + std::chrono::seconds(7)).size(), std::size_t(1));
    plan.switchDone(done(SuiteId::ChaCha20));
    QVERIFY(plan.poll(kStart + std::chrono::milliseconds(7100)).empty()); // no burst to catch up
}

void SwitchPlanTest::continuesFromTheSuiteInUse()
{
    SwitchPlan plan({SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm}, std::chrono::seconds(1));
    plan.sessionUp(kStart, kPlanSession);
    QCOMPARE(plan.poll(kStart + std::chrono::seconds(1)).size(), std::size_t(1));
    auto rekey = done(SuiteId::Aes256Ctr); // not the requested suite
    rekey.rekey = true;
    plan.switchDone(rekey);
    QVERIFY(plan.poll(kStart + std::chrono::seconds(2)).empty());
    rekey.to = SuiteId::ChaCha20Poly1305; // requested while in use: reported as a rekey
    plan.switchDone(rekey);
    const auto orders = plan.poll(kStart + std::chrono::seconds(3));
    QCOMPARE(orders.size(), std::size_t(1));
    QCOMPARE(orders[0].suite, SuiteId::Aes256Gcm);
}

void SwitchPlanTest::endsWithItsSession()
{
    SwitchPlan plan({SuiteId::Aes256Gcm}, std::chrono::seconds(1));
    plan.sessionUp(kStart, kPlanSession);
    plan.sessionDown(kPlanSession);
    QVERIFY(plan.poll(kStart + std::chrono::seconds(5)).empty());
}

void SwitchPlanTest::remembersWhatWasNeverReached()
{
    SwitchPlan plan({SuiteId::Aes256Gcm, SuiteId::Rc4}, std::chrono::seconds(1));
    plan.switchDone(done(SuiteId::Rc4, channel::SwitchFailure::NotAllowedHere));
    plan.switchDone(done(SuiteId::Aes256Gcm, channel::SwitchFailure::NotConfirmed));
    plan.switchDone(done(SuiteId::Aes256Gcm));
    QCOMPARE(plan.notReached(), std::vector{SuiteId::Rc4});
    auto rekey = done(SuiteId::ChaCha20, channel::SwitchFailure::NotConfirmed);
    rekey.rekey = true;
    plan.switchDone(rekey);
    QCOMPARE(plan.notReached(), std::vector{SuiteId::Rc4});
}

SKYSEAL_TEST(SwitchPlanTest)
#include "switch_plan_test.moc"
