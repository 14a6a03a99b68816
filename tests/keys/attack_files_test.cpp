// Key files and lists of peers that other users can read or have changed, symbolic links, damage, and keys in error messages.
#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/counter_file.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/error_text.h"
#include "tests/keys/temporary_folder.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"

#include <QtTest/QTest>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;
using test::contains;
using test::errorOf;
using test::readText;

class AttackFilesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void keysThatOthersCanRead();
    void peersThatOthersCanChange();
    void symbolicLinks();
    void everyTruncation();
    void everyDamagedCharacter();
    void everyDamagedPeer();
    void anotherPassphrase();
    void errorsShowNoKey();
    void strangersCauseNoWrites();
    void failingDiskEndsNoSession_data();
    void failingDiskEndsNoSession();
    void namesThatSteerATerminal();

private:
    std::string newKey(const char *name)
    {
        const std::string path = m_folder.path(name);
        return writeNewIdentity(path, m_random) ? path : std::string();
    }

    test::TemporaryFolder m_folder;
    test::SeededRandom m_random{42};
};

void AttackFilesTest::keysThatOthersCanRead()
{
    const std::string key = newKey("readable.key"), shared = m_folder.path("readable.psk");
    QVERIFY(writeNewPresharedKey(shared, m_random));
    for (const mode_t mode : {0640, 0604, 0620, 0602, 0610, 0601, 0644, 0777}) {
        ::chmod(key.c_str(), mode);
        ::chmod(shared.c_str(), mode);
        HOLDS(contains(errorOf(loadIdentity(key)), "other users") && contains(errorOf(loadPresharedKey(shared)), "other users"),
              "no key is used that others can read");
    }
    ::chmod(key.c_str(), 0400);
    QCOMPARE(errorOf(loadIdentity(key)), std::string());
}

void AttackFilesTest::peersThatOthersCanChange()
{
    const std::string key = publicKeyText(crypto::X25519KeyPair::generate(m_random).publicKey);
    const std::string path = m_folder.write("shared.peers", "a pilot 1 " + key + "\n");
    for (const mode_t mode : {0664, 0646, 0666, 0620, 0602}) {
        ::chmod(path.c_str(), mode);
        HOLDS(contains(errorOf(loadPeers(path)), "other users"), "no list is used that others can change");
    }
    ::chmod(path.c_str(), 0644); // readable by everyone is allowed
    QCOMPARE(loadPeers(path)->size(), std::size_t(1));
}

void AttackFilesTest::symbolicLinks()
{
    const std::string key = newKey("linked.key"), link = m_folder.path("link.key");
    QCOMPARE(::symlink(key.c_str(), link.c_str()), 0);
    HOLDS(contains(errorOf(loadIdentity(link)), "symbolic link"), "no secret is read through a link");
    const std::string dangling = m_folder.path("dangling.key");
    QCOMPARE(::symlink(m_folder.path("nowhere").c_str(), dangling.c_str()), 0);
    QVERIFY(contains(errorOf(writeNewIdentity(dangling, m_random)), "exists already"));
}

void AttackFilesTest::everyTruncation()
{
    const std::string whole = readText(newKey("whole.key"));
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) // only the last newline may be missing
        HOLDS(!loadIdentity(m_folder.write("cut.key", whole.substr(0, size))), "no piece of a key is a key");
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("cut.key", whole.substr(0, whole.size() - 9)))), "truncated"));
}

void AttackFilesTest::everyDamagedCharacter()
{
    const std::string good = readText(newKey("good.key"));
    const std::size_t keyAt = good.size() - 49;
    for (std::size_t at = keyAt; at < good.size() - 1; ++at) {
        std::string bad = good;
        bad[at] = bad[at] == 'A' ? 'B' : 'A';
        HOLDS(contains(errorOf(loadIdentity(m_folder.write("bad.key", bad))), ":3: has a damaged key"),
              "no damaged key is a key");
    }
}

void AttackFilesTest::everyDamagedPeer()
{
    // A list of peers with one changed character in a key is rejected, not read as another key.
    PeersFile peers;
    PeerEntry entry;
    entry.peer.key = crypto::X25519KeyPair::generate(m_random).publicKey;
    entry.peer.name = "air-1";
    QVERIFY(peers.add(entry) && peers.save(m_folder.path("good.peers")));
    const std::string good = readText(m_folder.path("good.peers")), key = publicKeyText(entry.peer.key);
    const std::size_t keyAt = good.find(key) + key.find(':') + 1;
    for (std::size_t at = keyAt; at < good.find(key) + key.size(); ++at) {
        std::string bad = good;
        bad[at] = bad[at] == 'A' ? 'B' : 'A';
        HOLDS(!PeersFile::load(m_folder.write("bad.peers", bad)), "no damaged list is a list");
    }
}

