// Sealed private keys as a person and as a script use them: the passphrase is typed without an echo or read from a file or a
// descriptor, and no byte of it or of the key shows anywhere.
#include "tests/support/run_program.h"
#include "tests/support/terminal.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

class KeyPassphraseTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void typedAtTheTerminalWithoutEcho();
    void interruptedAndMistyped();
    void readFromAFile();
    void readFromADescriptor();
    void passphraseFileIsChecked();
    void withoutATerminalTheOptionIsNamed();
    void changedAndRemoved();
    void agentAndMonitorOpenIt();
    void noKeyByteAndNoPassphraseInTheOutput();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    static RunResult keys(const QStringList &arguments, const QByteArray &input = {})
    {
        return runProgram("skyseal-cli", QStringList{QStringLiteral("keys")} + arguments, input);
    }
    QString write(const char *name, const QByteArray &content,
                  QFile::Permissions mode = QFile::ReadOwner | QFile::WriteOwner) const
    {
        QFile file(path(name));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        file.setPermissions(mode);
        return file.fileName();
    }
    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    RunResult newSealed(const char *name, const QByteArray &passphrase) const
    {
        return keys({QStringLiteral("new"), QStringLiteral("--out"), path(name), QStringLiteral("--new-passphrase-fd"),
                     QStringLiteral("0")},
                    passphrase + '\n');
    }
    /// Whether the passphrase opens the file, by changing it to itself.
    int opens(const char *name, const QByteArray &passphrase) const
    {
        const QString file = write("try.pass", passphrase);
        return keys({QStringLiteral("passphrase"), path(name), QStringLiteral("--passphrase-file"), file,
                     QStringLiteral("--new-passphrase-file"), file})
            .status;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void KeyPassphraseTest::typedAtTheTerminalWithoutEcho()
{
    Terminal made(QStringLiteral("skyseal-cli"),
                  {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), path("a.key"),
                   QStringLiteral("--passphrase")});
    QVERIFY2(made.waitForText("New passphrase of "), made.errors().constData());
    made.type("swordfish\n");
    QVERIFY(made.waitForText("Repeat the passphrase: "));
    made.type("swordfish\n");
    QCOMPARE(made.waitForExit(), 0);
    QVERIFY2(!made.shown().contains("sword"), made.shown().constData());
    QVERIFY(read("a.key").startsWith("skyseal-sealed-key-v1\n"));

    // Wrong twice, right at the third attempt; into another file, without a passphrase there.
    Terminal opened(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("keys"), QStringLiteral("import"), path("a.key"), QStringLiteral("--out"), path("b.key")});
    QVERIFY(opened.waitForText("Passphrase of "));
    opened.type("sworfish\n");
    QVERIFY(opened.waitForText("Try again: "));
    opened.type("s\n");
    QVERIFY(opened.waitForText("Try again: "));
    opened.type("swordfish\n");
    QCOMPARE(opened.waitForExit(), 0);
    QVERIFY(!opened.shown().contains("fish"));
    QVERIFY(read("b.key").startsWith("skyseal-private-key-v1\n"));
}

void KeyPassphraseTest::interruptedAndMistyped()
{
    const QStringList make{QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), path("a.key"),
                           QStringLiteral("--passphrase")};
    {
        Terminal interrupted(QStringLiteral("skyseal-cli"), make);
        QVERIFY(interrupted.waitForText("New passphrase of "));
        interrupted.type("half a word\x03");
        QCOMPARE(interrupted.waitForExit(), 3);
        QVERIFY(interrupted.errors().contains("cancelled"));
        QVERIFY(!interrupted.shown().contains("half"));
    }
    {
        Terminal mistyped(QStringLiteral("skyseal-cli"), make);
        QVERIFY(mistyped.waitForText("New passphrase of "));
        mistyped.type("one\n");
        QVERIFY(mistyped.waitForText("Repeat the passphrase: "));
        mistyped.type("two\n");
        QCOMPARE(mistyped.waitForExit(), 3);
        QVERIFY(mistyped.errors().contains("differ"));
    }
    QVERIFY(!QFile::exists(path("a.key")));
}

