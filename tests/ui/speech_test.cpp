// Spoken alerts: a voice that hangs or is absent holds nothing up; and speech-dispatcher's protocol, with a service of our own.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/speech.h"

#include <QtCore/QMutex>
#include <QtCore/QSemaphore>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// State that a voice and its test share; the voice may outlive the test.
struct Heard
{
    QSemaphore permits; ///< one for each text that may be spoken
    QSemaphore begun;   ///< one for each text that has arrived at the voice
    QMutex mutex;
    QStringList texts;
    QStringList all()
    {
        const QMutexLocker lock(&mutex);
        return texts;
    }
};

class PatientVoice : public Voice
{
public:
    explicit PatientVoice(std::shared_ptr<Heard> heard) : m_heard(std::move(heard)) {}
    void say(const QString &text, bool urgent) override
    {
        m_heard->begun.release();
        m_heard->permits.acquire();
        const QMutexLocker lock(&m_heard->mutex);
        m_heard->texts << (urgent ? text + QLatin1Char('!') : text);
    }

private:
    std::shared_ptr<Heard> m_heard;
};

/// Answers as speech-dispatcher does (SSIP), and keeps what is to be spoken.
class SpeechService : public QObject
{
    Q_OBJECT

public:
    explicit SpeechService(const QString &path)
    {
        connect(&m_server, &QLocalServer::newConnection, this, [this] {
            QLocalSocket *client = m_server.nextPendingConnection();
            connect(client, &QLocalSocket::readyRead, this, [this, client] {
                while (client->canReadLine())
                    answer(*client, QString::fromUtf8(client->readLine()).trimmed());
            });
        });
        listening = m_server.listen(path);
    }

    bool listening = false;
    QStringList spoken, commands;

private:
    void answer(QLocalSocket &client, const QString &line)
    {
        if (m_inText && line != QLatin1String(".")) {
            spoken << line;
            return;
        }
        commands << line;
        const bool ended = m_inText;
        m_inText = line.compare(QLatin1String("speak"), Qt::CaseInsensitive) == 0;
        client.write(m_inText ? "230 OK RECEIVING DATA\r\n" : ended ? "225-21\r\n225 OK MESSAGE QUEUED\r\n" : "208 OK\r\n");
        client.flush();
    }

    QLocalServer m_server;
    bool m_inText = false;
};

} // namespace

class SpeechTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysNothingWhileOff()
    {
        const auto heard = std::make_shared<Heard>();
        Speech speech(std::make_unique<PatientVoice>(heard));
        QVERIFY(!speech.say(QStringLiteral("one"), false));
        speech.setOn(true);
        QVERIFY(speech.say(QStringLiteral("two"), true));
        heard->permits.release();
        EVENTUALLY_EQUAL(heard->all(), QStringList{QStringLiteral("two!")});
    }

    void hangingVoiceHoldsNothingUp()
    {
        const auto heard = std::make_shared<Heard>();
        {
            Speech speech(std::make_unique<PatientVoice>(heard));
            speech.setOn(true);
            for (int i = 0; i < 100; ++i)
                QCOMPARE(speech.say(QString::number(i), false), i < Speech::kMostWaiting);
            QVERIFY(heard->begun.tryAcquire(1, test::kDeadlineMs));
            QVERIFY(heard->all().isEmpty());
        } // returns although the voice hangs
        heard->permits.release(Speech::kMostWaiting);
        EVENTUALLY_EQUAL(heard->all(), QStringList{QStringLiteral("0")}); // what waited is not spoken any more
    }

    void buildWithoutVoiceIsSilent()
    {
        Speech speech(nullptr);
        speech.setOn(true);
        QVERIFY(!speech.say(QStringLiteral("one"), true));
    }

    void absentServiceIsNoError()
    {
        const QTemporaryDir folder;
        qputenv("SPEECHD_ADDRESS", "unix_socket:" + folder.filePath(QStringLiteral("none.sock")).toUtf8());
        qputenv("PATH", ""); // none that could be started
        const auto voice = desktopVoice();
        voice->say(QStringLiteral("one"), false);
        voice->say(QStringLiteral("two"), true);
    }

    void serviceSpeaks()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("speech.sock"));
        SpeechService service(path);
        QVERIFY(service.listening);
        qputenv("SPEECHD_ADDRESS", "unix_socket:" + path.toUtf8());
        Speech speech;
        speech.setOn(true);
        QVERIFY(speech.say(QStringLiteral("Link lost 4 s"), true));
        EVENTUALLY_EQUAL(service.spoken, QStringList{QStringLiteral("Link lost 4 s")});
        QVERIFY2(service.commands.contains(QStringLiteral("SET SELF PRIORITY IMPORTANT")),
                 qPrintable(service.commands.join(QLatin1Char('\n'))));
    }
};

SKYSEAL_TEST(SpeechTest)
#include "speech_test.moc"
