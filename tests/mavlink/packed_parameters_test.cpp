// The packed parameter file against bytes that were written down from the description of its format.
#include "core/mavlink/packed_parameters.h"
#include "core/mavlink/enums.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::mavlink;

class PackedParametersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyTypeIsRead();
    void defaultsAreSkipped();
    void damagedFilesAreRefused_data();
    void damagedFilesAreRefused();
};

namespace {

const Bytes kFile{0x1b, 0x67, 4,   0,    4,    0,                                // magic, parameters, of the vehicle
                  3,    0x10, 'A', 'B',  1,    0,   2,   0,                      // AB, 32 bits
                  1,    0x11, 'C', 'D',  0xfe,                                   // ACD, 8 bits
                  0,    0,    0,                                                 // padding
                  2,    0x01, 'B', 0xdc, 0x05,                                   // AB again is AB: shared 1
                  4,    0x50, 'R', 'T',  'L',  '_', 'A', 'B', 0, 0, 0xc0, 0x3f}; // RTL_AB, a float

} // namespace

void PackedParametersTest::everyTypeIsRead()
{
    const auto file = parsePackedParameters(kFile);
    QVERIFY(file && !file->hasDefaults);
    QCOMPARE(file->total, std::uint16_t(4));
    QCOMPARE(file->parameters.size(), std::size_t(4));
    const auto is = [&](std::size_t i, const char *name, int type, double value) {
        const PackedParameter &parameter = file->parameters[i];
        return parameter.name == name && parameter.type == type && parameter.value == value;
    };
    QVERIFY(is(0, "AB", MAV_PARAM_TYPE_INT32, 0x20001));
    QVERIFY(is(1, "ACD", MAV_PARAM_TYPE_INT8, -2));
    QVERIFY(is(2, "AB", MAV_PARAM_TYPE_INT16, 1500));
    QVERIFY(is(3, "RTL_AB", MAV_PARAM_TYPE_REAL32, 1.5));
}

void PackedParametersTest::defaultsAreSkipped()
{
    const Bytes bytes{0x1c, 0x67, 2, 0, 2, 0, 0x12, 0, 'A', 1, 0, 2, 0, 1, 0x01, 'B', 7};
    const auto file = parsePackedParameters(bytes);
    QVERIFY(file && file->hasDefaults);
    QCOMPARE(file->parameters[0].value, 1.);
    QCOMPARE(file->parameters[1].name, std::string("AB"));
    QCOMPARE(file->parameters[1].value, 7.);
}

void PackedParametersTest::damagedFilesAreRefused_data()
{
    QTest::addColumn<int>("place");
    QTest::addColumn<int>("content");
    QTest::newRow("magic") << 0 << 0x1d;
    QTest::newRow("more parameters") << 2 << 5;
    QTest::newRow("fewer parameters") << 2 << 3;
    QTest::newRow("no type") << 6 << 5;
    QTest::newRow("unknown flag") << 6 << 0x23;
    QTest::newRow("more shared than there is") << 7 << 0x01;
    QTest::newRow("a name of 18 characters") << 15 << 0xf2;
    for (int length = 0; length < static_cast<int>(kFile.size()); ++length)
        QTest::addRow("cut after %d bytes", length) << -1 << length;
}

void PackedParametersTest::damagedFilesAreRefused()
{
    QFETCH(int, place);
    QFETCH(int, content);
    Bytes file = kFile;
    if (place < 0)
        file.resize(static_cast<std::size_t>(content));
    else
        file[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(content);
    QVERIFY(!parsePackedParameters(file));
}

SKYSEAL_TEST_APPLESS(PackedParametersTest)
#include "packed_parameters_test.moc"
