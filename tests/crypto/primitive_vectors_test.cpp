// The primitives against the vectors of their own standards, and sealed records against a second implementation.
#include "core/crypto/hash.h"
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/kdf.h"
#include "core/crypto/rc4_stream.h"
#include "core/crypto/record_keys.h"
#include "core/crypto/cpace.h"
#include "core/crypto/x25519.h"
#include "tests/support/test_runner.h"

#include "core/base/secret_bytes.h"
#include "tests/crypto/vector_file.h"
#include "tests/noise/fixed_random.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::crypto;
using test::readVectors;
using test::Vector;

namespace {

Key32 key32(const Bytes &bytes)
{
    Key32 key;
    std::copy_n(bytes.begin(), std::min<std::size_t>(bytes.size(), 32), key.mutableView().begin());
    return key;
}

/// Seals with a suite under the given keys and counter 0, whose nonce equals the IV.
std::string sealWithKeys(SuiteId suite, const Vector &vector, const Bytes &plaintext)
{
    RecordKeys keys{key32(vector.bytes("key")), key32(vector.bytes("nonce")), {}};
    const auto cipher = makeRecordCipherFromKeys(suite, std::move(keys));
    Bytes out(cipher->sealedSize(plaintext.size()));
    const Bytes associated = vector.bytes("aad");
    cipher->seal(0, associated, plaintext, out);
    return toHex(out);
}

/// Our block numbers start at 0, those of the vectors at 1: a block of zeros is put in front and removed again.
std::string cipherFromBlockOne(SuiteId suite, const Vector &vector, std::size_t blockSize)
{
    Bytes plaintext(blockSize);
    const Bytes text = vector.bytes("plaintext");
    plaintext.insert(plaintext.end(), text.begin(), text.end());
    return sealWithKeys(suite, vector, plaintext).substr(2 * blockSize, 2 * text.size());
}

} // namespace

class PrimitiveVectorsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void rfc8439();
    void rfc3686();
    void sp800_38a();
    void rfc6229();
    void rfc7748();
    void x25519RefusesPointsOfSmallOrder();
    void cpace();
    void rfc5869();
    void hkdfRefusesTooMuch();
    void rfc4231();
    void rfc7693();
    void hmacBlake2bHashesLongKeys();
    void recordsOfASecondImplementation();
};

void PrimitiveVectorsTest::rfc8439()
{
    const auto vectors = readVectors("rfc8439.txt");
    QCOMPARE(vectors.size(), std::size_t(2));
    QCOMPARE(cipherFromBlockOne(SuiteId::ChaCha20, vectors[0], 64), vectors[0].text("ciphertext"));
    QCOMPARE(sealWithKeys(SuiteId::ChaCha20Poly1305, vectors[1], vectors[1].bytes("plaintext")),
             vectors[1].text("ciphertext") + vectors[1].text("tag"));
}

void PrimitiveVectorsTest::rfc3686()
{
    const auto vectors = readVectors("rfc3686.txt");
    QCOMPARE(vectors.size(), std::size_t(3));
    for (const Vector &vector : vectors)
        QCOMPARE(cipherFromBlockOne(SuiteId::Aes256Ctr, vector, 16), vector.text("ciphertext"));
}

void PrimitiveVectorsTest::sp800_38a()
{
    const auto vectors = readVectors("sp800_38a.txt");
    QCOMPARE(vectors.size(), std::size_t(3));
    for (const Vector &vector : vectors) {
        const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, vector.text("mode").c_str(), nullptr));
        const Bytes iv = vector.bytes("iv");
        for (const EvpDirection direction : {EvpDirection::Encrypt, EvpDirection::Decrypt}) {
            const bool encrypt = direction == EvpDirection::Encrypt;
            const Bytes in = vector.bytes(encrypt ? "plaintext" : "ciphertext");
            const EvpContext context = makeEvpContext(cipher.get(), vector.bytes("key").data(), direction);
            QVERIFY(context);
            EVP_CIPHER_CTX_set_padding(context.get(), 0);
            Bytes out(in.size());
            int written = 0;
            for (int again = 0; again < 2; ++again) { // setting the IV alone restarts a context
                QCOMPARE(EVP_CipherInit_ex2(context.get(), nullptr, nullptr, iv.empty() ? nullptr : iv.data(), -1, nullptr), 1);
                QCOMPARE(EVP_CipherUpdate(context.get(), out.data(), &written, in.data(), int(in.size())), 1);
                QCOMPARE(toHex(out), vector.text(encrypt ? "ciphertext" : "plaintext"));
            }
        }
    }
}

