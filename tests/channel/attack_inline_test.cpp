// Attacks on inline frames under every suite that has them: changed, truncated, invented and replayed frames.
#include "attack.h"
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "inline_pair.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackInlineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void everyBitOfAFrame_data() { everyInlineSuite(); }
    void everyBitOfAFrame();
    void everyLengthOfAFrame_data() { everyInlineSuite(); }
    void everyLengthOfAFrame();
    void replayOfFrames_data() { everyInlineSuite(); }
    void replayOfFrames();
};

namespace {

bool offerFrame(Pair &pair, Side to, Bytes bytes)
{
    return pair.ends[to].handleInlineFrame(pair.now, pair.pathOf(to == Air ? Ground : Air), bytes).has_value();
}

/// Recomputes the checksum as an attacker can: it needs no key.
Bytes withRightChecksum(Bytes frame)
{
    const engine::DialectTraits traits(mavlink::Dialect::builtin());
    const std::size_t end = frame.size() - kInlineTrailer - 2;
    const std::uint8_t crcExtra = mavlink::Dialect::builtin().find("COMMAND_LONG")->crcExtra;
    const std::uint16_t checksum = traits.checksum(ByteView(frame).subspan(1, end - 1), crcExtra);
    frame[end] = static_cast<std::uint8_t>(checksum);
    frame[end + 1] = static_cast<std::uint8_t>(checksum >> 8);
    return frame;
}

} // namespace

#define INLINE_PAIR                                                                                                            \
    QFETCH(int, suite);                                                                                                        \
    const auto owner = inlinePair(static_cast<SuiteId>(suite));                                                                \
    Pair &pair = *owner;                                                                                                       \
    QVERIFY(pair.bothUp() && framingOf(pair.air()) == Framing::Inline)

void AttackInlineTest::everyBitOfAFrame()
{
    INLINE_PAIR;
    for (const std::size_t size : {9u, 16u, 33u}) {
        const Caught caught = catchOne(pair, size);
        QVERIFY(looksInline(caught.flight.bytes));
        const auto before = received(pair.ground());
        std::uint64_t offered = 0;
        for (std::size_t bit = caught.flight.bytes.size() * 8; bit-- > 0;) {
            Bytes changed = caught.flight.bytes;
            changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1u << bit % 8);
            HOLDS(!offerFrame(pair, Ground, changed), "no changed bit of a frame is accepted");
            const Bytes plausible = withRightChecksum(changed);
            HOLDS(plausible == caught.flight.bytes || !offerFrame(pair, Ground, plausible),
                  "no changed bit of a frame is accepted");
            offered += plausible == caught.flight.bytes ? 1 : 2;
        }
        QCOMPARE(refused(received(pair.ground())) - refused(before), offered);
        QCOMPARE(received(pair.ground()).lost, before.lost);
        QVERIFY(offerFrame(pair, Ground, caught.flight.bytes));
        ++pair.ground().delivered[caught.number];
    }
    QVERIFY(aliveAndExact(pair));
}

void AttackInlineTest::everyLengthOfAFrame()
{
    INLINE_PAIR;
    const Caught caught = catchOne(pair, 40);
    const std::size_t full = caught.flight.bytes.size();
    const auto good = received(pair.ground()).good;
    for (std::size_t length = 0; length <= full + 32; ++length) {
        Bytes changed = caught.flight.bytes;
        changed.resize(length, 0xa5);
        if (length != full)
            offerFrame(pair, Ground, changed);
    }
    // The same with matching length field, checksum and trailer, none of which needs a key.
    const Bytes &whole = caught.flight.bytes;
    for (std::size_t payload = 1; payload <= 255; ++payload) {
        Bytes changed(whole.begin(), whole.end() - static_cast<std::ptrdiff_t>(2 + kInlineTrailer));
        if (changed.size() == 10 + payload)
            continue;
        changed.resize(10 + payload + 2, 0xa5);
        changed[1] = static_cast<std::uint8_t>(payload);
        changed.insert(changed.end(), whole.end() - static_cast<std::ptrdiff_t>(kInlineTrailer), whole.end());
        offerFrame(pair, Ground, withRightChecksum(changed));
    }
    HOLDS(received(pair.ground()).good == good, "no other length of a frame is accepted");
    QVERIFY(offerFrame(pair, Ground, caught.flight.bytes));
    ++pair.ground().delivered[caught.number];
    QVERIFY(aliveAndExact(pair));
}

void AttackInlineTest::replayOfFrames()
{
    INLINE_PAIR;
    Tap tap(pair);
    for (int i = 0; i < 100; ++i) {
        pair.sendFrame(Air, 20);
        pair.run(10ms);
    }
    pair.run(50ms);
    pair.link.attacker = nullptr;
    std::size_t taken = 0, tried = 0;
    for (const SentDatagram &flight : tap.flights) {
        if (!looksInline(flight.bytes))
            continue;
        ++tried;
        for (const Side side : {Ground, Air}) // replayed, and reflected
            taken += offerFrame(pair, side, flight.bytes);
    }
    QVERIFY(tried >= 100);
    HOLDS(taken == 0, "no frame is accepted twice, nor by its sender");
    QVERIFY(aliveAndExact(pair));
}

SKYSEAL_TEST(AttackInlineTest)
#include "attack_inline_test.moc"
