// The program skyseal from the outside: help, usage, pictures, an orderly end, a port that is taken.
#include "core/engine/station/snapshot.h"
#include "tests/engine/flight_rig.h"
#include "tests/support/eventually.h"
#include "tests/support/free_port.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <csignal>

using namespace skyseal;
using namespace skyseal::test;

class ProgramTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void helpAndVersionNeedNoDisplay()
    {
        for (const char *option : {"--help", "--version"}) {
            QProcess skyseal;
            prepare(skyseal);
            QProcessEnvironment bare = skyseal.processEnvironment();
            bare.remove(QStringLiteral("QT_QPA_PLATFORM"));
            bare.remove(QStringLiteral("DISPLAY"));
            skyseal.setProcessEnvironment(bare);
            skyseal.start(program(), {QLatin1String(option)});
            QVERIFY(skyseal.waitForFinished(kDeadlineMs));
            QCOMPARE(skyseal.exitCode(), 0);
            QVERIFY(skyseal.readAllStandardOutput().contains("skyseal"));
        }
    }

    void wrongUsageIsTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("unknown") << QStringList{QStringLiteral("--nonsense")};
        QTest::newRow("link") << QStringList{QStringLiteral("--link"), QStringLiteral("pigeon:1")};
        QTest::newRow("seconds") << QStringList{QStringLiteral("--after"), QStringLiteral("soon")};
        QTest::newRow("keys") << QStringList{QStringLiteral("--identity"), QStringLiteral("a.key")};
        QTest::newRow("argument") << QStringList{QStringLiteral("stray")};
        QTest::newRow("escape sequence") << QStringList{QStringLiteral("\x1b[2J\nstray\u202e")};
    }
    void wrongUsageIsTwo()
    {
        QFETCH(QStringList, arguments);
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(), arguments);
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QCOMPARE(skyseal.exitCode(), 2);
        const QByteArray said = skyseal.readAllStandardError();
        QCOMPARE(said.count('\n'), 1);
        QVERIFY(!said.contains('\x1b') && !said.contains("\xe2\x80\xae"));
    }

    void missingKeyIsThree()
    {
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(),
                      {QStringLiteral("--identity"), m_folder.filePath(QStringLiteral("none.key")), QStringLiteral("--peers"),
                       m_folder.filePath(QStringLiteral("none.peers"))});
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QCOMPARE(skyseal.exitCode(), 3);
        QVERIFY(skyseal.readAllStandardError().contains("none.key"));
    }

    void takesAPicture()
    {
        const QString file = m_folder.filePath(QStringLiteral("window.png"));
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(),
                      {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"), QStringLiteral("--screenshot"), file,
                       QStringLiteral("--after"), QStringLiteral("0.5")});
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QCOMPARE(skyseal.exitCode(), 0);
        const QImage picture(file);
        QCOMPARE(picture.size(), QSize(1280, 800)); // although the screen has 800 by 800
    }

    void anUnwritablePictureIsThree()
    {
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(),
                      {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"), QStringLiteral("--screenshot"),
                       m_folder.filePath(QStringLiteral("no/such/folder.png")), QStringLiteral("--after"),
                       QStringLiteral("0.2")});
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QCOMPARE(skyseal.exitCode(), 3);
        QVERIFY(skyseal.readAllStandardError().contains("folder.png: cannot be written"));
    }

    void firstRunMakesAnIdentity()
    {
        const QString identity = m_folder.filePath(QStringLiteral("data/skyseal/skyseal/identity.key"));
        QVERIFY(QFile::exists(identity)); // by the pictures above
        QCOMPARE(QFile::permissions(identity) & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther),
                 QFile::Permissions());
    }

    void endsOnAnInterrupt()
    {
        const quint16 port = freeUdpPort();
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(), {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(port)});
        QVERIFY(skyseal.waitForStarted(kDeadlineMs));
        EVENTUALLY(isBound(port));
        ::kill(static_cast<pid_t>(skyseal.processId()), SIGINT);
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QCOMPARE(skyseal.exitStatus(), QProcess::NormalExit);
        QCOMPARE(skyseal.exitCode(), 0);
    }

    /// The remains of a crash are there for the next start; an orderly end leaves none.
    void crashLeavesItsMarker()
    {
        const QDir runs(m_folder.filePath(QStringLiteral("data/skyseal/skyseal/runs")));
        const auto markers = [&runs] { return QDir(runs.path()).entryList({QStringLiteral("run-*")}, QDir::Files); };
        QVERIFY(markers().isEmpty());
        const QByteArray url = "udpin:127.0.0.1:" + QByteArray::number(freeUdpPort());
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(), {QStringLiteral("--link"), QString::fromLatin1(url)});
        QVERIFY(skyseal.waitForStarted(kDeadlineMs));
        const auto isMarked = [&] {
            QFile file(runs.filePath(markers().value(0)));
            return markers().size() == 1 && file.open(QIODevice::ReadOnly) && file.readAll().contains("link " + url);
        };
        EVENTUALLY(isMarked());
        skyseal.kill();
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QVERIFY(isMarked());
        skyseal.start(program(), {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0")});
        QVERIFY(skyseal.waitForStarted(kDeadlineMs));
        EVENTUALLY(!markers().isEmpty() && !isMarked());
        ::kill(static_cast<pid_t>(skyseal.processId()), SIGTERM);
        QVERIFY(skyseal.waitForFinished(kDeadlineMs));
        QVERIFY(markers().isEmpty());
    }

    void quittingSaysGoodbyeToTheAgent()
    {
        FlightRig rig;
        const engine::KeyPaths keys = rig.stationConfig().keys;
        const quint16 port = freeUdpPort();
        QProcess skyseal;
        prepare(skyseal);
        skyseal.start(program(),
                      {QStringLiteral("--identity"), QString::fromStdString(keys.identity), QStringLiteral("--peers"),
                       QString::fromStdString(keys.peers), QStringLiteral("--link"),
                       QStringLiteral("udpin:127.0.0.1:%1").arg(port)});
        QVERIFY(skyseal.waitForStarted(kDeadlineMs));
        rig.startAgent("127.0.0.1:" + std::to_string(port));
        const auto channelEvents = [&rig] {
            std::vector<channel::Event> out;
            for (const engine::AgentEvent &event : rig.agentEvents)
                if (const auto *common = std::get_if<channel::Event>(&event))
                    out.push_back(*common);
            return out;
        };
        EVENTUALLY(!channelEvents().empty() && std::holds_alternative<channel::SessionUp>(channelEvents().back()));
        ::kill(static_cast<pid_t>(skyseal.processId()), SIGTERM); // closes the windows
        QSignalSpy ended(&skyseal, &QProcess::finished);
        EVENTUALLY(!ended.empty());
        const auto wasClosed = [&channelEvents] {
            const std::vector<channel::Event> events = channelEvents();
            const auto *down = std::get_if<channel::SessionDown>(&events.back());
            return down && down->reason == channel::DownReason::PeerClosed;
        };
        EVENTUALLY(wasClosed());
    }

private:
    /// Looks without binding the port, which could take it from the program.
    static bool isBound(quint16 udpPort)
    {
        QFile sockets(QStringLiteral("/proc/net/udp"));
        return sockets.open(QIODevice::ReadOnly)
            && sockets.readAll().contains(':' + QByteArray::number(udpPort, 16).toUpper() + " 00000000:0000 ");
    }
    static QString program() { return QStringLiteral(SKYSEAL_BIN_DIR "/skyseal"); }

    void prepare(QProcess &process)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        environment.insert(QStringLiteral("XDG_DATA_HOME"), m_folder.filePath(QStringLiteral("data")));
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder.filePath(QStringLiteral("config")));
        process.setProcessEnvironment(environment);
    }

    QTemporaryDir m_folder;
};

SKYSEAL_TEST_WIDGETS(ProgramTest)
#include "program_test.moc"
