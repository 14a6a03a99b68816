// Messages that arrive after their context has changed: handshakes of removed peers, abandoned switches, and counts and closes
// that overtook records.
#include "core/channel/handshake_messages.h"
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "inline_pair.h"
#include "tap.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class LateMessagesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void recordOfARemovedPeer();
    void answerOfARemovedPeer();
    void forgedAnswerBeforeTheTrueOne();
    void countOfADeletedEpoch();
    void refusalIsRepeated();
    void suiteThatThePeerNeverOffered();
    void commitOfAnAbandonedSwitch();
    void closedWhileASwitchIsInDoubt();
    void policyThatLeavesNothing();
    void closeThatOvertookALostRecord();
    void inlineFrameEndsTheAttempt();
    void inlineFrameOfAnEpochWithoutInlineFraming();
};

namespace {

std::unique_ptr<Pair> settledPair(PairOptions options = {})
{
    auto pair = std::make_unique<Pair>(std::move(options));
    pair->run(5s, [&] { return pair->bothUp(); });
    pair->run(1s);
    return pair;
}

bool isRecord(const SentDatagram &flight)
{
    return (flight.bytes[0] & 0xfc) == 0x50;
}

void give(Pair &pair, Side to, Bytes datagram)
{
    pair.ends[to].handleDatagram(pair.now, pair.pathOf(to == Air ? Ground : Air), datagram);
    pair.pump();
}

/// The agent's answer to a handshake. It and all others are withheld while the attacker is present; empty if there was none.
Bytes catchAnswer(Pair &pair)
{
    Bytes answer;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] != 0x5a)
            return true;
        answer = flight.bytes;
        return false;
    };
    pair.run(2s, [&] { return !answer.empty(); });
    pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.bytes[0] != 0x5a; };
    return answer;
}

SuiteId suiteOf(Pair &pair, Side side)
{
    return pair.ends[side].sessionInfo()->suite;
}

} // namespace

void LateMessagesTest::recordOfARemovedPeer()
{
    Pair pair;
    std::optional<Bytes> proof; // the record by which the station confirms the session
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == Ground && isRecord(flight) && !proof)
            proof = flight.bytes;
        return flight.from == Air || !isRecord(flight);
    };
    QVERIFY(pair.run(2s, [&] { return proof.has_value(); }));
    QVERIFY(!pair.air().up());
    const auto peers = pair.configOf(Air).peers;
    pair.air().setPeers(pair.now, {});
    give(pair, Air, *proof);
    QVERIFY(!pair.air().up());
    QVERIFY(pair.air().all<SessionUp>().empty());
    QCOMPARE(pair.air().unmatched().malformed, std::uint64_t(1));
    pair.air().setPeers(pair.now, peers);
    give(pair, Air, *proof); // its keys were deleted
    QVERIFY(!pair.air().up());
    pair.link.attacker = {};
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
}

void LateMessagesTest::answerOfARemovedPeer()
{
    Pair pair;
    const Bytes answer = catchAnswer(pair);
    QVERIFY(!answer.empty());
    const auto peers = pair.configOf(Ground).peers;
    pair.ground().setPeers(pair.now, {});
    const auto sent = pair.ground().datagramsOut;
    give(pair, Ground, answer);
    pair.run(5s);
    QVERIFY(!pair.ground().up());
    QCOMPARE(pair.ground().datagramsOut, sent);
    pair.link.attacker = {};
    pair.ground().setPeers(pair.now, peers);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
}

void LateMessagesTest::forgedAnswerBeforeTheTrueOne()
{
    Pair pair;
    const Bytes answer = catchAnswer(pair);
    QVERIFY(!answer.empty());
    for (const std::size_t at : {3u, 34u, 35u, 57u}) {
        Bytes forged = answer;
        forged[at] ^= 1;
        Mac1(pair.ground().publicKey()).sign(forged); // possible with the public key
        give(pair, Ground, forged);
        QVERIFY(!pair.ground().up());
    }
    QCOMPARE(pair.ground().unmatched().forged, std::uint64_t(4));
    QCOMPARE(pair.ground().all<HandshakeRefused>().at(0).reason, RefusalReason::WrongKey);
    QCOMPARE(pair.ground().all<HandshakeRefused>().at(0).peer, pair.air().publicKey());
    give(pair, Ground, answer);
    QVERIFY(pair.ground().up());
}

