// core/README.md is the map of the code: it names every room, every program and every file of the channel, and nothing that is
// not there.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

namespace {

const QString kSourceTree = QStringLiteral(SKYSEAL_SOURCE_DIR "/");

QString mapOfTheCode()
{
    return contentOf(kSourceTree + QStringLiteral("core/README.md"));
}

QStringList foldersIn(const QString &folder)
{
    return QDir(kSourceTree + folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

bool isNamedIn(const QString &text, const QString &path)
{
    return text.contains(QLatin1Char('`') + path + QLatin1Char('`'));
}

} // namespace

class MapTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRoomIsNamed();
    void everyProgramIsNamed();
    void everyFolderOfTestsIsNamedOrMirrorsARoom();
    void everyFileOfTheChannelHasItsSubject();
    void whatIsNamedExists();
};

void MapTest::everyRoomIsNamed()
{
    const QString text = mapOfTheCode();
    QStringList missing;
    int rooms = 0;
    for (const char *layer : {"core", "core/engine", "ui"}) {
        for (const QString &room : foldersIn(QLatin1String(layer))) {
            const QString path = QLatin1String(layer) + QLatin1Char('/') + room;
            if (path == QLatin1String("core/engine")) // its rooms are
                continue;
            ++rooms;
            if (!isNamedIn(text, path))
                missing << path;
        }
    }
    QVERIFY(rooms > 40);
    QCOMPARE(missing, QStringList());
}

void MapTest::everyProgramIsNamed()
{
    const QString text = mapOfTheCode();
    const QString drawing = text.section(QStringLiteral("```"), 1, 1);
    QVERIFY(drawing.startsWith(QStringLiteral("\napp ")));
    for (const QString &folder : foldersIn(QStringLiteral("app"))) {
        if (folder == QLatin1String("common"))
            QVERIFY(isNamedIn(text, QStringLiteral("app/common")));
        else
            QVERIFY2(drawing.contains(folder == QLatin1String("skyseal")
                                          ? QStringLiteral(" skyseal ")
                                          : QStringLiteral(" skyseal-") + folder + QLatin1Char(' ')),
                     qPrintable(folder));
    }
}

void MapTest::everyFolderOfTestsIsNamedOrMirrorsARoom()
{
    const QString text = mapOfTheCode();
    const QStringList rooms = foldersIn(QStringLiteral("core")) + QStringList{QStringLiteral("ui"), QStringLiteral("app")};
    for (const QString &folder : foldersIn(QStringLiteral("tests")))
        QVERIFY2(rooms.contains(folder) || isNamedIn(text, QStringLiteral("tests/") + folder), qPrintable(folder));
}

/// The table below "The files of `core/channel`, by subject".
void MapTest::everyFileOfTheChannelHasItsSubject()
{
    const QString text = mapOfTheCode();
    const qsizetype begin = text.indexOf(QStringLiteral("\n| subject | files |"));
    const QString table = text.mid(begin, text.indexOf(QStringLiteral("\n\n"), begin) - begin);
    const auto headers = QDir(kSourceTree + QStringLiteral("core/channel")).entryList({QStringLiteral("*.h")}, QDir::Files);
    QVERIFY(begin > 0 && headers.size() > 50);
    QStringList missing;
    for (const QString &header : headers) {
        const QString name = header.chopped(2);
        if (!isNamedIn(table, name) && !isNamedIn(table, name.section(QLatin1Char('_'), 0, 0) + QStringLiteral("_*")))
            missing << name;
    }
    QCOMPARE(missing, QStringList());
    static const QRegularExpression kName(QStringLiteral("`([a-z0-9_]+)`"));
    for (auto found = kName.globalMatch(table); found.hasNext();) {
        const QString name = found.next().captured(1);
        QVERIFY2(headers.contains(name + QStringLiteral(".h")), qPrintable(name));
    }
}

/// Paths with a capital letter are patterns of the recipes.
void MapTest::whatIsNamedExists()
{
    static const QRegularExpression kPath(QStringLiteral("`((?:core|ui|app|tests|resources|packaging)/[a-z0-9_/.]+)`"));
    const QStringList generated{QStringLiteral("core/mavlink/messages.h"), QStringLiteral("core/mavlink/enums.h"),
                                QStringLiteral("core/mavlink/message_ids.h")};
    int found = 0;
    for (auto paths = kPath.globalMatch(mapOfTheCode()); paths.hasNext(); ++found) {
        const QString path = paths.next().captured(1);
        const bool exists = QFile::exists(kSourceTree + path) || QFile::exists(kSourceTree + path + QStringLiteral(".h"));
        QVERIFY2(exists || generated.contains(path), qPrintable(path));
    }
    QVERIFY(found > 60);
}

SKYSEAL_TEST_APPLESS(MapTest)
#include "map_test.moc"
