// The work with keys and peers, as a person does it before the first flight.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

class KeysCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void newKeyIsPrivateAndShown();
    void existingKeyIsNeverOverwritten();
    void keyThatOthersCanReadIsRefused();
    void peersAreAddedListedRemoved();
    void changedKeyNeedsAnExplicitReplace();
    void changedKeyIsToldWithBothFingerprints();
    void replacedKeyKeepsWhatWasNoted();
    void peersAreRenamedAndGivenAnotherRole();
    void publicKeyTravelsInAFile();
    void privateKeyIsImported();
    void presharedKeyIsMadeAndNamed();
    void damagedPeersFileIsLeftAlone();
    void missingFilesSayWhatMakesThem();
    void pairingNeedsSomebodyToAnswer();
    void noKeyByteInTheOutput();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    RunResult keys(const QStringList &arguments) const
    {
        return runProgram("skyseal-cli", QStringList{QStringLiteral("keys")} + arguments);
    }
    RunResult newKey(const char *name) const { return keys({QStringLiteral("new"), QStringLiteral("--out"), path(name)}); }
    QJsonObject shown(const char *name) const
    {
        return QJsonDocument::fromJson(keys({QStringLiteral("show"), path(name), QStringLiteral("--json")}).out).object();
    }
    QString publicKeyOf(const char *name) const { return shown(name)[QLatin1String("public")].toString(); }
    QJsonObject listed() const { return QJsonDocument::fromJson(peers("list", {QStringLiteral("--json")}).out).object(); }
    RunResult addPeer(const QString &publicKey, const QStringList &more = {}) const
    {
        return keys(QStringList{QStringLiteral("peers"), QStringLiteral("add"), QStringLiteral("--peers"), path("peers"),
                                QStringLiteral("--name"), QStringLiteral("scout-1"), publicKey}
                    + more);
    }
    RunResult peers(const char *action, const QStringList &more = {}) const
    {
        return keys(QStringList{QStringLiteral("peers"), QLatin1String(action), QStringLiteral("--peers"), path("peers")}
                    + more);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void KeysCommandTest::newKeyIsPrivateAndShown()
{
    QCOMPARE(newKey("a.key").status, 0);
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    QVERIFY(!(QFile::permissions(path("a.key")) & others));
    const QJsonObject key = shown("a.key");
    QCOMPARE(key[QLatin1String("event")].toString(), QStringLiteral("key"));
    QVERIFY(key[QLatin1String("public")].toString().startsWith(QLatin1String("skyseal:")));
    QCOMPARE(key[QLatin1String("fingerprint")].toString().remove(QLatin1Char(' ')).size(), 64);
    QCOMPARE(newKey("b.key").status, 0);
    QVERIFY(shown("b.key")[QLatin1String("public")] != key[QLatin1String("public")]);
}

void KeysCommandTest::existingKeyIsNeverOverwritten()
{
    QCOMPARE(newKey("a.key").status, 0);
    const QJsonObject before = shown("a.key");
    QCOMPARE(newKey("a.key").status, 3);
    QCOMPARE(shown("a.key"), before);
}

void KeysCommandTest::keyThatOthersCanReadIsRefused()
{
    QCOMPARE(newKey("a.key").status, 0);
    QVERIFY(QFile::setPermissions(path("a.key"), QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
    const RunResult refused = keys({QStringLiteral("show"), path("a.key")});
    QCOMPARE(refused.status, 3);
    QVERIFY2(refused.err.contains("a.key"), refused.err.constData());
}

void KeysCommandTest::peersAreAddedListedRemoved()
{
    QCOMPARE(newKey("a.key").status, 0);
    const QJsonObject key = shown("a.key");
    QCOMPARE(addPeer(key[QLatin1String("public")].toString(),
                     {QStringLiteral("--role"), QStringLiteral("observer"), QStringLiteral("--sysids"), QStringLiteral("1,7")})
                 .status,
             0);
    const QJsonObject listed = QJsonDocument::fromJson(peers("list", {QStringLiteral("--json")}).out).object();
    QCOMPARE(listed[QLatin1String("name")].toString(), QStringLiteral("scout-1"));
    QCOMPARE(listed[QLatin1String("role")].toString(), QStringLiteral("observer"));
    QCOMPARE(listed[QLatin1String("sysids")].toString(), QStringLiteral("1,7"));
    QCOMPARE(listed[QLatin1String("fingerprint")], key[QLatin1String("fingerprint")]);
    QCOMPARE(peers("remove", {QStringLiteral("nobody")}).status, 1);
    QCOMPARE(peers("remove", {QStringLiteral("scout-1")}).status, 0);
    QVERIFY(peers("list", {QStringLiteral("--json")}).out.isEmpty());
}

void KeysCommandTest::changedKeyNeedsAnExplicitReplace()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(newKey("b.key").status, 0);
    const QString first = shown("a.key")[QLatin1String("public")].toString(),
                  second = shown("b.key")[QLatin1String("public")].toString();
    QCOMPARE(addPeer(first).status, 0);
    QCOMPARE(addPeer(second).status, 1);
    QVERIFY(peers("list", {QStringLiteral("--json")}).out.contains(first.toUtf8()));
    QCOMPARE(addPeer(second, {QStringLiteral("--replace")}).status, 0);
    QVERIFY(peers("list", {QStringLiteral("--json")}).out.contains(second.toUtf8()));
}

void KeysCommandTest::changedKeyIsToldWithBothFingerprints()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(newKey("b.key").status, 0);
    QCOMPARE(addPeer(publicKeyOf("a.key")).status, 0);
    const RunResult refused = addPeer(publicKeyOf("b.key"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains("HAS CHANGED") && refused.err.contains("--replace"), refused.err.constData());
    for (const char *key : {"a.key", "b.key"})
        QVERIFY(refused.err.contains(shown(key)[QLatin1String("fingerprint")].toString().toUtf8()));
    QVERIFY(!refused.err.contains('?'));
}

void KeysCommandTest::replacedKeyKeepsWhatWasNoted()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(newKey("b.key").status, 0);
    QCOMPARE(addPeer(publicKeyOf("a.key"),
                     {QStringLiteral("--role"), QStringLiteral("observer"), QStringLiteral("--sysids"), QStringLiteral("7")})
                 .status,
             0);
    QCOMPARE(addPeer(publicKeyOf("b.key"), {QStringLiteral("--replace")}).status, 0);
    const QJsonObject peer = listed();
    QCOMPARE(peer[QLatin1String("public")].toString(), publicKeyOf("b.key"));
    QCOMPARE(peer[QLatin1String("role")].toString(), QStringLiteral("observer"));
    QCOMPARE(peer[QLatin1String("sysids")].toString(), QStringLiteral("7"));
    // There is nothing to replace where nobody is known.
    QCOMPARE(peers("remove", {QStringLiteral("scout-1")}).status, 0);
    QCOMPARE(addPeer(publicKeyOf("b.key"), {QStringLiteral("--replace")}).status, 1);
}

void KeysCommandTest::peersAreRenamedAndGivenAnotherRole()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(addPeer(publicKeyOf("a.key")).status, 0);
    QCOMPARE(peers("rename", {QStringLiteral("scout-1"), QStringLiteral("two words")}).status, 2);
    for (const char *bad : {"two words", "-x", "\u00a0x"}) {
        const RunResult refused = peers("add", {QStringLiteral("--name=") + QString::fromUtf8(bad), publicKeyOf("a.key")});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.err.contains("is not a peer's name"), refused.err.constData());
    }
    const RunResult unknown = peers("rename", {QStringLiteral("nobody"), QStringLiteral("scout-2")});
    QCOMPARE(unknown.status, 1);
    QVERIFY2(unknown.err.contains("there is no peer named \"nobody\""), unknown.err.constData());
    QVERIFY(
        peers("role", {QStringLiteral("nobody"), QStringLiteral("pilot")}).err.contains("there is no peer named \"nobody\""));
    QCOMPARE(peers("rename", {QStringLiteral("scout-1"), QStringLiteral("scout-2")}).status, 0);
    QCOMPARE(peers("role", {QStringLiteral("scout-2"), QStringLiteral("captain")}).status, 2);
    QCOMPARE(peers("role", {QStringLiteral("scout-2"), QStringLiteral("observer")}).status, 0);
    QCOMPARE(peers("sysids", {QStringLiteral("scout-2"), QStringLiteral("1,300")}).status, 2);
    QCOMPARE(peers("sysids", {QStringLiteral("scout-2"), QStringLiteral("1,3")}).status, 0);
    const QJsonObject peer = listed();
    QCOMPARE(peer[QLatin1String("name")].toString(), QStringLiteral("scout-2"));
    QCOMPARE(peer[QLatin1String("role")].toString(), QStringLiteral("observer"));
    QCOMPARE(peer[QLatin1String("sysids")].toString(), QStringLiteral("1,3"));
    QCOMPARE(peers("revoke", {QStringLiteral("scout-2")}).status, 0);
    QVERIFY(listed().isEmpty());
}

