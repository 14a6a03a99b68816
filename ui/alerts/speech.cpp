#include "ui/alerts/speech.h"

#include <QtCore/QThread>

namespace skyseal::ui {

namespace {
constexpr int kFarewellMs = 200; ///< for a text that is being handed over when the program ends
} // namespace

Speech::Speech(std::unique_ptr<Voice> voice, QObject *parent) : QObject(parent), m_shared(std::make_shared<Shared>())
{
    m_shared->voice = std::move(voice);
}

Speech::~Speech()
{
    if (!m_thread)
        return;
    m_shared->over = true;
    m_thread->quit();
    if (!m_thread->wait(kFarewellMs))
        return; // the voice hangs: its thread ends with the program
    delete m_there;
    delete m_thread;
}

bool Speech::say(const QString &text, bool urgent)
{
    if (!m_on || !m_shared->voice || m_shared->waiting >= kMostWaiting)
        return false;
    if (!m_thread) {
        m_thread = new QThread;
        m_there = new QObject;
        m_there->moveToThread(m_thread);
        m_thread->start();
    }
    ++m_shared->waiting;
    QMetaObject::invokeMethod(
        m_there,
        [shared = m_shared, text, urgent] {
            if (!shared->over)
                shared->voice->say(text, urgent);
            --shared->waiting;
        },
        Qt::QueuedConnection);
    return true;
}

} // namespace skyseal::ui

#include "moc_speech.cpp"
