// Values of fields: bit patterns, numbers and texts.
#include "core/mavlink/field_value.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

FieldType typeAt(int i)
{
    return static_cast<FieldType>(i);
}

} // namespace

class FieldValueTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void textReadsBackToTheSameBits();
    void wrongTextsAreRefused_data();
    void wrongTextsAreRefused();
    void numbersAreClamped();
    void signsAreExtended();
    void writingNeedsRoomAndTheRightType();
    void texts();
};

void FieldValueTest::textReadsBackToTheSameBits()
{
    QVERIFY(rc::check("any value of any type is the same after text", [] {
        const FieldType type = typeAt(*rc::gen::inRange(0, 11));
        const auto bits = *rc::gen::arbitrary<std::uint64_t>() & (~std::uint64_t(0) >> (64 - 8 * sizeOf(type)));
        const FieldValue value = FieldValue::fromBits(type, bits);
        const auto back = parseFieldValue(type, toText(value));
        RC_ASSERT(back.has_value());
        if (value.isFloating() && std::isnan(value.asDouble()))
            RC_ASSERT(std::isnan(back->asDouble()));
        else
            RC_ASSERT(*back == value);
    }));
}

void FieldValueTest::wrongTextsAreRefused_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("good");
    const auto row = [](FieldType type, const char *text, bool good) {
        QTest::addRow("%d %s", static_cast<int>(type), text) << static_cast<int>(type) << QByteArray(text) << good;
    };
    row(FieldType::Uint8, "255", true);
    row(FieldType::Uint8, "256", false);
    row(FieldType::Uint8, "-1", false);
    row(FieldType::Uint8, "0xff", true);
    row(FieldType::Uint8, "0x", false);
    row(FieldType::Uint8, "1.5", false);
    row(FieldType::Uint8, "", false);
    row(FieldType::Uint8, "--1", false);
    row(FieldType::Int8, "-128", true);
    row(FieldType::Int8, "-129", false);
    row(FieldType::Int8, "128", false);
    row(FieldType::Int64, "-9223372036854775808", true);
    row(FieldType::Int64, "9223372036854775808", false);
    row(FieldType::Uint64, "18446744073709551615", true);
    row(FieldType::Uint64, "18446744073709551616", false);
    row(FieldType::Float, "1e39", false);
    row(FieldType::Float, "-Infinity", true);
    row(FieldType::Float, "inf", false);
    row(FieldType::Float, "nan", false);
    row(FieldType::Float, "1.5 m", false);
    row(FieldType::Double, "1e300", true);
    row(FieldType::Char, "ab", false);
}

void FieldValueTest::wrongTextsAreRefused()
{
    QFETCH(int, type);
    QFETCH(QByteArray, text);
    QFETCH(bool, good);
    QCOMPARE(parseFieldValue(typeAt(type), text.toStdString()).has_value(), good);
}

void FieldValueTest::numbersAreClamped()
{
    QCOMPARE(FieldValue::fromNumber(FieldType::Uint8, 300).asUnsigned(), std::uint64_t(255));
    QCOMPARE(FieldValue::fromNumber(FieldType::Uint8, -3).asUnsigned(), std::uint64_t(0));
    QCOMPARE(FieldValue::fromNumber(FieldType::Int16, -1.9).asSigned(), std::int64_t(-1));
    QCOMPARE(FieldValue::fromNumber(FieldType::Int64, 1e30).asSigned(), std::numeric_limits<std::int64_t>::max());
    QCOMPARE(FieldValue::fromNumber(FieldType::Int64, -1e30).asSigned(), std::numeric_limits<std::int64_t>::min());
    QCOMPARE(FieldValue::fromNumber(FieldType::Uint64, 1e30).asUnsigned(), std::numeric_limits<std::uint64_t>::max());
    QCOMPARE(FieldValue::fromNumber(FieldType::Int32, std::nan("")).asSigned(), std::int64_t(0));
    QCOMPARE(FieldValue::fromNumber(FieldType::Float, 0.5).asFloat(), 0.5f);
}

void FieldValueTest::signsAreExtended()
{
    QCOMPARE(FieldValue::fromBits(FieldType::Int8, 0x80).asSigned(), std::int64_t(-128));
    QCOMPARE(FieldValue::fromBits(FieldType::Int32, 0xffffffff).asDouble(), -1.0);
    QCOMPARE(FieldValue::fromBits(FieldType::Uint32, 0xffffffff).asDouble(), 4294967295.0);
}

void FieldValueTest::writingNeedsRoomAndTheRightType()
{
    const FieldInfo field{.name = "f", .type = FieldType::Uint16, .arrayLength = 2, .offset = 1};
    std::array<std::uint8_t, 5> payload{};
    QVERIFY(setFieldValue(payload, field, 1, FieldValue::fromBits(FieldType::Uint16, 0x1234)));
    QCOMPARE(fieldValue(payload, field, 1).bits(), std::uint64_t(0x1234));
    QCOMPARE(int(payload[3]), 0x34);
    QVERIFY(!setFieldValue(payload, field, 2, FieldValue::fromBits(FieldType::Uint16, 1)));
    QVERIFY(!setFieldValue(payload, field, 0, FieldValue::fromBits(FieldType::Int16, 1)));
    QVERIFY(!setFieldValue(MutableByteView(payload).first(4), field, 1, FieldValue::fromBits(FieldType::Uint16, 1)));
    QCOMPARE(fieldValue(ByteView(payload).first(4), field, 1).bits(), std::uint64_t(0x34)); // the missing byte is zero
}

void FieldValueTest::texts()
{
    const FieldInfo field{.name = "t", .type = FieldType::Char, .arrayLength = 4, .offset = 1};
    std::array<std::uint8_t, 5> payload{1, 'x', 'x', 'x', 'x'};
    QCOMPARE(std::string(fieldText(payload, field)), std::string("xxxx"));
    QVERIFY(!setFieldText(payload, field, "12345"));
    QVERIFY(setFieldText(payload, field, "ab"));
    QCOMPARE(std::string(fieldText(payload, field)), std::string("ab"));
    QCOMPARE(std::string(fieldText(ByteView(payload).first(2), field)), std::string("a"));
    QVERIFY(fieldText(ByteView(), field).empty());
}

SKYSEAL_TEST_APPLESS(FieldValueTest)
#include "field_value_test.moc"
