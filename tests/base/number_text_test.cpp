// Numbers for machines: read back as they were written, with a decimal point in every locale.
#include "core/base/number_text.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace skyseal;

class NumberTextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void localeIsThatOfTheEntry();
    void numbersHaveAPoint();
    void textsAreReadWhole();
    void everyNumberComesBack();
};

/// The entry with a decimal comma proves nothing if its locale has a point.
void NumberTextTest::localeIsThatOfTheEntry()
{
    char text[8];
    std::snprintf(text, sizeof text, "%.1f", 1.5);
    QCOMPARE(text, std::getenv("LOCPATH") ? "1,5" : "1.5");
}

void NumberTextTest::numbersHaveAPoint()
{
    QCOMPARE(numberText(0.1), std::string("0.1"));
    QCOMPARE(numberText(0.1f), std::string("0.1"));
    QCOMPARE(numberText(1e22), std::string("1e+22"));
    QCOMPARE(numberText(std::numeric_limits<double>::quiet_NaN()), std::string("nan"));
    QCOMPARE(numberText(-std::numeric_limits<float>::quiet_NaN()), std::string("nan"));
    QCOMPARE(numberText(-HUGE_VALF), std::string("-inf"));
    QCOMPARE(fixedText(9.5, 2), std::string("9.50"));
    QCOMPARE(fixedText(-0.04, 1), std::string("0.0"));
    QCOMPARE(fixedText(-0.05001, 1), std::string("-0.1"));
    QCOMPARE(fixedText(1e300, 0).size(), std::size_t(301));
    QCOMPARE(shortNumber(9.5), std::string("9.5"));
    QCOMPARE(shortNumber(100), std::string("100"));
    QCOMPARE(shortNumber(-0.0001), std::string("0"));
    QCOMPARE(significantText(0.01250, 3), std::string("0.0125"));
    QCOMPARE(significantText(1.5e6, 3), std::string("1.5e+06"));
    QCOMPARE(significantText(-0.0, 3), std::string("0"));
}

void NumberTextTest::textsAreReadWhole()
{
    QCOMPARE(finiteNumber("+1.5"), std::optional(1.5));
    QCOMPARE(finiteNumber("-1e3"), std::optional(-1000.));
    for (const char *text : {"", "1,5", "1.5 ", " 1", "+-1", "nan", "inf", "1e999", "0x10", "one"})
        QVERIFY2(!finiteNumber(text), text);
}

void NumberTextTest::everyNumberComesBack()
{
    QVERIFY(rc::check("a finite number is read back as it was", [](double number) {
        RC_PRE(std::isfinite(number));
        RC_ASSERT(finiteNumber(numberText(number)) == number);
    }));
}

SKYSEAL_TEST_APPLESS(NumberTextTest)
#include "number_text_test.moc"
