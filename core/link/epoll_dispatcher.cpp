#include "core/link/epoll_dispatcher.h"

#include "core/link/readable_handler.h"
#include "core/link/steady_now.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtCore/QSocketNotifier>
#include <QtCore/QThread>

#include <algorithm>
#include <cerrno>
#include <cstdint>

#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace skyseal::link {

using std::chrono::milliseconds;

namespace {

struct Kind
{
    QSocketNotifier::Type type;
    std::uint32_t asked;
    std::uint32_t activating; ///< as with poll(2) in Qt's own dispatchers
};

constexpr std::array<Kind, 3> kKinds{{{QSocketNotifier::Read, EPOLLIN, EPOLLIN | EPOLLHUP | EPOLLERR},
                                      {QSocketNotifier::Write, EPOLLOUT, EPOLLOUT | EPOLLHUP | EPOLLERR},
                                      {QSocketNotifier::Exception, EPOLLPRI, EPOLLPRI | EPOLLHUP | EPOLLERR}}};

} // namespace

EpollDispatcher::EpollDispatcher(QObject *parentObject)
    : QAbstractEventDispatcher(parentObject), m_epoll(::epoll_create1(EPOLL_CLOEXEC)),
      m_wakeUp(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
{
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = m_wakeUp;
    if (m_epoll < 0 || m_wakeUp < 0 || ::epoll_ctl(m_epoll, EPOLL_CTL_ADD, m_wakeUp, &event) != 0)
        qFatal("no descriptors are left for an event loop");
}

EpollDispatcher::~EpollDispatcher()
{
    ::close(m_wakeUp);
    ::close(m_epoll);
}

bool EpollDispatcher::processEvents(QEventLoop::ProcessEventsFlags flags)
{
    m_interrupted = false;
    // Events posted before this line are sent now; later ones set the flag again.
    m_woken.exchange(false);
    Q_EMIT awake();
    QCoreApplication::sendPostedEvents();

    const bool timers = !flags.testFlag(QEventLoop::X11ExcludeTimers);
    const bool sockets = !flags.testFlag(QEventLoop::ExcludeSocketNotifiers);
    const bool mayWait = flags.testFlag(QEventLoop::WaitForMoreEvents) && !m_interrupted;
    if (mayWait)
        Q_EMIT aboutToBlock();
    if (m_interrupted)
        return false;
    // QEventLoop::exec() would call again at once. Its work and its caller's in between is only needed after an event of Qt: a
    // handler that posts one, deletes an object later or ends the loop calls wakeUp().
    const bool stays = mayWait && timers && sockets && flags.testFlag(QEventLoop::EventLoopExec);
    const bool ready = m_woken || (sockets && (!m_ready.empty() || !m_files.empty()));
    int limit = !mayWait || ready ? 0 : timers ? timeout(steadyNow()) : -1;
    for (;;) {
        wait(limit, sockets);
        const bool woken = m_woken;
        const Activated activated = sockets ? activateReady() : Activated::Nothing;
        const TimePoint now = timers ? steadyNow() : TimePoint();
        const bool expired = timers && activateTimers(now);
        if (!stays || m_woken || expired || activated != Activated::Readers || !m_files.empty())
            return woken || expired || activated != Activated::Nothing;
        limit = timeout(now);
    }
}

void EpollDispatcher::wait(int limit, bool sockets)
{
    std::array<epoll_event, 32> events;
    int count = 0;
    if (sockets) {
        count = ::epoll_wait(m_epoll, events.data(), static_cast<int>(events.size()), limit);
    } else {
        pollfd only{m_wakeUp, POLLIN, 0};
        count = ::poll(&only, 1, limit);
        events[0].events = EPOLLIN;
        events[0].data.fd = m_wakeUp;
    }
    for (int i = 0; i < count; ++i) {
        if (events[static_cast<std::size_t>(i)].data.fd != m_wakeUp) {
            collect(events[static_cast<std::size_t>(i)].data.fd, events[static_cast<std::size_t>(i)].events);
            continue;
        }
        eventfd_t value = 0;
        ::eventfd_read(m_wakeUp, &value);
        m_woken = true; // also if it was written before this call of processEvents(), since it counts as an event
    }
    if (sockets) {
        for (const int file : m_files)
            collect(file, EPOLLIN | EPOLLOUT);
    }
}

/// Milliseconds until the next timer expires, rounded up; -1 without timers.
int EpollDispatcher::timeout(TimePoint now) const
{
    const auto next = std::ranges::find(m_timers, false, &Timer::handled);
    if (next == m_timers.end())
        return -1;
    const Duration left = next->due - now;
    constexpr Duration kLongest = std::chrono::hours(24);
    return static_cast<int>(std::chrono::ceil<milliseconds>(std::clamp(left, Duration::zero(), kLongest)).count());
}

// ---- sockets

EpollDispatcher::Watched &EpollDispatcher::watched(int descriptor)
{
    const auto index = static_cast<std::size_t>(descriptor);
    if (m_watched.size() <= index)
        m_watched.resize(index + 1);
    return m_watched[index];
}

void EpollDispatcher::registerSocketNotifier(QSocketNotifier *notifier)
{
    const auto descriptor = static_cast<int>(notifier->socket());
    QSocketNotifier *&place = watched(descriptor).notifiers[notifier->type()];
    if (place && place != notifier)
        qWarning("two notifiers for descriptor %d", descriptor);
    place = notifier;
    watch(descriptor);
}

void EpollDispatcher::unregisterSocketNotifier(QSocketNotifier *notifier)
{
    std::erase(m_ready, Ready{notifier, nullptr});
    const auto descriptor = static_cast<int>(notifier->socket());
    QSocketNotifier *&place = watched(descriptor).notifiers[notifier->type()];
    if (place != notifier)
        return;
    place = nullptr;
    watch(descriptor);
}

void EpollDispatcher::addReader(int descriptor, ReadableHandler &handler)
{
    watched(descriptor).reader = &handler;
    watch(descriptor);
}

void EpollDispatcher::removeReader(int descriptor)
{
    ReadableHandler *&place = watched(descriptor).reader;
    if (!place)
        return;
    std::erase(m_ready, Ready{nullptr, place});
    place = nullptr;
    watch(descriptor);
}

/// Registers the events of the descriptor with epoll.
void EpollDispatcher::watch(int descriptor)
{
    Watched &entry = watched(descriptor);
    epoll_event event{};
    event.data.fd = descriptor;
    for (const Kind &kind : kKinds) {
        if (entry.notifiers[kind.type])
            event.events |= kind.asked;
    }
    if (entry.reader)
        event.events |= EPOLLIN;
    std::erase(m_files, descriptor);
    if (event.events == 0) {
        ::epoll_ctl(m_epoll, EPOLL_CTL_DEL, descriptor, nullptr); // fails if it was closed, which removed it
    } else {
        // A number may have been closed and given to another socket since it was registered.
        int failed = ::epoll_ctl(m_epoll, entry.events == 0 ? EPOLL_CTL_ADD : EPOLL_CTL_MOD, descriptor, &event);
        if (failed != 0 && errno == ENOENT)
            failed = ::epoll_ctl(m_epoll, EPOLL_CTL_ADD, descriptor, &event);
        else if (failed != 0 && errno == EEXIST)
            failed = ::epoll_ctl(m_epoll, EPOLL_CTL_MOD, descriptor, &event);
        if (failed != 0 && errno == EPERM) // a file or a device without poll: always ready, as poll(2) says
            m_files.push_back(descriptor);
        else if (failed != 0)
            qWarning("descriptor %d cannot be watched", descriptor);
    }
    entry.events = event.events;
}

void EpollDispatcher::collect(int descriptor, std::uint32_t events)
{
    if (static_cast<std::size_t>(descriptor) >= m_watched.size())
        return;
    const Watched &watched = m_watched[static_cast<std::size_t>(descriptor)];
    if (watched.reader && (events & kKinds[0].activating) != 0)
        addReady({nullptr, watched.reader});
    for (const Kind &kind : kKinds) {
        QSocketNotifier *notifier = watched.notifiers[kind.type];
        if (notifier && (events & kind.activating) != 0)
            addReady({notifier, nullptr});
    }
}

void EpollDispatcher::addReady(const Ready &ready)
{
    if (std::ranges::find(m_ready, ready) == m_ready.end())
        m_ready.push_back(ready);
}

EpollDispatcher::Activated EpollDispatcher::activateReady()
{
    auto out = Activated::Nothing;
    while (!m_ready.empty()) { // a handler may remove others, or run a loop of its own
        const Ready ready = m_ready.front();
        m_ready.erase(m_ready.begin());
        if (ready.reader) {
            ready.reader->handleReadable();
            out = std::max(out, Activated::Readers);
        } else {
            QEvent event(QEvent::SockAct);
            QCoreApplication::sendEvent(ready.notifier, &event);
            out = Activated::Notifiers;
        }
    }
    return out;
}

// ---- timers

void EpollDispatcher::insert(Timer timer)
{
    m_timers.insert(std::ranges::upper_bound(m_timers, timer.due, {}, &Timer::due), timer);
}

void EpollDispatcher::registerTimer(int timerId, qint64 interval, Qt::TimerType timerType, QObject *object)
{
    const Duration wait = milliseconds(interval);
    insert({timerId, timerType, object, wait, steadyNow() + wait});
}

bool EpollDispatcher::unregisterTimer(int timerId)
{
    return std::erase_if(m_timers, [timerId](const Timer &timer) { return timer.id == timerId; }) > 0;
}

bool EpollDispatcher::unregisterTimers(QObject *object)
{
    return std::erase_if(m_timers, [object](const Timer &timer) { return timer.object == object; }) > 0;
}

QList<QAbstractEventDispatcher::TimerInfo> EpollDispatcher::registeredTimers(QObject *object) const
{
    QList<TimerInfo> out;
    for (const Timer &timer : m_timers) {
        if (timer.object == object)
            out.append(
                {timer.id, static_cast<int>(std::chrono::duration_cast<milliseconds>(timer.interval).count()), timer.type});
    }
    return out;
}

int EpollDispatcher::remainingTime(int timerId)
{
    const auto found = std::ranges::find(m_timers, timerId, &Timer::id);
    if (found == m_timers.end())
        return -1;
    return static_cast<int>(std::chrono::ceil<milliseconds>(std::max(found->due - steadyNow(), Duration::zero())).count());
}

bool EpollDispatcher::activateTimers(TimePoint now)
{
    if (m_timers.empty() || m_timers.front().due > now)
        return false;
    const auto isDue = [now](const Timer &timer) { return timer.due <= now && !timer.handled; };
    // The timers that are due now, each once: a timer without an interval is due again at once.
    const auto most = std::ranges::count_if(m_timers, isDue);
    for (auto left = most; left > 0; --left) {
        const auto found = std::ranges::find_if(m_timers, isDue);
        if (found == m_timers.end())
            break;
        Timer timer = *found;
        m_timers.erase(found);
        timer.due += timer.interval;
        if (timer.due < now)
            timer.due = now + timer.interval;
        timer.handled = true;
        insert(timer);
        QTimerEvent event(timer.id);
        QCoreApplication::sendEvent(timer.object, &event);
        const auto kept = std::ranges::find(m_timers, timer.id, &Timer::id);
        if (kept != m_timers.end())
            kept->handled = false;
    }
    return most > 0;
}

// ---- other threads

void EpollDispatcher::wakeUp()
{
    // The thread itself checks the flag before it waits.
    if (!m_woken.exchange(true) && QThread::currentThread() != thread())
        ::eventfd_write(m_wakeUp, 1);
}

void EpollDispatcher::interrupt()
{
    m_interrupted = true;
    wakeUp();
}

} // namespace skyseal::link

#include "moc_epoll_dispatcher.cpp"
