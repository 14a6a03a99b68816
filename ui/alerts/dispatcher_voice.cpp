// The voice of the desktop by speech-dispatcher, through its client library. On the thread of Speech.
#include "ui/alerts/speech.h"
#include "ui/language.h"

#include <QtCore/QDeadlineTimer>
#include <QtCore/QStandardPaths>

#include <libspeechd.h>

#include <csignal>
#include <cstdlib>

namespace skyseal::ui {

namespace {

constexpr int kRetryMs = 60'000; ///< after the service could not be reached

class DispatcherVoice : public Voice
{
public:
    ~DispatcherVoice() override { close(); }

    void say(const QString &text, bool urgent) override
    {
        if (!m_connection && !open())
            return;
        if (spd_say(m_connection, urgent ? SPD_IMPORTANT : SPD_MESSAGE, text.toUtf8().constData()) < 0)
            close();
    }

private:
    bool open()
    {
        if (!m_retry.hasExpired())
            return false;
        m_retry.setRemainingTime(kRetryMs);
        sigset_t broken; // the library writes to a socket whose other end may have gone
        sigemptyset(&broken);
        sigaddset(&broken, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &broken, nullptr);
        const bool installed = !QStandardPaths::findExecutable(QStringLiteral("speech-dispatcher")).isEmpty();
        char *problem = nullptr;
        m_connection = spd_open2("skyseal", "alerts", nullptr, SPD_MODE_SINGLE, nullptr, installed ? 1 : 0, &problem);
        std::free(problem);
        if (m_connection) // else a voice of the desktop's language reads the texts
            spd_set_language(m_connection, languageInUse().toLatin1().constData());
        return m_connection != nullptr;
    }

    void close()
    {
        if (m_connection)
            spd_close(m_connection);
        m_connection = nullptr;
    }

    SPDConnection *m_connection = nullptr;
    QDeadlineTimer m_retry{0};
};

} // namespace

std::unique_ptr<Voice> desktopVoice()
{
    return std::make_unique<DispatcherVoice>();
}

bool isDesktopVoiceBuilt()
{
    return true;
}

} // namespace skyseal::ui
