// Private keys sealed with a passphrase: only the passphrase opens them, every changed byte is detected, excessive costs are
// rejected without computing, and no error message contains a byte of a key or of a passphrase.
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/public_key_text.h"
#include "core/keys/sealed_key.h"
#include "core/keys/secret_file.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/error_text.h"
#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::keys;
using crypto::Passphrase;
using crypto::PassphraseCost;
using crypto::PassphraseError;
using crypto::X25519KeyPair;
using test::contains;
using test::errorOf;
using test::readText;

namespace {

constexpr PassphraseCost kCheap = crypto::kLeastPassphraseCost;

Passphrase words(std::string_view text)
{
    return Passphrase::fromBytes(asBytes(text)).value();
}

/// Returns the given passphrases in order, then an error.
AskPassphrase answering(std::vector<std::string> answers, int *asked = nullptr)
{
    return [answers = std::move(answers), asked](const std::string &file, int attempt) -> Result<Passphrase, InputError> {
        if (asked)
            *asked = attempt + 1;
        if (attempt >= static_cast<int>(answers.size()))
            return tl::unexpected(InputError{"nobody knows the passphrase", file});
        return words(answers[static_cast<std::size_t>(attempt)]);
    };
}

} // namespace

class SealedKeyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void passphrasesHaveALength();
    void opensWithItsPassphraseAlone();
    void textReadsBackTheSame();
    void everyChangedCharacterIsNoticed();
    void everyTruncationIsRefused();
    void hostileCostsAreRefusedUnseen();
    void opensWhatOthersSealed();
    void fileIsSealedAndReadBack();
    void asksAgainUntilSomebodyGivesUp();
    void factsNeedNoPassphrase();
    void passphraseIsChangedAndTakenAway();
    void noErrorShowsASecret();

private:
    X25519KeyPair newPair() { return X25519KeyPair::generate(m_random); }
    SealedKey sealed(const X25519KeyPair &pair, std::string_view passphrase)
    {
        return SealedKey::seal(pair, words(passphrase), kCheap, m_random).value();
    }

    test::TemporaryFolder m_folder;
    test::SeededRandom m_random{7};
};

void SealedKeyTest::passphrasesHaveALength()
{
    QVERIFY(!Passphrase::fromBytes({}));
    QVERIFY(!Passphrase::fromBytes(Bytes(Passphrase::kMaxLength + 1, 'x')));
    QCOMPARE(Passphrase::fromBytes(Bytes(Passphrase::kMaxLength, 'x'))->view().size(), Passphrase::kMaxLength);
    QVERIFY(words("a b").equals(words("a b")));
    QVERIFY(!words("a b").equals(words("a c")) && !words("a").equals(words("ab")));
}

void SealedKeyTest::opensWithItsPassphraseAlone()
{
    for (int i = 0; i < 10; ++i) {
        const X25519KeyPair pair = newPair();
        const std::string passphrase = "horse " + std::to_string(m_random.number());
        const SealedKey key = sealed(pair, passphrase);
        QVERIFY(key.open(words(passphrase))->secret.equals(pair.secret));
        for (const std::string &wrong : {passphrase + " ", passphrase.substr(1), std::string("x"), passphrase + '\0'})
            QVERIFY(key.open(words(wrong)).error() == PassphraseError::DoesNotOpen);
        // Sealing again with the same passphrase gives another text, since the salt is fresh.
        QVERIFY(sealed(pair, passphrase).sealed != key.sealed);
    }
}

void SealedKeyTest::textReadsBackTheSame()
{
    for (int i = 0; i < 20; ++i) {
        SealedKey key = sealed(newPair(), "words");
        key.cost = {1 + std::uint32_t(m_random.number() % 16), 8192 + std::uint32_t(m_random.number() % 1040385)};
        const auto read = SealedKey::parse(key.text(), "test");
        QCOMPARE(errorOf(read), std::string());
        QVERIFY(read->cost == key.cost && read->salt == key.salt && read->publicKey == key.publicKey
                && read->sealed == key.sealed);
        QCOMPARE(read->text(), key.text());
    }
}