void KeyPassphraseTest::readFromAFile()
{
    const QString words = write("words", "correct horse\nthe second line is nobody's business\n");
    QCOMPARE(
        keys({QStringLiteral("new"), QStringLiteral("--out"), path("a.key"), QStringLiteral("--new-passphrase-file"), words})
            .status,
        0);
    QCOMPARE(opens("a.key", "correct horse\r\n"), 0);
    QCOMPARE(opens("a.key", "correct horse "), 3);
}

void KeyPassphraseTest::readFromADescriptor()
{
    QCOMPARE(newSealed("a.key", "by the pipe").status, 0);
    QCOMPARE(opens("a.key", "by the pipe"), 0);
    const RunResult empty = newSealed("b.key", "");
    QCOMPARE(empty.status, 3);
    QVERIFY(empty.err.contains("no passphrase"));
    QVERIFY(!QFile::exists(path("b.key")));
    QCOMPARE(newSealed("b.key", QByteArray(1025, 'x')).status, 3);
}

void KeyPassphraseTest::passphraseFileIsChecked()
{
    QCOMPARE(newSealed("a.key", "x").status, 0);
    const auto open = [this](const QString &file) {
        return keys({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--remove"),
                     QStringLiteral("--passphrase-file"), file});
    };
    const RunResult readable = open(write("readable", "x", QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    QCOMPARE(readable.status, 3);
    QVERIFY(readable.err.contains("other users"));
    QCOMPARE(open(path("nowhere")).status, 3);
    const RunResult wrong = open(write("wrong", "y"));
    QCOMPARE(wrong.status, 3);
    QVERIFY2(wrong.err.contains("wrong passphrase"), wrong.err.constData());
    QCOMPARE(keys({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--passphrase-file"), path("readable"),
                   QStringLiteral("--passphrase-fd"), QStringLiteral("0")})
                 .status,
             2);
    QVERIFY(read("a.key").startsWith("skyseal-sealed-key-v1\n"));
}

void KeyPassphraseTest::withoutATerminalTheOptionIsNamed()
{
    const auto alone = [](const QStringList &arguments) { // without the terminal of whoever runs the tests
        return runToItsEnd(
            QStringLiteral("setsid"),
            QStringList{QStringLiteral("-w"), QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"), QStringLiteral("keys")}
                + arguments);
    };
    const RunResult made = alone(
        {QStringLiteral("new"), QStringLiteral("--out"), path("a.key"), QStringLiteral("--passphrase")});
    QCOMPARE(made.status, 3);
    QVERIFY2(made.err.contains("use --new-passphrase-file or --new-passphrase-fd"), made.err.constData());
    QCOMPARE(newSealed("a.key", "x").status, 0);
    const RunResult opened = alone({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--remove")});
    QCOMPARE(opened.status, 3);
    QVERIFY2(opened.err.contains("use --passphrase-file or --passphrase-fd"), opened.err.constData());
}

void KeyPassphraseTest::changedAndRemoved()
{
    QCOMPARE(keys({QStringLiteral("new"), QStringLiteral("--out"), path("a.key")}).status, 0);
    const QByteArray plain = read("a.key");
    const QByteArray shownPlain = keys({QStringLiteral("show"), path("a.key"), QStringLiteral("--json")}).out;
    const QString words = write("words", "first"), others = write("others", "second");
    QCOMPARE(keys({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--new-passphrase-file"), words}).status, 0);
    QByteArray shownSealed =
        keys({QStringLiteral("show"), path("a.key"), QStringLiteral("--json")}).out; // without a passphrase
    QVERIFY2(shownSealed.contains("\"sealed\":true") && shownPlain.contains("\"sealed\":false"), shownSealed.constData());
    QCOMPARE(shownSealed.replace("\"sealed\":true", "\"sealed\":false"), shownPlain);
    QCOMPARE(keys({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--passphrase-file"), words,
                   QStringLiteral("--new-passphrase-file"), others})
                 .status,
             0);
    QCOMPARE(opens("a.key", "first"), 3);
    QCOMPARE(keys({QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--passphrase-file"), others,
                   QStringLiteral("--remove")})
                 .status,
             0);
    QCOMPARE(read("a.key"), plain);
}

void KeyPassphraseTest::agentAndMonitorOpenIt()
{
    QCOMPARE(newSealed("a.key", "open sesame").status, 0);
    write("peers", "");
    const QString right = write("right", "open sesame"), wrong = write("wrong", "open, sesame");
    const auto agent = [this](const QStringList &more) {
        return runProgram("skyseal-air",
                          QStringList{QStringLiteral("--vehicle"), QStringLiteral("udpin:127.0.0.1:1"),
                                      QStringLiteral("--ground"), QStringLiteral("udpout:nowhere.invalid:1"),
                                      QStringLiteral("--identity"), path("a.key"), QStringLiteral("--peers"), path("peers")}
                              + more);
    };
    const RunResult none = agent({QStringLiteral("--passphrase-file"), wrong});
    QCOMPARE(none.status, 3);
    QVERIFY2(none.err.contains("wrong passphrase"), none.err.constData());
    const RunResult opened = agent({QStringLiteral("--passphrase-file"), right});
    QCOMPARE(opened.status, 3); // by the next hurdle: there is no such station
    QVERIFY2(!opened.err.contains("a.key"), opened.err.constData());

    const auto monitor = [this](const QString &words) {
        return runProgram("skyseal-cli",
                          {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"),
                           QStringLiteral("--identity"), path("a.key"), QStringLiteral("--peers"), path("peers"),
                           QStringLiteral("--duration"), QStringLiteral("0.1"), QStringLiteral("--no-record"),
                           QStringLiteral("--passphrase-file"), words});
    };
    QCOMPARE(monitor(wrong).status, 3);
    QCOMPARE(monitor(right).status, 1); // no session came up, as nobody is there
}

void KeyPassphraseTest::noKeyByteAndNoPassphraseInTheOutput()
{
    QList<QByteArray> outputs;
    const auto note = [&outputs](const RunResult &result) { outputs << result.out << result.err; };
    const QString words = write("words", "swordfish"), others = write("others", "sawfish");
    note(keys({QStringLiteral("new"), QStringLiteral("--out"), path("a.key"), QStringLiteral("--new-passphrase-file"), words,
               QStringLiteral("--json")}));
    const QByteArray sealed = read("a.key").trimmed().split('\n').back();
    for (const QStringList &arguments : {QStringList{QStringLiteral("show"), path("a.key")},
                                         {QStringLiteral("export"), path("a.key")},
                                         {QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--passphrase-file"),
                                          others, QStringLiteral("--remove")},
                                         {QStringLiteral("passphrase"), path("a.key"), QStringLiteral("--passphrase-file"),
                                          words, QStringLiteral("--remove")}})
        note(keys(arguments));
    const QByteArray plain = read("a.key").trimmed().split('\n').back();
    QCOMPARE(plain.size(), 48);
    note(keys({QStringLiteral("show"), path("a.key"), QStringLiteral("--qr")}));
    note(keys({QStringLiteral("import"), path("a.key"), QStringLiteral("--out"), path("b.key")}));
    for (const QByteArray &output : outputs) {
        for (const QByteArray &secret :
             {sealed.left(8), plain.left(8), plain.right(8), QByteArray("swordfish"), QByteArray("sawfish")})
            QVERIFY2(!output.contains(secret), output.constData());
    }
}

SKYSEAL_TEST(KeyPassphraseTest)
#include "key_passphrase_test.moc"
