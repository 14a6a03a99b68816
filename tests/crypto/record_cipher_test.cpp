// Requirements on every suite: sealed records open, and everything else is rejected. Consistency of the table of suites.
#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"

#include <QtTest/QTest>

#include <algorithm>
#include <set>

using namespace skyseal;
using namespace skyseal::crypto;

namespace {

DirectionSecret secretOf(std::uint8_t value)
{
    DirectionSecret secret;
    std::fill(secret.mutableView().begin(), secret.mutableView().end(), value);
    return secret;
}

Bytes sealed(RecordCipher &cipher, std::uint64_t counter, ByteView associatedData, ByteView plaintext)
{
    Bytes out(cipher.sealedSize(plaintext.size()));
    out.resize(cipher.seal(counter, associatedData, plaintext, out));
    return out;
}

bool opens(RecordCipher &cipher, std::uint64_t counter, ByteView associatedData, Bytes record, ByteView plaintext)
{
    const auto opened = cipher.open(counter, associatedData, record);
    return opened && std::equal(opened->begin(), opened->end(), plaintext.begin(), plaintext.end());
}

/// True if the record is rejected and the buffer does not contain the start of the plaintext.
bool refuses(RecordCipher &cipher, std::uint64_t counter, ByteView associatedData, Bytes record, ByteView plaintext)
{
    if (cipher.open(counter, associatedData, record))
        return false;
    if (plaintext.size() < 4)
        return true;
    const ByteView start = plaintext.first(4);
    return std::search(record.begin(), record.end(), start.begin(), start.end()) == record.end();
}

} // namespace

class RecordCipherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void tableIsConsistent();
    void opensWhatItSealed_data() { eachSuite(); }
    void opensWhatItSealed();
    void refusesEveryFlippedBit_data() { eachSuite(); }
    void refusesEveryFlippedBit();
    void refusesOtherLengthsAndContexts_data() { eachSuite(); }
    void refusesOtherLengthsAndContexts();
    void refusesTooLittleRoom_data() { eachSuite(); }
    void refusesTooLittleRoom();
    void noTwoCountersShareAStream_data() { eachSuite(); }
    void noTwoCountersShareAStream();

private:
    void eachSuite();
    SuiteId suite() const { return static_cast<SuiteId>(*static_cast<int *>(QTest::qData("suite", QMetaType::Int))); }
};

void RecordCipherTest::eachSuite()
{
    QTest::addColumn<int>("suite");
    for (const SuiteInfo &info : suites()) {
        if (info.id != SuiteId::None)
            QTest::newRow(std::string(info.name).c_str()) << static_cast<int>(info.id);
    }
}

void RecordCipherTest::tableIsConsistent()
{
    QCOMPARE(suites().front().id, SuiteId::None);
    std::set<SuiteId> numbers;
    std::set<std::uint32_t> colors;
    bool research = false;
    for (const SuiteInfo &info : suites()) {
        QVERIFY2(numbers.insert(info.id).second && colors.insert(info.color).second, std::string(info.name).c_str());
        QVERIFY(info.research || !research); // research suites stand last
        research = info.research;
        QCOMPARE(info.strength == SuiteStrength::None, !info.authenticated);
        QVERIFY(!info.isAead() || !info.makeInline); // the tag of an AEAD is never truncated
        QCOMPARE(info.knownRecord.empty(), !info.authenticated);
        QCOMPARE(suiteFromName(info.name), std::optional(info.id));
        QCOMPARE(suiteFromNumber(static_cast<std::uint8_t>(info.id)), std::optional(info.id));
        QCOMPARE(&suiteInfo(info.id), &info);
        QVERIFY2(suiteAvailable(info.id), std::string(info.name).c_str());
        QCOMPARE(makeRecordCipher(info.id, secretOf(1)) != nullptr, info.authenticated);
    }
    QVERIFY(!suiteFromName("AES-256-GCM") && !suiteFromName(""));
    for (unsigned number = 0; number < 256; ++number) {
        const auto id = static_cast<SuiteId>(number);
        QCOMPARE(suiteFromNumber(static_cast<std::uint8_t>(number)).has_value(), numbers.contains(id));
        QCOMPARE(suiteInfo(id).id, numbers.contains(id) ? id : SuiteId::None);
    }
    QCOMPARE(sealedSuites().size(), suites().size() - 1);

    DirectionSecret secret = secretOf(7);
    QVERIFY(makeRecordCipher(SuiteId::ChaCha20, std::move(secret)));
    QVERIFY(secret.isZero()); // NOLINT(bugprone-use-after-move): the moved-from object is tested
}