void SealedKeyTest::everyChangedCharacterIsNoticed()
{
    const X25519KeyPair pair = newPair();
    const std::string good = sealed(pair, "words").text();
    const std::size_t remark = good.find('#');
    const std::size_t remarkEnd = good.find('\n', remark);
    int opened = 0;
    for (std::size_t at = 0; at < good.size(); ++at) {
        if (at >= remark && at <= remarkEnd)
            continue; // comments are not authenticated
        std::string bad = good;
        bad[at] = bad[at] == '2' ? '3' : '2';
        const auto read = SealedKey::parse(bad, "test");
        if (!read)
            continue;
        ++opened;
        QVERIFY2(!read->open(words("words")), std::to_string(at).c_str());
    }
    QVERIFY(opened >= 64 + 32); // salt and ciphertext stay well-formed; only decryption detects the change
}

void SealedKeyTest::everyTruncationIsRefused()
{
    const std::string whole = sealed(newPair(), "words").text();
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
        const auto read = SealedKey::parse(whole.substr(0, size), "test");
        QVERIFY2(!read && !read.error().message.empty(), std::to_string(size).c_str());
    }
    QVERIFY(contains(errorOf(SealedKey::parse(whole.substr(0, whole.size() - 9), "f")), "truncated"));
    QVERIFY(contains(errorOf(SealedKey::parse("skyseal-sealed-key-v1\n", "f")), "truncated"));
    QVERIFY(contains(errorOf(SealedKey::parse(whole + "x\n", "f")), "more behind"));
    QVERIFY(contains(errorOf(SealedKey::parse("", "f")), "does not begin"));
}

void SealedKeyTest::hostileCostsAreRefusedUnseen()
{
    const SealedKey good = sealed(newPair(), "words");
    const PassphraseCost hostile[] = {{17, 8192}, {4294967295, 8192}, {1, 1048577}, {1, 4294967295},
                                      {0, 8192},  {1, 8191},          {1, 0}};
    for (const PassphraseCost &cost : hostile) {
        SealedKey key = good;
        key.cost = cost;
        QVERIFY2(!SealedKey::parse(key.text(), "f"), key.text().c_str());
        // Nor computed if the object is made directly: a computed key would end in DoesNotOpen, after hours or gigabytes.
        QVERIFY(key.open(words("words")).error() == PassphraseError::NoMemory);
    }
    const std::string line = "argon2id 1 8192 ";
    for (const char *instead :
         {"argon2id 99999999999 8192 ", "argon2id -1 8192 ", "argon2id 01 8192 ", "argon2i 1 8192 ", "argon2id 1 8192"}) {
        std::string text = good.text();
        QVERIFY(contains(text, line));
        text.replace(text.find(line), line.size(), instead);
        QVERIFY(!SealedKey::parse(text, "f"));
    }
}

/// A file made by an independent implementation of the format: tests/data/keys/make_sealed_key.py.
void SealedKeyTest::opensWhatOthersSealed()
{
    const auto key = SealedKey::parse(readText(SKYSEAL_SOURCE_DIR "/tests/data/keys/sealed.key"), "sealed.key");
    QCOMPARE(errorOf(key), std::string());
    const auto pair = key->open(words("correct horse battery staple"));
    QVERIFY(pair.has_value());
    QCOMPARE(toHex(pair->secret.view()), std::string("000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f"));
    QVERIFY(!key->open(words("correct horse battery stable")));
}

