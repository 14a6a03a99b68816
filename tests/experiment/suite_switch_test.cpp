// The live switch before a run: orders, repeated orders, the time that counts, and when it is given up.
#include "core/experiment/suite_switch.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace std::chrono_literals;
using channel::SwitchFailure;
using crypto::SuiteId;
using experiment::SuiteSwitch;
using Outcome = SuiteSwitch::Outcome;

namespace {

constexpr channel::SessionId kFirstSession{7}, kSecondSession{8};

channel::SwitchDone done(SwitchFailure failure, channel::SessionId session = kFirstSession)
{
    channel::SwitchDone out;
    out.session = session;
    out.to = SuiteId::Aes256Gcm;
    out.failure = failure;
    out.took = 120ms;
    return out;
}

SuiteSwitch begun()
{
    SuiteSwitch out;
    out.begin(SuiteId::Aes256Gcm);
    return out;
}

} // namespace

class SuiteSwitchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneOrderForEachSession()
    {
        SuiteSwitch live = begun();
        QVERIFY(live.order(kFirstSession, 1));
        QVERIFY(!live.order(kFirstSession, 2));
        QVERIFY(live.order(kSecondSession, 3));
    }

    void firstOrderTakesTheTimeOfTheSwitch()
    {
        SuiteSwitch live = begun();
        QVERIFY(std::isnan(live.milliseconds()));
        live.order(kFirstSession, 1);
        QCOMPARE(int(live.finish(done(SwitchFailure::None), true, 9)), int(Outcome::Committed));
        QCOMPARE(live.milliseconds(), 120.0);
    }

    void repeatedOrderTakesTheTimeSinceTheFirst()
    {
        SuiteSwitch live = begun();
        live.order(kFirstSession, 1);
        QCOMPARE(int(live.finish(done(SwitchFailure::NotConfirmed), true, 6)), int(Outcome::Retry));
        QVERIFY(live.order(kFirstSession, 6));
        live.finish(done(SwitchFailure::None), true, 7.5);
        QCOMPARE(live.milliseconds(), 6500.0);
    }

    void orderOfALostSessionCounts()
    {
        SuiteSwitch live = begun();
        live.order(kFirstSession, 1);
        QCOMPARE(int(live.finish(done(SwitchFailure::SessionEnded), false, 3)), int(Outcome::LinkLost));
        QVERIFY(live.order(kSecondSession, 4));
        live.finish(done(SwitchFailure::None, kSecondSession), true, 5);
        QCOMPARE(live.milliseconds(), 4000.0);
    }

    void eighthFailureIsTheLast()
    {
        SuiteSwitch live = begun();
        for (unsigned i = 1; i < SuiteSwitch::kMostOrders; ++i) {
            QVERIFY(live.order(kFirstSession, i));
            QCOMPARE(int(live.finish(done(SwitchFailure::NotConfirmed), true, i)), int(Outcome::Retry));
        }
        QVERIFY(live.order(kFirstSession, 8));
        QCOMPARE(int(live.finish(done(SwitchFailure::NotConfirmed), true, 8)), int(Outcome::Failed));
        QCOMPARE(live.problem().text(), std::string("the switch was not confirmed in time, 8 times"));
    }

    void failureWithoutALinkDoesNotCount()
    {
        SuiteSwitch live = begun();
        for (int i = 0; i < 20; ++i) {
            QVERIFY(live.order(kFirstSession, i));
            QCOMPARE(int(live.finish(done(SwitchFailure::NotConfirmed), false, i)), int(Outcome::LinkLost));
        }
    }

    void refusalIsFinal()
    {
        for (const SwitchFailure refusal : {SwitchFailure::NotAllowedHere, SwitchFailure::NotAllowedByPeer}) {
            SuiteSwitch live = begun();
            live.order(kFirstSession, 1);
            QCOMPARE(int(live.finish(done(refusal), true, 2)), int(Outcome::Failed));
            QCOMPARE(live.problem().text(), std::string("the other end did not take this suite"));
        }
    }

    void otherSwitchesAreUnrelated()
    {
        SuiteSwitch live = begun();
        live.order(kFirstSession, 1);
        channel::SwitchDone other = done(SwitchFailure::None);
        other.to = SuiteId::ChaCha20;
        QCOMPARE(int(live.finish(other, true, 2)), int(Outcome::Unrelated));
        channel::SwitchDone rekey = done(SwitchFailure::None);
        rekey.rekey = true;
        QCOMPARE(int(live.finish(rekey, true, 2)), int(Outcome::Unrelated));
        QVERIFY(std::isnan(live.milliseconds()));
    }

    void nextRunBeginsAnew()
    {
        SuiteSwitch live = begun();
        live.order(kFirstSession, 1);
        live.finish(done(SwitchFailure::None), true, 2);
        live.begin(SuiteId::Aes256Ctr);
        QVERIFY(std::isnan(live.milliseconds()));
        QVERIFY(live.order(kFirstSession, 3));
    }
};

SKYSEAL_TEST(SuiteSwitchTest)
#include "suite_switch_test.moc"