void RecordCipherTest::opensWhatItSealed()
{
    const auto sender = makeRecordCipher(suite(), secretOf(1));
    const auto receiver = makeRecordCipher(suite(), secretOf(1));
    test::SeededRandom random(1);
    for (std::size_t size = 0; size <= 300; ++size) {
        const Bytes plaintext = random.bytes(size);
        const Bytes associated = random.bytes(size % 41);
        const std::uint64_t counter = random.number() >> (random.number() % 64);
        const Bytes record = sealed(*sender, counter, associated, plaintext);
        QCOMPARE(record.size(), sender->sealedSize(size));
        QCOMPARE(record.size(), suiteInfo(suite()).ciphertextSize(size) + sender->tagLength());
        QCOMPARE(sender->plaintextCapacity(record.size()), std::optional(suiteInfo(suite()).plaintextRoom(record.size() - 16)));
        QCOMPARE(sender->plaintextCapacity(record.size()).value() >= size, true);
        QVERIFY(sender->sealedSize(*sender->plaintextCapacity(record.size())) <= record.size());
        QVERIFY(opens(*receiver, counter, associated, record, plaintext));

        Bytes inPlace = plaintext;
        inPlace.resize(sender->sealedSize(size));
        QCOMPARE(sender->seal(counter, associated, ByteView(inPlace).first(size), inPlace), record.size());
        QCOMPARE(inPlace, record);
    }
}

void RecordCipherTest::refusesEveryFlippedBit()
{
    const auto cipher = makeRecordCipher(suite(), secretOf(1));
    test::SeededRandom random(2);
    for (const std::size_t size : {0, 9, 16, 28, 64}) {
        const Bytes plaintext = random.bytes(size);
        const Bytes associated = random.bytes(6);
        const Bytes record = sealed(*cipher, 77, associated, plaintext);
        for (std::size_t bit = 0; bit < record.size() * 8; ++bit) {
            Bytes forged = record;
            forged[bit / 8] = static_cast<std::uint8_t>(forged[bit / 8] ^ (1 << (bit % 8)));
            QVERIFY2(refuses(*cipher, 77, associated, forged, plaintext), std::to_string(bit).c_str());
        }
        for (std::size_t bit = 0; bit < associated.size() * 8; ++bit) {
            Bytes other = associated;
            other[bit / 8] = static_cast<std::uint8_t>(other[bit / 8] ^ (1 << (bit % 8)));
            QVERIFY(refuses(*cipher, 77, other, record, plaintext));
        }
        for (int bit = 0; bit < 64; ++bit)
            QVERIFY(refuses(*cipher, 77 ^ (std::uint64_t(1) << bit), associated, record, plaintext));
        QVERIFY(opens(*cipher, 77, associated, record, plaintext));
    }
}

void RecordCipherTest::refusesOtherLengthsAndContexts()
{
    const auto cipher = makeRecordCipher(suite(), secretOf(1));
    const auto otherKey = makeRecordCipher(suite(), secretOf(2));
    test::SeededRandom random(3);
    const Bytes plaintext = random.bytes(40);
    const Bytes associated = random.bytes(6);
    const Bytes record = sealed(*cipher, 5, associated, plaintext);

    for (std::size_t size = 0; size < record.size(); ++size) {
        QVERIFY(refuses(*cipher, 5, associated, Bytes(record.begin(), record.begin() + std::ptrdiff_t(size)), plaintext));
        QVERIFY(refuses(*cipher, 5, associated, Bytes(record.end() - std::ptrdiff_t(size), record.end()), plaintext));
    }
    for (std::size_t more = 1; more <= 32; ++more) {
        Bytes longer = record;
        longer.resize(record.size() + more);
        QVERIFY(refuses(*cipher, 5, associated, longer, plaintext));
    }
    QVERIFY(refuses(*otherKey, 5, associated, record, plaintext));

    // Moving a byte between associated data and ciphertext must be detected.
    Bytes shifted(record.begin() + 1, record.end());
    Bytes longerData = associated;
    longerData.push_back(record.front());
    QVERIFY(refuses(*cipher, 5, longerData, shifted, plaintext));

    for (const SuiteInfo &other : suites()) {
        if (other.id == SuiteId::None || other.id == suite())
            continue;
        const auto otherSuite = makeRecordCipher(other.id, secretOf(1));
        QVERIFY(refuses(*otherSuite, 5, associated, record, plaintext));
    }
    QVERIFY(opens(*cipher, 5, associated, record, plaintext));
}

void RecordCipherTest::refusesTooLittleRoom()
{
    const auto cipher = makeRecordCipher(suite(), secretOf(1));
    const Bytes plaintext(33, 0x55);
    for (std::size_t room = 0; room < cipher->sealedSize(plaintext.size()); ++room) {
        Bytes out(room, 0xaa);
        QCOMPARE(cipher->seal(0, {}, plaintext, out), std::size_t(0));
        QVERIFY(std::all_of(out.begin(), out.end(), [](std::uint8_t byte) { return byte == 0xaa; }));
    }
    QVERIFY(!cipher->plaintextCapacity(15));
}

void RecordCipherTest::noTwoCountersShareAStream()
{
    const auto cipher = makeRecordCipher(suite(), secretOf(1));
    const Bytes zeros(64);
    std::vector<Bytes> seen;
    for (std::uint64_t counter = 0; counter < 300; ++counter) {
        Bytes record = sealed(*cipher, counter, {}, zeros);
        record.resize(32);
        // Both blocks are compared: a counter must not reach into the next record's key stream.
        seen.push_back(Bytes(record.begin(), record.begin() + 16));
        seen.push_back(Bytes(record.begin() + 16, record.end()));
    }
    std::sort(seen.begin(), seen.end());
    QVERIFY(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

SKYSEAL_TEST_APPLESS(RecordCipherTest)
#include "record_cipher_test.moc"
