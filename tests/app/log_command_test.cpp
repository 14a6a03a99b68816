// skyseal-cli log and decode with input that contains nothing to show: an error that says what is wrong and where.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

class LogCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingToShowIsAnError_data();
    void nothingToShowIsAnError();
    void emptyRecordingIsNotSound();

private:
    QTemporaryDir m_folder;
};

void LogCommandTest::nothingToShowIsAnError_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("problem");
    const QByteArray garbage("this is a letter, not a recording of a flight");
    const auto row = [](const char *command, const char *input, const QByteArray &content, const char *problem) {
        QTest::addRow("%s, %s", command, input)
            << QString::fromLatin1(command).split(QLatin1Char(' ')) << content << QByteArray(problem);
    };
    for (const char *command : {"log info", "log verify", "decode"})
        row(command, "empty", {}, ": is empty");
    for (const char *command : {"log info", "log verify"})
        row(command, "garbage", garbage, ": contains no MAVLink frame; offset 0: ");
    row("decode", "garbage", garbage, ": contains no valid MAVLink message");
}

void LogCommandTest::nothingToShowIsAnError()
{
    QFETCH(QStringList, command);
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, problem);
    QFile file(m_folder.filePath(QStringLiteral("input")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const RunResult result = runProgram("skyseal-cli", command + QStringList{file.fileName()});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.contains(file.fileName().toUtf8() + problem), result.err.constData());
    QVERIFY2(!result.out.contains("sound"), result.out.constData());
    if (command.contains(QStringLiteral("decode")) && !content.isEmpty())
        QVERIFY2(result.out.contains("at byte 0"), result.out.constData());
}

void LogCommandTest::emptyRecordingIsNotSound()
{
    const RunResult result = runProgram(
        "skyseal-cli",
        {QStringLiteral("log"), QStringLiteral("verify"), QStringLiteral("/dev/null"), QStringLiteral("--json")});
    QCOMPARE(result.status, 1);
    QCOMPARE(QJsonDocument::fromJson(result.out).object()[QLatin1String("sound")].toBool(true), false);
}

SKYSEAL_TEST(LogCommandTest)
#include "log_command_test.moc"
