// Sessions with inline framing: negotiation, switches and bad links without loss, and attacks with recorded frames.
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/suite.h"
#include "inline_pair.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

namespace {

ReceiveCounters countersOf(const Pair::End &end)
{
    return end.stats()->rx;
}

/// Seals one frame of an end and keeps it off the wire.
Bytes sealOne(Pair &pair, Side from, std::size_t size = 28)
{
    Bytes out(kMaxInlineFrame);
    const auto sealed = pair.ends[from].sealInline(pair.now, numberedFrame(1, size), out);
    out.resize(sealed ? *sealed : 0);
    return out;
}

bool offerFrame(Pair &pair, Side to, Bytes frame, std::optional<Path> from = {})
{
    return pair.ends[to].handleInlineFrame(pair.now, from.value_or(pair.pathOf(to == Air ? Ground : Air)), frame).has_value();
}

} // namespace

class InlineSessionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void inlineFramingNeedsBothEnds_data();
    void inlineFramingNeedsBothEnds();
    void allSuitesBothWays();
    void stormOfSwitches();
    void sendsRecordsUntilThePeerIsHeard();
    void neverMovesTheAddress();
    void replayedReflectedForged_data() { everyInlineSuite(); }
    void replayedReflectedForged();
    void acrossEpochs();
    void consentWithdrawn();
    void hardStopExactlyThere();
};

void InlineSessionTest::inlineFramingNeedsBothEnds_data()
{
    QTest::addColumn<int>("ground");
    QTest::addColumn<int>("air");
    QTest::addColumn<bool>("agreed");
    const char *names[] = {"no", "allows", "prefers"};
    for (int ground = 0; ground < 3; ++ground) {
        for (int air = 0; air < 3; ++air)
            QTest::addRow("ground %s, air %s", names[ground], names[air])
                << ground << air << (ground > 0 && air > 0 && ground + air > 2);
    }
}

void InlineSessionTest::inlineFramingNeedsBothEnds()
{
    QFETCH(int, ground);
    QFETCH(int, air);
    QFETCH(bool, agreed);
    PairOptions options = inlineOptions();
    options.ground.allowInline = ground > 0, options.ground.preferInline = ground > 1;
    options.air.allowInline = air > 0, options.air.preferInline = air > 1;
    const auto pair = inlinePair(SuiteId::ChaCha20, options);
    QVERIFY(pair->bothUp());
    for (const Side side : {Ground, Air}) {
        QCOMPARE(framingOf(pair->ends[side]) == Framing::Inline, agreed);
        QCOMPARE(!sealOne(*pair, side).empty(), agreed);
    }

    // Without message traits inline framing is not negotiated, whatever the policy.
    options.messageTraits = nullptr;
    const auto blind = inlinePair(SuiteId::ChaCha20, options);
    QVERIFY(blind->bothUp() && framingOf(blind->ground()) == Framing::Sealed);
}

void InlineSessionTest::allSuitesBothWays()
{
    Pair pair(inlineOptions());
    pair.run(5s, [&] { return pair.bothUp(); });
    pair.run(1s);
    pair.every(10ms, [&] { pair.sendFrame(Air, 9 + pair.sent[Air].size() % 240); });
    pair.every(13ms, [&] { pair.sendFrame(Ground, 9 + pair.sent[Ground].size() % 240); });
    std::uint64_t inPlace = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        inPlace += looksInline(flight.bytes);
        return true;
    };
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (info.id == SuiteId::None)
            continue;
        pair.ground().switchSuite(pair.now, info.id);
        pair.run(3s);
        QCOMPARE(pair.ground().sessionInfo()->suite, info.id);
        for (const Side side : {Ground, Air})
            QCOMPARE(framingOf(pair.ends[side]) == Framing::Inline, crypto::mayBeInline(info.id));
    }
    pair.stopTraffic();
    pair.run(3s);
    for (const Side side : {Ground, Air}) {
        QCOMPARE(pair.accountFrom(side), std::string());
        const auto stats = pair.ends[side].stats();
        QCOMPARE(stats->rx.lost + stats->rx.forged + stats->rx.replayed + stats->rx.malformed, std::uint64_t(0));
        QCOMPARE(stats->peerTx.records + 1,
                 stats->rx.good); // records and frames are counted together; the report was sent before it was counted itself
    }
    QVERIFY(inPlace > 1500);
}

