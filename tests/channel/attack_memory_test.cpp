// An attacker reads the memory of a process: wiped secrets must be gone from it. A forked second process computes, from the
// same seed, every secret of the beginning of a session and hands them over masked. This process searches its own memory for
// them, during the first epoch and after it.
#include "attack.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_keys.h"
#include "inline_pair.h"
#include "process_image.h"
#include "stolen_session.h"
#include "tests/support/holds.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <new>

#include <sodium.h>
#include <sys/wait.h>

using namespace skyseal;
using namespace skyseal::test;

namespace {

struct Secret
{
    QByteArray name;
    Bytes masked;
    bool livesWithTheEpoch = false; ///< otherwise it must be gone as soon as the session is up
};

/// Hands a secret to the process that searches its memory.
using WriteSecret = std::function<void(const char *name, ByteView secret, bool lives)>;

/// In the forked process: all secrets of a handshake and of epoch 0.
void writeSessionSecrets(const WriteSecret &write, const Pair &pair, const Tap &tap, SuiteId suite)
{
    const StolenSession stolen(pair, tap, kAttackSeed, suite);
    const auto e = Reconstruction::asKey(ByteView(tap.ofKind(0x59).at(0).bytes).subspan(1, 32)),
               re = Reconstruction::asKey(ByteView(tap.ofKind(0x5a).at(0).bytes).subspan(3, 32));
    const auto stations = stolen.keyPairOf(e), agents = stolen.keyPairOf(re);
    const auto shared = crypto::x25519(stations.secret, re);
    const RevealedSession &session = stolen.revealed();
    // Without the first and the last byte, which X25519 changes in its own copy.
    write("station's-ephemeral", ByteView(stations.secret.view()).subspan(1, 30), false);
    write("agent's-ephemeral", ByteView(agents.secret.view()).subspan(1, 30), false);
    // The two hash states that HMAC derives from a key are as secret as the key.
    const auto writeStates = [&](const char *name, const Key32 &key, bool lives) {
        crypto_auth_hmacsha256_state hmac; // libsodium's, since OpenSSL shows nobody its own
        crypto_auth_hmacsha256_init(&hmac, key.view().data(), key.size());
        const auto bytesOf = [](const std::uint32_t(&state)[8]) {
            return ByteView(reinterpret_cast<const std::uint8_t *>(state), sizeof state);
        };
        write((QByteArray(name) + "-inner").constData(), bytesOf(hmac.ictx.state), lives);
        write((QByteArray(name) + "-outer").constData(), bytesOf(hmac.octx.state), lives);
    };
    write("shared-secret", shared->view(), false);
    write("transport-key-1", session.initiators.view(), false);
    write("transport-key-2", session.responders.view(), false);
    const Key32 chain = session.chain();
    write("chain", chain.view(), false); // its successor has taken its place
    writeStates("chain", chain, false);
    write("next-chain", session.next(suite).view(), true);
    const EpochSecrets &epoch = stolen.epoch();
    for (const Key32 *direction : {&epoch.fromInitiator, &epoch.fromResponder}) {
        write("direction-secret", direction->view(), false);
        writeStates("direction-secret", *direction, false);
        for (const std::string_view framing : {"record", "inline"}) {
            if (framing == "inline" && !crypto::mayBeInline(suite))
                continue;
            const bool hasMac = !crypto::suiteInfo(suite).isAead();
            const auto keys = crypto::RecordKeys::derive(*direction, suite, framing);
            const QByteArray name(framing.data(), static_cast<int>(framing.size()));
            write((name + "-mac-key").constData(), keys.mac.view(), hasMac);
            writeStates((name + "-mac").constData(), keys.mac, hasMac);
            write((name + "-key").constData(), keys.key.view(), true);
            write((name + "-iv").constData(), ByteView(keys.iv.view()).first(12), true); // of a key, where it is one
        }
    }
}

/// In the forked process: the secrets of the switch to epoch 1.
void writeSwitchSecrets(const WriteSecret &write, const Pair &pair, const Tap &tap, SuiteId suite)
{
    const StolenSession stolen(pair, tap, kAttackSeed, suite);
    const auto proposal = stolen.newest<Propose>(tap.flights);
    const auto acceptance = stolen.newest<Accept>(tap.flights);
    if (!proposal || !acceptance)
        qFatal("there was no switch");
    const auto proposers = stolen.keyPairOf(proposal->key), answerers = stolen.keyPairOf(acceptance->key);
    write("proposer's-key", ByteView(proposers.secret.view()).subspan(1, 30), false);
    write("answerer's-key", ByteView(answerers.secret.view()).subspan(1, 30), false);
    const auto shared = crypto::x25519(proposers.secret, acceptance->key);
    write("shared-secret", shared->view(), false);
    const Key32 next = stolen.revealed().next(suite);
    write("next-chain", next.view(), false);
    write("chain", crypto::hkdfExtractSha256(next.view(), shared->view()).view(), false);
}

/// Runs `compute` in a forked process, so that the secrets do not get into the memory of this one.
std::vector<Secret> secretsOf(const std::function<void(const WriteSecret &)> &compute)
{
    int ends[2];
    if (::pipe(ends) != 0)
        qFatal("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        compute([&](const char *name, ByteView secret, bool lives) {
            const Bytes bytes = masked(secret);
            const QByteArray line = QByteArray(name) + ' ' + (lives ? '1' : '0') + ' '
                + QByteArray(reinterpret_cast<const char *>(bytes.data()), static_cast<int>(bytes.size())).toHex() + '\n';
            if (::write(ends[1], line.constData(), static_cast<std::size_t>(line.size())) != line.size())
                qFatal("the pipe is full");
        });
        ::_exit(0);
    }
    ::close(ends[1]);
    QByteArray text;
    char buffer[4096];
    for (ssize_t got = 0; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<int>(got));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    std::vector<Secret> out;
    for (const QByteArray &line : text.split('\n')) {
        const auto words = line.split(' ');
        if (words.size() != 3)
            continue;
        const QByteArray bytes = QByteArray::fromHex(words[2]);
        out.push_back({words[0], Bytes(bytes.begin(), bytes.end()), words[1] == "1"});
    }
    return out;
}

