// The command line as scripts see it: exit statuses, one clear line for what is wrong, JSON that parses.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

class CommandLineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void helpAndVersion_data();
    void helpAndVersion();
    void helpNamesOtherCommandsAsTheyAre();
    void usageErrors_data();
    void usageErrors();
    void cannotOpen_data();
    void cannotOpen();
    void requiredSessionThatNeverComes();
    void selftestPasses();
};

void CommandLineTest::helpAndVersion_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *program, const char *arguments, const char *expected) {
        QTest::addRow("%s %s", program, arguments)
            << QString::fromUtf8(program) << words(arguments) << QString::fromUtf8(expected);
    };
    row("skyseal-cli", "--help", "monitor");
    row("skyseal-cli", "--version", "skyseal-cli ");
    row("skyseal-cli", "monitor --help", "--switch-every");
    row("skyseal-cli", "gateway --help", "write=none|all");
    row("skyseal-cli", "gateway --help", "failsafe");
    row("skyseal-cli", "status --help", "--control");
    row("skyseal-cli", "switch --help", "SUITE");
    row("skyseal-cli", "revoke --help", "PEER");
    row("skyseal-cli", "impair --help", "--jitter");
    row("skyseal-cli", "sweep --help", "--expect");
    row("skyseal-cli", "decode --help", "FILE");
    row("skyseal-cli", "keys --help", "peers add");
    row("skyseal-cli", "keys peers --help", "peers revoke");
    row("skyseal-cli", "log --help", "verify");
    row("skyseal-air", "--help", "--allow-plain");
    row("skyseal-sim", "--help", "udpin:HOST:PORT");
    row("skyseal-air", "--version", "skyseal-air ");
}

void CommandLineTest::helpAndVersion()
{
    QFETCH(QString, program);
    QFETCH(QStringList, arguments);
    QFETCH(QString, expected);
    const RunResult result = runProgram(program.toUtf8().constData(), arguments);
    QCOMPARE(result.status, 0);
    QVERIFY2(result.out.contains(expected.toUtf8()), result.out.constData());
    QVERIFY2(!result.out.contains("\xc3\xa2\xc2\x80"), result.out.constData()); // UTF-8 that was encoded once more
}

/// Started by its name alone, the program's name is a word of its texts as well.
void CommandLineTest::helpNamesOtherCommandsAsTheyAre()
{
    const RunResult help = runInShell("PATH=${1%/*}:$PATH; exec skyseal-cli gateway --help", "skyseal-cli", {});
    QCOMPARE(help.status, 0);
    QVERIFY2(help.out.startsWith("Usage: skyseal-cli gateway [options]"), help.out.constData());
    QVERIFY2(help.out.contains("skyseal-cli status"), help.out.constData());
}