void LateMessagesTest::countOfADeletedEpoch()
{
    // The last frames of an epoch are lost, and the message with their number is delayed beyond the lifetime of the epoch's
    // keys.
    auto pair = settledPair();
    std::uint64_t lost = 0;
    bool losing = false;
    const TimePoint confirmsFrom = pair->now + 8s;
    pair->link.attacker = [&](TimePoint at, SentDatagram &flight) {
        constexpr std::size_t kConfirm = 6 + 9 + 16;
        const bool drop = flight.from == Ground && isRecord(flight)
            && ((flight.tag && losing) || (flight.bytes.size() == kConfirm && at < confirmsFrom));
        lost += drop;
        return !drop;
    };
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    pair->pump();
    losing = true;
    for (int i = 0; i < 5; ++i)
        pair->sendFrame(Ground, 100); // still under the old epoch, and nothing comes behind them
    losing = false;
    pair->run(7s);
    const auto lostSaid = [&] { return pair->air().stats()->rx.lost; };
    QCOMPARE(suiteOf(*pair, Air), SuiteId::Aes256Gcm);
    QVERIFY(lostSaid() < lost);
    pair->run(5s);
    QCOMPARE(lostSaid(), lost);
}

void LateMessagesTest::refusalIsRepeated()
{
    auto pair = settledPair();
    pair->air().setPolicy(pair->now, Policy{{SuiteId::ChaCha20Poly1305}, true, false}); // known to itself alone
    const TimePoint until = pair->now + 450ms;
    pair->link.attacker = [&](TimePoint at, SentDatagram &flight) { return flight.from == Ground || at > until; };
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    pair->run(400ms);
    QVERIFY(pair->ground().all<SwitchDone>().empty());
    pair->run(1s);
    const auto done = pair->ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::NotAllowedByPeer);
    QVERIFY(done[0].took < 2s);
    QVERIFY(pair->air().all<SwitchPending>().empty());
}

void LateMessagesTest::suiteThatThePeerNeverOffered()
{
    PairOptions options;
    options.air.suites = {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Ctr};
    auto pair = settledPair(options);
    const auto sent = pair->ground().datagramsOut;
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    pair->pump();
    const auto done = pair->ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::NotAllowedByPeer);
    QCOMPARE(pair->ground().datagramsOut, sent); // no request to the peer is needed
}

void LateMessagesTest::commitOfAnAbandonedSwitch()
{
    // The agent accepts, receives nothing until it reports a failure, and requests another suite. But the station had
    // committed: its records must open, and its choice stands.
    auto pair = settledPair();
    bool deaf = false;
    pair->link.attacker = [&](TimePoint, SentDatagram &flight) { return !(deaf && flight.from == Ground); };
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    QVERIFY(pair->run(1s, [&] { return deaf = !pair->air().all<SwitchPending>().empty(); }));
    pair->run(5500ms);
    QCOMPARE(suiteOf(*pair, Ground), SuiteId::Aes256Gcm);
    QCOMPARE(pair->air().all<SwitchDone>().at(0).failure, SwitchFailure::NotConfirmed);
    pair->air().switchSuite(pair->now, SuiteId::Aes256Ctr);
    pair->run(500ms);
    QCOMPARE(suiteOf(*pair, Air), SuiteId::ChaCha20Poly1305);
    deaf = false;
    pair->run(2s);
    const auto done = pair->air().all<SwitchDone>();
    QCOMPARE(done.size(), 3u);
    QVERIFY(done[1].byPeer && done[1].failure == SwitchFailure::None && done[1].to == SuiteId::Aes256Gcm);
    QVERIFY(!done[2].byPeer && done[2].failure == SwitchFailure::Superseded);
    QCOMPARE(pair->air().all<SwitchPending>().size(), 3u); // one for each
    QCOMPARE(suiteOf(*pair, Air), SuiteId::Aes256Gcm);
    const std::uint64_t number = pair->sendFrame(Air);
    pair->run(100ms);
    QCOMPARE(pair->ground().delivered[number], 1);
}

