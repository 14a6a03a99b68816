// Attacks on a pairing: a man in the middle, and other devices during the comparison of fingerprints.
#include "attack.h"
#include "core/channel/pairing_handshake.h"
#include "core/crypto/init_crypto.h"
#include "pairing_pair.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackPairingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void inBetween();
    void oneYesIsNotEnough();
    void inBetweenWithoutThePassphrase();
    void passphraseMustBeTheSame();
    void anotherWhileComparing();
};

namespace {

std::shared_ptr<const Key32> secret(std::uint8_t first)
{
    Key32 key;
    key.mutableView()[0] = first;
    return std::make_shared<const Key32>(std::move(key));
}

std::shared_ptr<const crypto::X25519KeyPair> newKey(RandomSource &random)
{
    return std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(random));
}

/// Who is in between: an agent of its own towards the station, and a station of its own towards the agent, at the true
/// ends' addresses. Everything that either end sends goes to it alone.
struct InBetween
{
    explicit InBetween(PairingPair &victims, std::shared_ptr<const Key32> passphraseKey = {}) : pair(victims)
    {
        for (const Side as : {Ground, Air}) {
            auto config = PairingPair::configOf(as, newKey(random));
            config.passphraseKey = passphraseKey;
            faces[as].emplace(config, random, pair.now);
            keys[as] = config.identity->publicKey;
        }
        pair.link.attacker = [this](TimePoint, Flight &flight) {
            const Side as = flight.from == Ground ? Air : Ground;
            faces[as]->handleDatagram(pair.now, PairingPair::pathOf(flight.from), flight.bytes);
            pump();
            return false;
        };
    }
    void pump()
    {
        for (const Side as : {Ground, Air}) {
            faces[as]->handleDeadline(pair.now);
            while (const auto out = faces[as]->pollTransmit())
                pair.link.inject(pair.now + 1ms, {as, 0, 0, Bytes(out->bytes.begin(), out->bytes.end())});
            if (faces[as]->peer())
                faces[as]->confirm(pair.now, faces[as]->peer()->key);
            while (const auto event = faces[as]->pollEvent())
                hints += std::holds_alternative<PairingPassphraseDiffers>(*event);
        }
    }

    PairingPair &pair;
    SeededRandom random{666};
    std::array<std::optional<Pairing>, 2> faces;
    std::array<channel::PublicKey, 2> keys;
    int hints = 0;
};

} // namespace

void AttackPairingTest::inBetween()
{
    PairingPair pair;
    InBetween attacker(pair);
    pair.openBoth();
    pair.run(5s);
    HOLDS(pair.ground().all<Paired>().empty() && pair.air().all<Paired>().empty(), "nothing is kept without both yeses");
    // It gets through, and what the two people see are two keys, neither of them the other one's.
    QVERIFY(pair.ground().pairing->peer() && pair.air().pairing->peer());
    QCOMPARE(pair.ground().pairing->peer()->key, attacker.keys[Air]);
    QCOMPARE(pair.air().pairing->peer()->key, attacker.keys[Ground]);
    QVERIFY(!pair.shown());
    pair.confirm(Ground); // "Yes, if it is the key of the drone": it is not.
    pair.confirm(Air);
    QVERIFY(!pair.ground().pairing->confirmedHere() && !pair.air().pairing->confirmedHere());
    pair.ground().pairing->refuse(pair.now);
    pair.air().pairing->refuse(pair.now);
    pair.run(30s);
    QVERIFY(pair.ground().all<Paired>().empty() && pair.air().all<Paired>().empty());
    QVERIFY(!pair.ground().pairing->peer() && !pair.air().pairing->peer()); // Not shown again.
}

void AttackPairingTest::oneYesIsNotEnough()
{
    for (const Side side : {Ground, Air}) {
        PairingPair pair;
        pair.openBoth();
        QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
        pair.confirm(side);
        pair.run(200s);
        HOLDS(pair.ground().all<Paired>().empty() && pair.air().all<Paired>().empty(), "nothing is kept without both yeses");
        QVERIFY(pair.ground().pairing->finished() && pair.air().pairing->finished());
        QCOMPARE(pair.ends[side].over()->reason, channel::PairingEnd::TimedOut);
    }
}

void AttackPairingTest::inBetweenWithoutThePassphrase()
{
    for (const bool guesses : {false, true}) {
        PairingPair pair;
        pair.ground().config.passphraseKey = pair.air().config.passphraseKey = secret(7);
        InBetween attacker(pair, guesses ? secret(8) : nullptr);
        pair.openBoth();
        pair.run(100s);
        HOLDS(pair.ground().all<PairingPeerSeen>().empty() && pair.air().all<PairingPeerSeen>().empty(),
              "nobody is shown without the passphrase");
        QVERIFY(!pair.ground().all<PairingPassphraseDiffers>().empty());
        QVERIFY(!pair.air().all<PairingPassphraseDiffers>().empty());
    }
}

void AttackPairingTest::passphraseMustBeTheSame()
{
    const std::shared_ptr<const Key32> keys[] = {nullptr, secret(1), secret(2)};
    for (const auto &here : keys) {
        for (const auto &there : keys) {
            PairingPair pair;
            pair.ground().config.passphraseKey = here;
            pair.air().config.passphraseKey = there;
            pair.openBoth();
            pair.run(20s, [&] { return pair.shown(); });
            QVERIFY(here != there || pair.shown());
            const bool seen = !pair.ground().all<PairingPeerSeen>().empty() || !pair.air().all<PairingPeerSeen>().empty();
            HOLDS(here == there || !seen, "nobody is shown without the passphrase");
            QCOMPARE(pair.ground().all<PairingPassphraseDiffers>().empty(), here == there);
            QCOMPARE(pair.air().all<PairingPassphraseDiffers>().empty(), here == there);
        }
    }
}

void AttackPairingTest::anotherWhileComparing()
{
    // A second device that hears the calls does the whole handshake while the first is on the screen.
    PairingPair pair;
    PairingToken token{};
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        if (const auto called = calledToken(flight.bytes))
            token = *called;
        return true;
    };
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    Path elsewhere = PairingPair::pathOf(Ground);
    elsewhere.remote.ip[15] = 99;
    SeededRandom random(5);
    const auto other = newKey(random);
    std::optional<PairingVoice> voice;
    Bytes answer;
    pair.elsewhere = [&](Side, const Transmit &out) { answer.assign(out.bytes.begin(), out.bytes.end()); };
    for (std::uint32_t id = 1; id <= 30; ++id) {
        auto handshake = PairingHandshake::begin(noise::Role::Initiator, *other, nullptr, PairingId{id}, token);
        pair.air().pairing->handleDatagram(pair.now, elsewhere, *handshake->first(random));
        pair.pump();
        QVERIFY(handshake->readAnswer(answer));
        pair.air().pairing->handleDatagram(pair.now, elsewhere, *handshake->third({}, random));
        pair.pump();
        HOLDS(pair.shown(), "who came first stays");
        pair.run(500ms);
    }
    const auto told = pair.air().all<PairingOtherTried>();
    QVERIFY(!told.empty() && told.size() <= 16);
    QCOMPARE(told[0].peer.key, other->publicKey);
    pair.air().pairing->confirm(pair.now, other->publicKey);
    QVERIFY(!pair.air().pairing->confirmedHere());
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    QCOMPARE(pair.air().all<Paired>()[0].peer.key, pair.ground().identity->publicKey);
}

SKYSEAL_TEST(AttackPairingTest)
#include "attack_pairing_test.moc"
