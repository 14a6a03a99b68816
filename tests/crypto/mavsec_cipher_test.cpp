// The encryption of the code published with the paper MAVSec, against the vectors that its keys come from: RFC 8439 2.4.2
// and NIST SP 800-38A F.5.5; and its documented weakness.
#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/mavsec_cipher.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::crypto;

class MavsecCipherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void publishedVectors_data();
    void publishedVectors();
    void everyFrameIsXoredAlike();
    void workDoesNotChangeTheResult_data();
    void workDoesNotChangeTheResult();
    void noncesOfOtherLengthsAreRefused();

private:
    using Kind = MavsecCipher::Kind;
    static MavsecCipher published(Kind kind)
    {
        return *MavsecCipher::make(kind, MavsecCipher::publishedKey(kind), MavsecCipher::publishedNonce(kind),
                                   MavsecCipher::kPublishedCounter);
    }
};

void MavsecCipherTest::publishedVectors_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("plain");
    QTest::addColumn<QByteArray>("sealed");
    QTest::newRow("RFC 8439 2.4.2") << static_cast<int>(Kind::ChaCha20)
                                    << QByteArray("4c616469657320616e642047656e746c656d656e206f662074686520636c6173")
                                    << QByteArray("6e2e359a2568f98041ba0728dd0d6981e97e7aec1d4360c20a27afccfd9fae0b");
    QTest::newRow("SP 800-38A F.5.5") << static_cast<int>(Kind::Aes256Ctr)
                                      << QByteArray("6bc1bee22e409f96e93d7e117393172aae2d8a571e03ac9c9eb76fac45af8e51")
                                      << QByteArray("601ec313775789a5b7a7f504bbf3d228f443e3ca4d62b59aca84e990cacaf5c5");
}

void MavsecCipherTest::publishedVectors()
{
    QFETCH(int, kind);
    QFETCH(QByteArray, plain);
    QFETCH(QByteArray, sealed);
    const MavsecCipher cipher = published(static_cast<Kind>(kind));
    Bytes bytes = *fromHex(plain.toStdString());
    cipher.apply(bytes);
    QCOMPARE(toHex(bytes), sealed.toStdString());
    cipher.clone().apply(bytes);
    QCOMPARE(toHex(bytes), plain.toStdString());
}

void MavsecCipherTest::everyFrameIsXoredAlike()
{
    // One known payload reveals the key stream, and thereby every other payload.
    for (const Kind kind : {Kind::ChaCha20, Kind::Aes256Ctr}) {
        const MavsecCipher cipher = published(kind);
        Bytes known(255, 0x55), secret(255);
        for (std::size_t i = 0; i < secret.size(); ++i)
            secret[i] = static_cast<std::uint8_t>(i);
        Bytes first = known, second = secret;
        cipher.apply(first);
        cipher.apply(second);
        for (std::size_t i = 0; i < second.size(); ++i)
            QCOMPARE(static_cast<std::uint8_t>(second[i] ^ first[i] ^ known[i]), secret[i]);
    }
    // The number of the first block applies to ChaCha20 only.
    const auto streamOf = [](Kind kind, std::uint32_t counter) {
        Bytes zeros(64);
        const Bytes nonce = MavsecCipher::publishedNonce(kind);
        MavsecCipher::make(kind, MavsecCipher::publishedKey(kind), nonce, counter)->apply(zeros);
        return zeros;
    };
    QVERIFY(streamOf(Kind::ChaCha20, 1) != streamOf(Kind::ChaCha20, 2));
    QVERIFY(streamOf(Kind::Aes256Ctr, 1) == streamOf(Kind::Aes256Ctr, 2));
}

void MavsecCipherTest::workDoesNotChangeTheResult_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("nonce");
    QTest::newRow("chacha20") << static_cast<int>(Kind::ChaCha20) << QByteArray("00000000000000000000004a");
    QTest::newRow("aes-256-ctr") << static_cast<int>(Kind::Aes256Ctr) << QByteArray("f0f1f2f3f4f5f6f7f8f9fafbfcfdfeff");
    QTest::newRow("a counter that carries")
        << static_cast<int>(Kind::Aes256Ctr) << QByteArray("0011223344556677fffffffffffffffe");
}

void MavsecCipherTest::workDoesNotChangeTheResult()
{
    QFETCH(int, kind);
    QFETCH(QByteArray, nonce);
    const auto make = [&](MavsecWork work) {
        return *MavsecCipher::make(static_cast<Kind>(kind), MavsecCipher::publishedKey(Kind::Aes256Ctr),
                                   *fromHex(nonce.toStdString()), 7, work);
    };
    const MavsecCipher once = make(MavsecWork::Once), each = make(MavsecWork::EachFrame);
    for (std::size_t size = 0; size <= 255; ++size) {
        Bytes one(size, 0x5a), other = one;
        once.apply(one);
        each.apply(other);
        QCOMPARE(toHex(other), toHex(one));
        each.clone().apply(other);
        QCOMPARE(other, Bytes(size, 0x5a));
    }
}

void MavsecCipherTest::noncesOfOtherLengthsAreRefused()
{
    for (const Kind kind : {Kind::ChaCha20, Kind::Aes256Ctr}) {
        for (std::size_t length = 0; length <= 24; ++length) {
            const bool made = MavsecCipher::make(kind, Key32(), Bytes(length), 1).has_value();
            QCOMPARE(made, length == MavsecCipher::nonceLength(kind));
        }
    }
}

SKYSEAL_TEST_APPLESS(MavsecCipherTest)
#include "mavsec_cipher_test.moc"
