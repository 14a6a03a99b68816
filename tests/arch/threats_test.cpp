// Each test that THREATS.md names for a threat exists, so that the document cannot promise what nobody checks; each attack
// test is named there, and proven to be able to fail; each threat has such a test, or says why not; and nothing stands there
// twice. The same for the steps of PROTOCOL.md that are proved by machine: their tests, models and runs exist.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"
#include "tests/weakened/proofs.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtCore/QSet>
#include <QtTest/QTest>

#include <algorithm>

namespace {

/// The source of a test program or fuzzer as the document names it: attack_record is tests/…/attack_record_test.cpp, and
/// channel/allocation is that of one folder.
QString sourceOf(const QString &program)
{
    if (program.contains(QLatin1Char('/')))
        return contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/%1_test.cpp").arg(program));
    QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests"),
                      {program + QStringLiteral("_test.cpp"), program + QStringLiteral(".cpp")}, QDir::Files,
                      QDirIterator::Subdirectories);
    const QString found = walk.hasNext() ? walk.next() : QString();
    // Two programs of one name in different folders: the document has to say which.
    return found.isEmpty() || walk.hasNext() ? QString() : contentOf(found);
}

struct Mention
{
    QString row;
    QString program;
    QString function; ///< empty: the whole program
};

QString document()
{
    return contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/core/channel/THREATS.md"));
}

/// The table of the steps that are proved by machine.
QString provedSteps()
{
    const QString protocol = contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/core/channel/PROTOCOL.md"));
    return protocol.section(QStringLiteral("\n## 10. Proofs and tests\n"), 1, 1).section(QStringLiteral("\n## "), 0, 0);
}

/// "program: function, function; program" of the last column of a table's row; nothing of other lines.
QList<Mention> mentionsOf(const QString &line)
{
    QList<Mention> out;
    static const QRegularExpression remark(QStringLiteral("\\([^)]*\\)"));
    if (!line.startsWith(QStringLiteral("| ")))
        return out;
    const QStringList cells = line.split(QLatin1Char('|'));
    QString last = cells[cells.size() - 2];
    last.remove(remark);
    for (const QString &part : last.split(QLatin1Char(';'))) {
        const QStringList names = part.trimmed().split(QLatin1Char(':'));
        if (names[0].isEmpty() || names[0] == QStringLiteral("test") || names[0].startsWith(QChar(0x2013)))
            continue;
        if (names.size() == 1) {
            for (const QString &program : names[0].split(QLatin1Char(',')))
                out.append({cells[1].trimmed(), program.trimmed(), {}});
            continue;
        }
        for (const QString &function : names[1].split(QLatin1Char(',')))
            out.append({cells[1].trimmed(), names[0].trimmed(), function.trimmed()});
    }
    return out;
}

QList<Mention> mentionsIn(const QString &text)
{
    QList<Mention> out;
    for (const QString &line : text.split(QLatin1Char('\n')))
        out += mentionsOf(line);
    return out;
}

QList<Mention> mentions()
{
    return mentionsIn(document());
}

/// The tests that do not exist, one a line.
QString missingOf(const QList<Mention> &mentions)
{
    QString out;
    for (const Mention &mention : mentions) {
        const QString source = sourceOf(mention.program);
        const bool found = mention.function.isEmpty() || source.contains(QStringLiteral("void %1(").arg(mention.function));
        if (source.isEmpty() || !found)
            out += QStringLiteral("\n%1: %2: %3").arg(mention.row, mention.program, mention.function);
    }
    return out;
}

/// The definitions of the runs of a model that violate a property, by its head.
QStringList mutantsOf(const QString &model)
{
    static const QRegularExpression run(QStringLiteral("\n *run ([A-Z0-9_= ]*?) *violates "));
    QStringList out;
    for (const auto &match : run.globalMatch(contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/core/channel/proofs/") + model)))
        out << match.captured(1).split(QLatin1Char(' '));
    return out;
}

bool proves(const skyseal::test::Proof &proof, const Mention &mention)
{
    return mention.function == QLatin1String(proof.function)
        && QString::fromLatin1(proof.test).endsWith(mention.program + QStringLiteral("_test"));
}

bool isProven(const Mention &mention)
{
    return std::any_of(std::begin(skyseal::test::kProofs), std::end(skyseal::test::kProofs),
                       [&mention](const skyseal::test::Proof &proof) { return proves(proof, mention); });
}

} // namespace

class ThreatsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namedTestsExist();
    void attacksAreNamedAndProven();
    void threatsWithoutATwinSayWhy();
    void nothingStandsTwice();
    void provedStepsAreTested();
    void provedStepsHaveTheirMutants();
};

void ThreatsTest::namedTestsExist()
{
    const QList<Mention> all = mentions();
    QVERIFY2(all.size() > 50, "the tables of THREATS.md were not found");
    const QString missing = missingOf(all);
    QVERIFY2(missing.isEmpty(), qPrintable(missing));
}