void KeysCommandTest::publicKeyTravelsInAFile()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(keys({QStringLiteral("export"), path("a.key"), QStringLiteral("--out"), path("a.pub")}).status, 0);
    QCOMPARE(keys({QStringLiteral("export"), path("a.key"), QStringLiteral("--out"), path("a.pub")}).status, 3);
    QCOMPARE(keys({QStringLiteral("export"), path("a.key")}).out.trimmed(), publicKeyOf("a.key").toUtf8());
    const QStringList add{QStringLiteral("peers"),  QStringLiteral("add"),     QStringLiteral("--peers"), path("peers"),
                          QStringLiteral("--name"), QStringLiteral("scout-1"), QStringLiteral("--from")};
    QCOMPARE(keys(add + QStringList{path("nowhere")}).status, 3);
    QCOMPARE(keys(add + QStringList{path("a.key")}).status, 2); // the private one is no public key
    QCOMPARE(keys(add + QStringList{path("a.pub")}).status, 0);
    QCOMPARE(listed()[QLatin1String("public")].toString(), publicKeyOf("a.key"));
}

void KeysCommandTest::privateKeyIsImported()
{
    QCOMPARE(newKey("a.key").status, 0);
    QVERIFY(QFile::setPermissions(path("a.key"), QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther)); // as on a USB stick
    QCOMPARE(keys({QStringLiteral("import"), path("a.key"), QStringLiteral("--out"), path("b.key")}).status, 0);
    QVERIFY(QFile::setPermissions(path("a.key"), QFile::ReadOwner));
    QCOMPARE(shown("b.key"), shown("a.key"));
    QFile file(path("a.key"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const RunResult piped = runProgram(
        "skyseal-cli",
        {QStringLiteral("keys"), QStringLiteral("import"), QStringLiteral("-"), QStringLiteral("--out"), path("c.key")},
        file.readAll());
    QVERIFY2(piped.status == 0, piped.err.constData());
    QCOMPARE(shown("c.key"), shown("a.key"));
    QCOMPARE(keys({QStringLiteral("import"), path("a.key"), QStringLiteral("--out"), path("c.key")}).status, 3);
    QCOMPARE(keys({QStringLiteral("import"), path("peers"), QStringLiteral("--out"), path("d.key")}).status, 3);
    QVERIFY(!QFile::exists(path("d.key")));
}

void KeysCommandTest::presharedKeyIsMadeAndNamed()
{
    QCOMPARE(newKey("a.key").status, 0);
    QCOMPARE(keys({QStringLiteral("psk"), QStringLiteral("--out"), path("pair.psk")}).status, 0);
    QCOMPARE(keys({QStringLiteral("psk"), QStringLiteral("--out"), path("pair.psk")}).status, 3);
    QCOMPARE(addPeer(publicKeyOf("a.key"), {QStringLiteral("--psk"), path("pair.psk")}).status, 0);
    QVERIFY(listed()[QLatin1String("psk")].toBool());
}

void KeysCommandTest::damagedPeersFileIsLeftAlone()
{
    QCOMPARE(newKey("a.key").status, 0);
    QFile file(path("peers"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("nonsense\n");
    file.close();
    const RunResult refused = addPeer(publicKeyOf("a.key"));
    QCOMPARE(refused.status, 3);
    QVERIFY2(refused.err.contains("peers:1:"), refused.err.constData());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("nonsense\n"));
}

void KeysCommandTest::missingFilesSayWhatMakesThem()
{
    const RunResult list = peers("list", {});
    QCOMPARE(list.status, 3);
    QVERIFY2(list.err.contains("peers: does not exist; keys pair and keys peers add create it"), list.err.constData());
    const RunResult from = peers(
        "add", {QStringLiteral("--name"), QStringLiteral("scout-1"), QStringLiteral("--from"), path("none.pub")});
    QCOMPARE(from.status, 3);
    QVERIFY2(from.err.contains("none.pub"), from.err.constData());
}

void KeysCommandTest::pairingNeedsSomebodyToAnswer()
{
    QCOMPARE(newKey("a.key").status, 0);
    const RunResult ended = keys({QStringLiteral("pair"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"),
                                  QStringLiteral("--identity"), path("a.key"), QStringLiteral("--peers"), path("peers")});
    QCOMPARE(ended.status, 1);
    QVERIFY2(ended.err.contains("skyseal-air --pair --identity FILE"), ended.err.constData()); // what to do at the other end
    QVERIFY2(ended.err.contains("standard input has ended") && ended.err.contains("--expect"), ended.err.constData());
    QVERIFY2(!ended.err.contains("cancelled"), ended.err.constData());
    const RunResult nobody = runProgram("skyseal-air", {QStringLiteral("--pair"), QStringLiteral("--identity"), path("a.key")});
    QCOMPARE(nobody.status, 3);
    QVERIFY2(nobody.err.contains("no agent with this identity is running") && !nobody.err.contains("QLocalSocket"),
             nobody.err.constData());
}

void KeysCommandTest::noKeyByteInTheOutput()
{
    const RunResult made = newKey("a.key");
    QFile file(path("a.key"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray secret = file.readAll().trimmed().split('\n').back().trimmed();
    QVERIFY(secret.size() >= 40);
    const RunResult show = keys({QStringLiteral("show"), path("a.key"), QStringLiteral("--json")});
    for (const QByteArray &output : {made.out, made.err, show.out, show.err})
        QVERIFY(!output.contains(secret.left(8)));
}

SKYSEAL_TEST(KeysCommandTest)
#include "keys_command_test.moc"
