// Configuration files: the text, and options that stand in a file.
#include "app/common/config_file.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;

namespace {

struct Command : Options
{
    Command() : Options(QStringLiteral("test"), QStringLiteral("A command."))
    {
        addLink("link", "Links.");
        addValue("duration", "S", "Seconds.", "1");
        addFlag("json", "JSON.");
        addValue("record", "FOLDER", "Record there.");
        addFlag("no-record", "Record nothing.");
        addAlternatives("record", "no-record");
        addConfig();
    }
};

} // namespace

class ConfigFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesHaveNameAndValue();
    void wrongLinesAreNamed_data();
    void wrongLinesAreNamed();
    void optionsMayStandInTheFile();
    void commandLineReplacesTheFile();
    void commandLineReplacesTheOppositeInTheFile();
    void wrongOptionIsAUsageError_data();
    void wrongOptionIsAUsageError();
    void unreadableFileCannotBeOpened();
    void fileOfOthersIsRefused();

private:
    QString written(const QByteArray &content)
    {
        QFile file(m_folder.filePath(QStringLiteral("gateway.conf")));
        if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) || file.write(content) != content.size())
            qFatal("no file");
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        return file.fileName();
    }

    QTemporaryDir m_folder;
};

void ConfigFileTest::linesHaveNameAndValue()
{
    const auto lines = parseConfig("# links\nlink = udpin:14550\r\n\n\t serve=udpin:14551,write=param \n  json = yes",
                                   "a.conf");
    QVERIFY(lines);
    QCOMPARE(lines->size(), std::size_t(3));
    QCOMPARE((*lines)[0].name, std::string("link"));
    QCOMPARE((*lines)[0].value, std::string("udpin:14550"));
    QCOMPARE((*lines)[0].number, std::size_t(2));
    QCOMPARE((*lines)[1].name, std::string("serve"));
    QCOMPARE((*lines)[1].value, std::string("udpin:14551,write=param"));
    QCOMPARE((*lines)[1].number, std::size_t(4));
    QCOMPARE((*lines)[2].number, std::size_t(5));
    QVERIFY(parseConfig("", "a.conf")->empty());
}

void ConfigFileTest::wrongLinesAreNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("position");
    QTest::newRow("no value") << QByteArray("link = a\njson\n") << QStringLiteral("a.conf:2: ");
    QTest::newRow("no name") << QByteArray("\n\n = a\n") << QStringLiteral("a.conf:3: ");
    QTest::newRow("escape sequence") << QByteArray("link = \x1b[31m\n") << QStringLiteral("a.conf:1: ");
    QTest::newRow("no UTF-8") << QByteArray("link = \xff\n") << QStringLiteral("a.conf:1: ");
    QTest::newRow("zero") << QByteArray("link = a\0b\n", 11) << QStringLiteral("a.conf:1: ");
}

void ConfigFileTest::wrongLinesAreNamed()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, position);
    const auto lines = parseConfig(text.toStdString(), "a.conf");
    QVERIFY(!lines);
    QVERIFY2(QString::fromStdString(lines.error().text()).startsWith(position), lines.error().text().c_str());
}

void ConfigFileTest::optionsMayStandInTheFile()
{
    Command command;
    const QString file = written("link = udpin:14550\nlink = tcp:10.0.0.1:5760\njson = yes\n");
    QVERIFY(!command.parse({QStringLiteral("--config"), file, QStringLiteral("--duration"), QStringLiteral("7")}));
    QCOMPARE(command.urls("link").size(), std::size_t(2));
    QVERIFY(command.has("json"));
    QCOMPARE(command.number("duration", 0, 10), 7.0);
    QVERIFY(!command.finish());
}

void ConfigFileTest::commandLineReplacesTheFile()
{
    Command command;
    const QString file = written("link = udpin:14550\nduration = 3\njson = no\n");
    QVERIFY(!command.parse({QStringLiteral("--link"), QStringLiteral("udpin:14551"), QStringLiteral("--config"), file}));
    QCOMPARE(command.urls("link").size(), std::size_t(1));
    QCOMPARE(command.urls("link")[0].port(), std::uint16_t(14551));
    QCOMPARE(command.number("duration", 0, 10), 3.0);
    QVERIFY(!command.has("json"));
}

void ConfigFileTest::commandLineReplacesTheOppositeInTheFile()
{
    Command records;
    QVERIFY(!records.parse(
        {QStringLiteral("--record"), QStringLiteral("/a"), QStringLiteral("--config"), written("no-record = yes\n")}));
    QCOMPARE(records.text("record"), std::string("/a"));
    QVERIFY(!records.has("no-record"));

    Command recordsNothing;
    QVERIFY(!recordsNothing.parse({QStringLiteral("--no-record"), QStringLiteral("--config"), written("record = /a\n")}));
    QVERIFY(recordsNothing.has("no-record"));
    QVERIFY(!recordsNothing.has("record"));

    // At one place, the two are left to the command to judge.
    Command both;
    QVERIFY(!both.parse({QStringLiteral("--config"), written("record = /a\nno-record = yes\n")}));
    QVERIFY(both.has("record") && both.has("no-record"));
}

void ConfigFileTest::wrongOptionIsAUsageError_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("unknown") << QByteArray("lnik = udpin:14550\n");
    QTest::newRow("another file") << QByteArray("config = b.conf\n");
    QTest::newRow("flag") << QByteArray("json = maybe\n");
    QTest::newRow("argument") << QByteArray("--json\n");
}

void ConfigFileTest::wrongOptionIsAUsageError()
{
    QFETCH(QByteArray, text);
    Command command;
    QCOMPARE(command.parse({QStringLiteral("--config"), written(text)}), std::optional<int>(kUsage));
}

void ConfigFileTest::unreadableFileCannotBeOpened()
{
    Command command;
    QCOMPARE(command.parse({QStringLiteral("--config"), m_folder.filePath(QStringLiteral("missing"))}),
             std::optional<int>(kCannotOpen));
}

void ConfigFileTest::fileOfOthersIsRefused()
{
    const QString file = written("json = yes\n");
    QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner | QFile::WriteOther);
    Command command;
    QCOMPARE(command.parse({QStringLiteral("--config"), file}), std::optional<int>(kCannotOpen));
}

SKYSEAL_TEST_APPLESS(ConfigFileTest)
#include "config_file_test.moc"
