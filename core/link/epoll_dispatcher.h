// An event loop for threads that forward packets: Qt's loop with GLib checks every source and polls every descriptor at
// each wake-up, which costs more than the packet. Here sockets are registered once with epoll(7), and timers are in one short
// list.
//
// Linux only. Replaces the dispatcher of programs and threads without a window.
#pragma once

#include "core/base/clock.h"

#include <QtCore/QAbstractEventDispatcher>

#include <array>
#include <atomic>
#include <vector>

struct epoll_event;

namespace skyseal::link {

class EpollDispatcher final : public QAbstractEventDispatcher
{
    Q_OBJECT

public:
    explicit EpollDispatcher(QObject *parent = nullptr);
    ~EpollDispatcher() override;

    bool processEvents(QEventLoop::ProcessEventsFlags flags) override;
    void registerSocketNotifier(QSocketNotifier *notifier) override;
    void unregisterSocketNotifier(QSocketNotifier *notifier) override;
    void registerTimer(int timerId, qint64 interval, Qt::TimerType timerType, QObject *object) override;
    bool unregisterTimer(int timerId) override;
    bool unregisterTimers(QObject *object) override;
    QList<TimerInfo> registeredTimers(QObject *object) const override;
    int remainingTime(int timerId) override;
    void wakeUp() override;
    void interrupt() override;

private:
    struct Timer
    {
        int id;
        Qt::TimerType type; ///< all are kept to the millisecond
        QObject *object;
        Duration interval;
        TimePoint due;
        bool handled = false; ///< its event is being handled; does not expire again in a nested loop
    };
    struct Watched
    {
        std::array<QSocketNotifier *, 3> notifiers{}; ///< by QSocketNotifier::Type
        std::uint32_t events = 0;                     ///< registered with epoll
        bool alwaysReady = false;                     ///< a file, which epoll rejects
    };

    void insert(Timer timer);
    void watch(int descriptor);
    int timeout() const;
    void wait(int milliseconds, bool sockets);
    void collect(int descriptor, std::uint32_t events);
    bool activateNotifiers();
    bool activateTimers();

    int m_epoll;
    int m_wakeUp;                     ///< eventfd
    std::atomic<bool> m_woken{false}; ///< since processEvents() began
    std::atomic<bool> m_interrupted{false};
    std::vector<Timer> m_timers;            ///< by `due`
    std::vector<Watched> m_watched;         ///< by descriptor
    std::vector<int> m_files;               ///< those that are always ready
    std::vector<QSocketNotifier *> m_ready; ///< not yet activated
};

} // namespace skyseal::link
