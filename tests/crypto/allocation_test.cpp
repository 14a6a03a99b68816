// Sealing and opening must not allocate: the packet path runs for hours at hundreds of records per second. Only OpenSSL 3.0
// does, inside each HMAC (hmac_sha256.h).
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cstdlib>

static thread_local std::size_t allocations = 0;

// Every allocation of the process uses these functions, including OpenSSL's and libsodium's.
extern "C" void *__libc_malloc(std::size_t size);
extern "C" void *__libc_calloc(std::size_t count, std::size_t size);
extern "C" void *__libc_realloc(void *old, std::size_t size);

extern "C" void *malloc(std::size_t size)
{
    ++allocations;
    return __libc_malloc(size);
}

extern "C" void *calloc(std::size_t count, std::size_t size)
{
    ++allocations;
    return __libc_calloc(count, size);
}

extern "C" void *realloc(void *old, std::size_t size)
{
    ++allocations;
    return __libc_realloc(old, size);
}

using namespace skyseal;
using namespace skyseal::crypto;

class AllocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void countsAtAll();
    void nothingPerRecord();
};

void AllocationTest::countsAtAll()
{
    const std::size_t before = allocations;
    const auto bytes = std::make_unique<Bytes>(100);
    QVERIFY(bytes->size() == 100 && allocations >= before + 2);
}

void AllocationTest::nothingPerRecord()
{
    for (const SuiteInfo &info : suites()) {
        const auto cipher = makeRecordCipher(info.id, DirectionSecret());
        if (!cipher)
            continue;
        std::array<std::uint8_t, 512> buffer{};
        const std::array<std::uint8_t, 10> associated{};
        const std::size_t before = allocations; // from the first record on
        bool opened = true;
        for (std::uint64_t counter = 0; counter < 100; ++counter) {
            const std::size_t size = counter * 3;
            const std::size_t length = cipher->seal(counter, associated, ByteView(buffer).first(size), buffer);
            opened = opened && cipher->open(counter, associated, MutableByteView(buffer).first(length)).has_value();
            buffer[0] = static_cast<std::uint8_t>(buffer[0] ^ 1);
            static_cast<void>(cipher->open(counter, associated, MutableByteView(buffer).first(length)));
        }
        const std::size_t after = allocations;
        QVERIFY(opened);
        // Sealed, opened and refused; rc4 also makes the key of each record that it seals or opens by an HMAC.
        const std::size_t macs = info.isAead() ? 0 : info.id == SuiteId::Rc4 ? 5 : 3;
        QVERIFY2(after - before <= 2 * macs * 100, (std::string(info.name) + ": " + std::to_string(after - before)).c_str());
    }
}

SKYSEAL_TEST_APPLESS(AllocationTest)
#include "allocation_test.moc"
