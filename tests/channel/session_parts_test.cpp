// The parts of a session, each alone: the path of the peer, the exchange of reports, the handover between epochs, the schedule
// of rekeys, the counter of forgeries, and what both ends permit.
#include "core/channel/epoch_handover.h"
#include "core/channel/forgery_counter.h"
#include "core/channel/peer_path.h"
#include "core/channel/permissions.h"
#include "core/channel/rekey_schedule.h"
#include "core/channel/report_exchange.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::channel;
using namespace std::chrono_literals;
using crypto::SuiteId;

class SessionPartsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newPathIsKeptAfterItsConfirmation();
    void newPathWithoutRecordsIsLeft();
    void returnToTheFormerPathEndsTheTrial();
    void chainOfMovesKeepsTheConfirmedPath();
    void echoOfAReportToElsewhereConfirmsNothing();
    void serialPathHasNoTrial();
    void pathOfAFirstMessageIsNoFormerOne();
    void movesAreReportedOnceASecond();
    void roundTripFromAnEcho();
    void olderReportIsIgnored();
    void stampIsNeverZero();
    void reportsCarryTheFrameCounters();
    void previousEpochIsCompleteByCountOrByTime();
    void previousKeysAreWipedAfterThePeerMoved();
    void rekeyIsDueByAgeOrRecords();
    void failedRekeyIsNotDueAtOnce();
    void alarmsAreLimitedAndCountAll();
    void permissionsFollowOurPolicy();
    void inlineFramingNeedsBothAndThePolicy();

private:
    static Path path(std::uint16_t port, Carrier carrier = Carrier::Datagram)
    {
        Path out{LinkId{1}, {}};
        out.remote.port = port;
        out.carrier = carrier;
        return out;
    }

    const TimePoint m_start{1h};
    const Path m_first = path(1), m_second = path(2), m_third = path(3);
};

void SessionPartsTest::newPathIsKeptAfterItsConfirmation()
{
    PeerPath peer(m_first, m_start, 2500ms);
    QCOMPARE(peer.deadline(), kNever);
    peer.moveTo(m_second, m_start, 1000);
    QVERIFY(peer.takeMove(m_start));
    QCOMPARE(peer.deadline(), m_start + 2500ms);
    peer.confirm(m_second, 999);  // a stamp from before the move
    peer.confirm(m_first, 1001);  // from elsewhere
    peer.confirm(m_second, 1000); // the stamp of the move itself
    QCOMPARE(peer.deadline(), m_start + 2500ms);
    peer.confirm(m_second, 1001);
    QCOMPARE(peer.deadline(), kNever);
    peer.handleDeadline(m_start + 1min);
    QVERIFY(peer.current() == m_second && peer.origin() == m_first);
}

void SessionPartsTest::newPathWithoutRecordsIsLeft()
{
    PeerPath peer(m_first, m_start, 2500ms);
    peer.moveTo(m_second, m_start, 1000);
    peer.stay(m_start + 1s);
    peer.handleDeadline(m_start + 3499ms);
    QVERIFY(peer.current() == m_second);
    peer.handleDeadline(m_start + 3500ms);
    QVERIFY(peer.current() == m_first);
    QCOMPARE(peer.deadline(), kNever); // the other path was never reported
}

void SessionPartsTest::returnToTheFormerPathEndsTheTrial()
{
    PeerPath peer(m_first, m_start, 2500ms);
    peer.moveTo(m_second, m_start, 1000);
    peer.moveTo(m_first, m_start + 1s, 1001000);
    peer.handleDeadline(m_start + 1min);
    QVERIFY(peer.current() == m_first);
    QVERIFY(!peer.takeMove(m_start + 1min));
}

void SessionPartsTest::chainOfMovesKeepsTheConfirmedPath()
{
    PeerPath peer(m_first, m_start, 2500ms);
    peer.moveTo(m_second, m_start, 1000);
    peer.moveTo(m_third, m_start + 1s, 1001000);
    peer.confirm(m_third, 5000); // It was sent to the second path.
    peer.handleDeadline(m_start + 3500ms);
    QVERIFY(peer.current() == m_first);
}

void SessionPartsTest::echoOfAReportToElsewhereConfirmsNothing()
{
    PeerPath peer(m_first, m_start, 2500ms);
    peer.moveTo(m_second, m_start, 1000);
    QVERIFY(peer.takeMove(m_start));
    peer.reportSent(m_second, 2000);
    peer.reportSent(m_first, 3000);
    peer.confirm(m_second, 2000); // The report to the second path may be lost, and the echo relayed.
    peer.confirm(m_second, 3000);
    QCOMPARE(peer.deadline(), m_start + 2500ms);
    peer.reportSent(m_second, 4000);
    peer.confirm(m_second, 4000);
    QCOMPARE(peer.deadline(), kNever);
}

void SessionPartsTest::serialPathHasNoTrial()
{
    PeerPath peer(path(1, Carrier::Serial), m_start, 2500ms);
    peer.moveTo(path(2, Carrier::Serial), m_start, 1000);
    peer.handleDeadline(m_start + 1min);
    QVERIFY(peer.current() == path(2, Carrier::Serial));
}

