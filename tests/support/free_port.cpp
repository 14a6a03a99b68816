#include "tests/support/free_port.h"

#include <QtCore/QByteArray>
#include <QtCore/QCoreApplication>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QUdpSocket>

#include <cstddef>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace skyseal::test {

namespace {

/// Below the ports that the programs choose for others (core/link/free_port.h).
constexpr int kFirst = 20'000, kCount = 6'000;

/// Reserves the port for this process by a name in the abstract namespace of Unix sockets, which ends with the process.
bool reserve(quint16 port)
{
    const QByteArray name = "skyseal-test-port-" + QByteArray::number(port);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.constData(), static_cast<std::size_t>(name.size()));
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(name.size()));
    const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (::bind(descriptor, reinterpret_cast<const sockaddr *>(&address), length) == 0)
        return true; // stays open
    ::close(descriptor);
    return false;
}

/// `binds(port)`: whether a socket can be bound to it.
template<typename Binds> quint16 freePort(Binds binds)
{
    static int next = static_cast<int>(QCoreApplication::applicationPid() * 97 % kCount); // away from those of other tests
    for (int tried = 0; tried < kCount; ++tried) {
        const auto port = static_cast<quint16>(kFirst + next++ % kCount);
        if (reserve(port) && binds(port))
            return port;
    }
    qFatal("no free port");
    return 0;
}

} // namespace

quint16 freeUdpPort()
{
    return freePort([](quint16 port) { return QUdpSocket().bind(QHostAddress::LocalHost, port); });
}

quint16 freeTcpPort()
{
    return freePort([](quint16 port) { return QTcpServer().listen(QHostAddress::LocalHost, port); });
}

} // namespace skyseal::test