void CommandLineTest::usageErrors_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("named"); // the error names what is wrong
    const auto row = [](const char *program, const char *arguments, const char *named) {
        QTest::addRow("%s %s", program, arguments)
            << QString::fromUtf8(program) << words(arguments) << QString::fromUtf8(named);
    };
    row("skyseal-cli", "", "command");
    row("skyseal-cli", "fly", "fly");
    row("skyseal-cli", "monitor", "--link");
    row("skyseal-cli", "monitor --link", "link");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --loud", "loud");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 extra", "extra");
    row("skyseal-cli", "monitor --link pigeon:coop", "--link 'pigeon:coop': a link URL");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:99999", "99999");
    row("skyseal-cli", "keys pair --peers none.peers", "--identity is missing"); // --link has a preset
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --secure maybe", "maybe");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --secure required", "--identity");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --duration soon", "soon");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --duration -1", "-1");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --suite des", "des");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --switch-to rc4,rc4", "rc4");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --secure off --switch-to rc4", "--secure required");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --secure off --suite chacha20", "--secure required");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --identity k --peers p --suite rc4", "--allow-research");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --identity k --peers p --switch-to none", "plain");
    row("skyseal-cli",
        "monitor --link udpin:127.0.0.1:0 --identity k --peers p --suite aes-256-cbc --weakest-suite aes-256-gcm",
        "--weakest-suite");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --framing inline", "inline");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --do dance", "dance");
    row("skyseal-cli", "impair --listen udpin:127.0.0.1:0 --to udpout:127.0.0.1:9 --loss 1.5", "1.5");
    row("skyseal-cli", "impair --listen udpin:127.0.0.1:0", "--to");
    row("skyseal-cli", "sweep --suites des", "no suite is named 'des'; there are none, ");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --switch-to des", "there are chacha20-poly1305, ");
    row("skyseal-cli", "sweep --seconds 0", "--seconds");
    row("skyseal-cli", "sweep --repeats 0", "--repeats");
    row("skyseal-cli", "sweep --load heavy", "heavy");
    for (const char *limit : {"max-overtaken 0.1", "max-overtaken 11", "max-overtaken off", "max-age 0.4", "max-age 61"}) {
        const QString arguments = QStringLiteral("--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity k "
                                                 "--peers p --%1")
                                      .arg(QLatin1String(limit));
        row("skyseal-air", qPrintable(arguments), std::string(limit).substr(0, std::string(limit).find(' ')).c_str());
    }
    row("skyseal-cli", "sweep --fly arm", "--fly requires --vehicle");
    row("skyseal-cli", "sweep --vehicle tcp:127.0.0.1:5760 --fly arm;takeof", "takeof");
    row("skyseal-cli", "sweep --vehicle tcp:127.0.0.1:5760 --fly land", "no step leads to phase 1");
    row("skyseal-cli", "sweep --vehicle tcp:127.0.0.1:5760 --load saturated", "saturated");
    row("skyseal-cli", "sweep --vehicle tlog:flight.tlog", "tlog");
    row("skyseal-cli", "sweep --vehicle tcp:127.0.0.1:5760 --link udpin:1 --identity k --peers p", "not with --link");
    row("skyseal-cli", "sweep --pps 100,fast", "different rates of 1 to 1000000");
    row("skyseal-cli", "sweep --pps 100,100", "different rates of 1 to 1000000");
    row("skyseal-cli", "sweep --pps 0", "different rates of 1 to 1000000");
    row("skyseal-cli", "sweep --pps 100 --vehicle tcp:127.0.0.1:5760", "--pps: not with --link or --vehicle");
    row("skyseal-sim", "--link udpout:127.0.0.1:1 --pps 100 --saturate", "--pps: not with --saturate");
    row("skyseal-cli", "sweep --load saturated,natural --framing rot13", "sealed, inline, both, bare or all"); // in any order
    row("skyseal-cli", "sweep --impair loss=2", "loss=2");
    row("skyseal-cli", "sweep --framing rot13", "sealed, inline, both, bare or all");
    row("skyseal-cli", "sweep --framing inline --suites aes-256-gcm", "none of them supports this framing");
    row("skyseal-cli", "sweep --expect loss(chacha20,inline)<1", "framing inline");
    row("skyseal-cli", "sweep --expect loss", "comparison");
    row("skyseal-cli", "sweep --suites none --expect cpu(rc4)<1", "does not measure rc4");
    row("skyseal-cli", "sweep --link udpin:127.0.0.1:0", "--identity");
    row("skyseal-cli", "sweep --link udpin:127.0.0.1:0 --identity k --peers p --suites none", "--allow-plain");
    row("skyseal-cli", "sweep --link udpin:127.0.0.1:0 --identity k --peers p --suites rc4", "--allow-research");
    row("skyseal-cli", "sweep --link udpin:127.0.0.1:0 --identity k --peers p --load saturated", "saturated");
    row("skyseal-cli", "bench --sizes 0", "--sizes");
    row("skyseal-cli", "bench --sizes 28,2000", "1100");
    row("skyseal-cli", "bench --aes maybe", "maybe");
    row("skyseal-cli", "bench --suites none", "is not sealed");
    row("skyseal-cli", "gateway --link udpin:14550 --identity a --peers b", "--serve is missing");
    row("skyseal-cli", "gateway --link tlog:a.tlog --identity a --peers b --serve udpin:1", "--link");
    row("skyseal-cli", "gateway --link udpin:14550 --identity a --peers b --serve udpin:1,write=everything",
        "write='everything'");
    row("skyseal-cli", "gateway --link udpin:14550 --identity a --peers b --serve udpin:1 --control tcp:1", "unix:/PATH");
    for (const char *own : {"udpout:127.0.0.1:14550", "udpin:14551 --serve udpout:127.0.0.1:14551", "udpin:14550",
                            "udpin:14551 --serve udpin:0.0.0.0:14551"})
        row("skyseal-cli", (QByteArray("gateway --link udpin:14550 --identity a --peers b --serve ") + own).constData(),
            "the gateway itself listens there");
    for (const char *own : {"--vehicle udpin:14550 --ground udpout:127.0.0.1:14550",
                            "--vehicle udpin:14550 --ground udpin:14550", "--vehicle tcp:localhost:5760 --ground tcpin:5760",
                            "--vehicle udpin:14551 --ground udpin:14550 --ground udpout:127.0.0.1:14550"})
        row("skyseal-air", (QByteArray(own) + " --identity a --peers b").constData(), "the agent itself listens there");
    row("skyseal-cli", "impair --listen udpin:14550 --to udpout:127.0.0.1:14550", "the relay itself listens there");
    row("skyseal-cli", "gateway --link udpin:14550 --identity a --peers b --serve udpin:1 --metrics 9464",
        "--metrics '9464': ADDRESS:PORT");
    row("skyseal-cli", "gateway --link udpin:14550 --identity a --peers b --serve udpin:1 --record=", "--record is missing");
    row("skyseal-cli", "status", "--control is missing");
    row("skyseal-cli", "switch --control unix:/tmp/s", "argument");
    row("skyseal-cli", "decode", "argument");
    row("skyseal-cli", "decode a b", "b");
    row("skyseal-cli", "decode --framing rot13 a", "rot13");
    row("skyseal-cli", "decode --nonce 00 a", "mavsec2019");
    row("skyseal-cli", "decode --framing mavsec2019 --cipher rc4 a", "rc4");
    row("skyseal-cli", "decode --framing mavsec2019 --key 00 a", "64 hex digits");
    row("skyseal-cli", "decode --framing mavsec2019 --nonce 00 a", "24 hex digits");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --framing mavsec2019 --identity k --peers p", "--secure off");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --framing mavsec2019 --do arm", "never sends");
    row("skyseal-cli", "keys", "new");
    row("skyseal-cli", "keys new", "--out");
    row("skyseal-cli", "keys peers add --peers p --name n nonsense", "public key");
    row("skyseal-cli", "log", "info");
    row("skyseal-cli", "selftest now", "now");
    row("skyseal-air", "", "--vehicle");
    const QByteArray agent("--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity k --peers p --");
    for (const char *option : {"role observer", "replace", "expect 41c0", "as base", "pair-passphrase", "pair-passphrase-fd 0"})
        row("skyseal-air", (agent + option).constData(), "requires --pair");
    row("skyseal-sim", "--link tlog:flight.tlog", "tcpin:HOST:PORT or serial:/dev/NAME:BAUD is expected");
    for (const char *command :
         {"keys pair --link tlog:flight.tlog --identity k --peers p", "sweep --link tlog:flight.tlog --identity k --peers p",
          "impair --listen tlog:flight.tlog --to udpout:127.0.0.1:9"})
        row("skyseal-cli", command, "tcpin:HOST:PORT or serial:/dev/NAME:BAUD is expected");
    row("skyseal-air", "--vehicle udpin:127.0.0.1:0 --ground tlog:flight.tlog --identity k --peers p",
        "--ground 'tlog:flight.tlog': udpin:HOST:PORT, ");
    row("skyseal-air", "--vehicle udpin:127.0.0.1:0 --ground udpin:127.0.0.1:0 --carrier tunnel --identity k --peers p",
        "only listens");
    row("skyseal-air", "--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity k --peers p --suites ,", "suite");
    row("skyseal-air", "--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity k --peers p --suites rc4", "secure");
    row("skyseal-air",
        "--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity k --peers p --suites chacha20 "
        "--weakest-suite aes-256-gcm",
        "secure");
}

