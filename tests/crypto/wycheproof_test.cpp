// Wycheproof's edge cases: invalid ones are rejected, valid ones match.
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/kdf.h"
#include "core/crypto/record_keys.h"
#include "core/crypto/x25519.h"
#include "tests/support/test_runner.h"

#include "core/base/secret_bytes.h"
#include "tests/crypto/external_vectors.h"

#include <QtCore/QJsonArray>
#include <QtTest/QTest>

#include <functional>

using namespace skyseal;
using namespace skyseal::crypto;
using test::hexField;

class WycheproofTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void aesGcm() { aead("wycheproof_aes_gcm_test.json", SuiteId::Aes256Gcm, 60); }
    void chaCha20Poly1305() { aead("wycheproof_chacha20_poly1305_test.json", SuiteId::ChaCha20Poly1305, 250); }
    void hkdf();
    void hmac();
    void diffieHellman();

private:
    using Check = std::function<bool(const QJsonObject &group, const QJsonObject &test, bool valid)>;
    void aead(const char *file, SuiteId suite, int expected);
    void each(const char *file, const Check &check);
    int m_used = 0;
};

void WycheproofTest::initTestCase()
{
    SKYSEAL_REQUIRES("published_vectors");
    QVERIFY(initCrypto());
}

/// Runs `check` on every test of a file; if it returns false, the test fails and reports the number.
void WycheproofTest::each(const char *file, const Check &check)
{
    m_used = 0;
    const QJsonArray groups = test::externalVectors(file).value(QLatin1String("testGroups")).toArray();
    QVERIFY2(!groups.isEmpty(), file);
    for (const QJsonValue &group : groups) {
        for (const QJsonValue &value : group.toObject().value(QLatin1String("tests")).toArray()) {
            const QJsonObject test = value.toObject();
            const bool valid = test.value(QLatin1String("result")).toString() == QLatin1String("valid");
            const std::string name = "tcId " + std::to_string(test.value(QLatin1String("tcId")).toInt());
            QVERIFY2(check(group.toObject(), test, valid), name.c_str());
        }
    }
}

/// The tests with our sizes: 256-bit key, 96-bit nonce. With counter 0 the nonce equals the IV.
void WycheproofTest::aead(const char *file, SuiteId suite, int expected)
{
    each(file, [&](const QJsonObject &group, const QJsonObject &test, bool valid) {
        if (group.value(QLatin1String("keySize")).toInt() != 256 || group.value(QLatin1String("ivSize")).toInt() != 96)
            return true;
        ++m_used;
        RecordKeys keys;
        const Bytes key = hexField(test, "key");
        const Bytes nonce = hexField(test, "iv");
        std::copy(key.begin(), key.end(), keys.key.mutableView().begin());
        std::copy(nonce.begin(), nonce.end(), keys.iv.mutableView().begin());
        const auto cipher = makeRecordCipherFromKeys(suite, std::move(keys));
        const Bytes message = hexField(test, "msg");
        const Bytes associated = hexField(test, "aad");
        Bytes record = hexField(test, "ct");
        const Bytes tag = hexField(test, "tag");
        record.insert(record.end(), tag.begin(), tag.end());

        Bytes sealed(cipher->sealedSize(message.size()));
        cipher->seal(0, associated, message, sealed);
        if ((sealed == record) != valid)
            return false;
        const auto opened = cipher->open(0, associated, record);
        return opened.has_value() == valid
            && (!valid || std::equal(opened->begin(), opened->end(), message.begin(), message.end()));
    });
    if (!QTest::currentTestFailed() && m_used > 0)
        QVERIFY2(m_used >= expected, std::to_string(m_used).c_str());
}

void WycheproofTest::hkdf()
{
    each("wycheproof_hkdf_sha256_test.json", [](const QJsonObject &, const QJsonObject &test, bool valid) {
        Bytes out(static_cast<std::size_t>(test.value(QLatin1String("size")).toInt()));
        const Key32 secret = hkdfExtractSha256(hexField(test, "salt"), hexField(test, "ikm"));
        const bool done = hkdfExpandSha256(out, secret.view(), hexField(test, "info"));
        return done == valid && (!valid || out == hexField(test, "okm"));
    });
}

void WycheproofTest::hmac()
{
    each("wycheproof_hmac_sha256_test.json", [](const QJsonObject &, const QJsonObject &test, bool valid) {
        const Bytes tag = hexField(test, "tag");
        Bytes computed(tag.size());
        return HmacSha256(hexField(test, "key")).compute(computed, {hexField(test, "msg")}) && (computed == tag) == valid;
    });
}

/// "acceptable" are public keys in unusual form: the result must match as well, except that zero is rejected.
void WycheproofTest::diffieHellman()
{
    each("wycheproof_x25519_test.json", [](const QJsonObject &, const QJsonObject &test, bool) {
        const Bytes secret = hexField(test, "private");
        const Bytes publicBytes = hexField(test, "public");
        const Bytes expected = hexField(test, "shared");
        if (secret.size() != 32 || publicBytes.size() != 32)
            return false;
        PublicKey publicKey{};
        std::copy(publicBytes.begin(), publicBytes.end(), publicKey.begin());
        const auto shared = x25519(Key32(ByteView(secret).first<32>()), publicKey);
        if (expected == Bytes(32))
            return !shared.has_value();
        return shared && std::equal(expected.begin(), expected.end(), shared->view().begin());
    });
}

SKYSEAL_TEST_APPLESS(WycheproofTest)
#include "wycheproof_test.moc"
