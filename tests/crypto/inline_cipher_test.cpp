// Compares every suite at every length with a second implementation of inline_cipher.h from OpenSSL's one-shot calls, which
// include CBC with ciphertext stealing, HKDF and HMAC.
#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/inline_cipher.h"
#include "tests/support/joined.h"
#include "tests/support/test_runner.h"

#include "seeded_random.h"

#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/kdf.h>
#include <openssl/provider.h>

#include <QtTest/QTest>

#include <string>

using namespace skyseal;
using namespace skyseal::crypto;
using test::joined;

namespace {

Bytes expand(const DirectionSecret &secret, const std::string &info)
{
    Bytes out(32);
    EVP_KDF *kdf = EVP_KDF_fetch(nullptr, "HKDF", nullptr);
    EVP_KDF_CTX *context = EVP_KDF_CTX_new(kdf);
    int mode = EVP_KDF_HKDF_MODE_EXPAND_ONLY;
    const OSSL_PARAM parameters[] = {
        OSSL_PARAM_construct_int(OSSL_KDF_PARAM_MODE, &mode),
        OSSL_PARAM_construct_utf8_string(OSSL_KDF_PARAM_DIGEST, const_cast<char *>("SHA256"), 0),
        OSSL_PARAM_construct_octet_string(OSSL_KDF_PARAM_KEY, const_cast<std::uint8_t *>(secret.view().data()), 32),
        OSSL_PARAM_construct_octet_string(OSSL_KDF_PARAM_INFO, const_cast<char *>(info.data()), info.size()),
        OSSL_PARAM_construct_end()};
    const bool done = EVP_KDF_derive(context, out.data(), out.size(), parameters) == 1;
    EVP_KDF_CTX_free(context);
    EVP_KDF_free(kdf);
    return done ? out : Bytes();
}

Bytes encrypt(const char *name, const Bytes &key, const Bytes &iv, Bytes in, OSSL_LIB_CTX *library = nullptr)
{
    EVP_CIPHER *cipher = EVP_CIPHER_fetch(library, name, nullptr);
    EVP_CIPHER_CTX *context = EVP_CIPHER_CTX_new();
    Bytes out(in.size() + 32);
    int written = 0;
    bool done = cipher && EVP_EncryptInit_ex2(context, cipher, nullptr, nullptr, nullptr) == 1;
    if (std::string(name) == "RC4")
        done = done && EVP_CIPHER_CTX_set_key_length(context, 32) == 1;
    if (std::string(name) == "AES-256-CBC-CTS") {
        const OSSL_PARAM stealing[] = {
            OSSL_PARAM_construct_utf8_string(OSSL_CIPHER_PARAM_CTS_MODE, const_cast<char *>("CS1"), 0),
            OSSL_PARAM_construct_end()};
        done = done && EVP_CIPHER_CTX_set_params(context, stealing) == 1;
    }
    done = done && EVP_EncryptInit_ex2(context, nullptr, key.data(), iv.empty() ? nullptr : iv.data(), nullptr) == 1
        && EVP_CIPHER_CTX_set_padding(context, 0) == 1
        && EVP_EncryptUpdate(context, out.data(), &written, in.data(), static_cast<int>(in.size())) == 1;
    EVP_CIPHER_CTX_free(context);
    EVP_CIPHER_free(cipher);
    out.resize(done ? static_cast<std::size_t>(written) : 0);
    return out;
}

Bytes bigEndian(std::uint64_t counter)
{
    Bytes out(8);
    for (std::size_t i = 0; i < 8; ++i)
        out[i] = static_cast<std::uint8_t>(counter >> (56 - 8 * i));
    return out;
}

Bytes littleEndian(std::uint64_t number, std::size_t size)
{
    Bytes out(size);
    for (std::size_t i = 0; i < size; ++i)
        out[i] = static_cast<std::uint8_t>(number >> (8 * i));
    return out;
}

Bytes hmac(const Bytes &key, const Bytes &message)
{
    Bytes out(32);
    unsigned size = 0;
    HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()), message.data(), message.size(), out.data(), &size);
    return out;
}

Bytes nonceOf(const Bytes &iv, std::uint64_t counter)
{
    Bytes nonce(iv.begin(), iv.begin() + 12);
    const Bytes number = bigEndian(counter);
    for (std::size_t i = 0; i < 8; ++i)
        nonce[4 + i] ^= number[i];
    return nonce;
}

Bytes expectedBody(SuiteId suite, const Bytes &key, const Bytes &iv, std::uint64_t counter, const Bytes &plaintext)
{
    if (plaintext.empty())
        return {};
    switch (suite) {
    case SuiteId::Aes256Ctr: return encrypt("AES-256-CTR", key, joined({nonceOf(iv, counter), Bytes(4)}), plaintext);
    case SuiteId::ChaCha20: return encrypt("ChaCha20", key, joined({Bytes(4), nonceOf(iv, counter)}), plaintext);
    case SuiteId::Rc4: {
        OSSL_LIB_CTX *library = OSSL_LIB_CTX_new();
        OSSL_PROVIDER *legacy = OSSL_PROVIDER_load(library, "legacy");
        Bytes out = encrypt("RC4", hmac(key, littleEndian(counter, 8)), {}, joined({Bytes(768), plaintext}), library);
        OSSL_PROVIDER_unload(legacy);
        OSSL_LIB_CTX_free(library);
        out.erase(out.begin(), out.begin() + 768);
        return out;
    }
    default: {
        const Bytes first = encrypt("AES-256-ECB", iv, {}, joined({Bytes(8), bigEndian(counter)}));
        if (plaintext.size() >= 16)
            return encrypt("AES-256-CBC-CTS", key, first, plaintext);
        Bytes out = encrypt("AES-256-ECB", key, {}, first);
        out.resize(plaintext.size());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] ^= plaintext[i];
        return out;
    }
    }
}

} // namespace

class InlineCipherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void everyLengthAsWrittenDown_data() { suites(); }
    void everyLengthAsWrittenDown();
    void wrongInputsAreRefused_data() { suites(); }
    void wrongInputsAreRefused();
    void onlyTheClassicSuites();
    void sharesNothingWithRecords();

private:
    void suites()
    {
        QTest::addColumn<int>("suite");
        for (const SuiteInfo &info : crypto::suites()) {
            if (mayBeInline(info.id))
                QTest::newRow(std::string(info.name).c_str()) << static_cast<int>(info.id);
        }
    }
};

void InlineCipherTest::everyLengthAsWrittenDown()
{
    QFETCH(int, suite);
    const auto id = static_cast<SuiteId>(suite);
    test::SeededRandom random(11);
    const DirectionSecret secret(ByteView(random.bytes(32)).first<32>());
    const std::string label = "skyseal v1 inline " + std::string(suiteInfo(id).name) + " ";
    const Bytes key = expand(secret, label + "key"), iv = expand(secret, label + "iv"), mac = expand(secret, label + "mac");
    const auto writer = makeInlineCipher(id, secret);
    const auto reader = makeInlineCipher(id, secret);
    for (std::size_t length = 0; length <= 255; ++length) {
        const Bytes plaintext = random.bytes(length);
        const Bytes associated = random.bytes(random.number() % 40);
        const std::uint64_t counter = random.number() % (1u << 24);
        Bytes body = plaintext;
        const auto tag = writer->seal(counter, associated, body);
        QVERIFY(tag);
        QCOMPARE(toHex(body), toHex(expectedBody(id, key, iv, counter, plaintext)));
        Bytes whole = hmac(mac, joined({littleEndian(counter, 8), littleEndian(associated.size(), 4), associated, body}));
        whole.resize(8);
        QCOMPARE(toHex(*tag), toHex(whole));
        QVERIFY(reader->open(counter, associated, body, *tag));
        QCOMPARE(toHex(body), toHex(plaintext));
    }
}

void InlineCipherTest::wrongInputsAreRefused()
{
    QFETCH(int, suite);
    const auto cipher = makeInlineCipher(static_cast<SuiteId>(suite), DirectionSecret());
    test::SeededRandom random(12);
    for (const std::size_t length : {1, 15, 16, 17, 31, 32, 33, 255}) {
        const Bytes associated = random.bytes(18);
        Bytes sealed = random.bytes(length);
        const auto tag = cipher->seal(7, associated, sealed);
        QVERIFY(tag);
        const auto refused = [&](std::uint64_t counter, const Bytes &about, Bytes body, InlineCipher::Tag with) {
            const Bytes before = body;
            return !cipher->open(counter, about, body, with) && body == before;
        };
        QVERIFY(refused(8, associated, sealed, *tag));
        for (std::size_t bit = 0; bit < length * 8; ++bit) {
            Bytes other = sealed;
            other[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
            QVERIFY(refused(7, associated, other, *tag));
        }
        for (std::size_t bit = 0; bit < associated.size() * 8; ++bit) {
            Bytes other = associated;
            other[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
            QVERIFY(refused(7, other, sealed, *tag));
        }
        for (std::size_t bit = 0; bit < tag->size() * 8; ++bit) {
            auto other = *tag;
            other[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
            QVERIFY(refused(7, associated, sealed, other));
        }
        QVERIFY(cipher->open(7, associated, sealed, *tag));
    }
}

void InlineCipherTest::onlyTheClassicSuites()
{
    int possible = 0;
    for (const SuiteInfo &info : crypto::suites()) {
        const bool classic = info.authenticated && !info.isAead();
        QCOMPARE(mayBeInline(info.id), classic);
        QCOMPARE(makeInlineCipher(info.id, DirectionSecret()) != nullptr, classic);
        possible += classic;
    }
    QCOMPARE(possible, 4);
}

void InlineCipherTest::sharesNothingWithRecords()
{
    // Under the same key and counter a stream cipher would give the same ciphertext in both framings.
    for (const SuiteId suite : {SuiteId::Aes256Ctr, SuiteId::ChaCha20, SuiteId::Rc4}) {
        const DirectionSecret secret;
        Bytes body(64);
        QVERIFY(makeInlineCipher(suite, secret)->seal(5, {}, body));
        Bytes record(64 + 16);
        QCOMPARE(makeRecordCipher(suite, secret.clone())->seal(5, {}, Bytes(64), record), record.size());
        record.resize(64);
        QVERIFY(record != body);
    }
}

SKYSEAL_TEST_APPLESS(InlineCipherTest)
#include "inline_cipher_test.moc"