void LateMessagesTest::closedWhileASwitchIsInDoubt()
{
    auto pair = settledPair();
    pair->link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from == Ground; };
    pair->ground().switchSuite(pair->now, SuiteId::Aes256Gcm);
    QVERIFY(pair->run(1s, [&] { return !pair->air().all<SwitchPending>().empty(); }));
    pair->air().close(pair->now);
    pair->ground().close(pair->now);
    pair->pump();
    for (const Pair::End &end : pair->ends) {
        const auto done = end.all<SwitchDone>();
        QCOMPARE(done.size(), 1u);
        QCOMPARE(done[0].failure, SwitchFailure::SessionEnded);
    }
    QVERIFY(pair->air().all<SwitchDone>()[0].byPeer);
}

void LateMessagesTest::policyThatLeavesNothing()
{
    auto pair = settledPair();
    pair->ground().setPolicy(pair->now, Policy{{}, false, false});
    pair->run(100ms);
    QCOMPARE(pair->ground().all<SessionDown>().at(0).reason, DownReason::Closed);
    QCOMPARE(pair->air().all<SessionDown>().at(0).reason, DownReason::PeerClosed);
    pair->run(10s);
    QVERIFY(!pair->ground().up() && !pair->air().up());
}

void LateMessagesTest::closeThatOvertookALostRecord()
{
    auto pair = settledPair();
    pair->link.attacker = [](TimePoint, SentDatagram &flight) { return flight.tag == 0; };
    pair->sendFrame(Air);
    pair->link.attacker = {};
    pair->air().close(pair->now);
    pair->pump();
    pair->kill(Air); // which would announce itself again
    pair->run(2900ms);
    QVERIFY(pair->ground().up()); // The record may still come.
    pair->run(300ms);
    QVERIFY(!pair->ground().up());
    const auto down = pair->ground().all<SessionDown>();
    QCOMPARE(down.size(), 1u);
    QCOMPARE(down[0].reason, DownReason::PeerClosed);
    QCOMPARE(down[0].stats.rx.lost, std::uint64_t(1));
}

void LateMessagesTest::inlineFrameEndsTheAttempt()
{
    // A silent agent returns, and its first message is a frame, not a record.
    auto pair = inlinePair(SuiteId::Aes256Ctr);
    QCOMPARE(framingOf(pair->air()), Framing::Inline);
    bool frames = false;
    std::size_t calls = 0;
    pair->link.attacker = [&](TimePoint, SentDatagram &flight) {
        calls += flight.bytes[0] == 0x59;
        return flight.from == Ground ? flight.bytes[0] != 0x59 : frames && looksInline(flight.bytes);
    };
    pair->run(4s);
    QVERIFY(calls > 0);
    frames = true;
    const std::uint64_t number = pair->sendFrame(Air);
    pair->run(50ms);
    QCOMPARE(pair->ground().delivered[number], 1);
    const auto before = calls;
    pair->run(2s);
    QCOMPARE(calls, before);
    QCOMPARE(pair->ground().all<SessionDown>().size(), 0u);
}

void LateMessagesTest::inlineFrameOfAnEpochWithoutInlineFraming()
{
    auto pair = inlinePair(SuiteId::Aes256Ctr);
    const auto seal = [&](ByteView frame, MutableByteView out) { return pair->air().sealInline(pair->now, frame, out); };
    const Bytes frame = numberedFrame(1, 40);
    Bytes sealed(frame.size() + 13);
    QCOMPARE(seal(frame, MutableByteView(sealed).first(sealed.size() - 1)).error(), SealError::NoRoom);
    Bytes damaged = frame;
    damaged.back() ^= 1;
    QCOMPARE(seal(damaged, sealed).error(), SealError::NotInline); // sent in a record instead
    const auto records = pair->air().stats()->tx.records;
    QVERIFY(seal(frame, sealed));
    QCOMPARE(pair->air().stats()->tx.records, records + 1);

    pair->ground().switchSuite(pair->now, SuiteId::ChaCha20Poly1305);
    pair->run(5s);
    const auto epoch = pair->ground().sessionInfo()->epoch;
    sealed[sealed.size() - 13] = static_cast<std::uint8_t>(epoch); // whose suite never seals in place
    const auto rx = [&] { return pair->ground().stats()->rx; };
    const auto before = rx();
    QVERIFY(!pair->ground().handleInlineFrame(pair->now, pair->pathOf(Air), sealed));
    QCOMPARE(rx().malformed, before.malformed + 1);
    QCOMPARE(rx().good, before.good);
}

SKYSEAL_TEST(LateMessagesTest)
#include "late_messages_test.moc"
