// A name means one thing: no two types in headers, those of tests included, have the same name, since a search finds both.
#include "tests/support/test_runner.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QMap>
#include <QtCore/QRegularExpression>
#include <QtCore/QSet>
#include <QtCore/QTextStream>
#include <QtTest/QTest>

namespace {

/// Headers that define a type, by its name. Namespaces are not indented, so a definition at the start of a line is no member.
QMap<QString, QSet<QString>> headersByType()
{
    static const QRegularExpression kType(
        QStringLiteral("^(?:template<[^>]*> )?(?:(?:class|struct|enum class|enum) (\\w+)(?!\\w|::)|using (\\w+) = )"));
    static const QRegularExpression kForward(QStringLiteral("^(?:template<[^>]*> )?(?:class|struct|enum)[^{]*;"));
    QMap<QString, QSet<QString>> out;
    for (const char *folder : {"core", "ui", "app", "tests"}) {
        QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/") + QLatin1String(folder), {QStringLiteral("*.h")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            if (!file.open(QIODevice::ReadOnly))
                continue;
            const QString path = QDir(QStringLiteral(SKYSEAL_SOURCE_DIR)).relativeFilePath(file.fileName());
            QTextStream lines(&file);
            for (QString line; lines.readLineInto(&line);) {
                const auto match = kType.match(line);
                if (match.hasMatch() && !kForward.match(line).hasMatch())
                    out[match.captured(1) + match.captured(2)].insert(path);
            }
        }
    }
    return out;
}

/// Each room's sum of all its events; written with the room: channel::Event, vehicle::Event, engine::Event.
const QSet<QString> kAllowed{QStringLiteral("Event")};

} // namespace

class NamesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noTwoTypesShareAName();
};

void NamesTest::noTwoTypesShareAName()
{
    const auto types = headersByType();
    QVERIFY(types.size() > 500);
    QStringList wrong;
    for (auto type = types.cbegin(); type != types.cend(); ++type) {
        if (type->size() > 1 && !kAllowed.contains(type.key()))
            wrong << type.key() + QStringLiteral(": ") + QStringList(type->cbegin(), type->cend()).join(QStringLiteral(", "));
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    for (const QString &name : kAllowed)
        QVERIFY2(types.value(name).size() > 1, qPrintable(name + QStringLiteral(" need not be allowed")));
}

SKYSEAL_TEST_APPLESS(NamesTest)
#include "names_test.moc"
