// ByteReader and ByteWriter: limits, byte order, and access past the end; hex text; wiping of secrets.
#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;

class BytesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesAndReadsBothByteOrders();
    void shortReadIsStickyAndGivesZeros();
    void fullWriterWritesNothingMore();
    void hexRefusesWhatIsNotHex();
    void movedSecretIsWiped();
};

void BytesTest::writesAndReadsBothByteOrders()
{
    std::array<std::uint8_t, 15> buffer{};
    ByteWriter writer(buffer);
    writer.u8(0xfe);
    writer.littleEndian<std::int16_t>(-2);
    writer.u32(0x01020304);
    writer.bigEndian<std::uint64_t>(0x1122334455667788);
    QVERIFY(writer.ok());
    QCOMPARE(toHex(writer.written()), std::string("fefeff040302011122334455667788"));

    ByteReader reader(buffer);
    QCOMPARE(reader.u8(), std::uint8_t(0xfe));
    QCOMPARE(reader.littleEndian<std::int16_t>(), std::int16_t(-2));
    QCOMPARE(reader.u32(), 0x01020304u);
    QCOMPARE(reader.bigEndian<std::uint64_t>(), std::uint64_t(0x1122334455667788));
    QVERIFY(reader.ok() && reader.atEnd());
}

void BytesTest::shortReadIsStickyAndGivesZeros()
{
    const std::array<std::uint8_t, 3> buffer{1, 2, 3};
    ByteReader reader(buffer);
    QCOMPARE(reader.u16(), std::uint16_t(0x0201));
    QCOMPARE(reader.u32(), 0u);
    QVERIFY(!reader.ok());
    QCOMPARE(reader.u8(), std::uint8_t(0));
    QCOMPARE(reader.position(), std::size_t(2));
}

void BytesTest::fullWriterWritesNothingMore()
{
    std::array<std::uint8_t, 3> buffer{9, 9, 9};
    ByteWriter writer(buffer);
    writer.u16(0);
    writer.u16(0xffff);
    QVERIFY(!writer.ok());
    QCOMPARE(buffer[2], std::uint8_t(9));
    QCOMPARE(writer.size(), std::size_t(2));
}

void BytesTest::hexRefusesWhatIsNotHex()
{
    QCOMPARE(fromHex("00fFa0").value(), (Bytes{0x00, 0xff, 0xa0}));
    QVERIFY(!fromHex("0"));
    QVERIFY(!fromHex("0g"));
    QVERIFY(fromHex("")->empty());
}

void BytesTest::movedSecretIsWiped()
{
    Key32 key;
    key.mutableView()[5] = 7;
    const Key32 moved = std::move(key);
    QCOMPARE(moved.view()[5], std::uint8_t(7));
    QVERIFY(key.isZero()); // NOLINT(bugprone-use-after-move): the moved-from object is tested
    QVERIFY(moved.equals(moved.clone()));
    QVERIFY(!moved.equals(key));
}

SKYSEAL_TEST_APPLESS(BytesTest)
#include "bytes_test.moc"
