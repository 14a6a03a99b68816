// The link of a sweep by made-up snapshots: which session and vehicles count in each mode, consent, and the return to the
// first suite.
#include "core/engine/station/snapshot.h"
#include "core/experiment/measured_link.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using crypto::SuiteId;
using engine::Protection;
using experiment::MeasuredLink;
using experiment::SweepArm;

namespace {

constexpr channel::SessionId kSession{7}, kNextSession{8};
constexpr SweepArm kPlain{SuiteId::None}, kSealed{SuiteId::Aes256Ctr};
constexpr SweepArm kInline{SuiteId::Aes256Ctr, false, experiment::ArmFraming::Inline};
constexpr SweepArm kBare{SuiteId::Aes256Ctr, false, experiment::ArmFraming::Bare};

engine::Snapshot withSession(channel::SessionId session, SuiteId suite = SuiteId::ChaCha20Poly1305)
{
    engine::SessionSnapshot up;
    up.info.session = session;
    up.info.suite = suite;
    engine::Snapshot out;
    out.sessions.push_back(std::move(up));
    return out;
}

/// `over`: the session by which the vehicle was heard; nullopt: in clear.
void addVehicle(engine::Snapshot &snapshot, std::optional<channel::SessionId> over, std::uint64_t trips = 0)
{
    engine::VehicleSnapshot vehicle;
    vehicle.session = over;
    vehicle.state.trips = trips;
    snapshot.vehicles.push_back(std::move(vehicle));
}

} // namespace

class MeasuredLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void protectionFollowsSuiteAndFraming()
    {
        using experiment::ArmFraming;
        QVERIFY(experiment::protectionOf({SuiteId::None, false, ArmFraming::Inline}) == Protection::Plain);
        QVERIFY(experiment::protectionOf({SuiteId::Aes256Ctr, false, ArmFraming::Sealed}) == Protection::Sealed);
        QVERIFY(experiment::protectionOf({SuiteId::Aes256Ctr, false, ArmFraming::Inline}) == Protection::Inline);
        QVERIFY(experiment::protectionOf(kBare) == Protection::Plain);
    }

    void bareCipherIsNoPlainMavlink()
    {
        MeasuredLink link;
        engine::Snapshot before, after;
        addVehicle(before, std::nullopt, 5);
        addVehicle(after, std::nullopt, 6);
        link.setProtection(Protection::Plain, nullptr);
        QVERIFY(link.isCarriedAs(kPlain) && !link.isCarriedAs(kBare));
        link.setBareCipher(crypto::MavsecKind::Aes256Ctr, &before);
        QVERIFY(link.isCarriedAs(kBare) && link.isPlain());
        QVERIFY(!link.isCarriedAs(kPlain) && !link.isCarriedAs(Protection::Plain));
        QVERIFY(!link.isCarriedAs({SuiteId::ChaCha20, false, experiment::ArmFraming::Bare}));
        QVERIFY(link.hasVehicle(before) && !link.hasReadableVehicle(before)); // heard, but under another key nothing answers
        QVERIFY(link.hasReadableVehicle(after));
        link.setProtection(Protection::Plain, &before);
        QVERIFY(link.isCarriedAs(kPlain) && link.hasReadableVehicle(before));
    }

    void wrongKeyIsToldAndLeavesTheOthers()
    {
        MeasuredLink link;
        QCOMPARE(link.refusal(kBare).text(), std::string());
        link.bareSilent();
        QVERIFY(link.refusal(kBare).text().find("key") != std::string::npos);
        QCOMPARE(link.refusal(kPlain).text(), std::string());
        QCOMPARE(link.refusal(kInline).text(), std::string());
        link.setBareCipher(crypto::MavsecKind::Aes256Ctr, nullptr);
        link.plainSucceeded();
        link.bareSilent(); // by the link, then
        QCOMPARE(link.refusal(kBare).text(), std::string());
    }

    void sessionThatIsAboutToEndDoesNotCount()
    {
        MeasuredLink link;
        engine::Snapshot snapshot = withSession(kSession);
        QVERIFY(link.session(snapshot));
        link.setProtection(Protection::Sealed, &snapshot); // sessions are sealed already
        QVERIFY(link.session(snapshot));
        link.setProtection(Protection::Inline, &snapshot);
        QVERIFY(!link.session(snapshot));
        QVERIFY(link.session(withSession(kNextSession)));
    }

    void silentSessionDoesNotCount()
    {
        engine::Snapshot snapshot = withSession(kSession);
        snapshot.sessions.front().info.silent = true;
        QVERIFY(!MeasuredLink().session(snapshot));
    }

    void vehicleCountsInTheModeOfTheLink()
    {
        MeasuredLink link;
        engine::Snapshot sealed = withSession(kSession), clear = withSession(kSession), older = withSession(kNextSession);
        addVehicle(sealed, kSession);
        addVehicle(clear, std::nullopt);
        addVehicle(older, kSession);
        QVERIFY(link.hasVehicle(sealed));
        QVERIFY(!link.hasVehicle(clear));
        QVERIFY(!link.hasVehicle(older));
        link.setProtection(Protection::Plain, nullptr);
        QVERIFY(!link.hasVehicle(sealed));
        QVERIFY(link.hasVehicle(clear));
        clear.vehicles.front().state.lost = true;
        QVERIFY(!link.hasVehicle(clear));
    }

    void vehicleIsSettledWhenItKnowsItsPosition()
    {
        const MeasuredLink link;
        engine::Snapshot snapshot = withSession(kSession);
        addVehicle(snapshot, kSession);
        QVERIFY(!link.hasSettledVehicle(snapshot));
        snapshot.vehicles.front().state.ekfOk = true;
        snapshot.vehicles.front().state.home.latitude = 47.4;
        snapshot.vehicles.front().state.home.longitude = 8.5;
        QVERIFY(link.hasSettledVehicle(snapshot));
    }

    void answersCountSinceTheChangeOfMode()
    {
        MeasuredLink link;
        engine::Snapshot before = withSession(kSession), after = withSession(kNextSession);
        addVehicle(before, kSession, 5);
        addVehicle(after, kNextSession, 6);
        link.setProtection(Protection::Inline, &before);
        QVERIFY(!link.isAnswering(before));
        QVERIFY(link.isAnswering(after));
    }

    void plainNeedsTheOffersConsent()
    {
        MeasuredLink link;
        QVERIFY(link.refusal(kPlain).empty());
        engine::Snapshot snapshot = withSession(kSession);
        link.learnConsent(snapshot);
        QCOMPARE(link.refusal(kPlain).text(), std::string("the other end does not allow plain MAVLink"));
        snapshot.sessions.front().info.peerOffered = {SuiteId::None};
        link.learnConsent(snapshot);
        QVERIFY(link.refusal(kPlain).empty());
    }

    void silenceInPlainIsRefusalUntilARunSucceeded()
    {
        MeasuredLink link;
        link.plainSilent();
        QVERIFY(!link.refusal(kPlain).empty());
        link.plainSucceeded();
        link.plainSilent();
        QVERIFY(link.refusal(kPlain).empty());
    }

    void inlineNeedsASessionThatAgreesToIt()
    {
        MeasuredLink link;
        link.setProtection(Protection::Inline, nullptr);
        channel::SessionUp up;
        up.framing = channel::Framing::Inline;
        link.sessionUp(up);
        link.learnConsent(withSession(kSession));
        QVERIFY(link.refusal(kInline).empty());
        up.framing = channel::Framing::Sealed;
        link.sessionUp(up);
        link.learnConsent(withSession(kNextSession));
        QCOMPARE(link.refusal(kInline).text(), std::string("the other end does not allow inline framing"));
        QVERIFY(link.refusal(kSealed).empty());
    }

    void pendingSwitchLeavesTheSuite()
    {
        const MeasuredLink link;
        engine::Snapshot snapshot = withSession(kSession, SuiteId::Aes256Gcm);
        QVERIFY(link.isUnder(SuiteId::Aes256Gcm, snapshot));
        QVERIFY(!link.isUnder(SuiteId::Aes256Ctr, snapshot));
        snapshot.sessions.front().info.pending = SuiteId::Aes256Ctr;
        QVERIFY(!link.isUnder(SuiteId::Aes256Gcm, snapshot));
    }

    void linkIsRestoredUnderItsFirstSuite()
    {
        MeasuredLink link;
        const engine::Snapshot first = withSession(kSession, SuiteId::Aes256Ctr);
        link.update(first);
        link.update(withSession(kNextSession, SuiteId::Aes256Gcm));
        QVERIFY(link.firstSuite() == SuiteId::Aes256Ctr);
        QVERIFY(!link.isRestored(withSession(kNextSession, SuiteId::Aes256Gcm)));
        QVERIFY(link.isRestored(first));
        engine::Snapshot pending = first;
        pending.sessions.front().info.pending = SuiteId::Aes256Gcm;
        QVERIFY(!link.isRestored(pending));
        link.setProtection(Protection::Plain, nullptr);
        QVERIFY(!link.isRestored(first));
    }
};

SKYSEAL_TEST(MeasuredLinkTest)
#include "measured_link_test.moc"