void CommandLineTest::usageErrors()
{
    QFETCH(QString, program);
    QFETCH(QStringList, arguments);
    QFETCH(QString, named);
    const RunResult result = runProgram(program.toUtf8().constData(), arguments);
    QCOMPARE(result.status, 2);
    QVERIFY(result.out.isEmpty());
    QCOMPARE(result.err.count('\n'), 1);
    QVERIFY2(result.err.contains(named.toUtf8()), result.err.constData());
}

void CommandLineTest::cannotOpen_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("named");
    const auto row = [](const char *program, const char *arguments, const char *named) {
        QTest::addRow("%s %s", program, arguments)
            << QString::fromUtf8(program) << words(arguments) << QString::fromUtf8(named);
    };
    row("skyseal-cli", "gateway --config /nonexistent/gateway.conf", "/nonexistent/gateway.conf");
    row("skyseal-cli", "switch rc4 --control unix:/nonexistent/s", "/nonexistent/s: no gateway listens there\n");
    row("skyseal-cli", "decode /nonexistent/flight.tlog", "/nonexistent/flight.tlog");
    row("skyseal-cli", "decode /tmp", "/tmp");
    row("skyseal-cli", "log info /nonexistent/flight.tlog", "/nonexistent/flight.tlog");
    row("skyseal-cli", "keys show /nonexistent/key", "/nonexistent/key");
    row("skyseal-cli", "keys new --out /nonexistent/key", "/nonexistent/key");
    row("skyseal-cli", "keys peers list --peers /nonexistent/peers", "/nonexistent/peers");
    row("skyseal-cli", "monitor --no-record --link tlog:/nonexistent/flight.tlog --secure off", "/nonexistent/flight.tlog");
    row("skyseal-cli", "monitor --link udpin:127.0.0.1:0 --identity /nonexistent/key --peers /nonexistent/peers",
        "/nonexistent/key");
    row("skyseal-air", "--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --identity /nonexistent/key --peers p",
        "/nonexistent/key");
}

