// Private key files: what was written reads back, and each way in which one can be wrong is told apart and refused.
#include "core/crypto/init_crypto.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;
using test::readText;

/// The error of a result as text, or "" when it is none.
template<typename T> static std::string errorOf(const Result<T, InputError> &result)
{
    return result ? std::string() : result.error().text();
}

static bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

class SecretFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void writtenForTheOwnerAloneAndReadBack();
    void neverOverwrites();
    void refusesWhatOthersCanRead();
    void refusesWhatBelongsToAnother();
    void refusesASymbolicLink();
    void refusesEveryTruncation();
    void refusesEveryDamagedCharacter();
    void refusesWhatIsNoKeyFile();
    void errorsShowNoKey();
    void presharedKeysAreAnotherKind();
    void publicKeysAsText();
    void fingerprintsAreWholeAndDiffer();

private:
    test::TemporaryFolder m_folder;
    test::SeededRandom m_random{42};
};

void SecretFileTest::writtenForTheOwnerAloneAndReadBack()
{
    const mode_t old = ::umask(0); // whatever the user's mask is
    const std::string path = m_folder.path("device.key");
    const auto written = writeNewIdentity(path, m_random);
    ::umask(old);
    QCOMPARE(errorOf(written), std::string());
    QCOMPARE(test::modeOf(path), mode_t(0600));
    const auto read = loadIdentity(path);
    QCOMPARE(errorOf(read), std::string());
    QVERIFY(read->secret.equals(written->secret));
    QCOMPARE(read->publicKey, written->publicKey);
    QVERIFY(readText(path).starts_with("skyseal-private-key-v1\n"));
}

void SecretFileTest::neverOverwrites()
{
    const std::string path = m_folder.write("existing", "dear diary");
    QVERIFY(contains(errorOf(writeNewIdentity(path, m_random)), "exists already"));
    QCOMPARE(readText(path), std::string("dear diary"));
    QVERIFY(contains(errorOf(writeNewIdentity(m_folder.path("no/such/folder"), m_random)), "cannot be created"));
}

void SecretFileTest::refusesWhatOthersCanRead()
{
    const std::string path = m_folder.path("readable.key");
    QVERIFY(writeNewIdentity(path, m_random));
    for (const mode_t mode : {0640, 0604, 0620, 0602, 0610, 0601, 0644, 0777}) {
        ::chmod(path.c_str(), mode);
        QVERIFY2(contains(errorOf(loadIdentity(path)), "other users"), std::to_string(mode).c_str());
    }
    ::chmod(path.c_str(), 0400);
    QCOMPARE(errorOf(loadIdentity(path)), std::string());
}

void SecretFileTest::refusesWhatBelongsToAnother()
{
    if (::geteuid() != 0)
        QSKIP("only the superuser can give files away");
    const std::string path = m_folder.path("given.key");
    QVERIFY(writeNewIdentity(path, m_random));
    QCOMPARE(::chown(path.c_str(), 65534, 65534), 0);
    QVERIFY(contains(errorOf(loadIdentity(path)), "another user"));
    QCOMPARE(::chown(path.c_str(), 0, 65534), 0);
    QCOMPARE(errorOf(loadIdentity(path)), std::string());
}

void SecretFileTest::refusesASymbolicLink()
{
    const std::string path = m_folder.path("linked.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const std::string link = m_folder.path("link.key");
    QCOMPARE(::symlink(path.c_str(), link.c_str()), 0);
    QVERIFY(contains(errorOf(loadIdentity(link)), "symbolic link"));

    const std::string dangling = m_folder.path("dangling.key");
    QCOMPARE(::symlink(m_folder.path("nowhere").c_str(), dangling.c_str()), 0);
    QVERIFY(contains(errorOf(writeNewIdentity(dangling, m_random)), "exists already"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.path("missing.key"))), "No such file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.path("."))), "not a regular file"));
}

void SecretFileTest::refusesEveryTruncation()
{
    const std::string path = m_folder.path("whole.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const std::string whole = readText(path);
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) // only the last newline may be missing
        QVERIFY2(!loadIdentity(m_folder.write("cut.key", whole.substr(0, size))), std::to_string(size).c_str());
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("cut.key", whole.substr(0, whole.size() - 9)))), "truncated"));
}

