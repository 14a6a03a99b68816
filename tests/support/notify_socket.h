// The service manager's end of sd_notify(3).
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QTemporaryDir>

#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace skyseal::test {

/// Receives what a service tells its manager.
class NotifySocket
{
public:
    NotifySocket() : m_descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0))
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const QByteArray path = m_folder.filePath(QStringLiteral("notify")).toLocal8Bit();
        std::memcpy(address.sun_path, path.constData(), static_cast<std::size_t>(path.size()));
        if (::bind(m_descriptor, reinterpret_cast<const sockaddr *>(&address), sizeof address) != 0)
            qFatal("no socket");
        qputenv("NOTIFY_SOCKET", path); // inherited by the programs that start from now on
    }
    ~NotifySocket()
    {
        ::close(m_descriptor);
        qunsetenv("NOTIFY_SOCKET");
        qunsetenv("WATCHDOG_USEC");
    }
    NotifySocket(const NotifySocket &) = delete;
    NotifySocket &operator=(const NotifySocket &) = delete;

    /// A file of the test's own.
    QString path(const QString &name) const { return m_folder.filePath(name); }
    /// How often this was received.
    int count(const char *state)
    {
        char bytes[256];
        for (ssize_t size; (size = ::recv(m_descriptor, bytes, sizeof bytes, 0)) > 0;)
            m_received << QByteArray(bytes, size);
        return static_cast<int>(m_received.count(state));
    }

private:
    QTemporaryDir m_folder;
    const int m_descriptor;
    QByteArrayList m_received;
};

} // namespace skyseal::test