void CommandLineTest::cannotOpen()
{
    QFETCH(QString, program);
    QFETCH(QStringList, arguments);
    QFETCH(QString, named);
    const RunResult result = runProgram(program.toUtf8().constData(), arguments);
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains(named.toUtf8()), result.err.constData());
}

void CommandLineTest::requiredSessionThatNeverComes()
{
    QTemporaryDir folder;
    const QString key = folder.filePath(QStringLiteral("ground.key")), peers = folder.filePath(QStringLiteral("peers"));
    QCOMPARE(runProgram("skyseal-cli", {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), key}).status,
             0);
    QFile file(peers);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    const QStringList arguments{QStringLiteral("monitor"),
                                QStringLiteral("--link"),
                                QStringLiteral("udpin:127.0.0.1:0"),
                                QStringLiteral("--secure"),
                                QStringLiteral("required"),
                                QStringLiteral("--identity"),
                                key,
                                QStringLiteral("--peers"),
                                peers,
                                QStringLiteral("--no-record"),
                                QStringLiteral("--json"),
                                QStringLiteral("--duration"),
                                QStringLiteral("1.2")};
    const RunResult result = runProgram("skyseal-cli", arguments);
    QCOMPARE(result.status, 1);
    QVERIFY(result.err.contains("session"));
    const QByteArrayList lines = result.out.trimmed().split('\n');
    for (const QByteArray &line : lines)
        QVERIFY2(QJsonDocument::fromJson(line).isObject(), line.constData());
    const QJsonObject summary = QJsonDocument::fromJson(lines.back()).object();
    QCOMPARE(summary[QLatin1String("event")].toString(), QStringLiteral("summary"));
    for (const char *part : {"t", "mavlink", "channel", "process", "vehicles"})
        QVERIFY2(summary.contains(QLatin1String(part)), part);
}

void CommandLineTest::selftestPasses()
{
    const RunResult result = runProgram("skyseal-cli", words("selftest --json"));
    QCOMPARE(result.status, 0);
    const QByteArrayList lines = result.out.trimmed().split('\n');
    QVERIFY(lines.size() > 10);
    for (const QByteArray &line : lines)
        QVERIFY2(QJsonDocument::fromJson(line)[QLatin1String("passed")].toBool(), line.constData());
}

SKYSEAL_TEST(CommandLineTest)
#include "command_line_test.moc"
