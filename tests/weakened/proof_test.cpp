// Proves that the attack tests can fail: each is run again in a program whose protocol has one weakness put in, and must
// then fail in the named check, in no other, and without crashing. The same program without a weakness must pass, so that
// it is the weakness that makes the difference; and no attack test is left without such a proof.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "tests/weakened/proofs.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QHash>
#include <QtCore/QProcess>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <string_view>

using namespace skyseal::test;

namespace {

struct Run
{
    bool ended = false; ///< by itself, with an exit status
    int failures = 0;
    QStringList checks; ///< the lines of failed checks
    QStringList passed; ///< "function(row)"
    QString output;
};

Run run(const char *test, const QStringList &arguments, const char *weaknesses)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("SKYSEAL_WEAKNESS"), QLatin1String(weaknesses));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0")); // kept keys are leaked keys
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(SKYSEAL_WEAKENED_PROGRAM), QStringList{QLatin1String(test)} + arguments);
    Run out;
    out.ended = process.waitForFinished(2 * kDeadlineMs) && process.exitStatus() == QProcess::NormalExit;
    out.failures = process.exitCode();
    out.output = QString::fromUtf8(process.readAll());
    for (const QString &line : out.output.split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1String("FAIL!")))
            out.checks << line;
        else if (line.startsWith(QLatin1String("PASS")))
            out.passed << line.section(QStringLiteral("::"), 1);
    }
    return out;
}

/// Under a sanitizer, which replaces mlock(), the search of the whole memory takes minutes.
bool canRun([[maybe_unused]] const QString &test)
{
#ifdef SKYSEAL_SANITIZED
    return test != QLatin1String("attack_memory_test");
#else
    return true;
#endif
}

QStringList rowsOf(const Proof &proof)
{
    return QString::fromLatin1(proof.untouched).split(QLatin1Char(';'), Qt::SkipEmptyParts);
}

} // namespace

class ProofTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void failsWhereItMust_data();
    void failsWhereItMust();
    void passesWithoutWeakness_data();
    void passesWithoutWeakness();
    void everyAttackIsProven_data();
    void everyAttackIsProven();
    void unknownWeaknessEndsTheProgram();
    void nothingShippedIsWeakened();
};

void ProofTest::failsWhereItMust_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < std::size(kProofs); ++i) {
        if (canRun(QLatin1String(kProofs[i].test)))
            QTest::addRow("%s %s without %s", kProofs[i].test, kProofs[i].function, kProofs[i].weaknesses)
                << static_cast<int>(i);
    }
}

void ProofTest::failsWhereItMust()
{
    QFETCH(int, index);
    const Proof &proof = kProofs[index];
    const Run attacked = run(proof.test, {QLatin1String(proof.function)}, proof.weaknesses);
    QVERIFY2(attacked.ended, qPrintable(QStringLiteral("crashed or hung:\n") + attacked.output));
    QVERIFY2(!attacked.checks.isEmpty(), qPrintable(QStringLiteral("passed in spite of it:\n") + attacked.output));
    QCOMPARE(attacked.failures, static_cast<int>(attacked.checks.size()));
    // The line names the function; the check's own words stand on it, or on the next for long ones.
    for (const QString &check : attacked.checks) {
        QVERIFY2(check.contains(QLatin1String("::") + QLatin1String(proof.function) + QLatin1Char('(')), qPrintable(check));
        QVERIFY2(check.contains(QLatin1String(proof.check)), qPrintable(QStringLiteral("another check failed: ") + check));
    }
    const QStringList untouched = rowsOf(proof);
    for (const QString &passed : attacked.passed) {
        if (passed.startsWith(QLatin1String(proof.function) + QLatin1Char('('))) {
            const QString row = passed.section(QLatin1Char('('), 1).chopped(1);
            QVERIFY2(untouched.contains(row), qPrintable(QStringLiteral("passed in spite of it: ") + passed));
        }
    }
    for (const QString &row : untouched)
        QVERIFY2(attacked.passed.contains(QStringLiteral("%1(%2)").arg(QLatin1String(proof.function), row)), qPrintable(row));
}

void ProofTest::passesWithoutWeakness_data()
{
    QTest::addColumn<QString>("test");
    for (const QString &test : provenTests()) {
        if (canRun(test))
            QTest::addRow("%s", qPrintable(test)) << test;
    }
}

void ProofTest::passesWithoutWeakness()
{
    QFETCH(QString, test);
    QStringList functions;
    for (const Proof &proof : kProofs) {
        if (test == QLatin1String(proof.test))
            functions << QLatin1String(proof.function);
    }
    functions.removeDuplicates();
    const Run untouched = run(qPrintable(test), functions, "");
    QVERIFY2(untouched.ended && untouched.failures == 0, qPrintable(untouched.output));
}

void ProofTest::everyAttackIsProven_data()
{
    passesWithoutWeakness_data();
}

void ProofTest::everyAttackIsProven()
{
    QFETCH(QString, test);
    QStringList proven;
    QHash<QString, QStringList> unproven; // rows that no weakness was seen to touch yet
    for (const Proof &proof : kProofs) {
        if (test != QLatin1String(proof.test))
            continue;
        const QString function = QLatin1String(proof.function);
        const QStringList untouched = rowsOf(proof);
        QStringList &left = proven.contains(function) ? unproven[function] : unproven[function] = untouched;
        left.removeIf([&](const QString &row) { return !untouched.contains(row); });
        proven << function;
    }
    for (const QStringList &rows : unproven)
        QVERIFY2(rows.isEmpty(), qPrintable(rows.join(QLatin1Char(';'))));
    static const QRegularExpression kSignature(QStringLiteral("^(\\w+)\\(\\)$"));
    const Run listed = run(qPrintable(test), {QStringLiteral("-functions")}, "");
    int seen = 0;
    for (const QString &line : listed.output.split(QLatin1Char('\n'))) {
        const auto match = kSignature.match(line.trimmed());
        if (!match.hasMatch())
            continue;
        ++seen;
        QVERIFY2(proven.contains(match.captured(1)), qPrintable(line + QStringLiteral(" has no proof")));
    }
    QVERIFY(seen > 0);
}

void ProofTest::unknownWeaknessEndsTheProgram()
{
    const Run slip = run(kProofs[0].test, {QLatin1String(kProofs[0].function)}, "NoSuchThing");
    QVERIFY(!slip.ended);
    QVERIFY(slip.output.contains(QLatin1String("no weakness is called 'NoSuchThing'")));
}

void ProofTest::nothingShippedIsWeakened()
{
    // The name of the variable that selects weaknesses stands in every file that could be weakened, and in no other.
    const auto mentions = [](const QString &path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly)
            && file.readAll().contains("SKYSEAL_"
                                       "WEAKNESS");
    };
    QVERIFY(mentions(QStringLiteral(SKYSEAL_WEAKENED_PROGRAM)));
    int looked = 0;
    for (const char *folder : {"bin", "core", "ui", "app"}) {
        QDirIterator walk(QStringLiteral(SKYSEAL_BUILD_DIR "/") + QLatin1String(folder),
                          {QStringLiteral("*.a"), QStringLiteral("skyseal*")}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QString path = walk.next();
            QVERIFY2(!mentions(path), qPrintable(path));
            ++looked;
        }
    }
    QVERIFY2(looked >= 4, qPrintable(QString::number(looked)));
}

SKYSEAL_TEST(ProofTest)
#include "proof_test.moc"