void InlineSessionTest::stormOfSwitches()
{
    PairOptions options = inlineOptions(99);
    options.link = {.loss = 0.2, .duplicate = 0.1, .reorder = 0.1, .delay = 20ms, .jitter = 60ms};
    Pair pair(options);
    QVERIFY(pair.run(20s, [&] { return pair.bothUp(); }));
    pair.every(10ms, [&] { pair.sendFrame(Air); });
    pair.every(10ms, [&] { pair.sendFrame(Ground); });
    std::vector<SuiteId> suites = crypto::sealedSuites(); // those that do not seal in place as well
    std::size_t turn = 0;
    pair.every(700ms, [&] { pair.ground().switchSuite(pair.now, suites[turn++ % suites.size()]); });
    pair.every(1100ms, [&] { pair.air().switchSuite(pair.now, suites[turn++ % suites.size()]); });
    pair.run(120s);
    pair.stopTraffic();
    pair.link.model = {};
    pair.run(10s);
    for (const Side side : {Ground, Air}) {
        QCOMPARE(pair.accountFrom(side), std::string());
        QVERIFY(std::is_sorted(pair.ends[side].epochs.begin(), pair.ends[side].epochs.end())
                || pair.ends[side].epochs.size() > 1000); // late ones of the epoch before are allowed
        QCOMPARE(countersOf(pair.ends[side]).forged, std::uint64_t(0));
    }
    std::size_t committed = 0;
    for (const auto &done : pair.ground().all<SwitchDone>())
        committed += done.failure == SwitchFailure::None;
    QVERIFY(committed > 40);
    QCOMPARE(pair.ground().all<SessionUp>().size(), std::size_t(1));
}

void InlineSessionTest::sendsRecordsUntilThePeerIsHeard()
{
    PairOptions options = inlineOptions();
    for (Policy *policy : {&options.ground, &options.air})
        policy->suites = {SuiteId::Aes256Ctr};
    Pair pair(options);
    // The station is up with the answer. It sends records until it has received a record.
    QVERIFY(pair.run(5s, [&] { return pair.ground().up(); }));
    QCOMPARE(framingOf(pair.ground()), Framing::Sealed);
    QVERIFY(pair.sendFrame(Ground) != 0);
    pair.run(2s);
    QCOMPARE(framingOf(pair.ground()), Framing::Inline);
    QCOMPARE(framingOf(pair.air()), Framing::Inline);
    QCOMPARE(pair.accountFrom(Ground), std::string());
    QCOMPARE(countersOf(pair.air()).malformed + pair.air().unmatched().malformed, std::uint64_t(0));
}

void InlineSessionTest::neverMovesTheAddress()
{
    const auto owner = inlinePair(SuiteId::Aes256Ctr);
    Pair &pair = *owner;
    const Path home = pair.ground().recordPath();
    Path elsewhere = pair.pathOf(Air);
    elsewhere.remote.port = 41000;
    const Bytes frame = sealOne(pair, Air);
    QVERIFY(!offerFrame(pair, Ground, frame, elsewhere)); // authentic, but its session has another address
    QCOMPARE(pair.ground().unmatched().malformed, std::uint64_t(1));
    QCOMPARE(pair.ground().recordPath(), home);
    QVERIFY(offerFrame(pair, Ground, frame));

    // The agent gets another port: its next report moves the session, and frames are accepted again from then on.
    pair.air().port = 41000;
    pair.run(1500ms);
    QCOMPARE(pair.ground().recordPath().remote.port, std::uint16_t(41000));
    QVERIFY(offerFrame(pair, Ground, sealOne(pair, Air)));
}

