// An event loop for threads that forward packets: Qt's loop with GLib checks every source and polls every descriptor at
// each wake-up, which costs more than the packet. Here sockets are registered once with epoll(7), and timers are in one short
// list. A ReadableHandler is called without an event of Qt, and as long as only such handlers have something to do, no code of
// Qt runs: between two frames other programs use the caches, so that each further page of code costs a wake-up.
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

class ReadableHandler;

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

    /// Calls the handler whenever the descriptor is readable, until removeReader(). No QSocketNotifier may wait for that too.
    void addReader(int descriptor, ReadableHandler &handler);
    /// Call before the descriptor is closed. The handler may do so itself.
    void removeReader(int descriptor);

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
        ReadableHandler *reader = nullptr;
        std::uint32_t events = 0; ///< registered with epoll
        bool alwaysReady = false; ///< a file, which epoll rejects
    };

    /// One of the two.
    struct Ready
    {
        QSocketNotifier *notifier = nullptr;
        ReadableHandler *reader = nullptr;
        bool operator==(const Ready &) const = default;
    };
    enum class Activated : std::uint8_t { Nothing, Readers, Notifiers };

    void insert(Timer timer);
    Watched &watched(int descriptor);
    void watch(int descriptor);
    int timeout(TimePoint now) const;
    void wait(int milliseconds, bool sockets);
    void collect(int descriptor, std::uint32_t events);
    void addReady(const Ready &ready);
    Activated activateReady();
    bool activateTimers(TimePoint now);

    int m_epoll;
    int m_wakeUp;                     ///< eventfd
    std::atomic<bool> m_woken{false}; ///< since processEvents() began
    std::atomic<bool> m_interrupted{false};
    std::vector<Timer> m_timers;    ///< by `due`
    std::vector<Watched> m_watched; ///< by descriptor
    std::vector<int> m_files;       ///< those that are always ready
    std::vector<Ready> m_ready;     ///< not yet activated
};

} // namespace skyseal::link
