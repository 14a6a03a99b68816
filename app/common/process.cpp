#include "app/common/process.h"

#include "app/common/output.h"
#include "core/base/locked_memory.h"

#include <QtCore/QSocketNotifier>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

// The leak checker of a sanitizer build attaches to the process.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SKYSEAL_MAY_BE_TRACED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SKYSEAL_MAY_BE_TRACED 1
#endif
#endif

namespace skyseal::app {

namespace {

// The only state accessible to a signal handler.
std::atomic<int> g_stopPipe{-1};

constexpr char kStop = 's', kReload = 'r';

/// A terminal that is closed may send SIGHUP more than once: the shell does, and the system.
extern "C" void handleStop(int number)
{
    static_cast<void>(!write(g_stopPipe, &kStop, 1));
    if (number != SIGHUP)
        std::signal(number, SIG_DFL); // a second signal ends the process
}

extern "C" void handleReload(int)
{
    static_cast<void>(!write(g_stopPipe, &kReload, 1)); // if the pipe is full, a reload is due anyway
}

/// Not if the program was started to ignore it, as by nohup(1).
void replaceHangup(void (*handler)(int))
{
    if (std::signal(SIGHUP, handler) == SIG_IGN)
        std::signal(SIGHUP, SIG_IGN);
}

} // namespace

void protectKeysInMemory()
{
    reportLockFailure([](int error) {
        remark(std::string("keys may be written to the swap space: memory cannot be locked (") + std::strerror(error)
               + "; the limit is that of ulimit -l, and LimitMEMLOCK= of a service)");
    });
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
#if defined(__linux__) && !defined(SKYSEAL_MAY_BE_TRACED)
    prctl(PR_SET_DUMPABLE, 0);
#endif
}

StopSignals::StopSignals(QObject *parent) : QObject(parent)
{
    if (pipe(m_pipe) != 0)
        return;
    for (const int end : m_pipe) {
        fcntl(end, F_SETFD, FD_CLOEXEC);
        fcntl(end, F_SETFL, O_NONBLOCK);
    }
    g_stopPipe = m_pipe[1];
    auto *notifier = new QSocketNotifier(m_pipe[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        char bytes[16];
        const ssize_t count = read(m_pipe[0], bytes, sizeof bytes);
        const std::string_view signals(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (signals.find(kStop) != std::string_view::npos)
            Q_EMIT stopRequested();
        else if (!signals.empty())
            Q_EMIT reloadRequested();
    });
    std::signal(SIGINT, handleStop);
    std::signal(SIGTERM, handleStop);
    replaceHangup(handleStop);
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe is an error of write(), not the end of the process
}

void StopSignals::takeReload()
{
    std::signal(SIGHUP, handleReload);
}

StopSignals::~StopSignals()
{
    replaceHangup(SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    g_stopPipe = -1;
    for (const int end : m_pipe) {
        if (end >= 0)
            close(end);
    }
}

} // namespace skyseal::app

#include "moc_process.cpp"