void InlineSessionTest::replayedReflectedForged()
{
    QFETCH(int, suite);
    const auto owner = inlinePair(static_cast<SuiteId>(suite));
    Pair &pair = *owner;
    const Bytes frame = sealOne(pair, Air, 33);
    const ReceiveCounters before = countersOf(pair.ground());

    QVERIFY(!offerFrame(pair, Air, frame)); // reflected
    std::uint64_t forged = 0;
    for (std::size_t bit = 0; bit < frame.size() * 8; ++bit) {
        Bytes other = frame;
        other[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
        QVERIFY(!offerFrame(pair, Ground, other));
        ++forged;
    }
    const ReceiveCounters after = countersOf(pair.ground());
    QCOMPARE(after.forged + after.malformed + after.replayed - before.forged - before.malformed - before.replayed, forged);
    QCOMPARE(after.lost, before.lost); // no forged counter moved the window
    QVERIFY(offerFrame(pair, Ground, frame));
    for (int i = 0; i < 3; ++i)
        QVERIFY(!offerFrame(pair, Ground, frame));
    QCOMPARE(countersOf(pair.ground()).replayed, after.replayed + 3);
    for (int i = 0; i < 2049; ++i)
        QVERIFY(offerFrame(pair, Ground, sealOne(pair, Air)));
    QVERIFY(!offerFrame(pair, Ground, frame)); // by now older than the window
    pair.run(2s);
    QVERIFY(pair.sendFrame(Air) && pair.run(2s) == false && pair.accountFrom(Air).empty());
}

void InlineSessionTest::acrossEpochs()
{
    const auto owner = inlinePair(SuiteId::Aes256Ctr);
    Pair &pair = *owner;
    const Bytes old = sealOne(pair, Air);
    pair.ground().switchSuite(pair.now, SuiteId::ChaCha20);
    pair.run(1s);
    QVERIFY(offerFrame(pair, Ground, old)); // late, under the keys of the epoch before
    const Bytes older = sealOne(pair, Air);
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Cbc);
    pair.run(10s);
    QVERIFY(!offerFrame(pair, Ground, older)); // those keys are gone
    Bytes relabelled = older;
    ++relabelled[relabelled.size() - kInlineTrailer];
    relabelled[relabelled.size() - kInlineTrailer + 2] = 0xff; // a counter that is fresh there
    QVERIFY(!offerFrame(pair, Ground, relabelled));
    QCOMPARE(countersOf(pair.ground()).forged, std::uint64_t(1));
}

void InlineSessionTest::consentWithdrawn()
{
    const auto owner = inlinePair(SuiteId::Aes256Ctr);
    Pair &pair = *owner;
    const Bytes frame = sealOne(pair, Air);
    Policy policy = pair.ground().policy;
    policy.allowInline = false;
    pair.ground().setPolicy(pair.now, policy);
    QCOMPARE(framingOf(pair.ground()), Framing::Sealed);
    QVERIFY(!offerFrame(pair, Ground, frame));
    QCOMPARE(countersOf(pair.ground()).malformed, std::uint64_t(1));
}

void InlineSessionTest::hardStopExactlyThere()
{
    PairOptions options = inlineOptions();
    options.timing.hardStopRecords = 500;
    options.timing.rekeyAfterRecords = 1u << 30;
    const auto owner = inlinePair(SuiteId::Aes256Ctr, options);
    Pair &pair = *owner;
    const auto counterOf = [](const Bytes &frame) {
        const std::size_t at = frame.size() - kInlineTrailer + 1;
        return frame[at] | frame[at + 1] << 8 | frame[at + 2] << 16;
    };
    int last = -1;
    for (Bytes frame = sealOne(pair, Air); !frame.empty(); frame = sealOne(pair, Air)) {
        QVERIFY(counterOf(frame) > last);
        last = counterOf(frame);
        if (last == 499)
            break;
    }
    QCOMPARE(last, 499);
    QVERIFY(sealOne(pair, Air).empty());
    pair.pump();
    QCOMPARE(pair.air().all<SessionDown>().back().reason, DownReason::Exhausted);
}

SKYSEAL_TEST_APPLESS(InlineSessionTest)
#include "inline_session_test.moc"
