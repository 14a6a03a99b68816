// A secret sealed with a passphrase: secrets sealed by another implementation open; only the same passphrase, cost, salt and
// associated data open them; excessive costs are rejected without computing.
#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/passphrase_box.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::crypto;

class PassphraseBoxTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void opensWhatAnotherSealed();
    void nothingElseOpensIt();
    void hostileCostsAreRefused();
    void passphrasesHaveALength();

private:
    static Passphrase words(std::string_view text) { return *Passphrase::fromBytes(asBytes(text)); }
    static Key32 counted()
    {
        Key32 key;
        for (std::size_t i = 0; i < key.size(); ++i)
            key.mutableView()[i] = static_cast<std::uint8_t>(i);
        return key;
    }

    const PassphraseCost m_cheap{1, 8 * 1024};
    const PassphraseSalt m_salt{0xa0, 0xa1, 0xa2, 0xa3, 0xa4, 0xa5, 0xa6, 0xa7, 0xa8, 0xa9, 0xaa, 0xab, 0xac, 0xad, 0xae, 0xaf};
};

void PassphraseBoxTest::opensWhatAnotherSealed()
{
    // From tests/data/keys/sealed.key, which a script made with python3-cryptography.
    constexpr std::string_view kAssociated = "skyseal-sealed-key-v1\n"
                                             "argon2id 2 8192 a0a1a2a3a4a5a6a7a8a9aaabacadaeaf\n"
                                             "skyseal:j0DFrbaPJWJK5bIU6nZ6bslNgp09e14a0bpvPiE4KF-6pDEN\n";
    const Bytes bytes = *fromHex("f9be03f1baf1105f558625d55f1f019b7511a90c6b16bfd482554c558bb14ceb"
                                 "bb64a81af2ae7071b58f1d1c62eaa294");
    SealedSecret sealed{};
    std::copy(bytes.begin(), bytes.end(), sealed.begin());
    const Passphrase passphrase = words("correct horse battery staple");
    const auto opened = openWithPassphrase(sealed, passphrase, {2, 8192}, m_salt, asBytes(kAssociated));
    QVERIFY(opened && opened->equals(counted()));
    const auto again = sealWithPassphrase(*opened, passphrase, {2, 8192}, m_salt, asBytes(kAssociated));
    QVERIFY(again && *again == sealed);
}

void PassphraseBoxTest::nothingElseOpensIt()
{
    const Bytes associated{1, 2, 3};
    const auto sealed = sealWithPassphrase(counted(), words("secret"), m_cheap, m_salt, associated);
    QVERIFY(sealed);
    const auto refused = [&](const SealedSecret &box, std::string_view text, const PassphraseCost &cost,
                             const PassphraseSalt &salt, ByteView said) {
        const auto opened = openWithPassphrase(box, words(text), cost, salt, said);
        return !opened && opened.error() == PassphraseError::DoesNotOpen;
    };
    for (const char *text : {"Secret", "secre", "secret ", "s"})
        QVERIFY2(refused(*sealed, text, m_cheap, m_salt, associated), text);
    QVERIFY(refused(*sealed, std::string_view("secret\0", 7), m_cheap, m_salt, associated));
    for (const std::size_t at : {std::size_t(0), std::size_t(31), std::size_t(32), std::size_t(47)}) {
        SealedSecret changed = *sealed;
        changed[at] ^= 0x80;
        QVERIFY(refused(changed, "secret", m_cheap, m_salt, associated));
    }
    PassphraseSalt otherSalt = m_salt;
    otherSalt[15] ^= 1;
    QVERIFY(refused(*sealed, "secret", m_cheap, otherSalt, associated));
    QVERIFY(refused(*sealed, "secret", {2, 8 * 1024}, m_salt, associated));
    QVERIFY(refused(*sealed, "secret", {1, 8 * 1024 + 8}, m_salt, associated));
    QVERIFY(refused(*sealed, "secret", m_cheap, m_salt, Bytes{1, 2}));
    QVERIFY(openWithPassphrase(*sealed, words("secret"), m_cheap, m_salt, associated)->equals(counted()));
}

void PassphraseBoxTest::hostileCostsAreRefused()
{
    for (const PassphraseCost cost : {PassphraseCost{0, 8192}, PassphraseCost{17, 8192}, PassphraseCost{1, 8191},
                                      PassphraseCost{1, 1024 * 1024 + 1}, PassphraseCost{UINT32_MAX, UINT32_MAX}}) {
        QVERIFY(!isAcceptable(cost));
        QCOMPARE(sealWithPassphrase(counted(), words("secret"), cost, m_salt, {}).error(), PassphraseError::NoMemory);
        QCOMPARE(openWithPassphrase({}, words("secret"), cost, m_salt, {}).error(), PassphraseError::NoMemory);
    }
    QVERIFY(isAcceptable(PassphraseCost()) && isAcceptable(kLeastPassphraseCost) && isAcceptable(kMostPassphraseCost));
}

void PassphraseBoxTest::passphrasesHaveALength()
{
    QVERIFY(!Passphrase::fromBytes({}));
    QVERIFY(!Passphrase::fromBytes(Bytes(Passphrase::kMaxLength + 1)));
    const auto longest = Passphrase::fromBytes(Bytes(Passphrase::kMaxLength, 'x'));
    QVERIFY(longest && longest->view().size() == Passphrase::kMaxLength);
    QVERIFY(longest->clone().equals(*longest));
    QVERIFY(!words("secret").equals(words("secres")));
    QVERIFY(!words("secret").equals(*Passphrase::fromBytes(Bytes{'s', 'e', 'c', 'r', 'e', 't', 0})));
}

SKYSEAL_TEST_APPLESS(PassphraseBoxTest)
#include "passphrase_box_test.moc"
