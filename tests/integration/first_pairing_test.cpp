// The first steps of README.md with the real programs: two new keys, an agent without a list of peers, a pairing whose ends are
// named, and the sealed session that follows.
#include "tests/support/eventually.h"
#include "tests/support/pairing_people.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

QStringList words(const QString &line)
{
    return line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

} // namespace

class FirstPairingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agentMakesItsListAndIsPaired();
    void agentThatListensIsPaired();
    void listThatCannotBeMadeIsAnError();
    void missingKeyMakesNoList();
    void checkAgreesWithAStart();

private:
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    bool makeKey(const char *name) const
    {
        return QFile::exists(path(name))
            || runProgram("skyseal-cli", words(QStringLiteral("keys new --out ")) << path(name)).status == 0;
    }
    QStringList agent(quint16 ground, const QString &key, const QString &peers) const
    {
        return words(QStringLiteral("--vehicle udpin:127.0.0.1:0 --json --ground udpout:127.0.0.1:%1").arg(ground))
            << QStringLiteral("--identity") << key << QStringLiteral("--peers") << peers;
    }

    QTemporaryDir m_folder;
};

void FirstPairingTest::agentMakesItsListAndIsPaired()
{
    QVERIFY(makeKey("ground.key") && makeKey("air.key"));
    const quint16 port = freeUdpPort();
    Program air(QStringLiteral("skyseal-air"), agent(port, path("air.key"), path("air.peers")));
    QVERIFY(!air.waitFor(QStringLiteral("link")).isEmpty());
    QVERIFY(QFile::exists(path("air.peers")));
    QCOMPARE(QFile::permissions(path("air.peers"))
                 & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther),
             QFile::Permissions());
    EVENTUALLY2(air.errors().contains("no station is known yet, pair one with skyseal-air --pair --identity"),
                air.errors().constData());

    const QString link = QStringLiteral("--link udpin:127.0.0.1:%1 ").arg(port);
    const QStringList own{QStringLiteral("--identity"), path("ground.key"), QStringLiteral("--peers"), path("ground.peers")};
    {
        Program desk(QStringLiteral("skyseal-air"),
                     words(QStringLiteral("--pair --json --as ground --identity ")) << path("air.key"));
        Program ground(QStringLiteral("skyseal-cli"), words(QStringLiteral("keys pair --json --as air-1 ") + link) + own);
        QVERIFY2(confirmAtBoth(ground, desk), ground.errors().constData());
    }
    QVERIFY2(read("air.peers").startsWith("ground pilot "), read("air.peers").constData());
    QVERIFY2(read("ground.peers").startsWith("air-1 "), read("ground.peers").constData());
    Program monitor(QStringLiteral("skyseal-cli"),
                    words(QStringLiteral("monitor --json --no-record --secure required ") + link) + own);
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"), stateIs("up"));
    QCOMPARE(session[QLatin1String("peer")].toString(), QStringLiteral("air-1"));
}

/// The station calls the address of the agent, for the pairing and for the session.
void FirstPairingTest::agentThatListensIsPaired()
{
    QVERIFY(makeKey("caller.key") && makeKey("listener.key"));
    QStringList arguments = agent(0, path("listener.key"), path("listener.peers"));
    const quint16 port = freeUdpPort();
    arguments[arguments.indexOf(QStringLiteral("--ground")) + 1] = QStringLiteral("udpin:127.0.0.1:%1").arg(port);
    Program air(QStringLiteral("skyseal-air"), arguments);
    QVERIFY2(!air.waitFor(QStringLiteral("stats")).isEmpty(), air.errors().constData());
    const QString link = QStringLiteral("--link udpout:127.0.0.1:%1 ").arg(port);
    const QStringList own{QStringLiteral("--identity"), path("caller.key"), QStringLiteral("--peers"), path("caller.peers")};
    {
        Program desk(QStringLiteral("skyseal-air"),
                     words(QStringLiteral("--pair --json --as caller --identity ")) << path("listener.key"));
        Program ground(QStringLiteral("skyseal-cli"), words(QStringLiteral("keys pair --json --as listener ") + link) + own);
        QVERIFY2(confirmAtBoth(ground, desk), ground.errors().constData());
    }
    Program monitor(QStringLiteral("skyseal-cli"),
                    words(QStringLiteral("monitor --json --no-record --secure required ") + link) + own);
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"), stateIs("up"));
    QCOMPARE(session[QLatin1String("peer")].toString(), QStringLiteral("listener"));
}

void FirstPairingTest::listThatCannotBeMadeIsAnError()
{
    QVERIFY(makeKey("air.key"));
    const RunResult result = runProgram("skyseal-air", agent(9, path("air.key"), path("no/such/folder.peers")));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("folder.peers"), result.err.constData());
}

void FirstPairingTest::missingKeyMakesNoList()
{
    const RunResult result = runProgram("skyseal-air", agent(9, path("mistyped.key"), path("none.peers")));
    QCOMPARE(result.status, 3);
    QVERIFY(!QFile::exists(path("none.peers")));
}

void FirstPairingTest::checkAgreesWithAStart()
{
    QVERIFY(makeKey("air.key"));
    const auto check = [this](const char *peers) {
        return runProgram("skyseal-air", agent(freeUdpPort(), path("air.key"), path(peers)) << QStringLiteral("--check"));
    };
    const RunResult fresh = check("checked.peers");
    QCOMPARE(fresh.out, QByteArray("the configuration is valid\n"));
    QCOMPARE(fresh.status, 0);
    QVERIFY2(fresh.err.contains("the start creates it") && fresh.err.contains("skyseal-air --pair --identity"),
             fresh.err.constData());
    QVERIFY(!QFile::exists(path("checked.peers")));

    QFile list(path("checked.peers"));
    QVERIFY(list.open(QIODevice::WriteOnly) && list.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    list.close();
    const RunResult empty = check("checked.peers");
    QCOMPARE(empty.status, 0);
    QVERIFY2(empty.err.contains("no station is known yet"), empty.err.constData());
    QCOMPARE(check("no/such/folder").status, 1);
}

SKYSEAL_TEST(FirstPairingTest)
#include "first_pairing_test.moc"