/// Keys in use that lie in pages which the system may write to the swap space. The IV of a suite is part of its nonces, which
/// pass over the stack; only aes-256-cbc makes a key of it.
QByteArrayList unlockedKeys(const std::vector<Secret> &secrets, SuiteId suite)
{
    auto image = std::make_unique<ProcessImage>();
    QByteArrayList out;
    for (const Secret &secret : secrets) {
        const bool isKey = suite == SuiteId::Aes256Cbc || !secret.name.endsWith("-iv");
        if (secret.livesWithTheEpoch && isKey && image->countUnlocked(secret.masked) > 0)
            out << secret.name;
    }
    return out;
}

/// Names of those that lie in memory.
QByteArrayList found(const std::vector<Secret> &secrets, bool alsoLiving)
{
    auto image = std::make_unique<ProcessImage>();
    QByteArrayList out;
    for (const Secret &secret : secrets) {
        if ((alsoLiving || !secret.livesWithTheEpoch) && image->count(secret.masked) > 0)
            out << secret.name;
    }
    return out;
}

} // namespace

class AttackMemoryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void searchFindsAPlantedCopy();
    void deadSecretsAreGone_data();
    void deadSecretsAreGone();
    void switchSecretsAreGone();
    void stolenChainOpensNoLaterEpoch();
    void livingSecretsAreLocked_data() { deadSecretsAreGone_data(); }
    void livingSecretsAreLocked();
};

void AttackMemoryTest::searchFindsAPlantedCopy()
{
    Bytes hidden(32);
    SeededRandom(1).fill(hidden); // what lies there is known masked only
    const Bytes wanted = hidden;
    auto image = std::make_unique<ProcessImage>();
    QCOMPARE(image->count(wanted), std::size_t(0));
    // In memory that outlives the secret, so that neither the heap nor a call reuses its place before the search.
    struct Place
    {
        alignas(SecretBytes<32>) std::array<std::byte, sizeof(SecretBytes<32>)> bytes;
    };
    const auto place = std::make_unique<Place>();
    {
        SecretBytes<32> onTheStack;
        auto *const inPlace = new (place->bytes.data()) SecretBytes<32>;
        for (std::size_t i = 0; i < 32; ++i)
            onTheStack.mutableView()[i] = inPlace->mutableView()[i] = hidden[i] ^ kMask;
        QCOMPARE(image->count(wanted), std::size_t(2));
        inPlace->~SecretBytes<32>();
    }
    HOLDS(image->count(wanted) == 0, "a secret that died is gone");
}

void AttackMemoryTest::deadSecretsAreGone_data()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (info.authenticated && !info.research) // No session begins under a research suite.
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