void PrimitiveVectorsTest::rfc6229()
{
    const auto vectors = readVectors("rfc6229.txt");
    QCOMPARE(vectors.size(), std::size_t(2));
    Rc4Stream stream;
    QVERIFY2(stream.ready(), "OpenSSL's legacy provider is missing");
    for (const Vector &vector : vectors) {
        Bytes zeros(16);
        QVERIFY(stream.crypt(key32(vector.bytes("key")), zeros, zeros.data()));
        QCOMPARE(toHex(zeros), vector.text("stream768"));
    }
}

void PrimitiveVectorsTest::rfc7748()
{
    const auto vectors = readVectors("rfc7748.txt");
    QCOMPARE(vectors.size(), std::size_t(3));
    for (const Vector &vector : vectors) {
        PublicKey other{};
        const Bytes bytes = vector.bytes("public");
        std::copy(bytes.begin(), bytes.end(), other.begin());
        const X25519KeyPair own = X25519KeyPair::fromSecret(key32(vector.bytes("secret")));
        QCOMPARE(toHex(x25519(own.secret, other)->view()), vector.text("shared"));
        if (vector.has("secretsPublic"))
            QCOMPARE(toHex(own.publicKey), vector.text("secretsPublic"));
    }
}

void PrimitiveVectorsTest::x25519RefusesPointsOfSmallOrder()
{
    // The orders 1, 2, 4 and 8 in their canonical forms, and p itself as another form of zero.
    for (const char *point : {"0000000000000000000000000000000000000000000000000000000000000000",
                              "0100000000000000000000000000000000000000000000000000000000000000",
                              "ecffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f",
                              "e0eb7a7c3b41b8ae1656e3faf19fc46ada098deb9c32b1fd866205165f49b800",
                              "5f9c95bca3508c24b1d0b1559c83ef5b04445cc4581c8e86d8224eddd09f1157",
                              "edffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f"}) {
        PublicKey key{};
        const Bytes bytes = *fromHex(point);
        std::copy(bytes.begin(), bytes.end(), key.begin());
        QVERIFY2(!x25519(key32(Bytes(32, 0x42)), key), point);
    }
}

void PrimitiveVectorsTest::cpace()
{
    const auto vectors = readVectors("cpace_ristretto255.txt");
    QCOMPARE(vectors.size(), std::size_t(1));
    const Vector &vector = vectors[0];
    const Bytes passphrase = vector.bytes("passphrase"), channel = vector.bytes("channel"), session = vector.bytes("session");
    const CpaceInputs inputs{passphrase, channel, session};
    QCOMPARE(toHex(cpaceGenerator(inputs)), vector.text("generator"));
    const auto begin = [&](Cpace::Role role, const char *scalar) {
        test::FixedRandom random(vector.bytes(scalar));
        return Cpace::begin(role, inputs, random);
    };
    const Cpace a = begin(Cpace::Role::Initiator, "scalar a"), b = begin(Cpace::Role::Responder, "scalar b");
    QCOMPARE(toHex(a.share()), vector.text("share a"));
    QCOMPARE(toHex(b.share()), vector.text("share b"));
    const Bytes dataA = vector.bytes("data a"), dataB = vector.bytes("data b");
    const CpaceMessage fromA{a.share(), dataA}, fromB{b.share(), dataB};
    QCOMPARE(toHex(a.key(session, fromA, fromB)->view()), vector.text("key"));
    QCOMPARE(toHex(b.key(session, fromA, fromB)->view()), vector.text("key"));
    for (const char *refused : {"invalid", "identity"}) {
        const Bytes share = vector.bytes(refused);
        QVERIFY(!a.key(session, fromA, {share, dataB}));
        QVERIFY(!b.key(session, {share, dataA}, fromB));
    }
    QVERIFY(!a.key(session, fromA, {{}, dataB}));
}

