// The benchmark on a machine that lacks a cipher: OpenSSL's legacy provider, and RC4 with it, is not installed everywhere. What
// cannot be made has no cost, and no memory of zero bytes either.
#include "core/crypto/init_crypto.h"
#include "core/experiment/cipher_bench.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

class MissingCipherBenchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("OPENSSL_MODULES", "/nonexistent"); // before the first look for the provider
        QVERIFY(crypto::initCrypto());
        QVERIFY(!crypto::suiteAvailable(SuiteId::Rc4));
    }
    void hasNoMemory()
    {
        QVERIFY(!contextBytes(SuiteId::Rc4));
        QVERIFY(!sessionBytes(SuiteId::Rc4));
    }
    void hasNoCosts()
    {
        const SuiteCosts costs = benchSuite(SuiteId::Rc4, {16});
        QVERIFY(costs.failed && costs.sizes.empty() && !costs.contextBytes && !costs.sessionBytes);
    }
};

SKYSEAL_TEST_APPLESS(MissingCipherBenchTest)
#include "missing_cipher_bench_test.moc"