void AttackMemoryTest::deadSecretsAreGone()
{
    QFETCH(int, suite);
    PairOptions options = inlineOptions(kAttackSeed); // Frames go in place under the suites that can do it.
    options.ground.suites = {static_cast<SuiteId>(suite), SuiteId::ChaCha20};
    Pair pair(options);
    Tap tap(pair);
    pair.every(20ms, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(2s);
    const auto secrets = secretsOf(
        [&](const WriteSecret &write) { writeSessionSecrets(write, pair, tap, static_cast<SuiteId>(suite)); });
    QCOMPARE(secrets.size(), crypto::mayBeInline(static_cast<SuiteId>(suite)) ? std::size_t(35) : std::size_t(25));
    const QByteArrayList early = found(secrets, false);
    if (!early.isEmpty())
        qInfo("found: %s", early.join(' ').constData());
    HOLDS(early.isEmpty(), "the handshake's secrets are gone");
    const QByteArrayList living = found(secrets, true);
    for (const Secret &secret : secrets)
        QVERIFY2(!secret.livesWithTheEpoch || living.contains(secret.name), "a key in use is not found: the search is blind");

    pair.ground().rekey(pair.now);
    QVERIFY(pair.run(2s, [&] { return pair.air().all<SwitchDone>().size() == 1; }));
    QVERIFY(found(secrets, true).contains("record-key")); // for late records
    pair.run(5s);
    const QByteArrayList late = found(secrets, true);
    if (!late.isEmpty())
        qInfo("found: %s", late.join(' ').constData());
    HOLDS(late.isEmpty(), "the keys of a dead epoch are gone");
    QVERIFY(pair.bothUp());
}

void AttackMemoryTest::switchSecretsAreGone()
{
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.ground().rekey(pair.now);
    QVERIFY(pair.run(2s, [&] { return pair.air().all<SwitchDone>().size() == 1; }));
    const auto secrets = secretsOf(
        [&](const WriteSecret &write) { writeSwitchSecrets(write, pair, tap, SuiteId::ChaCha20Poly1305); });
    QCOMPARE(secrets.size(), std::size_t(5));
    const QByteArrayList left = found(secrets, true);
    if (!left.isEmpty())
        qInfo("found: %s", left.join(' ').constData());
    HOLDS(left.isEmpty(), "the secrets of a switch are gone");
}

void AttackMemoryTest::stolenChainOpensNoLaterEpoch()
{
    // The thief has the memory of epoch 0 (deadSecretsAreGone shows that it holds the chain) and both static keys, and listens.
    PairOptions options = attackOptions();
    options.seed = kAttackSeed + 1; // so that no secret of the other tests comes into this process
    Pair pair(options);
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const StolenSession thief(pair, tap, options.seed, SuiteId::ChaCha20Poly1305);
    pair.every(20ms, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    pair.ground().rekey(pair.now);
    QVERIFY(pair.run(2s, [&] { return pair.air().all<SwitchDone>().size() == 1; }));
    pair.run(1s);
    const auto proposal = thief.newest<Propose>(tap.flights); // opens the present epoch
    const auto acceptance = thief.newest<Accept>(tap.flights);
    QVERIFY(proposal && acceptance);

    const auto later = tap.ofKind(0x51);
    QVERIFY(later.size() > 50);
    const auto opened = [&](std::optional<Key32> shared) {
        SwitchSecret exchanged{proposal->key, acceptance->key, shared ? std::move(*shared) : Key32()};
        const EpochSecrets next = thief.epoch().next.advance(Epoch{1}, SuiteId::ChaCha20Poly1305, exchanged);
        return std::count_if(later.begin(), later.end(), [&](const SentDatagram &record) { return thief.open(record, next); });
    };
    const auto &station = pair.ground().identity, &agent = pair.air().identity;
    const auto inAll = opened(std::nullopt) + opened(crypto::x25519(station->secret, acceptance->key))
        + opened(crypto::x25519(agent->secret, proposal->key)) + opened(crypto::x25519(station->secret, agent->publicKey))
        + opened(thief.revealed().chain());
    HOLDS(inAll == 0, "a stolen chain opens no later epoch");
    // The attack lacks nothing but the Diffie-Hellman of the switch.
    QCOMPARE(opened(crypto::x25519(thief.keyPairOf(proposal->key).secret, acceptance->key)),
             static_cast<std::ptrdiff_t>(later.size()));
}

void AttackMemoryTest::livingSecretsAreLocked()
{
    QFETCH(int, suite);
    SKYSEAL_REQUIRES("locked_memory");
    PairOptions options = inlineOptions(kAttackSeed);
    options.ground.suites = {static_cast<SuiteId>(suite), SuiteId::ChaCha20};
    Pair pair(options);
    Tap tap(pair);
    pair.every(20ms, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(2s);
    const auto secrets = secretsOf(
        [&](const WriteSecret &write) { writeSessionSecrets(write, pair, tap, static_cast<SuiteId>(suite)); });
    const QByteArrayList swappable = unlockedKeys(secrets, static_cast<SuiteId>(suite));
    if (!swappable.isEmpty())
        qInfo("not locked: %s", swappable.join(' ').constData());
    HOLDS(swappable.isEmpty(), "keys in use lie in locked pages");
}

SKYSEAL_TEST(AttackMemoryTest)
#include "attack_memory_test.moc"
