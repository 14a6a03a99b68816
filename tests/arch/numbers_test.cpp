// Numbers for machines have a decimal point (core/base/number_text.h): no floating-point number goes through a function that
// follows the locale. The entries with a comma (tests/CMakeLists.txt) check what tests write; this rule finds the rest.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDirIterator>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

class NumbersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noFloatingPointNumberFollowsTheLocale();
    void ruleFindsWhatItForbids_data();
    void ruleFindsWhatItForbids();
};

namespace {

/// The first forbidden piece of a source file; empty if there is none. "100 %" in a text is no conversion: its letter would
/// have to follow at once.
QString forbiddenIn(const QString &content)
{
    static const QRegularExpression kForbidden(
        QStringLiteral("%[-+#0]*(?:\\d+|\\*)?(?:\\.(?:\\d+|\\*)?)?L?[aAeEfFgG](?![A-Za-z])"
                       "|\\b(?:strto(?:d|f|ld)|sto(?:d|f|ld)|atof)\\("
                       "|\\bimbue\\(|std::locale\\b|setlocale\\("));
    return kForbidden.match(content).captured();
}

} // namespace

void NumbersTest::noFloatingPointNumberFollowsTheLocale()
{
    QStringList wrong;
    int files = 0;
    for (const char *folder : {"core", "app", "ui"}) {
        QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/") + QLatin1String(folder),
                          {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QString path = walk.next();
            ++files;
            if (const QString found = forbiddenIn(contentOf(path)); !found.isEmpty())
                wrong << QDir(QStringLiteral(SKYSEAL_SOURCE_DIR)).relativeFilePath(path) + QStringLiteral(": ") + found;
        }
    }
    QVERIFY(files > 500);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void NumbersTest::ruleFindsWhatItForbids_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<bool>("isForbidden");
    QTest::newRow("fixed") << QStringLiteral("snprintf(out, 9, \"%.1f\", x)") << true;
    QTest::newRow("width from arguments") << QStringLiteral("\"%*.*g m\"") << true;
    QTest::newRow("read") << QStringLiteral("std::strtod(text, nullptr)") << true;
    QTest::newRow("whole numbers") << QStringLiteral("\"%d %-4u %s %zu %lld\"") << false;
    QTest::newRow("share") << QStringLiteral("\" %\", \"95 % for all\", \"%1 %\"") << false;
}

void NumbersTest::ruleFindsWhatItForbids()
{
    QFETCH(QString, source);
    QFETCH(bool, isForbidden);
    QCOMPARE(!forbiddenIn(source).isEmpty(), isForbidden);
}

SKYSEAL_TEST_APPLESS(NumbersTest)
#include "numbers_test.moc"
