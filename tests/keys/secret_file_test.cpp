// Private key files: written files read back, and every kind of invalid file is rejected with its own error.
#include "core/base/secret_bytes.h"
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/error_text.h"
#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;
using test::contains;
using test::errorOf;
using test::readText;

class SecretFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void writtenForTheOwnerAloneAndReadBack();
    void keyOfAnotherUserIsRefused();
    void neverOverwrites();
    void refusesWhatIsNoKeyFile();
    void presharedKeysAreAnotherKind();
    void publicKeysAsText();
    void fingerprintsAreWholeAndDiffer();

private:
    test::TemporaryFolder m_folder;
    test::SeededRandom m_random{42};
};

void SecretFileTest::writtenForTheOwnerAloneAndReadBack()
{
    const mode_t old = ::umask(0); // independent of the user's umask
    const std::string path = m_folder.path("device.key");
    const auto written = writeNewIdentity(path, m_random);
    ::umask(old);
    QCOMPARE(errorOf(written), std::string());
    QCOMPARE(test::modeOf(path), mode_t(0600));
    const auto read = loadIdentity(path);
    QCOMPARE(errorOf(read), std::string());
    QCOMPARE(read->publicKey, *written);
    QVERIFY(readText(path).starts_with("skyseal-private-key-v1\n"));
}

void SecretFileTest::keyOfAnotherUserIsRefused()
{
    SKYSEAL_REQUIRES("superuser");
    const std::string path = m_folder.path("foreign.key");
    QVERIFY(writeNewIdentity(path, m_random));
    QCOMPARE(::chown(path.c_str(), test::kSomebodyElse, 0), 0);
    QVERIFY(contains(errorOf(loadIdentity(path)), "another user"));
    QCOMPARE(::chown(path.c_str(), 0, test::kSomebodyElse), 0); // its group may not read it
    QCOMPARE(errorOf(loadIdentity(path)), std::string());
}

void SecretFileTest::neverOverwrites()
{
    const std::string path = m_folder.write("existing", "dear diary");
    QVERIFY(contains(errorOf(writeNewIdentity(path, m_random)), "exists already"));
    QCOMPARE(readText(path), std::string("dear diary"));
    QVERIFY(contains(errorOf(writeNewIdentity(m_folder.path("no/such/folder"), m_random)), "cannot be created"));
}

void SecretFileTest::refusesWhatIsNoKeyFile()
{
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("empty", ""))), "not a key file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("ssh", "-----BEGIN OPENSSH PRIVATE KEY-----\n"))), "not a key file"));
    QVERIFY(
        contains(errorOf(loadIdentity(m_folder.write("v2", "skyseal-private-key-v2\nAAAA\n"))), "\"skyseal-private-key-v2\""));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.write("large", std::string(2 << 20, 'x')))), "too large"));
    QVERIFY(contains(errorOf(loadIdentity("/dev/null")), "not a regular file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.path("."))), "not a regular file"));
    QVERIFY(contains(errorOf(loadIdentity(m_folder.path("missing.key"))), "No such file"));
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
    // The text of a private key is not a public key, even with the public prefix.
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

SKYSEAL_TEST_APPLESS(SecretFileTest)
#include "secret_file_test.moc"