void AttackFilesTest::anotherPassphrase()
{
    const auto words = [](std::string_view text) { return *crypto::Passphrase::fromBytes(asBytes(text)); };
    const crypto::Passphrase right = words("correct horse");
    const std::string path = m_folder.path("sealed.key");
    QVERIFY(writeNewIdentity(path, m_random, {&right, crypto::kLeastPassphraseCost}));
    const auto openedWith = [&](std::string_view text) {
        return loadIdentity(path, [&](const std::string &, int attempt) -> Result<crypto::Passphrase, InputError> {
            if (attempt > 0)
                return tl::unexpected(InputError{"no other one", path});
            return words(text);
        });
    };
    for (const std::string_view wrong : {"correct hors", "correct horse ", "Correct horse", "battery"})
        HOLDS(!openedWith(wrong), "no key opens under another passphrase");
    QVERIFY(openedWith("correct horse"));
}

void AttackFilesTest::errorsShowNoKey()
{
    const std::string text = readText(newKey("secret.key"));
    const std::string key = text.substr(text.size() - 49, 48);
    // A key in a file of the wrong kind, without its header, twice, or with trailing text.
    for (const std::string &content :
         {key + "\n", "skyseal-preshared-key-v1\n" + key + "\n", text + key + "\n", text + "x" + key})
        HOLDS(!contains(errorOf(loadIdentity(m_folder.write("other.key", content))), key.substr(0, 8)), "no error shows a key");
}

/// A thousand first messages, each of which a stranger can cause by an announcement, and the writes that they cause.
void AttackFilesTest::strangersCauseNoWrites()
{
    const std::string path = m_folder.path("counters");
    const auto store = std::move(*FileCounterStore::open(path));
    std::set<std::string> contents;
    std::uint64_t last = 0;
    for (int i = 0; i < 1000; ++i) {
        std::optional<std::uint64_t> number = store->next();
        store->waitUntilStored();
        if (!number)
            number = store->next();
        QVERIFY(number && *number > last);
        last = *number;
        contents.insert(readText(path));
    }
    HOLDS(contents.size() <= 2, "strangers cause no writes to the disk");
}

/// An agent confirms no session whose counter its store does not accept.
void AttackFilesTest::failingDiskEndsNoSession_data()
{
    QTest::addColumn<QString>("error");
    QTest::newRow("full") << QStringLiteral("No space left on device");
    QTest::newRow("read-only") << QStringLiteral("Read-only file system");
    QTest::newRow("hanging") << QString();
}

void AttackFilesTest::failingDiskEndsNoSession()
{
    QFETCH(QString, error);
    struct Trouble
    {
        std::mutex mutex;
        std::condition_variable ended;
        bool now = false;
        std::atomic<int> seconds = 0; ///< each look at the clock takes one while the disk hangs
    };
    const auto trouble = std::make_shared<Trouble>();
    CounterDisk disk = counterDisk(m_folder.path(QTest::currentDataTag()));
    disk.now = [trouble] {
        const std::lock_guard lock(trouble->mutex);
        return TimePoint(std::chrono::seconds(trouble->seconds += trouble->now));
    };
    disk.update = [trouble, error, update = disk.update](StoredCounters ours, std::uint64_t reserve,
                                                         bool create) -> Result<StoredCounters, InputError> {
        std::unique_lock lock(trouble->mutex);
        if (trouble->now && !error.isEmpty())
            return tl::unexpected(InputError{error.toStdString(), "counters"});
        trouble->ended.wait(lock, [&] { return !trouble->now; });
        return update(std::move(ours), reserve, create);
    };
    const auto store = std::move(*FileCounterStore::open(std::move(disk)));
    store->waitUntilStored();
    const auto setTrouble = [&](bool now) {
        const std::lock_guard lock(trouble->mutex);
        trouble->now = now;
        trouble->ended.notify_all();
    };
    setTrouble(true);
    const channel::PublicKey peer{1};
    const bool remembered = store->remember(peer, 17);
    const std::uint64_t seen = store->lastSeen(peer);
    const bool told = test::eventually(
        [&] { return contains(store->problem().text(), error.isEmpty() ? "does not answer" : error.toStdString()); });
    setTrouble(false);
    HOLDS(remembered, "a failing disk ends no session");
    QCOMPARE(seen, std::uint64_t(17));
    QVERIFY(told);
}

void AttackFilesTest::namesThatSteerATerminal()
{
    const std::string key = publicKeyText(crypto::X25519KeyPair::generate(m_random).publicKey);
    const auto loads = [&](const char *name) {
        return loadPeers(m_folder.write("named.peers", std::string(name) + " pilot 1 " + key + "\n")).has_value();
    };
    QVERIFY(loads("Zoë"));
    // A control sequence (CSI), a change of direction, a character without width, no UTF-8.
    for (const char *name : {"a\xc2\x9b"
                             "2J",
                             "a\xe2\x80\xae"
                             "b",
                             "a\xe2\x80\x8b"
                             "b",
                             "a\xff"})
        HOLDS(!loads(name), "no name steers a terminal");
}

SKYSEAL_TEST_APPLESS(AttackFilesTest)
#include "attack_files_test.moc"