void SecretFileTest::refusesEveryDamagedCharacter()
{
    const std::string path = m_folder.path("good.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const std::string good = readText(path);
    const std::size_t keyAt = good.size() - 49;
    for (std::size_t at = keyAt; at < good.size() - 1; ++at) {
        std::string bad = good;
        bad[at] = bad[at] == 'A' ? 'B' : 'A';
        const std::string error = errorOf(loadIdentity(m_folder.write("bad.key", bad)));
        QVERIFY2(contains(error, ":3: has a damaged key"), error.c_str());
    }
}

void SecretFileTest::refusesWhatIsNoKeyFile()
{
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("empty", ""))), "not a key file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("ssh", "-----BEGIN OPENSSH PRIVATE KEY-----\n"))), "not a key file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("v2", "skyseal-private-key-v2\nAAAA\n"))), "\"skyseal-private-key-v2\""));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("large", std::string(2 << 20, 'x')))), "too large"));
    QVERIFY(contains(errorOf(loadIdentity("/dev/null")), "not a regular file"));
}

void SecretFileTest::errorsShowNoKey()
{
    const std::string path = m_folder.path("secret.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const std::string text = readText(path);
    const std::string key = text.substr(text.size() - 49, 48);
    // A key in a file of the wrong kind, without its header, twice, or with something behind it.
    for (const std::string &content : {key + "\n", "skyseal-preshared-key-v1\n" + key + "\n", text + key + "\n", text + "x" + key})
        QVERIFY(!contains(errorOf(loadIdentity(m_folder.write("other.key", content))), key.substr(0, 8)));
}

void SecretFileTest::presharedKeysAreAnotherKind()
{
    const std::string path = m_folder.path("pair.psk");
    const auto written = writeNewPresharedKey(path, m_random);
    QVERIFY(written.has_value());
    QCOMPARE(test::modeOf(path), mode_t(0600));
    QVERIFY(loadPresharedKey(path)->equals(*written));
    QVERIFY(contains(errorOf(loadIdentity(path)), "holds \"skyseal-preshared-key-v1\""));
}

void SecretFileTest::publicKeysAsText()
{
    for (int i = 0; i < 200; ++i) {
        const PublicKey key = crypto::X25519KeyPair::generate(m_random).publicKey;
        const std::string text = publicKeyText(key);
        QCOMPARE(text.size(), std::size_t(8 + 48));
        QCOMPARE(publicKeyFromText(text).value(), key);
        QCOMPARE(publicKeyFromText("  " + text + "\r\n").value(), key);
        for (std::size_t at = 0; at < text.size(); ++at) {
            std::string slip = text;
            slip[at] = slip[at] == 'x' ? 'y' : 'x';
            QVERIFY(!publicKeyFromText(slip));
        }
        QVERIFY(!publicKeyFromText(text + "A") && !publicKeyFromText(text.substr(0, text.size() - 1)));
    }
    QVERIFY(contains(errorOf(publicKeyFromText("ssh-ed25519 AAAA")), "does not begin with \"skyseal:\""));
    QVERIFY(contains(errorOf(publicKeyFromText("skyseal:abc")), "here 3"));
    QVERIFY(!publicKeyFromText(""));
    // The private file's word is no public key, even with the other prefix in front.
    const std::string path = m_folder.path("mixed-up.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const std::string text = readText(path);
    QVERIFY(!publicKeyFromText("skyseal:" + text.substr(text.size() - 49, 48)));
}

void SecretFileTest::fingerprintsAreWholeAndDiffer()
{
    PublicKey key{};
    const std::string first = fingerprint(key);
    QCOMPARE(first.size(), std::size_t(16 * 4 + 15));
    QCOMPARE(first, fingerprint(key));
    key[31] = 1;
    QVERIFY(fingerprint(key) != first);
}

QTEST_APPLESS_MAIN(SecretFileTest)
#include "secret_file_test.moc"