void SessionPartsTest::pathOfAFirstMessageIsNoFormerOne()
{
    PeerPath peer(m_first, m_start, 2500ms, false);
    QCOMPARE(peer.deadline(), kNever);
    peer.moveTo(m_second, m_start, 1000);
    QVERIFY(peer.handleDeadline(m_start + 2499ms));
    QVERIFY(!peer.handleDeadline(m_start + 2500ms)); // nowhere to return to
    QVERIFY(peer.current() != m_first);

    PeerPath heard(m_first, m_start, 2500ms, false);
    heard.stay(m_start);
    heard.moveTo(m_second, m_start, 1000);
    QVERIFY(heard.handleDeadline(m_start + 2500ms));
    QVERIFY(heard.current() == m_first);

    PeerPath proven(m_first, m_start, 2500ms, false);
    proven.moveTo(m_second, m_start, 1000);
    proven.confirm(m_second, 2000);
    QVERIFY(proven.handleDeadline(m_start + 1min));
    QVERIFY(proven.current() == m_second);
}

void SessionPartsTest::movesAreReportedOnceASecond()
{
    PeerPath peer(m_first, m_start, 1min);
    QVERIFY(!peer.takeMove(m_start));
    peer.moveTo(m_second, m_start, 1000);
    const auto move = peer.takeMove(m_start);
    QVERIFY(move && move->from == m_first && move->to == m_second);
    peer.moveTo(m_third, m_start + 100ms, 101000);
    QVERIFY(!peer.takeMove(m_start + 999ms));
    QCOMPARE(peer.deadline(), m_start + 1s);
    const auto next = peer.takeMove(m_start + 1s);
    QVERIFY(next && next->from == m_second && next->to == m_third);
}

void SessionPartsTest::roundTripFromAnEcho()
{
    ReportExchange ours(m_start, m_start), theirs(m_start - 5s, kNever);
    const Report sent = ours.make(m_start + 1s);
    QCOMPARE(sent.echo, 0u);
    QVERIFY(theirs.handle(m_start + 1030ms, sent));
    QVERIFY(!theirs.roundTrip().known());
    const Report answer = theirs.make(m_start + 1200ms);
    QCOMPARE(answer.echo, sent.stamp);
    QCOMPARE(answer.held, 170000u);
    QVERIFY(ours.handle(m_start + 1220ms, answer));
    const auto trip = ours.roundTrip().smoothed();
    QVERIFY(trip > 49ms && trip < 51ms);
}

void SessionPartsTest::olderReportIsIgnored()
{
    ReportExchange ours(m_start, m_start);
    Report report;
    report.stamp = 5;
    report.rx.good = 1;
    report.asksCosts = true;
    QVERIFY(ours.handle(m_start, report));
    QVERIFY(ours.peerAsksCosts());
    QVERIFY(!ours.handle(m_start, report));
    report.stamp = 0xffffff00; // before the wrap
    report.rx.good = 2;
    report.asksCosts = false;
    QVERIFY(!ours.handle(m_start, report));
    QVERIFY(ours.peerAsksCosts());
    SessionStats stats;
    ours.addTo(stats);
    QVERIFY(stats.peerReported && stats.peerRx.good == 1 && stats.peerStamp == 5);
}

void SessionPartsTest::stampIsNeverZero()
{
    const ReportExchange reports(m_start, kNever);
    QCOMPARE(reports.stamp(m_start), 1u);
    QCOMPARE(reports.stamp(m_start + std::chrono::microseconds(std::int64_t(1) << 32)), 1u);
    QCOMPARE(reports.stamp(m_start + 1s), 1000001u);
}

void SessionPartsTest::reportsCarryTheFrameCounters()
{
    ReportExchange reports(m_start, kNever);
    QVERIFY(!reports.make(m_start).frames);
    reports.noteFrames({900, 1});
    QVERIFY(reports.make(m_start).frames && reports.make(m_start).frames->taken == 900);
}

void SessionPartsTest::previousEpochIsCompleteByCountOrByTime()
{
    RoundTrip trip;
    EpochHandover handover;
    handover.epochBegan(300);
    QCOMPARE(handover.sentBefore(), 300u);
    QVERIFY(!handover.complete(m_start + 1h, 0, trip)); // The peer may have sent more.
    handover.countReported();
    QVERIFY(handover.complete(m_start, 0, trip));
    QVERIFY(!handover.complete(m_start + 1h, 1, trip));
    handover.peerSends(m_start);
    QVERIFY(!handover.complete(m_start + 1h, 1, trip)); // The round trip is not known.
    for (int i = 0; i < 3; ++i)
        trip.add(100ms);
    QVERIFY(!handover.complete(m_start + trip.generous() - 1ms, 1, trip));
    QVERIFY(handover.complete(m_start + trip.generous(), 1, trip));
    handover.epochBegan(7);
    QVERIFY(!handover.complete(m_start + 1h, 0, trip));
}

