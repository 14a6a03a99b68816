// Traces of keys outside the programs that hold them: output, logs, recordings and files contain no byte of a key, and the
// system may not write their memory to a core file.
#include "core/base/secret_bytes.h"
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"
#include "tests/support/eventually.h"
#include "tests/support/flight.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <memory>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// All the ways in which 32 secret bytes could be written down.
QByteArrayList spellings(ByteView secret)
{
    const QByteArray raw(reinterpret_cast<const char *>(secret.data()), static_cast<qsizetype>(secret.size()));
    QByteArrayList out{raw, raw.toHex(), raw.toHex().toUpper(), raw.toHex(':'), raw.toHex(' ')};
    // The last character of these depends on what follows.
    out << raw.toBase64().left(42) << raw.toBase64(QByteArray::Base64UrlEncoding).left(42);
    QByteArrayList numbers;
    for (const std::uint8_t byte : secret)
        numbers << QByteArray::number(byte);
    return out << numbers.join(',') << numbers.join(", ");
}

bool mentions(const QByteArray &text, const QByteArrayList &secrets)
{
    return std::any_of(secrets.begin(), secrets.end(), [&text](const QByteArray &secret) { return text.contains(secret); });
}

QByteArray contentsOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void bindPresharedKey(const QString &peersFile, const QString &keyFile)
{
    auto peers = keys::PeersFile::load(peersFile.toStdString());
    keys::PeersFile bound;
    for (keys::PeerEntry entry : peers->entries()) {
        entry.presharedKeyFile = keyFile.toStdString();
        if (!bound.add(std::move(entry)))
            qFatal("cannot bind the pre-shared key");
    }
    if (!bound.save(peersFile.toStdString()))
        qFatal("cannot save the peers");
}

} // namespace

class SecrecyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void searchFindsTheKeyFilesThemselves();
    void noKeyInAnyOutput();
    void coreFilesAreForbidden_data();
    void coreFilesAreForbidden();
    void keysAreKeptFromTheSwapSpace();

private:
    QString path(const char *name) const { return m_flight->path(QLatin1String(name)); }
    std::unique_ptr<Flight> m_flight;
    QByteArrayList m_secrets;
};

void SecrecyTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    m_flight = std::make_unique<Flight>();
    QVERIFY(m_flight->ready());
    crypto::SystemRandom random;
    const auto shared = keys::writeNewPresharedKey(path("pair.psk").toStdString(), random);
    QVERIFY(shared);
    m_secrets = spellings(shared->view());
    for (const char *name : {"ground.key", "air.key"}) {
        const auto identity = keys::loadIdentity(path(name).toStdString());
        QVERIFY(identity);
        m_secrets << spellings(identity->secret.view());
    }
    bindPresharedKey(path("ground.peers"), path("pair.psk"));
    bindPresharedKey(path("air.peers"), path("pair.psk"));
}

void SecrecyTest::searchFindsTheKeyFilesThemselves()
{
    for (const char *name : {"ground.key", "air.key", "pair.psk"})
        QVERIFY2(mentions(contentsOf(path(name)), m_secrets), name);
}

void SecrecyTest::noKeyInAnyOutput()
{
    QByteArray said;
    {
        Program sim(QStringLiteral("skyseal-sim"), m_flight->simArguments());
        Program air(QStringLiteral("skyseal-air"), m_flight->airArguments());
        Program monitor(QStringLiteral("skyseal-cli"),
                        m_flight->monitorArguments({QStringLiteral("--record"), path("logs"), QStringLiteral("--switch-to"),
                                                    allSuites(), QStringLiteral("--switch-every"), QStringLiteral("1"),
                                                    QStringLiteral("--duration"), QStringLiteral("9")}));
        QVERIFY2(!monitor.waitFor(QStringLiteral("session")).isEmpty(), monitor.errors().constData());
        QCOMPARE(monitor.waitForExit(), 0);
        QCOMPARE(air.terminate(), 0);
        for (Program *program : {&sim, &air, &monitor}) {
            said += program->errors() + program->otherLines().join('\n');
            for (const QJsonObject &event : program->events())
                said += QJsonDocument(event).toJson(QJsonDocument::Compact) + '\n';
        }
    }
    // Words about keys, and about a key file that cannot be used.
    QFile::copy(path("ground.key"), path("open.key"));
    QFile::setPermissions(path("open.key"), QFile::permissions(path("open.key")) | QFile::ReadOther);
    const std::vector<QStringList> commands{
        {QStringLiteral("keys"), QStringLiteral("show"), path("ground.key")},
        {QStringLiteral("keys"), QStringLiteral("show"), path("open.key")},
        {QStringLiteral("keys"), QStringLiteral("peers"), QStringLiteral("list"), QStringLiteral("--peers"),
         path("ground.peers")},
        {QStringLiteral("selftest")},
    };
    for (const QStringList &command : commands) {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"), command);
        QVERIFY(process.waitForFinished(kDeadlineMs));
        const QByteArray words = process.readAll();
        QVERIFY2(!words.isEmpty(), qPrintable(command.join(QLatin1Char(' '))));
        said += words;
    }
    QFile::remove(path("open.key"));
    QVERIFY(said.size() > 1000);
    QVERIFY(!mentions(said, m_secrets));

    int looked = 0;
    QDirIterator walk(QFileInfo(path("ground.key")).path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString file = walk.next();
        if (file.endsWith(QLatin1String(".key")) || file.endsWith(QLatin1String(".psk")))
            continue;
        QVERIFY2(!mentions(contentsOf(file), m_secrets), qPrintable(file));
        ++looked;
    }
    QVERIFY2(looked >= 5, qPrintable(QString::number(looked))); // peers and counters of both, a recording
}

void SecrecyTest::coreFilesAreForbidden_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("skyseal-air") << QStringLiteral("skyseal-air") << m_flight->airArguments();
    QTest::newRow("skyseal-cli") << QStringLiteral("skyseal-cli") << m_flight->monitorArguments();
    if (QFile::exists(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal")))
        QTest::newRow("skyseal") << QStringLiteral("skyseal") << QStringList{QStringLiteral("--demo")};
}

void SecrecyTest::coreFilesAreForbidden()
{
    QFETCH(QString, name);
    QFETCH(QStringList, arguments);
    Program program(name, arguments);
    static const QRegularExpression kNone(QStringLiteral("Max core file size +0 +0 "));
    const auto forbidden = [&] {
        return QString::fromLatin1(contentsOf(QStringLiteral("/proc/%1/limits").arg(program.pid()))).contains(kNone);
    };
    EVENTUALLY(forbidden() || !program.running());
    QVERIFY2(program.running(), program.errors().constData());
    QVERIFY(forbidden());
}

void SecrecyTest::keysAreKeptFromTheSwapSpace()
{
    SKYSEAL_REQUIRES("locked_memory");
    Program air(QStringLiteral("skyseal-air"), m_flight->airArguments());
    QVERIFY(!air.waitFor(QStringLiteral("stats")).isEmpty());
    static const QRegularExpression kLocked(QStringLiteral("VmLck:\\s+([0-9]+) kB"));
    const QString status = QString::fromLatin1(contentsOf(QStringLiteral("/proc/%1/status").arg(air.pid())));
    QVERIFY2(kLocked.match(status).captured(1).toInt() > 0, qPrintable(status));
    QVERIFY2(!air.errors().contains("swap space"), air.errors().constData());
}

SKYSEAL_TEST(SecrecyTest)
#include "secrecy_test.moc"
