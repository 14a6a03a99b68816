// Properties of every suite over inputs that rapidcheck makes up; it prints the seed of a failure (RC_PARAMS repeats it).
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "tests/support/test_runner.h"

#include <rapidcheck.h>

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::crypto;

namespace {

rc::Gen<SuiteId> anySuite()
{
    return rc::gen::elementOf(sealedSuites());
}

DirectionSecret anySecret()
{
    const auto bytes = *rc::gen::container<Bytes>(32, rc::gen::arbitrary<std::uint8_t>());
    return DirectionSecret(ByteView(bytes).first<32>());
}

Bytes seal(RecordCipher &cipher, std::uint64_t counter, const Bytes &associated, const Bytes &plaintext)
{
    Bytes out(cipher.sealedSize(plaintext.size()));
    RC_ASSERT(cipher.seal(counter, associated, plaintext, out) == out.size());
    return out;
}

} // namespace

class RecordPropertyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void roundTrip();
    void anyOtherBytesAreRefused();
    void differentSecretsDifferentRecords();
    void capacityIsTheInverseOfSize();
};

void RecordPropertyTest::roundTrip()
{
    QVERIFY(rc::check("what was sealed opens", [](std::uint64_t counter, const Bytes &associated, const Bytes &plaintext) {
        const auto cipher = makeRecordCipher(*anySuite(), anySecret());
        Bytes record = seal(*cipher, counter, associated, plaintext);
        const auto opened = cipher->open(counter, associated, record);
        RC_ASSERT(opened.has_value());
        RC_ASSERT(Bytes(opened->begin(), opened->end()) == plaintext);
    }));
}

void RecordPropertyTest::anyOtherBytesAreRefused()
{
    QVERIFY(rc::check("nothing else opens", [](std::uint64_t counter, const Bytes &associated, const Bytes &plaintext) {
        const auto cipher = makeRecordCipher(*anySuite(), anySecret());
        const Bytes record = seal(*cipher, counter, associated, plaintext);
        Bytes other = record;
        std::uint64_t otherCounter = counter;
        Bytes otherAssociated = associated;
        switch (*rc::gen::inRange(0, 4)) {
        case 0: other[*rc::gen::inRange<std::size_t>(0, other.size())] ^= *rc::gen::inRange<std::uint8_t>(1, 255); break;
        case 1: otherCounter = *rc::gen::distinctFrom(counter); break;
        case 2: otherAssociated = *rc::gen::distinctFrom(associated); break;
        default: other = *rc::gen::distinctFrom(record); break;
        }
        RC_ASSERT(!cipher->open(otherCounter, otherAssociated, other));
    }));
}

void RecordPropertyTest::differentSecretsDifferentRecords()
{
    QVERIFY(rc::check("keys are apart by secret and suite", [](std::uint64_t counter, const Bytes &plaintext) {
        const SuiteId suite = *anySuite();
        DirectionSecret secret = anySecret();
        DirectionSecret other = anySecret();
        RC_PRE(!secret.equals(other));
        const SuiteId otherSuite = *rc::gen::distinctFrom(anySuite(), suite);
        const auto cipher = makeRecordCipher(suite, secret.clone());
        const Bytes record = seal(*cipher, counter, {}, plaintext);
        Bytes copy = record;
        RC_ASSERT(!makeRecordCipher(suite, std::move(other))->open(counter, {}, copy));
        copy = record;
        RC_ASSERT(!makeRecordCipher(otherSuite, std::move(secret))->open(counter, {}, copy));
    }));
}

void RecordPropertyTest::capacityIsTheInverseOfSize()
{
    QVERIFY(rc::check("the most that fits fits, and one more does not", [] {
        const auto cipher = makeRecordCipher(*anySuite(), DirectionSecret());
        const std::size_t room = *rc::gen::inRange<std::size_t>(0, 3000);
        const std::optional<std::size_t> most = cipher->plaintextCapacity(room);
        RC_ASSERT(most.has_value() == (cipher->sealedSize(0) <= room));
        if (most) {
            RC_ASSERT(cipher->sealedSize(*most) <= room);
            RC_ASSERT(cipher->sealedSize(*most + 1) > room);
        }
    }));
}

SKYSEAL_TEST_APPLESS(RecordPropertyTest)
#include "record_property_test.moc"
