// The socket between an agent and `skyseal-air --pair`, with real programs: it lies beside the key, however that is named; a
// second agent takes nothing over; and a program of another user that listens there is told nothing.
#include "tests/support/eventually.h"
#include "tests/support/pairing_people.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cstring>
#include <memory>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr uid_t kNobody = 65534;

/// A process of another user that listens at a path and reads what the first client sends. Its exit status is the number of
/// bytes.
class ForeignListener
{
public:
    explicit ForeignListener(const QByteArray &path)
    {
        int ready[2];
        if (::pipe(ready) != 0)
            return;
        m_pid = ::fork();
        if (m_pid == 0)
            listen(path, ready[1]);
        ::close(ready[1]);
        char listening = 0;
        m_isListening = ::read(ready[0], &listening, 1) == 1;
        ::close(ready[0]);
    }
    ~ForeignListener()
    {
        if (m_pid > 0 && !m_hasEnded) {
            ::kill(m_pid, SIGKILL);
            ::waitpid(m_pid, nullptr, 0);
        }
    }
    bool isListening() const { return m_isListening; }
    /// Waits for the end of the client's connection. -1: it failed otherwise.
    int bytesHeard()
    {
        int status = 0;
        ::waitpid(m_pid, &status, 0);
        m_hasEnded = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    /// Only what may be called between fork() and the end.
    [[noreturn]] static void listen(const QByteArray &path, int ready)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, path.constData(), static_cast<std::size_t>(path.size()));
        const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
        if (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0
            || ::bind(server, reinterpret_cast<const sockaddr *>(&address), sizeof address) != 0 || ::listen(server, 1) != 0)
            ::_exit(200);
        if (::write(ready, "1", 1) != 1)
            ::_exit(201);
        const int client = ::accept(server, nullptr, nullptr);
        char heard[100];
        ssize_t sum = 0;
        for (ssize_t got = 1; got > 0 && sum<100; sum += got> 0 ? got : 0)
            got = ::read(client, heard, sizeof heard);
        ::_exit(static_cast<int>(sum));
    }

    pid_t m_pid = -1;
    bool m_isListening = false, m_hasEnded = false;
};

} // namespace

class PairingSocketTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_folder->path()));
        QCOMPARE(runProgram("skyseal-cli", words("keys new --out air.key")).status, 0);
    }
    void cleanup() { QDir::setCurrent(m_before); }

    void namesOfTheKeyReachTheSameAgent_data();
    void namesOfTheKeyReachTheSameAgent();
    void anotherFolderIsAnotherAgent();
    void secondAgentTakesNothingOver();
    void programOfAnotherUserIsToldNothing();
    void longPathsAreRefused();

private:
    static std::unique_ptr<Program> agent(const QString &key)
    {
        return std::make_unique<Program>(
            QStringLiteral("skyseal-air"),
            words("--vehicle udpin:127.0.0.1:0 --ground udpin:127.0.0.1:0 --peers air.peers --json")
                << QStringLiteral("--identity") << key);
    }
    static std::unique_ptr<Program> window(const QString &key)
    {
        return std::make_unique<Program>(QStringLiteral("skyseal-air"), words("--pair --json --identity") << key);
    }
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_before;
};

void PairingSocketTest::namesOfTheKeyReachTheSameAgent_data()
{
    QTest::addColumn<QString>("agents");
    QTest::addColumn<QString>("clients");
    const QString plain = QStringLiteral("air.key");
    QTest::newRow("relative, absolute") << plain << QStringLiteral("%1/air.key");
    QTest::newRow("absolute, relative") << QStringLiteral("%1/air.key") << QStringLiteral("./air.key");
    QTest::newRow("through a folder") << QStringLiteral("sub/../air.key") << plain;
    QTest::newRow("through a linked folder") << QStringLiteral("linked/air.key") << plain;
    QTest::newRow("by a link") << plain << QStringLiteral("link.key");
}

void PairingSocketTest::namesOfTheKeyReachTheSameAgent()
{
    QFETCH(QString, agents);
    QFETCH(QString, clients);
    QVERIFY(QDir().mkdir(QStringLiteral("sub")) && QFile::link(m_folder->path(), QStringLiteral("linked")));
    QVERIFY(QFile::link(QStringLiteral("air.key"), QStringLiteral("link.key")));
    const auto named = [this](const QString &name) {
        return name.contains(QLatin1Char('%')) ? name.arg(m_folder->path()) : name;
    };
    const auto air = agent(named(agents));
    EVENTUALLY2(QFile::exists(path("air.key.control")), air->errors().constData());
    QVERIFY(!QFile::exists(QDir::temp().filePath(QStringLiteral("air.key.control"))));
    const auto desk = window(named(clients));
    QVERIFY2(!desk->waitFor(QStringLiteral("pairing"), stateIs("open")).isEmpty(), desk->errors().constData());
}

void PairingSocketTest::anotherFolderIsAnotherAgent()
{
    const auto air = agent(QStringLiteral("air.key"));
    EVENTUALLY2(QFile::exists(path("air.key.control")), air->errors().constData());
    QVERIFY(QDir().mkdir(QStringLiteral("other")) && QDir::setCurrent(path("other")));
    QCOMPARE(runProgram("skyseal-cli", words("keys new --out air.key")).status, 0);
    QCOMPARE(window(QStringLiteral("air.key"))->waitForExit(), 3);
    QVERIFY(air->running());
}

void PairingSocketTest::secondAgentTakesNothingOver()
{
    const auto air = agent(QStringLiteral("air.key"));
    EVENTUALLY2(QFile::exists(path("air.key.control")), air->errors().constData());
    {
        const auto second = agent(QStringLiteral("air.key"));
        EVENTUALLY2(second->errors().contains("another program listens there"), second->errors().constData());
        second->terminate();
    }
    QVERIFY(QFile::exists(path("air.key.control")));
    const auto desk = window(QStringLiteral("air.key"));
    QVERIFY2(!desk->waitFor(QStringLiteral("pairing"), stateIs("open")).isEmpty(), desk->errors().constData());
}

void PairingSocketTest::programOfAnotherUserIsToldNothing()
{
    SKYSEAL_REQUIRES("superuser");
    QVERIFY(::chmod(m_folder->path().toLocal8Bit().constData(), 0777) == 0);
    ForeignListener listener(path("air.key.control").toLocal8Bit());
    QVERIFY(listener.isListening());
    QFile passphrase(path("words"));
    QVERIFY(passphrase.open(QIODevice::WriteOnly) && passphrase.write("blue heron at noon\n") > 0);
    passphrase.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    passphrase.close();
    const RunResult run = runProgram("skyseal-air", words("--pair --identity air.key --pair-passphrase-file words"));
    QCOMPARE(run.status, 3);
    QVERIFY2(run.err.contains("belongs to another user"), run.err.constData());
    QCOMPARE(listener.bytesHeard(), 0);
}

void PairingSocketTest::longPathsAreRefused()
{
    const QString deep(60, QLatin1Char('d'));
    QVERIFY(QDir().mkpath(deep + QLatin1Char('/') + deep));
    const QString key = deep + QLatin1Char('/') + deep + QStringLiteral("/air.key");
    QVERIFY(QFile::copy(QStringLiteral("air.key"), key));
    QFile::setPermissions(key, QFile::ReadOwner | QFile::WriteOwner);
    const auto air = agent(key);
    EVENTUALLY2(air->errors().contains("is too long for a socket"), air->errors().constData());
    QVERIFY(air->running()); // without pairing it flies all the same
}

SKYSEAL_TEST(PairingSocketTest)
#include "pairing_socket_test.moc"
