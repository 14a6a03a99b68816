// The patches that take defences out of copies of the source files: applied in their order, each change can stand in one place
// of its file only (patch takes the nearest of several), asks for the weakness that its patch is named after, and a proof asks
// for each weakness.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"
#include "tests/weakened/proofs.h"

#include <QtCore/QDir>
#include <QtCore/QMap>
#include <QtTest/QTest>

namespace {

const QString kFolder = QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/weakened/patches");

QStringList patches()
{
    return QDir(kFolder).entryList({QStringLiteral("*.patch")}, QDir::Files);
}

QString patchOf(const QString &file)
{
    return contentOf(kFolder + QLatin1Char('/') + file);
}

/// One change: the lines that it expects in the file, and what they become.
struct Hunk
{
    QString file;
    QString before, after;
};

QList<Hunk> hunksOf(const QString &patch)
{
    QList<Hunk> out;
    QString file;
    for (const QString &line : patch.split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1String("--- a/")))
            file = line.sliced(6);
        else if (line.startsWith(QLatin1String("@@ ")))
            out.append({file, {}, {}});
        else if (!out.isEmpty() && !line.isEmpty()) {
            if (line[0] != QLatin1Char('+'))
                out.last().before += line.sliced(1) + QLatin1Char('\n');
            if (line[0] != QLatin1Char('-'))
                out.last().after += line.sliced(1) + QLatin1Char('\n');
        }
    }
    return out;
}

} // namespace

class PatchesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyChangeHasOnePlace();
    void everyWeaknessIsProven();
};

void PatchesTest::everyChangeHasOnePlace()
{
    QMap<QString, QString> files;
    for (const QString &name : patches()) {
        const QList<Hunk> hunks = hunksOf(patchOf(name));
        QVERIFY2(!hunks.isEmpty(), qPrintable(name));
        for (const Hunk &hunk : hunks) {
            QString &text = files[hunk.file];
            if (text.isEmpty())
                text = contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/") + hunk.file);
            QVERIFY2(text.count(hunk.before) == 1, qPrintable(name + QStringLiteral(":\n") + hunk.before));
            text.replace(hunk.before, hunk.after);
        }
    }
}

void PatchesTest::everyWeaknessIsProven()
{
    QStringList proven;
    for (const skyseal::test::Proof &proof : skyseal::test::kProofs)
        proven += QString::fromLatin1(proof.weaknesses).split(QLatin1Char(','));
    // Those that fuzzers and one test of the parser look for.
    const QString others = contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/fuzz/CMakeLists.txt"))
        + contentOf(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/mavlink/CMakeLists.txt"));
    for (const QString &name : patches()) {
        const QString weakness = name.chopped(6); // ".patch"
        QString added;
        for (const QString &line : patchOf(name).split(QLatin1Char('\n'))) {
            if (line.startsWith(QLatin1Char('+')))
                added += line;
        }
        if (!added.contains(QLatin1String("weakened(")))
            continue; // it marks secrets for Valgrind
        QVERIFY2(added.contains(QStringLiteral("weakened(\"%1\")").arg(weakness)), qPrintable(name));
        QVERIFY2(proven.contains(weakness) || others.contains(weakness), qPrintable(weakness));
    }
}

SKYSEAL_TEST(PatchesTest)
#include "patches_test.moc"
