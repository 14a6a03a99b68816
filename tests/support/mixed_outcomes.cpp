// A class for test_runner_test, and no ctest entry: it passes, skips and fails.
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

class MixedOutcomes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void passes() { qInfo("passed"); }
    void skipsARow_data();
    void skipsARow();
    void skipsWithoutARequirement() { QSKIP("on purpose"); }
    void fails() { QFAIL("on purpose"); }
};

void MixedOutcomes::skipsARow_data()
{
    QTest::addColumn<bool>("skips");
    QTest::newRow("skips") << true;
    QTest::newRow("passes") << false;
}

void MixedOutcomes::skipsARow()
{
    QFETCH(bool, skips);
    if (skips)
        SKYSEAL_REQUIRES("mavproxy");
}

SKYSEAL_TEST(MixedOutcomes)
#include "mixed_outcomes.moc"
