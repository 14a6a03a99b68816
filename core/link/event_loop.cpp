#include "core/link/event_loop.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QThread>

#if defined(__linux__)
#include "core/link/epoll_dispatcher.h"
#endif

namespace skyseal::link {

void installEventLoop()
{
#if defined(__linux__)
    QCoreApplication::setEventDispatcher(new EpollDispatcher);
#endif
}

void installEventLoop(QThread &thread)
{
#if defined(__linux__)
    thread.setEventDispatcher(new EpollDispatcher);
#else
    static_cast<void>(thread);
#endif
}

} // namespace skyseal::link
