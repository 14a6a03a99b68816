// Attacks on a pairing: a man in the middle, guesses of the passphrase, and other devices during the comparison of codes.
#include "attack.h"
#include "core/base/byte_writer.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/cpace.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/kdf.h"
#include "core/crypto/x25519.h"
#include "core/noise/cipher_state.h"
#include "pairing_pair.h"
#include "tests/noise/fixed_random.h"
#include "tests/support/holds.h"
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
    void nonceChosenAfterTheOthers();
    void oneOpeningOfTheStation();
    void oneOpeningOfTheAgent();
    void passphraseGuessedAtTheAgent();
    void passphraseGuessedAfterTheOpening();
    void guessWithAnUnusableKeyCounts_data();
    void guessWithAnUnusableKeyCounts();
};

namespace {

/// A man in the middle: an agent of its own towards the station, and a station of its own towards the agent, at the addresses
/// of the true ends. It receives all datagrams, and no other reaches its receiver.
struct InBetween
{
    explicit InBetween(PairingPair &victims, std::shared_ptr<const crypto::Passphrase> passphrase = {}) : pair(victims)
    {
        for (const Side as : {Ground, Air}) {
            auto config = PairingPair::configOf(as, newIdentity(random));
            config.passphrase = passphrase;
            faces[as].emplace(config, random, pair.now);
            keys[as] = config.identity->publicKey;
        }
        pair.link.attacker = [this](TimePoint, SentDatagram &flight) {
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
    // It gets through, and the two people see two codes, for two keys of the attacker.
    QVERIFY(pair.ground().pairing->peer() && pair.air().pairing->peer());
    QCOMPARE(pair.ground().pairing->peer()->key, attacker.keys[Air]);
    QCOMPARE(pair.air().pairing->peer()->key, attacker.keys[Ground]);
    QVERIFY(!pair.shown());
    QVERIFY(pair.ground().pairing->peer()->code != pair.air().pairing->peer()->code);
    pair.confirm(Ground); // only the key of the other end, which is not shown
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
        pair.ground().config.passphrase = pair.air().config.passphrase = passphraseOf("blue heron");
        InBetween attacker(pair, guesses ? passphraseOf("grey heron") : nullptr);
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
    const std::shared_ptr<const crypto::Passphrase> passphrases[] = {nullptr, passphraseOf("blue"), passphraseOf("grey")};
    for (const auto &here : passphrases) {
        for (const auto &there : passphrases) {
            PairingPair pair;
            pair.ground().config.passphrase = here;
            pair.air().config.passphrase = there;
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
    // A second device that hears the calls finishes the handshake while the first is on the screen.
    PairingPair pair;
    Stranger stranger(pair);
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    Path elsewhere = PairingPair::pathOf(Ground);
    elsewhere.remote.ip[15] = 99;
    SeededRandom random(5);
    const auto other = newIdentity(random);
    for (std::uint32_t id = 1; id <= 30; ++id) {
        auto handshake = handshakeAs(Ground, other, PairingId{id}, *stranger.token, random);
        pair.air().pairing->handleDatagram(pair.now, elsewhere, handshake.first());
        pair.pump();
        if (handshake.takeAnswer(stranger.received))
            pair.air().pairing->handleDatagram(pair.now, elsewhere, handshake.opening());
        pair.pump();
        HOLDS(pair.shown(), "who came first stays");
        pair.run(500ms);
    }
    const auto others = pair.air().all<PairingOtherTried>();
    QVERIFY(!others.empty() && others.size() <= 16);
    pair.air().pairing->confirm(pair.now, other->publicKey);
    QVERIFY(!pair.air().pairing->confirmedHere());
    pair.confirm(Air);
    pair.confirm(Ground);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
    QCOMPARE(pair.air().all<Paired>()[0].peer.key, pair.ground().identity->publicKey);
}

namespace {

/// An agent's answer and opening made by hand, so that the opening need not be what the answer commits to.
class FalseAgent
{
public:
    FalseAgent(const PairingDatagram &first, RandomSource &random) : m_first(first), m_hello(*readFirst(first))
    {
        random.fill(m_scalar);
        m_opening.key = newIdentity(random)->publicKey;
        random.fill(m_opening.nonce);
        m_hello.share = exchange().share();
        m_hello.commitment = commitmentTo(m_opening.write());
    }
    PairingAnswer answer() const { return pairingAnswer(m_hello); }
    /// Reads the code that the station shows. Returns false if it cannot be read.
    bool readStation(ByteView datagram)
    {
        PairingOpening::Bytes bytes;
        noise::CipherState cipher;
        cipher.initializeKey(openingKey("station"));
        if (!cipher.decryptWithAd(datagram.first(kSealedHead), datagram.subspan(kSealedHead), bytes))
            return false;
        m_station = PairingOpening::read(bytes);
        return true;
    }
    std::string code() const { return pairingCode(m_first, answer(), m_station, m_opening); }
    /// Tries nonces until the station shows `wanted`: about a million hashes.
    void grindFor(const std::string &wanted)
    {
        for (std::uint64_t nonce = 0; code() != wanted; ++nonce)
            ByteWriter(m_opening.nonce).u64(nonce);
    }
    OpeningDatagram opening() const
    {
        OpeningDatagram out{};
        const auto head = sealedHead(m_hello.id, 0);
        std::ranges::copy(head, out.begin());
        noise::CipherState cipher;
        cipher.initializeKey(openingKey("agent"));
        static_cast<void>(cipher.encryptWithAd(head, m_opening.write(), MutableByteView(out).subspan(kSealedHead)));
        return out;
    }

private:
    crypto::Cpace exchange() const
    {
        test::FixedRandom scalar(Bytes(m_scalar.begin(), m_scalar.end()));
        return crypto::Cpace::begin(crypto::Cpace::Role::Responder, {{}, asBytes("skyseal pairing v1\x01"), session()}, scalar);
    }
    Bytes session() const
    {
        Bytes out(m_first.begin() + 5, m_first.begin() + 21);
        out.insert(out.end(), m_first.begin() + 1, m_first.begin() + 5);
        return out;
    }
    Key32 openingKey(std::string_view sender) const
    {
        const PairingHello station = *readFirst(m_first);
        const auto shared = exchange().key(session(), {station.share, {}}, {m_hello.share, m_hello.commitment});
        return crypto::hkdfExpandKey(crypto::hkdfExtractSha256(asBytes("skyseal pairing v1"), shared->view()),
                                     asBytes("skyseal v1 pairing opening " + std::string(sender)));
    }

    PairingDatagram m_first;
    PairingHello m_hello;
    std::array<std::uint8_t, 32> m_scalar{};
    PairingOpening m_opening, m_station;
};

/// Catches what the ends send, for an attacker who stands between them.
struct Interceptor
{
    explicit Interceptor(PairingPair &victims) : pair(victims)
    {
        pair.link.attacker = [this](TimePoint, SentDatagram &flight) {
            caught[flight.from].push_back(flight.bytes);
            return false;
        };
    }
    /// The newest datagram of an end for which `is` holds; waits for it.
    template<typename Is> Bytes await(Side from, Is &&is)
    {
        const auto found = [&] { return std::find_if(caught[from].rbegin(), caught[from].rend(), is); };
        pair.run(5s, [&] { return found() != caught[from].rend(); });
        return found() == caught[from].rend() ? Bytes() : *found();
    }
    void send(Side to, ByteView datagram)
    {
        pair.ends[to].pairing->handleDatagram(pair.now, PairingPair::pathOf(to == Ground ? Air : Ground), datagram);
        pair.pump();
    }
    std::size_t openingsOf(Side side) const
    {
        std::set<Bytes> out;
        std::ranges::copy_if(caught[side], std::inserter(out, out.end()), [](const Bytes &bytes) { return isOpening(bytes); });
        return out.size();
    }

    PairingPair &pair;
    std::array<std::vector<Bytes>, 2> caught;
};

PairingDatagram asFirst(const Bytes &bytes)
{
    PairingDatagram out{};
    std::copy_n(bytes.begin(), std::min(bytes.size(), out.size()), out.begin());
    return out;
}

} // namespace

/// The man in the middle learns both nonces of the true ends before he shows his own, and searches one that makes the station's
/// code the same as the agent's.
void AttackPairingTest::nonceChosenAfterTheOthers()
{
    PairingPair pair;
    SeededRandom random(6);
    Interceptor between(pair);
    pair.openBoth();
    const auto token = calledToken(between.await(Air, [](const Bytes &bytes) { return calledToken(bytes).has_value(); }));
    QVERIFY(token);
    between.send(Ground, pairingCall(*token));
    FalseAgent toStation(asFirst(between.await(Ground, [](const Bytes &bytes) { return readFirst(bytes).has_value(); })),
                         random);
    auto toAgent = handshakeAs(Ground, newIdentity(random), PairingId{1}, *token, random);
    between.send(Air, toAgent.first());
    QVERIFY(toAgent.takeAnswer(between.await(Air, [](const Bytes &bytes) { return readAnswer(bytes).has_value(); })));
    between.send(Ground, toStation.answer());
    QVERIFY(toStation.readStation(between.await(Ground, &isOpening)));
    between.send(Air, toAgent.opening());
    QVERIFY(toAgent.takeOpening(between.await(Air, &isOpening)));
    toStation.grindFor(toAgent.code());
    QCOMPARE(toStation.code(), toAgent.code());
    between.send(Ground, toStation.opening());
    pair.run(2s);
    HOLDS(std::ranges::none_of(between.caught[Ground], &isWord), "an agent shows what it committed to");
    QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::Interrupted);
}

/// The man in the middle sees a wrong code, does not continue, and tries again.
void AttackPairingTest::oneOpeningOfTheStation()
{
    PairingPair pair;
    SeededRandom random(7);
    Interceptor between(pair);
    pair.open(Ground);
    for (int attempt = 0; attempt < 9; ++attempt) {
        PairingToken token;
        random.fill(token);
        between.send(Ground, pairingCall(token));
        for (const Bytes &sent : std::vector<Bytes>(between.caught[Ground])) {
            const auto head = readFirst(sent);
            if (head && head->token == token)
                between.send(Ground, FalseAgent(asFirst(sent), random).answer());
        }
        pair.run(12s);
    }
    QVERIFY(between.openingsOf(Ground) >= 1);
    HOLDS(between.openingsOf(Ground) == 1, "one opening in a window");
    QCOMPARE(pair.ground().over()->reason, channel::PairingEnd::Interrupted);
}

void AttackPairingTest::oneOpeningOfTheAgent()
{
    PairingPair pair;
    SeededRandom random(8);
    Interceptor between(pair);
    pair.open(Air);
    const auto token = calledToken(between.await(Air, [](const Bytes &bytes) { return calledToken(bytes).has_value(); }));
    QVERIFY(token);
    for (std::uint32_t id = 1; id <= 9; ++id) {
        auto handshake = handshakeAs(Ground, newIdentity(random), PairingId{id}, *token, random);
        between.send(Air, handshake.first());
        for (const Bytes &sent : std::vector<Bytes>(between.caught[Air])) {
            if (handshake.takeAnswer(sent))
                between.send(Air, handshake.opening());
        }
        pair.run(12s);
    }
    QVERIFY(between.openingsOf(Air) >= 1);
    HOLDS(between.openingsOf(Air) == 1, "one opening in a window");
    QCOMPARE(pair.air().over()->reason, channel::PairingEnd::Interrupted);
}

void AttackPairingTest::passphraseGuessedAtTheAgent()
{
    PairingPair pair;
    SeededRandom random(9);
    pair.air().config.passphrase = passphraseOf("4711");
    Interceptor between(pair);
    pair.open(Air);
    const auto token = calledToken(between.await(Air, [](const Bytes &bytes) { return calledToken(bytes).has_value(); }));
    QVERIFY(token);
    PairingId id{};
    for (const char *guess : {"0000", "1111", "1234", "2222", "4711"}) {
        id = PairingId{static_cast<std::uint32_t>(id) + 1};
        auto handshake = handshakeAs(Ground, newIdentity(random), id, *token, random, passphraseOf(guess));
        between.send(Air, handshake.first());
        for (const Bytes &sent : std::vector<Bytes>(between.caught[Air])) {
            if (!handshake.takeAnswer(sent))
                continue;
            for (int copy = 0; copy < 5; ++copy)
                between.send(Air, handshake.opening());
        }
        pair.run(1s);
    }
    HOLDS(between.openingsOf(Air) == 0, "three guesses in a window");
    QCOMPARE(pair.air().over()->reason, channel::PairingEnd::Guessed);
    QVERIFY(!pair.air().all<PairingPassphraseDiffers>().empty());
}

namespace {

/// A device that heard a call and guesses the agent's passphrase.
struct Guesser
{
    explicit Guesser(PairingPair &victims) : pair(victims), stranger(victims) { from.remote.ip[15] = 99; }
    Bytes replyTo(ByteView datagram)
    {
        stranger.received.clear();
        pair.air().pairing->handleDatagram(pair.now, from, datagram);
        pair.pump();
        return stranger.received;
    }
    /// All that can differ between two guesses: which messages are answered, and whether a repeated one gets the same answer.
    struct Traces
    {
        bool answered = false, opened = false, sameAnswer = false;
        bool operator==(const Traces &) const = default;
    };
    Traces guess(const char *passphrase, std::shared_ptr<const crypto::X25519KeyPair> key)
    {
        auto handshake = handshakeAs(Ground, std::move(key), PairingId{++tries}, *stranger.token, random,
                                     passphraseOf(passphrase));
        const Bytes answer = replyTo(handshake.first());
        static_cast<void>(handshake.takeAnswer(answer));
        const bool opened = !replyTo(handshake.opening()).empty();
        return {!answer.empty(), opened, replyTo(handshake.first()) == answer};
    }

    PairingPair &pair;
    Stranger stranger;
    Path from = PairingPair::pathOf(Ground);
    SeededRandom random{10};
    std::uint32_t tries = 0;
};

} // namespace

/// The true station's opening was accepted, and the agent waits for its person.
void AttackPairingTest::passphraseGuessedAfterTheOpening()
{
    PairingPair pair;
    pair.ground().config.passphrase = pair.air().config.passphrase = passphraseOf("4711");
    Guesser guesser(pair);
    pair.openBoth();
    QVERIFY(pair.run(2s, [&] { return pair.shown(); }));
    for (int i = 0; i < 20; ++i) {
        const auto wrong = guesser.guess("0000", newIdentity(guesser.random));
        pair.run(1s);
        const auto right = guesser.guess("4711", newIdentity(guesser.random));
        pair.run(1s);
        HOLDS(right == wrong, "a right guess looks like a wrong one");
        QVERIFY(!right.answered && !right.opened);
    }
    QVERIFY(!pair.air().all<PairingOtherTried>().empty());
    pair.confirm(Ground);
    pair.confirm(Air);
    QVERIFY(pair.run(1s, [&] { return pair.paired(); }));
}

void AttackPairingTest::guessWithAnUnusableKeyCounts_data()
{
    QTest::addColumn<bool>("isOurs");
    QTest::newRow("the agent's own key") << true;
    QTest::newRow("a key without a shared secret") << false;
}

/// A right guess that the agent cannot show must look and count like a wrong one.
void AttackPairingTest::guessWithAnUnusableKeyCounts()
{
    QFETCH(bool, isOurs);
    PairingPair pair;
    pair.air().config.passphrase = passphraseOf("4711");
    Guesser guesser(pair);
    pair.open(Air);
    pair.run(1s);
    for (int i = 0; i < 5 && !pair.air().over(); ++i) {
        auto key = crypto::X25519KeyPair::generate(guesser.random);
        key.publicKey = isOurs ? pair.air().identity->publicKey : channel::PublicKey{};
        const auto traces = guesser.guess("4711", std::make_shared<crypto::X25519KeyPair>(std::move(key)));
        QVERIFY(traces.answered && !traces.opened);
        QVERIFY(traces.sameAnswer || pair.air().over());
        pair.run(1s);
    }
    HOLDS(guesser.tries == 3 && pair.air().over(), "three guesses in a window");
    QCOMPARE(pair.air().over()->reason, channel::PairingEnd::Guessed);
}

SKYSEAL_TEST(AttackPairingTest)
#include "attack_pairing_test.moc"