void ThreatsTest::attacksAreNamedAndProven()
{
    const QList<Mention> all = mentions();
    for (const skyseal::test::Proof &proof : skyseal::test::kProofs) {
        const auto named = [&proof](const Mention &mention) { return proves(proof, mention); };
        QVERIFY2(std::any_of(all.begin(), all.end(), named), proof.function);
    }
    // proof_test sees to the functions of these programs.
    QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests"), {QStringLiteral("attack_*_test.cpp")}, QDir::Files,
                      QDirIterator::Subdirectories);
    int programs = 0;
    for (; walk.hasNext(); ++programs) {
        walk.next();
        const QString name = walk.fileInfo().completeBaseName();
        const auto proven = [&name](const auto &proof) { return QLatin1String(proof.test).endsWith(name); };
        QVERIFY2(std::any_of(std::begin(skyseal::test::kProofs), std::end(skyseal::test::kProofs), proven), qPrintable(name));
    }
    QVERIFY(programs >= 8);
}

void ThreatsTest::threatsWithoutATwinSayWhy()
{
    const QString section =
        document().section(QStringLiteral("## Threat by threat"), 1, 1).section(QStringLiteral("\n## "), 0, 0);
    static const QRegularExpression reason(QStringLiteral("\\(no twin: ([a-z ]+)\\)"));
    int threats = 0;
    for (const QString &line : section.split(QLatin1Char('\n'))) {
        const QList<Mention> named = mentionsOf(line);
        if (named.isEmpty())
            continue;
        ++threats;
        const bool hasTwin = std::any_of(named.begin(), named.end(), isProven);
        const auto said = reason.match(line);
        QVERIFY2(hasTwin != said.hasMatch(), qPrintable(line));
        // In words that the section explains.
        QVERIFY2(hasTwin || section.contains(QStringLiteral("\n- *%1*").arg(said.captured(1))), qPrintable(line));
    }
    QVERIFY2(threats > 50, qPrintable(QString::number(threats)));
}

void ThreatsTest::nothingStandsTwice()
{
    // Paragraphs, list items and rows of tables, whatever their line breaks.
    static const QRegularExpression begin(QStringLiteral("\n(?:\n|(?=- )|(?=\\| ))"));
    static const QRegularExpression ruler(QStringLiteral("^[|-]+$"));
    QSet<QString> known;
    for (const QString &part : document().split(begin, Qt::SkipEmptyParts)) {
        const QString text = part.simplified();
        QVERIFY2(!known.contains(text) || ruler.match(text).hasMatch(), qPrintable(text));
        known.insert(text);
    }
    QVERIFY(known.size() > 150);
}

void ThreatsTest::provedStepsAreTested()
{
    const QList<Mention> all = mentionsIn(provedSteps());
    QVERIFY2(all.size() > 40, "the table of PROTOCOL.md was not found");
    const QString missing = missingOf(all);
    QVERIFY2(missing.isEmpty(), qPrintable(missing));
}

void ThreatsTest::provedStepsHaveTheirMutants()
{
    static const QRegularExpression reference(QStringLiteral("([a-z_]+\\.(?:pv|pml))((?:,? [A-Z][A-Z0-9_]+)*)"));
    static const QRegularExpression name(QStringLiteral("[A-Z][A-Z0-9_]+"));
    QSet<QString> named;
    for (const QString &line : provedSteps().split(QLatin1Char('\n'))) {
        if (mentionsOf(line).isEmpty())
            continue;
        const QString cell = line.split(QLatin1Char('|'))[3];
        auto models = reference.globalMatch(cell);
        QVERIFY2(models.hasNext(), qPrintable(line));
        while (models.hasNext()) {
            const auto model = models.next();
            const QStringList mutants = mutantsOf(model.captured(1));
            QVERIFY2(!mutants.isEmpty(), qPrintable(line));
            for (const auto &mutant : name.globalMatch(model.captured(2))) {
                QVERIFY2(mutants.contains(mutant.captured()), qPrintable(line));
                named.insert(mutant.captured());
            }
        }
    }
    // Each rule that a model can do without is in the table; the other definitions are what the attacker has.
    static const QRegularExpression notARule(
        QStringLiteral("^(STEAL_.*|LATER|REACH|PSK|ON_PATH|SECRET_POINT|KNOWN|WHO_.*|LINKED|FIRST_ALONE|LISTENS|ACTIVE|BACKWARD"
                       "|PASSPHRASE|GUESS|THIEF|LOST_COUNTER|REKEY|REPLACEMENT)$"));
    QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/core/channel/proofs"), QDir::Files);
    while (walk.hasNext()) {
        walk.next();
        for (const QString &mutant : mutantsOf(walk.fileName()))
            QVERIFY2(mutant.isEmpty() || named.contains(mutant) || notARule.match(mutant).hasMatch(), qPrintable(mutant));
    }
}

SKYSEAL_TEST_APPLESS(ThreatsTest)
#include "threats_test.moc"