void SessionPartsTest::previousKeysAreWipedAfterThePeerMoved()
{
    RoundTrip trip;
    EpochHandover handover;
    handover.epochBegan(1);
    QCOMPARE(handover.retireAt(3s, trip), kNever);
    handover.peerSends(m_start);
    handover.peerSends(m_start + 1s); // The first record counts.
    QVERIFY(handover.peerMoved());
    QCOMPARE(handover.retireAt(3s, trip), m_start + 3s);
    trip.add(2s);
    QCOMPARE(handover.retireAt(3s, trip), m_start + trip.generous());
}

void SessionPartsTest::rekeyIsDueByAgeOrRecords()
{
    const Timing timing;
    const RekeySchedule station(timing, true, m_start), agent(timing, false, m_start);
    QVERIFY(!station.due(m_start + 600s - 1ms, 0));
    QVERIFY(station.due(m_start + 600s, 0));
    QVERIFY(!agent.due(m_start + 659s, 0)); // later, so that the two do not cross
    QVERIFY(agent.due(m_start + 660s, 0));
    QVERIFY(!agent.due(m_start, timing.rekeyAfterRecords - 1));
    QVERIFY(agent.due(m_start, timing.rekeyAfterRecords));
}

void SessionPartsTest::failedRekeyIsNotDueAtOnce()
{
    const Timing timing;
    RekeySchedule schedule(timing, true, m_start);
    const TimePoint due = m_start + 600s;
    schedule.started(due);
    QVERIFY(!schedule.due(due + 2 * timing.switchConfirm - 1ms, timing.rekeyAfterRecords));
    QVERIFY(schedule.due(due + 2 * timing.switchConfirm, 0));
    schedule.started(due + 20s);
    schedule.epochBegan(due + 21s);
    QVERIFY(!schedule.due(due + 22s, 0));
    QVERIFY(schedule.due(due + 22s, timing.rekeyAfterRecords)); // The limit of the new epoch counts at once.
}

void SessionPartsTest::alarmsAreLimitedAndCountAll()
{
    ForgeryCounter counter(m_start);
    counter.addReplayed();
    QCOMPARE(counter.deadline(), kNever); // Duplicates alone are no attack.
    QVERIFY(!counter.take(m_start + 1min));
    counter.addForged();
    QCOMPARE(counter.pendingForged(), std::uint64_t(1));
    const auto first = counter.take(m_start + 1min);
    QVERIFY(first && first->forged == 1 && first->replayed == 1);
    for (int i = 0; i < 500; ++i)
        counter.addForged();
    QVERIFY(!counter.take(m_start + 1min + 999ms));
    QCOMPARE(counter.deadline(), m_start + 1min + 1s);
    const auto second = counter.take(counter.deadline());
    QVERIFY(second && second->forged == 500 && second->replayed == 0);
    QCOMPARE(counter.deadline(), kNever);
}

void SessionPartsTest::permissionsFollowOurPolicy()
{
    SuiteOffer ours{{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Rc4}, true, true};
    const SuiteOffer peers{{SuiteId::Rc4, SuiteId::Aes256Gcm, SuiteId::ChaCha20Poly1305}, true, true};
    const Permissions station(ours, peers, true, false), agent(ours, peers, false, false);
    QCOMPARE(station.suites(), (std::vector{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Rc4}));
    QCOMPARE(agent.suites(), (std::vector{SuiteId::Rc4, SuiteId::Aes256Gcm, SuiteId::ChaCha20Poly1305}));
    QVERIFY(station.permits(SuiteId::Rc4) && station.permittedHere(SuiteId::Rc4));
    QVERIFY(!station.permits(SuiteId::None) && !station.permittedHere(SuiteId::None));
    QVERIFY(!station.permits(SuiteId::Aes256Ctr) && !station.permittedHere(SuiteId::Aes256Ctr));
    ours.allowResearch = false;
    QVERIFY(!station.permits(SuiteId::Rc4) && !station.permittedHere(SuiteId::Rc4));
    ours.suites = {SuiteId::Aes256Gcm, SuiteId::Aes256Ctr};
    QCOMPARE(agent.suites(), std::vector{SuiteId::Aes256Gcm});
    QVERIFY(!agent.permits(SuiteId::Aes256Ctr) && agent.permittedHere(SuiteId::Aes256Ctr));
    QCOMPARE(agent.offeredByPeer(), peers);
}

void SessionPartsTest::inlineFramingNeedsBothAndThePolicy()
{
    SuiteOffer ours{{SuiteId::Aes256Ctr}, false, false, true, true};
    const SuiteOffer peers{{SuiteId::Aes256Ctr}, false, false, true, false};
    QCOMPARE(Permissions(ours, peers, true, false).framing(), Framing::Sealed);
    const Permissions agreed(ours, peers, true, true);
    QCOMPARE(agreed.framing(), Framing::Inline);
    ours.preferInline = false; // neither end prefers it
    QVERIFY(agreed.inlineAllowed() && agreed.framing() == Framing::Sealed);
    ours.preferInline = true;
    ours.allowInline = false;
    QVERIFY(agreed.inlineAgreed() && !agreed.inlineAllowed() && agreed.framing() == Framing::Sealed);
}

SKYSEAL_TEST(SessionPartsTest)
#include "session_parts_test.moc"
