// Speaks alerts through a voice in a thread of its own, so that a slow or absent voice never holds up the window: texts that
// come faster than they are spoken are dropped. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>
#include <QtCore/QString>

#include <atomic>
#include <memory>

class QThread;

namespace skyseal::ui {

/// Lives on the thread of Speech, which may wait in it.
class Voice
{
public:
    virtual ~Voice() = default;
    /// Speaks, or does nothing if it cannot. `urgent` interrupts other speech.
    virtual void say(const QString &text, bool urgent) = 0;
};

/// The voice of the desktop, speech-dispatcher; null in a build without it.
std::unique_ptr<Voice> desktopVoice();
bool isDesktopVoiceBuilt();

class Speech : public QObject
{
    Q_OBJECT

public:
    static constexpr int kMostWaiting = 3; ///< texts, one of which is being spoken

    explicit Speech(std::unique_ptr<Voice> voice = desktopVoice(), QObject *parent = nullptr);
    ~Speech() override;

    /// Off at first. The voice is not touched before the first text.
    void setOn(bool on) { m_on = on; }
    /// Returns false if the text was dropped.
    bool say(const QString &text, bool urgent);

private:
    /// Shared with the thread, which may outlive this in a voice that hangs.
    struct Shared
    {
        std::unique_ptr<Voice> voice;
        std::atomic<int> waiting = 0;
        std::atomic<bool> over = false; ///< what waits is no longer spoken
    };

    std::shared_ptr<Shared> m_shared;
    QThread *m_thread = nullptr; ///< from the first text on
    QObject *m_there = nullptr;  ///< lives on the thread
    bool m_on = false;
};

} // namespace skyseal::ui
