// One row for each requirement of other tests. Each row is a ctest entry, requires_NAME, which is skipped, with its reason, on
// a machine that does not meet it. In continuous integration (the variable CI is set) it fails if such a machine ought to.
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

using namespace skyseal::test;

class RequirementsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isMet_data();
    void isMet();
};

void RequirementsTest::isMet_data()
{
    QTest::addColumn<bool>("isExpected");
    const QByteArray variable = qgetenv("CI");
    const bool isContinuousIntegration = !variable.isEmpty() && variable != "false";
    for (const Requirement &requirement : requirements())
        QTest::newRow(requirement.name) << (isContinuousIntegration && requirement.isInContinuousIntegration);
}

void RequirementsTest::isMet()
{
    QFETCH(bool, isExpected);
    const char *const lack = lackOf(QTest::currentDataTag());
    if (!lack)
        return;
    if (isExpected)
        QFAIL(lack);
    QSKIP(lack);
}

SKYSEAL_TEST(RequirementsTest)
#include "requirements_test.moc"