void SealedKeyTest::fileIsSealedAndReadBack()
{
    const std::string path = m_folder.path("sealed.key");
    const Passphrase passphrase = words("between us");
    const auto written = writeNewIdentity(path, m_random, {&passphrase, kCheap});
    QCOMPARE(errorOf(written), std::string());
    QCOMPARE(test::modeOf(path), mode_t(0600));
    QVERIFY(readText(path).starts_with("skyseal-sealed-key-v1\n"));
    QCOMPARE(loadIdentity(path, answering({"between us"}))->publicKey, *written);
    QVERIFY(contains(errorOf(loadIdentity(path)), "is sealed with a passphrase, and none is given"));
    ::chmod(path.c_str(), 0640);
    int asked = 0;
    QVERIFY(contains(errorOf(loadIdentity(path, answering({"between us"}, &asked))), "other users"));
    QCOMPARE(asked, 0);
}

void SealedKeyTest::asksAgainUntilSomebodyGivesUp()
{
    const std::string path = m_folder.path("asked.key");
    const Passphrase passphrase = words("third");
    QVERIFY(writeNewIdentity(path, m_random, {&passphrase, kCheap}));
    int asked = 0;
    QVERIFY(loadIdentity(path, answering({"first", "second", "third"}, &asked)).has_value());
    QCOMPARE(asked, 3);
    QVERIFY(contains(errorOf(loadIdentity(path, answering({"first", "second"}, &asked))), "nobody knows"));
    QCOMPARE(asked, 3);
}

void SealedKeyTest::factsNeedNoPassphrase()
{
    const std::string sealedPath = m_folder.path("facts-sealed.key");
    const std::string plainPath = m_folder.path("facts-plain.key");
    const Passphrase passphrase = words("x");
    const auto first = writeNewIdentity(sealedPath, m_random, {&passphrase, kCheap});
    const auto second = writeNewIdentity(plainPath, m_random);
    QVERIFY(first && second);
    QCOMPARE(readIdentityFacts(sealedPath)->publicKey, *first);
    QVERIFY(readIdentityFacts(sealedPath)->sealed);
    QCOMPARE(readIdentityFacts(plainPath)->publicKey, *second);
    QVERIFY(!readIdentityFacts(plainPath)->sealed);
    QVERIFY(contains(errorOf(readIdentityFacts(m_folder.path("nowhere"))), "No such file"));
}

void SealedKeyTest::passphraseIsChangedAndTakenAway()
{
    const std::string path = m_folder.path("changed.key");
    QVERIFY(writeNewIdentity(path, m_random));
    const auto pair = loadIdentity(path);
    QVERIFY(pair.has_value());
    const Passphrase one = words("one"), two = words("two");
    for (const Passphrase *passphrase : {&one, &two}) {
        QCOMPARE(errorOf(rewriteIdentity(path, *pair, m_random, {passphrase, kCheap})), std::string());
        QVERIFY(loadIdentity(path, answering({std::string(asText(passphrase->view()))}))->secret.equals(pair->secret));
    }
    QVERIFY(!loadIdentity(path, answering({"one"})));
    QCOMPARE(::chmod(path.c_str(), 0644), 0); // a secret is never written where others can read it
    QVERIFY(rewriteIdentity(path, *pair, m_random, {}).has_value());
    QVERIFY(loadIdentity(path)->secret.equals(pair->secret));
    QCOMPARE(test::modeOf(path), mode_t(0600));
}

void SealedKeyTest::noErrorShowsASecret()
{
    const X25519KeyPair pair = newPair();
    const std::string good = sealed(pair, "swordfish").text();
    const std::string ciphertext = good.substr(good.size() - 65, 64);
    const std::string secret = toHex(pair.secret.view());
    for (std::size_t size = 0; size < good.size(); size += 3) {
        for (const std::string &text :
             {good.substr(0, size), good.substr(size), good.substr(0, size) + "!" + good.substr(size)}) {
            const std::string error = errorOf(parseIdentity(text, "file", answering({"swordfish"})));
            QVERIFY2(!contains(error, ciphertext.substr(0, 8)) && !contains(error, "swordfish")
                         && !contains(error, secret.substr(0, 8)),
                     error.c_str());
        }
    }
}

SKYSEAL_TEST_APPLESS(SealedKeyTest)
#include "sealed_key_test.moc"
