// Each row of allowed_skips.txt belongs to a test that can still skip for that reason, so that the list does not go on allowing
// the skips of tests that are gone.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDirIterator>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

namespace {

const QString kTests = QStringLiteral(SKYSEAL_SOURCE_DIR "/tests");

/// The sources and scripts of all tests, string literals that the compiler joins as one.
QString allTests()
{
    QString out;
    QDirIterator walk(kTests, {QStringLiteral("*.cpp"), QStringLiteral("*.h"), QStringLiteral("*.py")}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (walk.hasNext())
        out += contentOf(walk.next());
    static const QRegularExpression kJoint(QStringLiteral("\"\\s*\""));
    return out.remove(kJoint);
}

/// Why the row "Class::function reason" allows no skip of `tests`; empty if it does.
QString faultOf(const QString &row, const QString &tests)
{
    const QString name = row.section(QLatin1Char(' '), 0, 0), reason = row.section(QLatin1Char(' '), 1);
    const QString type = name.section(QStringLiteral("::"), 0, 0), function = name.section(QStringLiteral("::"), 1);
    if (!tests.contains(name)
        && !(tests.contains(QStringLiteral("class ") + type) && tests.contains(function + QStringLiteral("()"))))
        return row + QStringLiteral(": there is no such test");
    // A reason may begin with the name of a variable that its test fills in.
    constexpr qsizetype kEnding = 18;
    return tests.contains(reason.right(kEnding)) ? QString() : row + QStringLiteral(": no test gives this reason");
}

} // namespace

class SkipsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void faultsAreFound();
    void allowedSkipsCanHappen();
};

void SkipsTest::faultsAreFound()
{
    const QString tests = QStringLiteral("void PumpTest::runs()\n{\n    QSKIP(\"there is no pump on this machine\");\n}\n");
    QCOMPARE(faultOf(QStringLiteral("PumpTest::runs there is no pump on this machine"), tests), QString());
    QVERIFY(!faultOf(QStringLiteral("PumpTest::stops there is no pump on this machine"), tests).isEmpty());
    QVERIFY(!faultOf(QStringLiteral("PumpTest::runs there is no water in the well"), tests).isEmpty());
}

void SkipsTest::allowedSkipsCanHappen()
{
    const QString tests = allTests();
    int rows = 0;
    QStringList faults;
    for (const QString &row :
         contentOf(kTests + QStringLiteral("/allowed_skips.txt")).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        if (row.startsWith(QLatin1Char('#')))
            continue;
        ++rows;
        if (const QString fault = faultOf(row, tests); !fault.isEmpty())
            faults << fault;
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    QVERIFY(rows > 0);
}

SKYSEAL_TEST(SkipsTest)
#include "skips_test.moc"