void PrimitiveVectorsTest::rfc5869()
{
    const auto vectors = readVectors("rfc5869.txt");
    QCOMPARE(vectors.size(), std::size_t(3));
    for (const Vector &vector : vectors) {
        const Key32 secret = hkdfExtractSha256(vector.bytes("salt"), vector.bytes("ikm"));
        QCOMPARE(toHex(secret.view()), vector.text("prk"));
        Bytes out(vector.bytes("okm").size());
        QVERIFY(hkdfExpandSha256(out, secret.view(), vector.bytes("info")));
        QCOMPARE(toHex(out), vector.text("okm"));
        QCOMPARE(toHex(hkdfExpandKey(secret, vector.bytes("info")).view()), vector.text("okm").substr(0, 64));
    }
}

void PrimitiveVectorsTest::hkdfRefusesTooMuch()
{
    Bytes out(255 * 32 + 1, 0x77);
    QVERIFY(!hkdfExpandSha256(out, Bytes(32), {}));
    QCOMPARE(out, Bytes(out.size(), 0x77));
    out.pop_back();
    QVERIFY(hkdfExpandSha256(out, Bytes(32), {}));
}

void PrimitiveVectorsTest::rfc4231()
{
    const auto vectors = readVectors("rfc4231.txt");
    QCOMPARE(vectors.size(), std::size_t(7));
    for (const Vector &vector : vectors) {
        HmacSha256 hmac(vector.bytes("key"));
        const Bytes message = vector.bytes("message");
        // For every split into parts, and repeatedly under the same key.
        for (std::size_t cut = 0; cut <= message.size(); ++cut) {
            Bytes tag(vector.bytes("tag").size());
            QVERIFY(hmac.compute(tag, {ByteView(message).first(cut), ByteView(), ByteView(message).subspan(cut)}));
            QCOMPARE(toHex(tag), vector.text("tag"));
        }
    }
}

void PrimitiveVectorsTest::rfc7693()
{
    const auto vectors = readVectors("rfc7693.txt");
    QCOMPARE(vectors.size(), std::size_t(1));
    const Bytes message = vectors[0].bytes("message");
    QCOMPARE(toHex(blake2b({message})), vectors[0].text("digest"));
    QCOMPARE(toHex(blake2b({ByteView(message).first(1), ByteView(message).subspan(1)})), vectors[0].text("digest"));
}

void PrimitiveVectorsTest::hmacBlake2bHashesLongKeys()
{
    const Bytes longKey(200, 0x31);
    const Hash64 hashed = blake2b({longKey});
    Hash64 direct{};
    Hash64 throughHash{};
    hmacBlake2b(direct, longKey, {asBytes("message")});
    hmacBlake2b(throughHash, hashed, {asBytes("message")});
    QCOMPARE(direct, throughHash);

    Bytes first(16);
    Bytes second(16);
    keyedBlake2b(first, Bytes(32, 1), {asBytes("mac1")});
    keyedBlake2b(second, Bytes(32, 2), {asBytes("mac1")});
    QVERIFY(first != second);
}

void PrimitiveVectorsTest::recordsOfASecondImplementation()
{
    const auto vectors = readVectors("record_ciphers.txt");
    for (const SuiteId suite : sealedSuites()) {
        const std::string name(suiteInfo(suite).name);
        QVERIFY2(
            std::any_of(vectors.begin(), vectors.end(), [&](const Vector &vector) { return vector.text("suite") == name; }),
            name.c_str());
    }
    for (const Vector &vector : vectors) {
        const auto cipher = makeRecordCipher(suiteFromName(vector.text("suite")).value(), key32(vector.bytes("secret")));
        const Bytes plaintext = vector.bytes("plaintext");
        const Bytes associated = vector.bytes("aad");
        const std::uint64_t counter = std::stoull(vector.text("counter"), nullptr, 16);
        Bytes record(cipher->sealedSize(plaintext.size()));
        QCOMPARE(cipher->seal(counter, associated, plaintext, record), record.size());
        QCOMPARE(toHex(record), vector.text("sealed"));
        const auto opened = cipher->open(counter, associated, record);
        QVERIFY(opened.has_value());
        QCOMPARE(toHex(*opened), toHex(plaintext));
    }
}

SKYSEAL_TEST_APPLESS(PrimitiveVectorsTest)
#include "primitive_vectors_test.moc"
