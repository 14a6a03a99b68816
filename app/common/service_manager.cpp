#include "app/common/service_manager.h"

#include <QtCore/QtGlobal>

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace skyseal::app {

ServiceManager::ServiceManager() : m_socket(qEnvironmentVariable("NOTIFY_SOCKET").toStdString())
{
    QObject::connect(&m_alive, &QTimer::timeout, &m_alive, [this] {
        if (m_isAlive())
            send("WATCHDOG=1");
    });
}

void ServiceManager::ready()
{
    send("READY=1");
    const qlonglong limit = qEnvironmentVariable("WATCHDOG_USEC").toLongLong();
    const QString process = qEnvironmentVariable("WATCHDOG_PID");
    if (limit > 0 && (process.isEmpty() || process.toLongLong() == ::getpid()))
        m_alive.start(std::chrono::milliseconds(std::max<qlonglong>(limit / 2000, 1))); // twice in each interval
}

void ServiceManager::stopping()
{
    send("STOPPING=1");
}

void ServiceManager::send(const std::string &state) const
{
    sockaddr_un address{};
    if (m_socket.empty() || m_socket.size() >= sizeof address.sun_path)
        return;
    address.sun_family = AF_UNIX;
    std::copy(m_socket.begin(), m_socket.end(), address.sun_path);
    if (m_socket.front() == '@')
        address.sun_path[0] = 0; // in the abstract name space
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket < 0)
        return;
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + m_socket.size());
    // Nothing to do if it fails: the manager then acts as if this process hung.
    static_cast<void>(
        ::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr *>(&address), length));
    ::close(socket);
}

} // namespace skyseal::app
